// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include <vector>

namespace core {

/// The greatest distance between two of the points; 0 of fewer than two.
///
/// It is exact: the same number that a comparison of every point with every other finds. Boxes of
/// points are compared instead, and pairs of boxes that cannot hold a longer distance than one
/// already found are passed over. For n points of a surface that costs about n log n; of a ball,
/// where all opposite points are nearly equally far apart, it costs most.
[[nodiscard]] double longestDistance(std::vector<glm::dvec3> points);

} // namespace core
