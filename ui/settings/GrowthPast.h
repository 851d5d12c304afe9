// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/kinds/growth/GrowCriteria.h"
#include "core/history/History.h"

#include <bitset>
#include <optional>

namespace core {
class EditSession;
}

namespace ui {

/// What the history says of growth at its position. It is asked again and again while a growth is
/// watched, and answering costs a walk through the history: so the answer is kept until the
/// position is another one. What lies before a position never changes.
class GrowthPast {
public:
    struct Known {
        int seeds = 0; ///< sketchedSeeds()
        std::optional<core::GrowCriteria> criteria{}; ///< core::recentCriteria()
        std::bitset<256> growing; ///< core::growingSegments()
    };

    [[nodiscard]] const Known& of(const core::EditSession& session);
    /// For another session.
    void clear() { m_position.reset(); }

private:
    std::optional<core::RowId> m_position;
    Known m_known;
};

} // namespace ui
