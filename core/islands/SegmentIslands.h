// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Progress.h"
#include "core/base/Result.h"
#include "core/brick/VoxelRuns.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace core {

/// What is to be done with islands or holes of a segment. Islands are parts of the segment that do
/// not touch each other, not even at a corner (26 neighbours). Holes are regions outside the
/// segment that it encloses on all sides, so that no path over faces (6 neighbours) leads out of
/// them. A region that touches the border of the volume is no hole.
enum class IslandRule : std::uint8_t {
    FillHoles, ///< the segment receives holes of at most a given number of voxels
    KeepLargest, ///< only the largest island stays; of equally large ones the first in memory
    RemoveSmall, ///< islands of fewer than a given number of voxels are removed
    KeepClicked, ///< only one island stays, which the user points at
    RemoveClicked, ///< the island that the user points at is removed
    GiveClicked, ///< another segment receives that island
};

/// Whether the rule is about a single island, which is chosen by one of its voxels.
[[nodiscard]] constexpr bool isOfClicked(IslandRule rule)
{
    return rule == IslandRule::KeepClicked || rule == IslandRule::RemoveClicked
        || rule == IslandRule::GiveClicked;
}

/// The voxels that change their label by a rule.
struct IslandChange {
    VoxelRuns voxels;
    std::int64_t parts = 0; ///< number of holes or islands
};

/// Finds the voxels of a segment's islands or holes that a rule is about. Voxels of other segments
/// inside a hole count as part of it; whether they are taken is left to the caller. Cost: two
/// passes over the volume, and memory ∝ the runs of voxels along x. Any thread outside a
/// parallelFor(). Errors: Cancelled.
/// @param labels one for each voxel of the volume in the segment's plane, x fastest
/// @param voxels for FillHoles, the greatest number of voxels of a hole; for RemoveSmall, the least
/// number of an island that stays; not used by other rules
/// @param clicked for rules about a single island, the index in @p labels of one of its voxels; if
/// that voxel does not have the label, the result is empty
[[nodiscard]] Result<IslandChange> islandChange(std::span<const std::uint8_t> labels,
    const glm::ivec3& size, std::uint8_t label, IslandRule rule, std::int64_t voxels,
    const Progress& progress, std::size_t clicked = 0);

/// The number of voxels of each island of a segment, in descending order. Cost and memory as for
/// islandChange(). Any thread outside a parallelFor(). Errors: Cancelled.
/// @param labels one for each voxel of the volume in the segment's plane, x fastest
[[nodiscard]] Result<std::vector<std::int64_t>> islandSizes(std::span<const std::uint8_t> labels,
    const glm::ivec3& size, std::uint8_t label, const Progress& progress);

/// The islands of a segment except its largest one.
struct FurtherIslands {
    /// In descending order of size; equally large ones in the order of memory.
    std::vector<VoxelRuns> islands;
    std::int64_t count = 0; ///< number of islands, including those that are not listed
};

/// Finds them; the largest island is the one that IslandRule::KeepLargest keeps. Cost and memory as
/// for islandChange(). Any thread outside a parallelFor(). Errors: Cancelled.
/// @param labels one for each voxel of the volume in the segment's plane, x fastest
/// @param least islands of fewer voxels are ignored
/// @param most the greatest number of islands that are listed
[[nodiscard]] Result<FurtherIslands> furtherIslands(std::span<const std::uint8_t> labels,
    const glm::ivec3& size, std::uint8_t label, std::int64_t least, std::size_t most,
    const Progress& progress);

} // namespace core
