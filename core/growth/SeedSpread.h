// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"
#include "core/brick/BrickGrid.h"
#include "core/growth/GrowthRange.h"

#include <array>
#include <bitset>
#include <cstdint>
#include <optional>

namespace core {

/// Grow from seeds: give each voxel to the segment whose seeds are nearest along a path of least
/// cost. All numbers are integers, and both engines follow this rule exactly.
///
/// Seeds: every voxel at which the plane holds a label of `seeds` is a seed of that label. Where
///   the plane holds 0 or a label in `overwritable`, pending seeds (SeedWord.h) of a label in
///   `seeds` are seeds too, in `within` and among the voxels of `range`.
/// Box: the given one. Otherwise it is the bounding box of all seeds, enlarged on every side by a
///   twentieth of its extent along that axis, rounded up, and by at least leastMargin voxels, and
///   clipped to the volume. Seeds outside the box take no part.
/// Open voxels: those in the box, in `within` and among the voxels of `range` that are no seed and
///   no barrier and at which the plane holds 0 or a label in `overwritable`. Everything else is a
///   wall. What the range closes is asked of the label that the plane holds now, also where growth
///   has added it.
/// Paths: a path begins with a seed and continues through open voxels, each a neighbour of the one
///   before (`connectivity` as in GrowBurst). A step in seedWord direction d between codes a and b
///   costs
///
///       |a − b| · differenceWeight + lengths[d / 2]
///
///   and a path costs the sum of its steps. A path that would cost maxCost or more does not exist.
/// Result: every open voxel to which paths lead receives the label of the path that is least by
///   (cost, label), and seeds receive their own label. Elsewhere the plane stays as it is. Where
///   the plane's label changes, a seed word that has another label becomes unvisited.
///
/// As each step costs at least 1, the least (cost, label) of all voxels is the unique fixpoint of
/// "the least that a neighbour offers", so the order of work does not matter. The command is
/// refused (InvalidField) if fewer than two labels have seeds, since nothing would compete.
struct SpreadLabels {
    static constexpr std::uint32_t maxCost = (1u << 24) - 1; ///< a word holds cost and label
    static constexpr int marginParts = 20;
    static constexpr int leastMargin = 3; ///< voxels

    std::uint8_t plane = 0;
    std::bitset<256> seeds{}; ///< labels, not 0
    std::bitset<256> overwritable{}; ///< labels, none of them in `seeds`
    GrowthRange range{};
    std::optional<VoxelBox> within{}; ///< which voxels may change; none: all
    std::optional<VoxelBox> box{}; ///< not empty, within the volume
    int connectivity = 6; ///< 6, 18 or 26
    std::uint32_t differenceWeight = 4; ///< 0 … 64
    std::array<std::uint32_t, 13> lengths{}; ///< 1 … 65535; see seedWord::offsets
};

/// For an open SpreadLabels: the engine shall not keep its intermediate results for the next one.
/// Otherwise it may keep them beyond a rollback, so that the next one computes only what differs.
struct ForgetSpread { };

/// Whether an engine may accept it: connectivity and costs are in range, 0 is in neither set, no
/// label is in both, and the box is not empty and within the volume.
[[nodiscard]] bool isSound(const SpreadLabels& spread, const glm::ivec3& volumeSize);

[[nodiscard]] Result<void> checkSound(const SpreadLabels& spread, const BrickGrid& grid);

/// The box of the rule above, from the bounding box of all seeds.
[[nodiscard]] VoxelBox spreadBox(
    const SpreadLabels& spread, const VoxelBox& seeds, const glm::ivec3& volumeSize);

} // namespace core
