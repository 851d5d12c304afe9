// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/VolumeGeometry.h"

namespace core {

/// The thickness that each slice counts for, mm: half the distance to either neighbour; the
/// outermost as if the next slice were equally far on the other side.
[[nodiscard]] std::vector<double> sliceThicknessesMm(const VolumeGeometry& geometry);

/// LPS mm of an index position. Between uneven slices it lies on the line from one to the next;
/// beyond the last slice it continues as before it.
[[nodiscard]] glm::dvec3 worldBetweenSlices(
    const VolumeGeometry& geometry, const glm::dvec3& index);

} // namespace core
