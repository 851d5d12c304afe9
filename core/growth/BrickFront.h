// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/brick/BrickGrid.h"

#include <array>
#include <cstdint>

namespace core {

/// The voxels of a brick as bits: row y + 16 z holds the 16 voxels along x, bit x that at x.
using BrickBits = std::array<std::uint16_t, BrickGrid::side * BrickGrid::side>;

/// The fronts in a brick and in its 26 neighbours; null: none there. The brick at an offset of
/// (dx, dy, dz) has the index dx + 1 + 3 (dy + 1) + 9 (dz + 1).
using FrontsAround = std::array<const BrickBits*, 27>;

/// How a growth of one label claims voxels whose criterion does not depend on their parents.
struct FrontRule {
    std::uint8_t label = 0;
    int connectivity = 6; ///< 6, 18 or 26
    bool tellsHeld = false; ///< GrowBurst::tellsHeld
};

/// The voxels of a brick that a growth writes, `BrickGrid::voxelsPerBrick` of each kind.
struct GrownVoxels {
    std::uint32_t* words = nullptr; ///< seed words
    std::uint8_t* labels = nullptr;
    std::uint8_t* overwritten = nullptr; ///< Field::Overwritten; null: not kept here
};

/// Computes one generation of a growth in one brick: every open voxel that has a neighbour in the
/// front is claimed, by the lowest direction (seedWord::offsets) that leads to it from the front.
/// The words, labels and overwritten labels of claimed voxels are those of growRing.comp, to the
/// bit. Any thread.
/// @param generation of the voxels that are claimed
/// @param open the voxels that may be claimed; those that are claimed are taken out
/// @param next receives the claimed voxels, and nothing else
/// @return the number of claimed voxels
int claimVoxels(const FrontRule& rule, std::uint32_t generation, const FrontsAround& fronts,
    BrickBits& open, BrickBits& next, const GrownVoxels& voxels);

/// The sides of a brick at which it has voxels of a set: bit 2 · axis for the lower end of an axis,
/// bit 2 · axis + 1 for the upper one.
[[nodiscard]] unsigned sidesReached(const BrickBits& bits);

} // namespace core
