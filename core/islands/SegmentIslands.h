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

/// What is to be done about the parts of a segment that do not belong together. Islands are its
/// parts that do not touch each other, not even at a corner (26 neighbours); holes are what it
/// surrounds on all sides so that no way of faces (6 neighbours) leads out. A hole is never at the
/// border of the volume.
enum class IslandRule : std::uint8_t {
    FillHoles, ///< holes of at most so many voxels become the segment's
    KeepLargest, ///< all islands but the largest go; of equal ones the first in memory stays
    RemoveSmall, ///< islands of fewer voxels go
    KeepClicked, ///< all islands but one that is pointed at go
    RemoveClicked, ///< that one goes
    GiveClicked, ///< that one becomes another segment's
};

/// Whether the rule is about one island, which is told by one of its voxels.
[[nodiscard]] constexpr bool isOfClicked(IslandRule rule)
{
    return rule == IslandRule::KeepClicked || rule == IslandRule::RemoveClicked
        || rule == IslandRule::GiveClicked;
}

/// The voxels that a rule gives to a segment, or takes from it.
struct IslandChange {
    VoxelRuns voxels;
    std::int64_t parts = 0; ///< holes or islands
};

/// The voxels of a segment's islands or holes that a rule is about. What lies in a hole and is
/// another segment's counts as the hole's, too; whether it is taken is the caller's rule. Cost: two
/// passes over the volume, and memory ∝ the runs of voxels along x. Any thread. Errors: Cancelled.
/// @param labels of the whole volume in the segment's plane, x fastest
/// @param voxels for FillHoles the most that a hole has, for RemoveSmall the least that an island
/// keeps; the others do not ask
/// @param clicked of the rules about one island: the index in @p labels of a voxel of it; where
/// that voxel is not the label's, no voxel is meant
[[nodiscard]] Result<IslandChange> islandChange(std::span<const std::uint8_t> labels,
    const glm::ivec3& size, std::uint8_t label, IslandRule rule, std::int64_t voxels,
    const Progress& progress, std::size_t clicked = 0);

/// How many voxels each island of a segment has, from the largest down. Cost and memory as of
/// islandChange(). Any thread. Errors: Cancelled.
/// @param labels of the whole volume in the segment's plane, x fastest
[[nodiscard]] Result<std::vector<std::int64_t>> islandSizes(std::span<const std::uint8_t> labels,
    const glm::ivec3& size, std::uint8_t label, const Progress& progress);

/// The islands of a segment beside its largest one.
struct FurtherIslands {
    /// From the largest down; of equal ones the first in memory comes first.
    std::vector<VoxelRuns> islands;
    std::int64_t count = 0; ///< how many there are, also those that are not listed
};

/// The largest is the one that IslandRule::KeepLargest keeps. Cost and memory as of islandChange().
/// Any thread. Errors: Cancelled.
/// @param labels of the whole volume in the segment's plane, x fastest
/// @param least islands of fewer voxels do not count
/// @param most so many are listed
[[nodiscard]] Result<FurtherIslands> furtherIslands(std::span<const std::uint8_t> labels,
    const glm::ivec3& size, std::uint8_t label, std::int64_t least, std::size_t most,
    const Progress& progress);

} // namespace core
