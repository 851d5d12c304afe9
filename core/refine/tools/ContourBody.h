// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/refine/tools/SurfaceTool.h"
#include "core/refine/tools/ThinPlateSpline.h"

#include <functional>

namespace core {

class Progress;

/// A place at the border of the region to be mended, on the sound surface around it, and the
/// outward direction there.
struct BorderPlace {
    glm::dvec3 placeLps{0.0};
    glm::dvec3 outwardsLps{0.0};
};

/// Everything that a body is to pass through.
struct ContourBodyPoints {
    const std::vector<TemplateContour>& contours;
    std::vector<BorderPlace> border; ///< not empty
    double edgeMm = 1.0; ///< edge length of the surface's faces
    /// Whether a place lies on the sound surface. Points of contours that do are left out, unless
    /// all do. Empty: none does.
    std::function<bool(const glm::dvec3&)> isSound;
};

struct ContourBody {
    VariationalBody body;
    /// The smoothed points of the contours, then those of the border.
    std::vector<glm::dvec3> pointsLps;
};

/// A body through any mixture of open and closed contours on any planes, and through the border of
/// the region that they mend (seed B §6.5, with a body that may be arbitrarily steep).
///
/// Since a hand is unsteady, contours are smoothed along themselves, and the body may deviate from
/// them if that reduces bending. It may not deviate from the border, where it continues the sound
/// surface. The outward side of an open contour follows from the nearest part of the border; that
/// of a closed contour leads away from the area that it encloses, if it encloses any. The exact
/// outward directions follow from a first body, since a contour's plane may cut the organ
/// obliquely; then the body is computed again.
///
/// Computed with + − × ÷ √ in a fixed order. Cost: two dense systems of equations with two unknowns
/// per point; contours have at most 260 points together.
/// @param progress asked before each of them whether the work was cancelled; null: it never is
/// Errors: InvalidField (argument 1: why; contours without length, …), Cancelled.
[[nodiscard]] Result<ContourBody> contourBody(
    const ContourBodyPoints& given, const Progress* progress = nullptr);

} // namespace core
