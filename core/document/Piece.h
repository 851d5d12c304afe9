// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/VolumeGeometry.h"

#include <QString>

#include <glm/glm.hpp>

#include <optional>

namespace core {

/// Where a piece is shown: turned and zoomed about its pivot, then moved.
struct PiecePose {
    glm::dvec3 offsetMm{0.0}; ///< patient axes (LPS)
    /// Its direction is the axis (LPS), its length the angle: [0, 0, 90] is a quarter turn about S.
    glm::dvec3 rotationDegrees{0.0};
    double zoom = 1.0;

    [[nodiscard]] bool isHome() const { return *this == PiecePose(); }
    bool operator==(const PiecePose&) const = default;
};

/// A part of the volume that is shown in a pose of its own (seed A §4.4): what a sculpt layer has
/// cut out, or the voxels of a segment. It holds no voxels, so it follows them: of a layer it is
/// where its coverage is 128 or more and no layer before it (by id) that is not muted has carved
/// that much already; what other layers carve later leaves it whole. A muted layer hides nothing,
/// so its piece is shown besides the matter at its place.
struct Piece {
    int id = 0; ///< 1, 2, 3 …, unique and never used again
    QString name;
    int layer = 0; ///< id of the sculpt layer that cut it; 0: none
    int segment = 0; ///< label of the segment that it is; 0: none. One of the two is.
    std::optional<glm::dvec3> pivotLps; ///< at its true place; none: the middle of the volume
    PiecePose pose;
};

/// A rotation vector in degrees as a matrix, and back (angles up to 180°).
[[nodiscard]] glm::dmat3 rotationMatrix(const glm::dvec3& rotationDegrees);
[[nodiscard]] glm::dvec3 rotationDegrees(const glm::dmat3& rotation);

/// From the true place to where it is shown, LPS mm.
[[nodiscard]] glm::dmat4 shownFromTrue(const Piece& piece, const VolumeGeometry& geometry);
[[nodiscard]] glm::dvec3 pivotOf(const Piece& piece, const VolumeGeometry& geometry);

} // namespace core
