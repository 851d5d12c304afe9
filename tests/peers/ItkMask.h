// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace peer {

/// A mask of 0 and 1 on an upright grid, x fastest, which a filter is given.
struct GridMask {
    glm::ivec3 size{0};
    glm::dvec3 spacingMm{1.0};
    std::span<const std::uint8_t> voxels{};
};

/// What filters made of it, 0 or 1 a voxel.
struct ItkMask {
    std::vector<std::uint8_t> voxels;
    double milliseconds = 0.0; ///< of the filters alone
};

} // namespace peer
