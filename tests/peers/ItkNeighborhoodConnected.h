// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace peer {

/// itk::NeighborhoodConnectedImageFilter of radius 1, faces (6): what has all 27 voxels around it
/// within bounds, inclusive.
/// @param values x fastest
/// @return 0 or 1 a voxel
[[nodiscard]] std::vector<std::uint8_t> itkNeighborhoodConnected(const glm::ivec3& size,
    std::span<const std::uint16_t> values, std::span<const glm::ivec3> seeds, std::uint16_t lower,
    std::uint16_t upper);

} // namespace peer
