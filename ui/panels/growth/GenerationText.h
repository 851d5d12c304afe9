// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/history/History.h"

#include <QString>

#include <cstdint>
#include <vector>

namespace core {
class EditSession;
}

namespace ui {

/// Where a growth stands, and what its last row did: "Generation 12 · added 3.4 ml".
/// @param row the last one; null: a growth is under way, or nothing was done
[[nodiscard]] QString generationText(
    std::uint32_t generation, const core::HistoryRow* row, double voxelMm3);

/// The same for the growth of a session; while it goes on also the size of its front.
/// @param fronts sizes of its fronts, by generation
[[nodiscard]] QString generationText(
    const core::EditSession& session, const std::vector<std::uint32_t>& fronts);

} // namespace ui
