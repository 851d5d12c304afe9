// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include <cstdint>
#include <vector>

namespace core {

/// How much of each element of a mask plane a closed curve covers (seed A §4.1), as a raster of
/// values 0 … 256. Element (a, b) covers [a, a + 1) × [b, b + 1) in units of elements.
///
/// The fill is exact: it is the limit of infinitely many jittered samples. A cubic B-spline
/// ([43, 170, 43] / 256 along each axis) then smooths the edge, so that the 0.5 level of a straight
/// edge stays in place and no steps are visible.
struct OutlineRaster {
    glm::ivec2 first{0}; ///< the element of values[0]
    glm::ivec2 size{0};
    std::vector<std::uint16_t> values{}; ///< rows along a, b ascending

    [[nodiscard]] bool empty() const { return values.empty(); }
    /// The value of an element; 0 outside the raster.
    [[nodiscard]] int at(const glm::ivec2& element) const
    {
        const glm::ivec2 place = element - first;
        if (place.x < 0 || place.y < 0 || place.x >= size.x || place.y >= size.y)
            return 0;
        return values[std::size_t(place.x) + std::size_t(size.x) * std::size_t(place.y)];
    }
    /// The covered area in 256ths of an element.
    [[nodiscard]] std::int64_t area() const;
};

/// A vertex in 1/1024 elements.
using OutlineVertex = glm::ivec2;
constexpr int outlineSubdivision = 1024;

/// The area inside the polygon through the vertices, closed from the last to the first, by the
/// non-zero winding rule. In an element in which parts of different winding numbers meet, their
/// areas are added, up to the whole element. The cost is that of the edges and of the elements of
/// the bounding box. Vertices lie within ±2²⁰ elements and span at most 2¹³ elements in each
/// direction. Fewer than three vertices cover nothing.
[[nodiscard]] OutlineRaster filledExactly(const std::vector<OutlineVertex>& vertices);

/// The mask with its edge smoothed by the cubic B-spline; it is one element larger on every side.
[[nodiscard]] OutlineRaster smoothed(const OutlineRaster& mask);

/// The mask with a soft edge: values rise evenly over @p width, in 1/256 elements, from the edge
/// inwards, and no value increases. A mask that is narrower rises over half its width, so that its
/// middle keeps its value. Distances between elements are exact; cost ∝ elements.
[[nodiscard]] OutlineRaster softened(const OutlineRaster& mask, std::int64_t width);

} // namespace core
