// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace peer {

struct ItkDistances {
    /// Of each voxel outside of the mask to the nearest one in it; of those in it 0 or less.
    std::vector<float> squared;
    double milliseconds = 0.0; ///< of the filter alone
};

/// itk::SignedMaurerDistanceMapImageFilter, in millimetres of an upright grid.
/// @param mask 0 or 1, x fastest
ItkDistances itkDistances(
    const glm::ivec3& size, const glm::dvec3& spacingMm, std::span<const std::uint8_t> mask);

} // namespace peer
