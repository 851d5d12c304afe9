// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/history/History.h"

#include <QString>

#include <cstdint>
#include <vector>

namespace core {
class EditSession;
struct Volume;
} // namespace core

namespace ui {

/// Returns a line about the state of a growth: its generation and what its last step did:
/// "Generation 12 · added 3.4 mL".
/// @param row the last step; null: none is shown, since a growth is under way or nothing was done
/// @param volume in which it grows
[[nodiscard]] QString generationText(
    std::uint32_t generation, const core::HistoryRow* row, const core::Volume& volume);

/// The same for the growth of a session in a label plane. While one runs, the line states the size
/// of its front instead.
/// @param fronts sizes of its fronts in voxels, by generation
[[nodiscard]] QString generationText(
    const core::EditSession& session, std::uint8_t plane, const std::vector<std::uint32_t>& fronts);

} // namespace ui
