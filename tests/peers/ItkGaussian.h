// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace peer {

struct ItkGaussian {
    std::vector<float> values; ///< of each voxel, from 0 to 1
    double milliseconds = 0.0;
};

/// A mask of 0 and 1 blurred with ITK's DiscreteGaussianImageFilter, whose kernel is the discrete
/// analogue of a Gaussian (modified Bessel functions), ends at a hundred-thousandth and continues
/// the image's border.
[[nodiscard]] ItkGaussian itkGaussian(const glm::ivec3& size, const glm::dvec3& spacingMm,
    std::span<const std::uint8_t> mask, double sigmaMm);

} // namespace peer
