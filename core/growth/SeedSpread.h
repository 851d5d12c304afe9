// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"
#include "core/brick/BrickGrid.h"

#include <array>
#include <bitset>
#include <cstdint>
#include <optional>

namespace core {

/// Give voxels to the segment whose seeds are nearest along the way of least cost (grow from
/// seeds), in integers. Both engines follow the rule to the bit.
///
/// Seeds: the voxels that the plane holds a label of `seeds` at, each of that label; and, where it
/// holds 0 or a label in `overwritable`, the pending seeds (SeedWord.h) of a label in `seeds`.
/// Box: the one given; else the one around all seeds, wider on every side by a twentieth of its
/// extent along the axis, rounded up, and by leastMargin voxels at least, cut at the volume. Seeds
/// outside do not take part.
/// Open: what lies in the box, is no seed and no barrier, and has 0 or a label in `overwritable` in
/// the plane. Everything else is a wall.
///
/// A path begins with a seed and goes on through open voxels, each a neighbour of the last
/// (`connectivity` as GrowBurst's). A step in seedWord direction d between codes a and b costs
///
///     |a − b| · differenceWeight + lengths[d / 2]
///
/// and a path the sum of its steps. A path whose cost would be maxCost or more leads nowhere.
/// Every open voxel that paths lead to receives the label of the least one, by (cost, label); so do
/// seeds theirs. Where a path leads nowhere, the plane stays as it is. As steps cost 1 at least,
/// the least (cost, label) of all voxels is the one fixpoint of "the least that a neighbour
/// offers": the order of work does not matter. Where the plane's label changes, a seed word that
/// bears another label becomes unvisited. With seeds of fewer than two labels there is no
/// competition, and nothing to be done.
struct SpreadLabels {
    static constexpr std::uint32_t maxCost = (1u << 24) - 1; ///< a word holds cost and label
    static constexpr int marginParts = 20;
    static constexpr int leastMargin = 3; ///< voxels

    std::uint8_t plane = 0;
    std::bitset<256> seeds{}; ///< labels, not 0
    std::bitset<256> overwritable{}; ///< labels, none in `seeds`
    std::optional<VoxelBox> box{}; ///< not empty, within the volume
    int connectivity = 6; ///< 6, 18 or 26
    std::uint32_t differenceWeight = 4; ///< 0 … 64
    std::array<std::uint32_t, 13> lengths{}; ///< 1 … 65535; see seedWord::offsets
};

/// Of an open SpreadLabels: what an engine has worked out is not to be kept for the next one. By
/// itself it may keep it beyond a rollback, so that the next works out only what differs.
struct ForgetSpread { };

/// Whether an engine may take it: connectivity and costs in their ranges, 0 in neither set, no
/// label in both, a box as it must be.
[[nodiscard]] bool isSound(const SpreadLabels& spread, const glm::ivec3& volumeSize);
[[nodiscard]] Result<void> checkSound(const SpreadLabels& spread, const BrickGrid& grid);

/// The box, from the one around all seeds.
[[nodiscard]] VoxelBox spreadBox(
    const SpreadLabels& spread, const VoxelBox& seeds, const glm::ivec3& volumeSize);

} // namespace core
