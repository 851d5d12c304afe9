// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/document/Measurement.h"

#include <cstddef>
#include <vector>

namespace core {

/// The points of a measurement after one of them was dragged to a place:
///
/// - The end of a distance, a point of an angle, the tip of an arrow and the place of a probe or
///   text move by themselves.
/// - The centre of a ball or an ellipse, the first corner of a rectangle and every corner of an
///   outline move the whole measurement.
/// - The other point of a ball changes its radius. The other points of an ellipse or a rectangle
///   change the length of their half axis or side, whose direction stays.
[[nodiscard]] std::vector<glm::dvec3> draggedPoints(
    const Measurement& measurement, std::size_t point, const glm::dvec3& placeLps);

} // namespace core
