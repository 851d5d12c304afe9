// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/VolumeGeometry.h"

#include <glm/glm.hpp>

#include <array>
#include <optional>
#include <vector>

namespace core {

/// Hides what lies on the side that its normal points to.
struct ClipPlane {
    glm::dvec3 pointLps{0.0};
    glm::dvec3 normalLps{0.0, 0.0, 1.0}; ///< unit
    bool on = false;
    bool operator==(const ClipPlane&) const = default;
};

/// What of a volume is looked at in 3D, without anything being carved: a box along the volume's
/// axes and planes. Convex, so a straight line stays in it for one stretch. It belongs to the
/// display: no edit changes it; picks end at it.
struct ClipRegion {
    struct Box {
        glm::dvec3 minimum{-0.5}; ///< index; a whole volume reaches from −0.5 to size − 0.5
        glm::dvec3 maximum{-0.5};
        bool on = false;
        bool operator==(const Box&) const = default;
    };
    Box box;
    std::array<ClipPlane, 3> planes;

    [[nodiscard]] bool any() const; ///< whether it hides something, or could
    bool operator==(const ClipRegion&) const = default;
};

/// Nothing hidden, the box as large as the volume.
[[nodiscard]] ClipRegion wholeVolume(const VolumeGeometry& geometry);

/// Index positions with dot(normal, index) ≤ offset.
struct HalfSpace {
    glm::dvec3 normal{0.0};
    double offset = 0.0;
};

/// What must hold of an index position that is seen; only what is on.
[[nodiscard]] std::vector<HalfSpace> halfSpaces(
    const ClipRegion& region, const VolumeGeometry& geometry);

/// A part of origin + t · direction.
struct LineStretch {
    double from = 0.0;
    double to = 0.0;
};

/// What is left of a stretch in all half spaces; none where it misses one.
[[nodiscard]] std::optional<LineStretch> stretchInside(LineStretch stretch,
    const glm::dvec3& origin, const glm::dvec3& direction,
    const std::vector<HalfSpace>& halfSpaces);

/// What of the region's box a plane cuts, as corners in order around it (LPS); empty: it misses the
/// box. For outlines, whether the box is on or not.
[[nodiscard]] std::vector<glm::dvec3> boxSection(const ClipRegion::Box& box,
    const VolumeGeometry& geometry, const glm::dvec3& pointLps, const glm::dvec3& normalLps);

} // namespace core
