// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/document/Measurement.h"

#include <glm/glm.hpp>

#include <optional>
#include <vector>

namespace core {

/// A region of a plane, in millimetres of that plane. The plane is the one through the region's
/// points, so it needs no slice of the volume.
struct PlaneShape {
    glm::dvec3 originLps{0.0};
    glm::dvec3 rightLps{1.0, 0.0, 0.0}; ///< unit vectors of the plane, perpendicular
    glm::dvec3 upLps{0.0, 1.0, 0.0};
    Measurement::Kind kind = Measurement::Kind::Outline;
    std::vector<glm::dvec2> points{}; ///< those of the measurement

    /// Corners closer than this to one line span no region.
    static constexpr double leastHeightMm = 1.0 / 256.0;
    /// An edit refuses corners that lie farther from their plane.
    static constexpr double mostOffPlaneMm = 0.05;

    [[nodiscard]] glm::dvec3 normalLps() const { return glm::cross(rightLps, upLps); }
    [[nodiscard]] glm::dvec2 inPlane(const glm::dvec3& placeLps) const;
    [[nodiscard]] glm::dvec3 toLps(const glm::dvec2& place) const;
    /// How far the point that lies farthest from the plane lies from it.
    [[nodiscard]] double offPlaneMm(const Measurement& measurement) const;

    /// Whether a place lies inside or on the border.
    [[nodiscard]] bool contains(const glm::dvec2& place) const;
    /// In closed form: π·|a×b| of an ellipse with half axes a and b, |a×b| of a rectangle with
    /// sides a and b, and of an outline the sum of trapezoids that it winds around.
    [[nodiscard]] double areaMm2() const;
    /// The border as corners: those of the shape, or this many of an ellipse.
    [[nodiscard]] std::vector<glm::dvec2> border(int ellipseCorners = 96) const;
};

/// None if its points span no plane. @param measurement isPlaneRegion()
[[nodiscard]] std::optional<PlaneShape> planeShape(const Measurement& measurement);

/// The half axes of an ellipse, the longer one first, from two conjugate half diameters. What is
/// drawn has perpendicular ones, whose lengths these are; seen in voxels they may lie askew.
[[nodiscard]] glm::dvec2 halfAxes(const glm::dvec3& a, const glm::dvec3& b);

} // namespace core
