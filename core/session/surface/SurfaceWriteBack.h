// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/brick/VoxelRuns.h"
#include "core/growth/GrowthCommands.h"
#include "core/sculpt/LayerWrites.h"
#include "core/session/surface/SurfaceAgreement.h"

#include <cstdint>
#include <vector>

namespace core {

/// How far around what a surface was moved over the mask may still change, in voxels along any of
/// the 26 ways.
constexpr int writeBackRimVoxels = 2;

/// What writing a surface back asks of the voxels of a label: to follow the surface to where it was
/// moved. All in whole numbers; no order of voxels matters.
///
/// - **Moved over** is a voxel that the surface encloses now and did not when the two agreed, or
///   the other way round. There the mask becomes what the surface encloses.
/// - **The rim.** A surface encloses not quite the voxels that it was laid around: a pit of one
///   voxel may lie inside of it, a bump outside. Where the surface is moved away from these, they
///   would be left as bubbles under the new boundary and crumbs above it. So a voxel in which mask
///   and surface differ becomes what the surface encloses, too, if one of the 26 around it does so
///   to the same side (both inside now, or both outside); again for those around that, and so on,
///   writeBackRimVoxels times.
/// - **All else stays**, to the voxel, whatever the surface encloses there. Where it was not moved
///   at all, nothing is asked.
///
/// What other tools wrote to the mask since stays likewise, unless the surface was moved over it or
/// it lies in the rim; there the surface has the last word. Voxels of other segments that are not
/// to be overwritten stay as they are. One that was moved over at any time since the surface was
/// laid, and is another segment's now, is asked for again where that may be overwritten, so that
/// writing back a second time, over others, takes what was refused the first time.
/// @param labels of the label's plane, x fastest @param size of the volume
[[nodiscard]] RelabelListed writeBackOf(const EnclosedVoxels& enclosed,
    const std::vector<std::uint8_t>& labels, const glm::ivec3& size, const LabelTarget& target);

/// The voxels that are not inside but have one that is among the 26 around them: every way from
/// inside out passes one, by whatever neighbours it goes. Cost ∝ the runs, and the volume's rows.
[[nodiscard]] VoxelRuns shellAround(const VoxelRuns& inside, const glm::ivec3& size);
/// The bricks that have any of these voxels.
[[nodiscard]] std::vector<ShutListed::Brick> placesOf(
    const VoxelRuns& voxels, const glm::ivec3& size);

} // namespace core
