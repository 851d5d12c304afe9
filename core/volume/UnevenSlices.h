// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/VolumeGeometry.h"

namespace core {

/// How thick each slice counts, mm: half the way to either neighbour; the outermost as if the next
/// were as far beyond.
[[nodiscard]] std::vector<double> sliceThicknessesMm(const VolumeGeometry& geometry);

/// LPS mm. Between uneven slices along the line from one to the next, beyond the last as before it.
[[nodiscard]] glm::dvec3 worldBetweenSlices(
    const VolumeGeometry& geometry, const glm::dvec3& index);

} // namespace core
