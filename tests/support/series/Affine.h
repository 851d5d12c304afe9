// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/VolumeGeometry.h"

#include <QJsonValue>

namespace test {

/// Converts an affine that a script wrote as four rows of four numbers.
[[nodiscard]] glm::dmat4 matrixFrom(const QJsonValue& rows);

/// The centre of a voxel, LPS mm, also for unevenly spaced slices.
[[nodiscard]] glm::dvec3 placeOf(const core::VolumeGeometry& geometry, const glm::ivec3& voxel);

/// The greatest distance in mm between the corners of a volume and where @p indexToWorld puts them.
[[nodiscard]] double cornerDistance(
    const glm::dmat4& indexToWorld, const core::VolumeGeometry& volume);

} // namespace test
