// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/document/Document.h"
#include "core/growth/GrowthCommands.h"
#include "core/history/History.h"

#include <optional>
#include <vector>

namespace core {

/// The segment whose seeds an edit sets or removes, by sketching or painting; none: it does
/// neither.
[[nodiscard]] std::optional<int> segmentOfSeeds(const Edit& edit);

/// The strokes of seeds in effect at the position of the history, oldest first: for each one the
/// voxels that it named in a plane, whatever became of them.
[[nodiscard]] std::vector<SeedGroup> seedStrokes(
    const History& history, const Document& document, int plane);

/// Adds to a growth the strokes that its criteria refer to (GrowCriteria::perStroke), if they do. A
/// replay is at the same place in the same rows, so it finds the same strokes.
/// @param edit the edit from which the burst was made
void addSeedStrokes(
    GrowBurst& burst, const Edit& edit, const History& history, const Document& document);

} // namespace core
