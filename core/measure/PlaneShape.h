// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/document/Measurement.h"

#include <glm/glm.hpp>

#include <optional>
#include <vector>

namespace core {

/// A region of a plane, with coordinates in millimetres within that plane. The plane is the one
/// through the points of the region; it need not be a slice of the volume.
struct PlaneShape {
    glm::dvec3 originLps{0.0};
    glm::dvec3 rightLps{1.0, 0.0, 0.0}; ///< unit vectors of the plane, perpendicular
    glm::dvec3 upLps{0.0, 1.0, 0.0};
    Measurement::Kind kind = Measurement::Kind::Outline;
    std::vector<glm::dvec2> points{}; ///< the points of the measurement

    /// Points that all lie closer than this to one line span no region.
    static constexpr double leastHeightMm = 1.0 / 256.0;
    /// An edit refuses points that lie farther than this from their plane.
    static constexpr double mostOffPlaneMm = 0.05;

    [[nodiscard]] glm::dvec3 normalLps() const { return glm::cross(rightLps, upLps); }
    [[nodiscard]] glm::dvec2 inPlane(const glm::dvec3& placeLps) const;
    [[nodiscard]] glm::dvec3 toLps(const glm::dvec2& place) const;
    /// The distance from the plane of the point that lies farthest from it.
    [[nodiscard]] double offPlaneMm(const Measurement& measurement) const;

    /// Whether a place lies inside or on the border.
    [[nodiscard]] bool contains(const glm::dvec2& place) const;
    /// The area in closed form: π·|a×b| for an ellipse with half axes a and b, |a×b| for a
    /// rectangle with sides a and b, and for an outline the area that it winds around
    /// (woundArea()).
    [[nodiscard]] double areaMm2() const;
    /// The border as a polygon; that of an ellipse gets this number of corners.
    [[nodiscard]] std::vector<glm::dvec2> border(int ellipseCorners = 96) const;
};

/// The region of a measurement; none if its points span no plane.
/// @pre measurement.isPlaneRegion()
[[nodiscard]] std::optional<PlaneShape> planeShape(const Measurement& measurement);

/// The lengths of the perpendicular half axes of an ellipse, the longer one first, from two
/// conjugate half diameters. A drawn ellipse has perpendicular half axes already, but converted to
/// voxels they may be oblique.
[[nodiscard]] glm::dvec2 halfAxes(const glm::dvec3& a, const glm::dvec3& b);

} // namespace core
