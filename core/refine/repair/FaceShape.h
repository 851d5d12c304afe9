// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/refine/mesh/SimplexMesh.h"

namespace core {

/// The shape and orientation of a face, on which restructuring decides.
struct FaceShape {
    glm::dvec3 middleLps{0.0};
    /// Outward normal of the plane that fits its vertices best (least squares); 0: it has no area.
    glm::dvec3 normalLps{0.0};
    double areaMm2 = 0.0; ///< of the fan around the middle
    glm::dvec3 longWay{0.0}; ///< unit vector along which the face is longest
    double lengthMm = 0.0; ///< twice the spread along it
    double widthMm = 0.0; ///< perpendicular to it, within the plane

    /// 1 for a regular face, greater for longer ones.
    [[nodiscard]] double elongation() const { return widthMm > 0.0 ? lengthMm / widthMm : 1e9; }
};
[[nodiscard]] FaceShape shapeOf(const SimplexMesh& mesh, FaceId face);

/// The area of the fan of triangles around the middle, mm².
[[nodiscard]] double areaOf(const SimplexMesh& mesh, FaceId face);
/// Half the sum of the cross products of edges: the area as an outward vector.
[[nodiscard]] glm::dvec3 areaVectorOf(const SimplexMesh& mesh, FaceId face);
/// Whether two areas, as vectors, differ in direction by at most 45 degrees.
[[nodiscard]] bool lookAlike(const glm::dvec3& one, const glm::dvec3& other);

} // namespace core
