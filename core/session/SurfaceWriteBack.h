// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/brick/VoxelRuns.h"
#include "core/growth/GrowthCommands.h"
#include "core/sculpt/LayerWrites.h"

#include <cstdint>
#include <vector>

namespace core {

/// What makes a label's voxels those that lie inside a surface: where they are others now.
/// @param labels of the label's plane, x fastest @param size of the volume
[[nodiscard]] RelabelListed writeBackOf(const VoxelRuns& inside,
    const std::vector<std::uint8_t>& labels, const glm::ivec3& size, const LabelTarget& target);

/// The voxels that are not inside but have one that is among the 26 around them: every way from
/// inside out passes one, by whatever neighbours it goes. Cost ∝ the runs, and the volume's rows.
[[nodiscard]] VoxelRuns shellAround(const VoxelRuns& inside, const glm::ivec3& size);
/// The bricks that have any of these voxels.
[[nodiscard]] std::vector<ShutListed::Brick> placesOf(
    const VoxelRuns& voxels, const glm::ivec3& size);

} // namespace core
