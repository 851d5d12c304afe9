// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/VolumeGeometry.h"

#include <glm/glm.hpp>

#include <array>
#include <optional>
#include <vector>

namespace core {

/// A clip plane: hides everything on the side to which its normal points.
struct ClipPlane {
    glm::dvec3 pointLps{0.0};
    glm::dvec3 normalLps{0.0, 0.0, 1.0}; ///< unit
    bool on = false;
    bool operator==(const ClipPlane&) const = default;
};

/// The part of a volume that is shown in 3D, without carving anything: a box along the volume's
/// axes, and planes. It is convex, so a straight line is inside for one stretch only. It is display
/// state: no edit changes it, and picks end at it.
struct ClipRegion {
    struct Box {
        glm::dvec3 minimum{-0.5}; ///< index; a whole volume extends from −0.5 to size − 0.5
        glm::dvec3 maximum{-0.5};
        bool on = false;
        bool operator==(const Box&) const = default;
    };
    Box box;
    std::array<ClipPlane, 3> planes;

    [[nodiscard]] bool any() const; ///< whether anything is switched on
    bool operator==(const ClipRegion&) const = default;
};

/// A region that hides nothing; its box is as large as the volume.
[[nodiscard]] ClipRegion wholeVolume(const VolumeGeometry& geometry);

/// The index positions with dot(normal, index) ≤ offset.
struct HalfSpace {
    glm::dvec3 normal{0.0};
    double offset = 0.0;
};

/// The half-spaces that contain every visible index position; only those that are switched on.
[[nodiscard]] std::vector<HalfSpace> halfSpaces(
    const ClipRegion& region, const VolumeGeometry& geometry);

/// A part of origin + t · direction.
struct LineStretch {
    double from = 0.0;
    double to = 0.0;
};

/// The part of a stretch that is inside all half-spaces; none if it misses one.
[[nodiscard]] std::optional<LineStretch> stretchInside(LineStretch stretch,
    const glm::dvec3& origin, const glm::dvec3& direction,
    const std::vector<HalfSpace>& halfSpaces);

/// The intersection of a plane with the region's box, as corners in order around it (LPS); empty:
/// the plane misses the box. For outlines, whether or not the box is switched on.
[[nodiscard]] std::vector<glm::dvec3> boxSection(const ClipRegion::Box& box,
    const VolumeGeometry& geometry, const glm::dvec3& pointLps, const glm::dvec3& normalLps);

} // namespace core
