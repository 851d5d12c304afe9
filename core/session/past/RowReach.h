// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/document/Document.h"
#include "core/edits/answers/EditReach.h"
#include "core/edits/kinds/Edit.h"

#include <vector>

namespace core {

/// Which bricks the result of a row depends on, those it wrote included: what "undo only here" must
/// leave as they were when the row was carried out. Rather too many than too few.
/// What that is of each kind of edit, it says itself: reach() (core/edits/answers/EditAnswers.h).
class RowReach {
public:
    /// @param written the bricks that the row changed; looked at for RevertRows and ReviseStroke
    /// only
    RowReach(const Edit& edit, const Document& document, const std::vector<BrickKey>& written,
        const RowTrace& trace = {});

    [[nodiscard]] bool covers(const BrickKey& key) const;

private:
    EditReach m_reach;
};

} // namespace core
