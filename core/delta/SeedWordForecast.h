// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/brick/BrickMask.h"

#include <glm/glm.hpp>

#include <vector>

namespace core {

/// The differences (XOR) of a brick of seed words.
struct SeedWordBrick {
    BrickKey key;
    std::array<std::uint32_t, BrickGrid::voxelsPerBrick> differences{};
    BrickMask foretold; ///< voxels whose generation and direction the others tell
};

// A growth follows from where it began: of a voxel that it took, generation and direction are told
// by its neighbours (core/growth/SeedWord.h), so of most only the label need be kept.
//
// A difference with bit 31 is a claim: its other bits are those of a member, inverted, since the
// voxel was unvisited before (or is so after). Where its lowest 13 bits are 0 a pending seed was
// admitted: then they are those of the member as they are, and its label is any.
// A claim that admits no seed is foretold if of its face neighbours in the same plane that are
// claims too, and of the same label or any, the earliest has its generation − 1, and the lowest
// direction from which one as early leads to it is its own.

/// Fills `foretold`. Linear in the voxels.
/// @param bricks no key twice @param along bricks of the volume along x and y
void markForetold(std::vector<SeedWordBrick>& bricks, const glm::ivec2& along);

/// The reverse: differences of foretold voxels come as foretoldDifference() and are completed, ring
/// by ring from those that are not foretold.
/// @pre foretold voxels hold a foretoldDifference(); along is at least 1 each
/// @return false: some are not told by the others
[[nodiscard]] bool completeForetold(std::vector<SeedWordBrick>& bricks, const glm::ivec2& along);

/// A claim of a label, without generation and direction.
[[nodiscard]] std::uint32_t foretoldDifference(std::uint8_t label);
[[nodiscard]] std::uint8_t labelOfDifference(std::uint32_t difference);

} // namespace core
