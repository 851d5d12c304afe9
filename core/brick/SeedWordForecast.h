// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/brick/BrickGrid.h"

#include <array>
#include <cstdint>

namespace core {

/// The differences (XOR) of a brick of seed words, voxel by voxel.
using WordDifferences = std::array<std::uint32_t, BrickGrid::voxelsPerBrick>;

// Generations are distances from the seeds, so neighbours all but tell them; what is left
// compresses well. Where a difference makes a member of a voxel that was none (bit 31), its 18 bits
// of generation are replaced by how far the generation is from the forecast, folded (0, −1, 1, −2 …
// become 0, 1, 2, 3 …). Everything else stays.
//
// The forecast for a voxel at (x, y, z), from voxels of the same brick that became members too:
// 1. the neighbour one lower along the axis of its direction, if there is one: that one's
// generation
//    + 1 where it is the parent (even directions), − 1 where the parent lies on the other side;
// 2. else, from the neighbours a, b, c one lower in x, y, z, and ab one lower in x and y …:
//    a + b + c − ab − ac − bc + abc if all are there; a + b − ab, a + c − ac, b + c − bc, a, b, c,
//    whichever comes first with all it needs;
// 3. else the member before it in the order of voxels; 0 if there is none.
// Modulo 2¹⁸ throughout.
[[nodiscard]] WordDifferences withForecast(const WordDifferences& differences);
[[nodiscard]] WordDifferences withoutForecast(const WordDifferences& forecast);

} // namespace core
