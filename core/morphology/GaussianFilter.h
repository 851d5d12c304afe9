// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/morphology/BallFilters.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <vector>

namespace core {

struct GridGaussian;

/// At which of its sides a box ends where the image does. There the outermost voxels go on for
/// ever, as with ITK's zero-flux Neumann condition; beyond its other sides nothing is of the mask.
struct ImageEnds {
    glm::bvec3 before{false};
    glm::bvec3 behind{false};
};

/// Voxels of a box, x fastest.
struct BoxValues {
    static constexpr std::uint16_t full = 32768; ///< of a voxel that only the mask surrounds
    static constexpr std::uint16_t half = full / 2;
    glm::ivec3 size{0};
    std::vector<std::uint16_t> values;
};

/// Memory for a mask of that size, its values and the work on them: three bytes a voxel, and what
/// is needed for single slices.
[[nodiscard]] double gaussianBytes(const glm::ivec3& size);

/// A mask blurred by a Gaussian, along x, then y, then z, in whole numbers. Along x a voxel's value
/// is (sum + 1) / 2 of the weights of the mask's voxels, since all weights are twice `full`; along
/// the others (sum + 2¹⁵) / 2¹⁶ of weight times value, both without the rest. A voxel that has only
/// the mask around it has `full`, one that has nothing of it 0.
///
/// On all cores; it asks for each row whether it was cancelled (Cancelled). Cost ∝ voxels of the
/// box × weights along y and z, and × runs of the mask along x. Any thread that is no
/// parallelFor's.
[[nodiscard]] Result<BoxValues> blurred(const ByteMask& mask, const GridGaussian& gaussian,
    const ImageEnds& ends, const FilterStage& stage);

} // namespace core
