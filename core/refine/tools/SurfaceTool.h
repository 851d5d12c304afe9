// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/refine/mesh/SimplexMesh.h"

#include <variant>

namespace core {

class GreyBox;

/// A sample of the pen.
struct SurfaceSample {
    glm::dvec3 placeLps{0.0}; ///< world, mm
    double pressure = 1.0; ///< times the tool's radius
    /// Of the plane scraper at this sample, towards what it takes off, of any length; 0: that of
    /// the tool.
    glm::dvec3 normalLps{0.0};
};

/// Paints marks (seed B §4.3): of the vertices within the ball that are reached along the surface,
/// within the ball, from the one nearest to the pen.
struct MarkBrush {
    SurfaceMark mark = SurfaceMark::Red;
    double radiusMm = 5.0;
};

/// Moves what lies within it out of it on the shortest way: outwards while its centre is within the
/// body, inwards while it is outside (seed B §4.4).
struct SphereTool {
    double radiusMm = 5.0;
};

/// A scraper (seed B §4.4): a cylinder that stands on the plane around the pen. What it reaches
/// goes down to the plane and stays exactly there.
struct PlaneTool {
    glm::dvec3 normalLps{0.0, 0.0, 1.0}; ///< towards what it takes off, of any length
    double radiusMm = 10.0;
    double heightMm = 20.0; ///< beyond which it reaches nothing
};

/// Takes the vertex that is nearest to the first sample, to where the pen goes; what is around
/// follows like a rubber sheet, by (1 − (distance / radius)²)². The vertex is green in the end.
struct DragTool {
    double radiusMm = 10.0;
    /// A green vertex that an earlier drag left, which is to be dragged again; noId: the nearest
    /// that is not green.
    VertexId again = noId;
};

/// A line that was drawn on some plane.
struct TemplateContour {
    std::vector<glm::dvec3> pointsLps; ///< world, mm
    bool isClosed = false;
};
/// The red region around the contours takes the shape that they give (seed B §4.4, 6.5; see
/// TemplateShape.h). Its samples say no more than that time has come for a few steps.
struct TemplateTool {
    std::vector<TemplateContour> contours;
};

/// Evens the curvature of what lies within the ball; nothing shrinks.
struct SmoothTool {
    double radiusMm = 5.0;
};

/// Moves what it touches along its normal to the steepest change of grey values nearby: from where
/// it was when the stroke came to it, however often it goes over it.
struct AttractTool {
    double radiusMm = 5.0;
    double reachMm = 5.0; ///< how far it looks to either side
    const GreyBox* grey = nullptr; ///< must outlive the stroke; null: nothing attracts
};

using SurfaceTool =
    std::variant<MarkBrush, SphereTool, PlaneTool, DragTool, TemplateTool, SmoothTool, AttractTool>;

} // namespace core
