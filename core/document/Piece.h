// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/VolumeGeometry.h"

#include <QString>

#include <glm/glm.hpp>

#include <optional>

namespace core {

/// Where a piece is shown: it is rotated and zoomed about its pivot, then moved.
struct PiecePose {
    glm::dvec3 offsetMm{0.0}; ///< patient axes (LPS)
    /// Rotation vector: its direction is the axis (LPS), its length the angle; [0, 0, 90] is a
    /// quarter turn about S.
    glm::dvec3 rotationDegrees{0.0};
    double zoom = 1.0;

    [[nodiscard]] bool isHome() const { return *this == PiecePose(); }
    bool operator==(const PiecePose&) const = default;
};

/// A part of the volume that is shown in its own pose (seed A §4.4): what a sculpt layer has cut
/// out, or the voxels of a segment. It holds no voxels of its own, so it follows theirs. A piece of
/// a layer consists of the voxels whose coverage is 128 or more in that layer and in no unmuted
/// layer before it (by id); later cuts in other layers do not change it. A muted layer hides
/// nothing, so its piece is then shown in addition to the tissue at its place.
struct Piece {
    int id = 0; ///< 1, 2, 3 …, unique and never used again
    QString name;
    int layer = 0; ///< id of the sculpt layer that cut it; 0: none
    int segment = 0; ///< label of its segment; 0: none. Exactly one of the two is set.
    /// before the pose is applied; none: the middle of the volume
    std::optional<glm::dvec3> pivotLps;
    PiecePose pose;
};

/// The matrix of a rotation vector in degrees, and the reverse (angles up to 180°).
[[nodiscard]] glm::dmat3 rotationMatrix(const glm::dvec3& rotationDegrees);
[[nodiscard]] glm::dvec3 rotationDegrees(const glm::dmat3& rotation);

/// The transform from the true place to where the piece is shown, LPS mm.
[[nodiscard]] glm::dmat4 shownFromTrue(const Piece& piece, const VolumeGeometry& geometry);
[[nodiscard]] glm::dvec3 pivotOf(const Piece& piece, const VolumeGeometry& geometry);

} // namespace core
