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

/// What the history says of growth at its present position. It is asked many times per second while
/// a growth is watched, and answering takes a walk through the history. So the answer is kept until
/// the position changes; what led to a position never changes.
class GrowthPast {
public:
    struct Known {
        int seeds = 0; ///< sketchedSeeds()
        std::optional<core::GrowCriteria> criteria{}; ///< core::recentCriteria()
        std::bitset<256> growing; ///< core::growingSegments()
    };

    [[nodiscard]] const Known& of(const core::EditSession& session);
    /// To be called when another session is opened.
    void clear() { m_position.reset(); }

private:
    std::optional<core::RowId> m_position;
    Known m_known;
};

} // namespace ui
