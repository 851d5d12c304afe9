// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/kinds/criteria/GrowCriteria.h"
#include "core/history/History.h"

#include <bitset>
#include <cstdint>
#include <optional>
#include <utility>

namespace core {
class EditSession;
}

namespace ui {

/// What the history says of the growth of a label plane at its present position. It is asked many
/// times per second while a growth is watched, and answering takes a walk through the history. So
/// the answer is kept until the position or the plane changes; what led to a position never
/// changes.
class GrowthPast {
public:
    struct Known {
        int seeds = 0; ///< sketchedSeeds()
        std::optional<core::GrowCriteria> criteria{}; ///< core::recentCriteria()
        std::bitset<256> growing; ///< core::growingSegments()
        std::bitset<256> grown; ///< core::grownIn()
        core::RowId barriers = 0; ///< core::lastBarrierRow()
    };

    [[nodiscard]] const Known& of(const core::EditSession& session, std::uint8_t plane);
    /// To be called when another session is opened.
    void clear() { m_asked.reset(); }

private:
    std::optional<std::pair<core::RowId, std::uint8_t>> m_asked; ///< position and plane
    Known m_known;
};

} // namespace ui
