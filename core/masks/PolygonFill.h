// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include <cstdint>
#include <functional>
#include <vector>

namespace core {

/// Points of closed curves in a slice, in columns and rows: integers in units of 2⁻¹⁴.
struct SlicePolygon {
    static constexpr int bits = 14;
    std::vector<glm::ivec2> points;
};
/// Rounds a point; coordinates are limited to ±65536 columns or rows.
[[nodiscard]] glm::ivec2 slicePoint(const glm::dvec2& place);

/// The voxels of a slice whose centres lie within an odd number of curves, so that a curve inside
/// another one is a hole, and a curve that goes in and out along the same line encloses what is
/// intended. A centre on an edge is inside if the inside is on the side of the greater column, or,
/// along a row, of the greater row.
/// @param span called with the row, the first column and one past the last, rows ascending
void fillPolygons(const std::vector<SlicePolygon>& polygons, const glm::ivec2& size,
    const std::function<void(int row, int from, int to)>& span);

/// How many such centres there are, also beyond the slice: on up to 4096 columns and rows around
/// it.
[[nodiscard]] std::uint64_t surroundedPixels(
    const std::vector<SlicePolygon>& polygons, const glm::ivec2& size);

} // namespace core
