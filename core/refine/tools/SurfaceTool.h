// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/refine/mesh/SimplexMesh.h"

#include <memory>
#include <variant>

namespace core {

class GreyBox;
class TemplateShape;

/// One report of the pen.
struct SurfaceSample {
    glm::dvec3 placeLps{0.0}; ///< world, mm
    double pressure = 1.0; ///< factor of the tool's radius
    /// For the plane scraper at this sample: points to the side that is removed, of any length; 0:
    /// that of the tool.
    glm::dvec3 normalLps{0.0};
};

/// Paints marks (seed B §4.3) on the vertices within the ball that are connected, within the ball,
/// with the one nearest to the pen.
struct MarkBrush {
    SurfaceMark mark = SurfaceMark::Red;
    double radiusMm = 5.0;
};

/// A ball that moves everything inside it out of it on the shortest way: outwards while its centre
/// is inside the body, inwards while it is outside (seed B §4.4).
struct SphereTool {
    double radiusMm = 5.0;
};

/// A scraper (seed B §4.4): a cylinder that stands on the plane around the pen. Vertices within it
/// move down to the plane and stay exactly there.
struct PlaneTool {
    glm::dvec3 normalLps{0.0, 0.0, 1.0}; ///< points to the side that is removed, of any length
    double radiusMm = 10.0;
    double heightMm = 20.0; ///< of the cylinder; nothing beyond it is moved
    /// The normal of the plane in which the pen moves, of any length. With it the scraper turns
    /// with the pen: its plane is perpendicular to the plane in which the pen moves, runs along the
    /// pen's path, and keeps facing the side that it faced before. 0: it keeps its normal.
    glm::dvec3 acrossLps{0.0};
};

/// Moves the vertex that is nearest to the first sample with the pen. Its surroundings follow like
/// a rubber sheet, by (1 − (distance / radius)²)². The vertex becomes green at the end.
struct DragTool {
    double radiusMm = 10.0;
    /// A green vertex from an earlier drag that is dragged again; noId: the nearest vertex that is
    /// not green.
    VertexId again = noId;
};

/// A line that was drawn on a plane.
struct TemplateContour {
    std::vector<glm::dvec3> pointsLps; ///< world, mm
    bool isClosed = false;
};
/// Gives the red region around the contours the shape that they describe (seed B §4.4, 6.5;
/// TemplateShape.h). Its samples only mean that a few more steps may be done.
struct TemplateTool {
    std::vector<TemplateContour> contours;
    /// The shape that the contours give this mesh; null: the stroke computes it, by the older
    /// rules.
    std::shared_ptr<const TemplateShape> shape = nullptr;
};

/// Evens out the curvature within the ball, without shrinking the surface.
struct SmoothTool {
    double radiusMm = 5.0;
};

/// Moves what it touches along its normal to the steepest change of grey values nearby. The search
/// starts where the surface was when the stroke first touched it, however often the tool passes.
struct AttractTool {
    double radiusMm = 5.0;
    double reachMm = 5.0; ///< how far it searches on either side
    const GreyBox* grey = nullptr; ///< must outlive the stroke; null: the tool has no effect
};

using SurfaceTool =
    std::variant<MarkBrush, SphereTool, PlaneTool, DragTool, TemplateTool, SmoothTool, AttractTool>;

} // namespace core
