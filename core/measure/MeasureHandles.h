// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/document/Measurement.h"

#include <cstddef>
#include <vector>

namespace core {

/// The points of a measurement after one of them was dragged to a place:
///
/// - an end, a vertex, a tip or a place alone moves;
/// - the centre of a ball or an ellipse and the first corner of a rectangle take all along, and so
///   does any corner of an outline;
/// - another point of a ball changes its radius; of an ellipse or a rectangle it changes the length
///   of its half axis or side, whose direction stays.
[[nodiscard]] std::vector<glm::dvec3> draggedPoints(
    const Measurement& measurement, std::size_t point, const glm::dvec3& placeLps);

} // namespace core
