// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include <cstdint>
#include <vector>

namespace core {

/// How much of each element of a mask plane a closed curve covers (seed A §4.1): a raster of values
/// 0 … 256. Element (a, b) covers [a, a + 1) × [b, b + 1) in units of elements.
///
/// The fill is exact: it is what infinitely many jittered samples would come to. A cubic B-spline
/// ([43, 170, 43] / 256 along each axis) then softens the edge, so that the 0.5 level of a straight
/// edge stays where it is and no steps show.
struct MaskRaster {
    glm::ivec2 first{0}; ///< the element of values[0]
    glm::ivec2 size{0};
    std::vector<std::uint16_t> values{}; ///< rows along a, b ascending

    [[nodiscard]] bool empty() const { return values.empty(); }
    /// 0 outside.
    [[nodiscard]] int at(const glm::ivec2& element) const
    {
        const glm::ivec2 place = element - first;
        if (place.x < 0 || place.y < 0 || place.x >= size.x || place.y >= size.y)
            return 0;
        return values[std::size_t(place.x) + std::size_t(size.x) * std::size_t(place.y)];
    }
    /// What is covered, in 256ths of an element.
    [[nodiscard]] std::int64_t area() const;
};

/// A vertex in 1/1024 elements.
using MaskVertex = glm::ivec2;
constexpr int maskSubdivision = 1024;

/// The curve through the vertices, closed from the last to the first, filled by non-zero winding.
/// In an element where parts of several windings meet, what counts is their sum, no more than all
/// of it. Cost ∝ edges and the elements of the bounding box; vertices lie within ±2²⁰ elements and
/// span at most 2¹³ elements each way. Fewer than three vertices cover nothing.
[[nodiscard]] MaskRaster filledExactly(const std::vector<MaskVertex>& vertices);

/// Its edge by the cubic B-spline; grows by one element on every side.
[[nodiscard]] MaskRaster smoothed(const MaskRaster& mask);

/// With a soft edge: values rise evenly over @p width, in 1/256 elements, from the edge inwards;
/// no value gets greater. Where the mask is narrower, over half its width, so that its middle keeps
/// its value. By exact distances between elements; cost ∝ elements.
[[nodiscard]] MaskRaster softened(const MaskRaster& mask, std::int64_t width);

} // namespace core
