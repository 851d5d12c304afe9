// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include <functional>
#include <vector>

namespace core {

/// Points of closed curves in a slice, in columns and rows: whole numbers of 2⁻¹⁴ of one.
struct SlicePolygon {
    static constexpr int bits = 14;
    std::vector<glm::ivec2> points;
};
/// Rounded; what lies farther out than 65536 columns or rows is brought to there.
[[nodiscard]] glm::ivec2 slicePoint(const glm::dvec2& place);

/// The voxels of a slice whose centres lie within the curves: within an odd number of them, so that
/// a curve in another one is a hole, and one that runs in and out along the same line surrounds
/// what it says. A centre on an edge is inside where the inside lies on the side of greater column,
/// or along a row on that of greater row.
/// @param span called with the row, the first column and one past the last, rows ascending
void fillPolygons(const std::vector<SlicePolygon>& polygons, const glm::ivec2& size,
    const std::function<void(int row, int from, int to)>& span);

} // namespace core
