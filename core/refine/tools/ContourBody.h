// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/refine/tools/SurfaceTool.h"
#include "core/refine/tools/ThinPlateSpline.h"

#include <functional>

namespace core {

class Progress;

/// A place on the sound surface around a region, and which way is out there.
struct BorderPlace {
    glm::dvec3 placeLps{0.0};
    glm::dvec3 outwardsLps{0.0};
};

/// What a body is to run through.
struct ContourBodyPoints {
    const std::vector<TemplateContour>& contours;
    std::vector<BorderPlace> border; ///< not empty
    double edgeMm = 1.0; ///< of the surface's faces
    /// Whether a place lies at the sound surface; what is drawn there is left out, unless all is.
    std::function<bool(const glm::dvec3&)> isSound;
};

struct ContourBody {
    VariationalBody body;
    std::vector<glm::dvec3> pointsLps; ///< those of the contours, evened out, then the border
};

/// A body through any mixture of open and closed contours on any planes, and through the border of
/// the region that they mend (seed B §6.5, with a form that may be as steep as it likes).
///
/// The hand is unsteady: contours are evened out along themselves, and the body may pass them by
/// for the sake of less bending, but not the border, where it goes on as the sound surface does.
/// Which side of an open contour is out follows from the border that is nearest to its ends; of a
/// closed one, from its turn, if it encloses anything. Which way is out exactly follows from a
/// first body: a plane may cut the organ obliquely.
///
/// Computed by + − × ÷ √ in a fixed order. Cost: two dense solutions for two unknowns per point, of
/// which the contours have at most 260.
/// @param progress asked before each solution whether it was cancelled; null: it never is
/// Errors: InvalidField (argument 1: why; contours without length, …), Cancelled.
[[nodiscard]] Result<ContourBody> contourBody(
    const ContourBodyPoints& given, const Progress* progress = nullptr);

} // namespace core
