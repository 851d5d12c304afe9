// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/refine/mesh/SimplexMesh.h"

namespace core {

/// How a face lies: what restructuring goes by.
struct FaceShape {
    glm::dvec3 middleLps{0.0};
    /// Of the plane that fits its vertices best (least squares), outwards; 0: it has no area.
    glm::dvec3 normalLps{0.0};
    double areaMm2 = 0.0; ///< of the fan around the middle
    glm::dvec3 longWay{0.0}; ///< unit vector along which it is longest
    double lengthMm = 0.0; ///< twice the spread along it
    double widthMm = 0.0; ///< across it, within the plane

    /// 1 for a regular one, greater the longer it is.
    [[nodiscard]] double elongation() const { return widthMm > 0.0 ? lengthMm / widthMm : 1e9; }
};
[[nodiscard]] FaceShape shapeOf(const SimplexMesh& mesh, FaceId face);

/// The area of the fan of triangles around the middle, mm².
[[nodiscard]] double areaOf(const SimplexMesh& mesh, FaceId face);
/// Half the sum of edges' cross products: the area as a vector, outwards.
[[nodiscard]] glm::dvec3 areaVectorOf(const SimplexMesh& mesh, FaceId face);
/// Whether two areas, as vectors, look the same way but for 45 degrees.
[[nodiscard]] bool lookAlike(const glm::dvec3& one, const glm::dvec3& other);

} // namespace core
