// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/brick/BrickGrid.h"

#include <cstdint>
#include <span>

namespace core {

/// The box around the voxels of a label; empty if there is none.
/// @param labels of the whole volume, x fastest
[[nodiscard]] VoxelBox boxOfLabel(
    std::span<const std::uint8_t> labels, const glm::ivec3& size, std::uint8_t label);

} // namespace core
