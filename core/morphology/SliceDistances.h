// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/brick/SliceAxis.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace core {

struct VolumeGeometry;

/// A mask of the pixels of a rectangle in a slice, x fastest: 1 or 0.
struct SliceMask {
    glm::ivec2 size{0};
    std::vector<std::uint8_t> pixels{};

    [[nodiscard]] std::size_t indexOf(const glm::ivec2& at) const
    {
        return std::size_t(at.y) * std::size_t(size.x) + std::size_t(at.x);
    }
};

/// Squared lengths of one step along a row and along a column of a slice, in whole numbers.
/// Millimetres become integers once, in sliceSteps(): the unit is the power of two that keeps every
/// squared length in a rectangle of three times the slice below 2⁶⁰. Rows and columns are taken as
/// perpendicular; they are not in slices across I or J if the gantry was tilted.
struct SliceSteps {
    std::int64_t xx = 1;
    std::int64_t yy = 1;

    [[nodiscard]] std::int64_t squared(const glm::ivec2& step) const
    {
        return xx * step.x * step.x + yy * step.y * step.y;
    }
};
[[nodiscard]] SliceSteps sliceSteps(const VolumeGeometry& geometry, SliceAxis axis);

/// The squared distance of each pixel to the border of a mask: inside the mask, to the nearest
/// pixel outside it; outside, the negative squared distance to the nearest pixel inside. Exact.
/// Cost ∝ pixels.
/// @pre the mask has pixels, and none along its border
[[nodiscard]] std::vector<std::int64_t> signedSquares(
    const SliceMask& mask, const SliceSteps& steps);

} // namespace core
