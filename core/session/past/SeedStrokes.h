// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/document/Document.h"
#include "core/growth/GrowthCommands.h"
#include "core/history/History.h"

#include <optional>
#include <vector>

namespace core {

/// The segment whose seeds an edit sets, or takes away: sketched, or painted; none: of no segment.
[[nodiscard]] std::optional<int> segmentOfSeeds(const Edit& edit);

/// The strokes of seeds that stand where the history is, oldest first: for each the voxels that it
/// named in a plane, whatever became of them.
[[nodiscard]] std::vector<SeedGroup> seedStrokes(
    const History& history, const Document& document, int plane);

/// Gives a growth the strokes that it goes by (GrowCriteria::perStroke), if it asks for any. Replay
/// stands at the same place of the same rows, and so finds the same.
/// @param edit what the burst was made of
void addSeedStrokes(
    GrowBurst& burst, const Edit& edit, const History& history, const Document& document);

} // namespace core
