// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/kinds/parts/BrushPath.h"
#include "core/volume/VolumeGeometry.h"

#include <array>
#include <cstdint>

namespace core {

/// Where stroke coordinates lie in the patient.
struct StrokeSpace {
    glm::dvec3 middleLps{0.0};
    glm::dmat3 toStroke{1.0}; ///< turns LPS directions
    double planeMm = 0.0; ///< of a flat brush: height of its plane over the middle
    double volumeRadiusMm = 0.0; ///< a ball around the middle that holds every voxel
    double halfThicknessMm = 0.0;

    [[nodiscard]] glm::dvec3 turned(const glm::dvec3& lps) const
    {
        return toStroke * (lps - middleLps) - glm::dvec3(0.0, 0.0, planeMm);
    }
    [[nodiscard]] glm::dvec3 toLps(const glm::dvec3& inStroke) const
    {
        return middleLps + glm::transpose(toStroke) * (inStroke + glm::dvec3(0.0, 0.0, planeMm));
    }
};

/// Expects a path that capsuleFrame() accepts.
[[nodiscard]] StrokeSpace strokeSpace(const BrushPath& path, const VolumeGeometry& geometry);

/// The least distance of two voxels along an axis, mm.
[[nodiscard]] double finestSpacing(const VolumeGeometry& geometry);

/// Of a straight way in stroke coordinates, cut into pieces, those that can come within @p nearMm
/// of the middle: the first and one past the last.
[[nodiscard]] std::array<std::int64_t, 2> piecesNear(
    const glm::dvec3& from, const glm::dvec3& along, std::int64_t pieces, double nearMm);

} // namespace core
