// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/morphology/BallFilters.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <vector>

namespace core {

struct GridGaussian;

/// At which of its sides a box ends together with the image. There the outermost voxels are
/// continued for ever, as with ITK's zero-flux Neumann condition. Beyond its other sides there is
/// nothing of the mask.
struct ImageEnds {
    glm::bvec3 before{false};
    glm::bvec3 behind{false};
};

/// Values of the voxels of a box, x fastest.
struct BoxValues {
    /// Value of a voxel that has only voxels of the mask around it.
    static constexpr std::uint16_t full = 32768;
    static constexpr std::uint16_t half = full / 2;
    glm::ivec3 size{0};
    std::vector<std::uint16_t> values;
};

/// Memory for a mask of this size, its values and the work on them: three bytes per voxel, and what
/// is needed for single slices.
[[nodiscard]] double gaussianBytes(const glm::ivec3& size);

/// Blurs a mask by a Gaussian, along x, then y, then z, in whole numbers. Along x a voxel's value
/// is (sum + 1) / 2, where sum adds up the weights of the mask's voxels, because all weights
/// together are twice `full`. Along y and z it is (sum + 2¹⁵) / 2¹⁶ of weight times value. Both are
/// rounded down. A voxel with only the mask around it gets `full`, one without any of it 0.
///
/// On all cores; for each row it checks whether it was cancelled (Cancelled). Cost ∝ voxels of the
/// box × weights along y and z, and × runs of the mask along x. Any thread outside a parallelFor().
[[nodiscard]] Result<BoxValues> blurred(const ByteMask& mask, const GridGaussian& gaussian,
    const ImageEnds& ends, const FilterStage& stage);

} // namespace core
