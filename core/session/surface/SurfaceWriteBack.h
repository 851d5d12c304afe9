// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/brick/VoxelRuns.h"
#include "core/growth/GrowthCommands.h"
#include "core/sculpt/labels/LayerWrites.h"
#include "core/session/surface/SurfaceAgreement.h"

#include <cstdint>
#include <vector>

namespace core {

/// How far around the voxels that a surface was moved over the mask may still change, in steps
/// between voxels (26 neighbours).
constexpr int writeBackRimVoxels = 2;

/// What writing a surface back changes of the voxels of a label: the mask follows the surface to
/// where it was moved. All numbers are integers, and the order of voxels does not matter.
///
/// - **Moved over** is a voxel that the surface encloses now and did not enclose when the two
///   agreed, or the reverse. There the mask becomes what the surface encloses.
/// - **The rim.** A surface does not enclose exactly the voxels around which it was laid: a pit of
///   one voxel may lie inside it, a bump outside. If the surface is moved away from these, they
///   would remain as bubbles under the new boundary and as crumbs above it. So a voxel in which
///   mask and surface differ also becomes what the surface encloses if one of its 26 neighbours
///   does so to the same side (both inside now, or both outside). This is repeated for the
///   neighbours of these voxels, writeBackRimVoxels times in all.
/// - **Everything else stays** as it is, whatever the surface encloses there. If the surface was
///   not moved at all, nothing changes.
///
/// What other tools wrote to the mask since also stays, unless the surface was moved over it or it
/// lies in the rim; there the surface decides. Voxels of other segments that must not be
/// overwritten stay as they are. A voxel that was moved over at any time since the surface was
/// laid, and that belongs to another segment now, is requested again if that segment may be
/// overwritten. So a second write-back that may overwrite others takes what was refused the first
/// time.
/// @param labels of the label's plane, x fastest
/// @param size of the volume
[[nodiscard]] RelabelListed writeBackOf(const EnclosedVoxels& enclosed,
    const std::vector<std::uint8_t>& labels, const glm::ivec3& size, const LabelTarget& target);

/// The voxels that are not inside but have a neighbour (26) that is: every path from inside to
/// outside passes one, whatever the connectivity. Cost ∝ the runs and the rows of their box.
[[nodiscard]] VoxelRuns shellAround(const VoxelRuns& inside, const glm::ivec3& size);
/// The bricks that contain any of these voxels.
[[nodiscard]] std::vector<BarrierListed::Brick> placesOf(
    const VoxelRuns& voxels, const glm::ivec3& size);

} // namespace core
