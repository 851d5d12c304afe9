// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/brick/BrickGrid.h"
#include "gpu/gl/Texture3D.h"

#include <cstdint>
#include <span>
#include <vector>

namespace gpu {

// Moves bricks between dense textures and memory without a kernel, which is the faster way with a
// software driver. A brick in memory has BrickGrid::voxelsPerBrick voxels, x fastest; those outside
// the volume are 0. Engine thread only; waits for the GPU.

/// @param texture of the volume, a byte per voxel
void readDense(const Texture3D& texture, const core::BrickGrid& grid, std::uint32_t brick,
    std::span<std::uint8_t> voxels);
void writeDense(const Texture3D& texture, const core::BrickGrid& grid, std::uint32_t brick,
    std::span<const std::uint8_t> voxels);

/// The codes of each of the bricks.
/// @param bricks ascending
[[nodiscard]] std::vector<std::vector<std::uint16_t>> readCodes(
    const Texture3D& codes, const core::BrickGrid& grid, std::span<const std::uint32_t> bricks);

} // namespace gpu
