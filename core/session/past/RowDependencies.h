// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/document/Document.h"
#include "core/edits/answers/EditDependencies.h"
#include "core/edits/kinds/Edit.h"

#include <vector>

namespace core {

/// The bricks on which the result of a row depends, including those that it wrote: "undo only here"
/// must leave them as they were when the row was carried out. It may contain too many bricks, never
/// too few. Each kind of edit computes it: dependencies() (core/edits/answers/EditAnswers.h).
class RowDependencies {
public:
    /// @param written the bricks that the row changed; used for RevertRows and ReviseStroke only
    RowDependencies(const Edit& edit, const Document& document,
        const std::vector<BrickKey>& written, const RowTrace& trace = {});

    [[nodiscard]] bool covers(const BrickKey& key) const;

private:
    EditDependencies m_dependencies;
};

} // namespace core
