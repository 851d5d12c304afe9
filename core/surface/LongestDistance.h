// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include <vector>

namespace core {

/// The greatest distance between two of the points; 0 of fewer than two.
///
/// It is exact: the same number that a comparison of every point with every other finds. Boxes of
/// points are compared instead, and pairs of boxes that cannot hold a longer distance than one
/// already found are passed over. The surface of a ball of voxels with 270 000 points takes 0.4 s.
/// The worst are points of an exact sphere, where all opposite ones are equally far apart and
/// little can be passed over: 300 000 take 2.6 s, a million 15 s.
[[nodiscard]] double longestDistance(std::vector<glm::dvec3> points);

} // namespace core
