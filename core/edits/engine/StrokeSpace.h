// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/kinds/parts/BrushPath.h"
#include "core/volume/VolumeGeometry.h"

#include <array>
#include <cstdint>

namespace core {

/// How stroke coordinates (CapsuleSweep.h), here in millimetres, lie in the patient.
struct StrokeSpace {
    glm::dvec3 middleLps{0.0};
    glm::dmat3 toStroke{1.0}; ///< rotates LPS directions into stroke coordinates
    /// For a flat brush, the signed distance of its plane from middleLps, along the normal.
    double planeMm = 0.0;
    double volumeRadiusMm = 0.0; ///< radius of a ball around middleLps that contains the volume
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

/// The stroke space of a path.
/// @pre capsuleFrame() accepts the path
[[nodiscard]] StrokeSpace strokeSpace(const BrushPath& path, const VolumeGeometry& geometry);

/// The smallest spacing of the volume, mm.
[[nodiscard]] double finestSpacing(const VolumeGeometry& geometry);

/// Divides a straight path in stroke coordinates into `pieces` equal parts and returns the range of
/// parts that may come within @p nearMm of the origin: the first, and one past the last. It may
/// contain one part too many at each end. An empty range: none does.
/// @param from where the path begins, mm
/// @param along from its beginning to its end, mm
[[nodiscard]] std::array<std::int64_t, 2> piecesNear(
    const glm::dvec3& from, const glm::dvec3& along, std::int64_t pieces, double nearMm);

} // namespace core
