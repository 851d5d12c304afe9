// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/brick/BrickBits.h"

#include <glm/glm.hpp>

#include <vector>

namespace core {

/// The differences (XOR) of a brick of seed words.
struct SeedWordBrick {
    BrickKey key;
    std::array<std::uint32_t, BrickGrid::voxelsPerBrick> differences{};
    BrickBits predicted; ///< voxels whose generation and direction follow from the others
};

// Most of a growth follows from where it began: generation and direction of a voxel that it claimed
// can be derived from its neighbours (core/growth/SeedWord.h), so only the label need be kept.
//
// A difference with bit 31 set is a claim. Its other bits are those of a member, inverted, since
// the voxel was unvisited before (or is unvisited after). If its lowest 13 bits are 0, a pending
// seed was admitted; then the other bits are those of the member as they are, and its label is
// unknown.
// A claim that admits no seed is predicted if, among those of its face neighbours in the same plane
// that are claims of the same or of an unknown label, the earliest has its generation − 1, and if
// its own direction is the lowest one that leads to it from a neighbour of that generation.

/// Fills `predicted`. Cost: linear in the voxels.
/// @param bricks no key twice
/// @param along number of bricks of the volume along x and y
void markPredicted(std::vector<SeedWordBrick>& bricks, const glm::ivec2& along);

/// The reverse: completes the differences of predicted voxels ring by ring, beginning at those that
/// are not predicted.
/// @pre predicted voxels hold a predictedDifference(); each component of along is at least 1
/// @return false: some do not follow from the others
[[nodiscard]] bool completePredicted(std::vector<SeedWordBrick>& bricks, const glm::ivec2& along);

/// A claim of a label, without generation and direction.
[[nodiscard]] std::uint32_t predictedDifference(std::uint8_t label);
[[nodiscard]] std::uint8_t labelOfDifference(std::uint32_t difference);

} // namespace core
