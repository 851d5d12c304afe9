// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/brick/VoxelRuns.h"
#include "core/sculpt/LayerWrites.h"

#include <cstdint>
#include <vector>

namespace core {

/// What makes a label's voxels those that lie inside a surface: where they are others now.
/// @param labels of the label's plane, x fastest @param size of the volume
[[nodiscard]] RelabelListed writeBackOf(const VoxelRuns& inside,
    const std::vector<std::uint8_t>& labels, const glm::ivec3& size, const LabelTarget& target);

} // namespace core
