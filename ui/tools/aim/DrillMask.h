// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/kinds/sculpt/ToolMask.h"
#include "ui/input/Tool.h"
#include "ui/tools/aim/SurfacePatch.h"
#include "ui/workspace/Workspace.h"

#include <QPolygonF>

class QPainter;

namespace ui {

/// The mask that results from the drill's settings and from how the pen is held: it is rotated with
/// the pen (by the direction of its tilt if it does not report its rotation) and, if the settings
/// say so, foreshortened like a disc perpendicular to the tilted pen. The result contains
/// everything that an edit needs to know.
[[nodiscard]] core::ToolMask drillMask(
    const Workspace::DrillSettings& settings, const PointerSample& pen = {});

/// The inverse of drillMask() for an outline: what must be stored of a curve that was drawn with a
/// pen held like this, so that the same pen reproduces the curve.
[[nodiscard]] std::vector<glm::dvec2> withoutPen(std::vector<glm::dvec2> curve,
    const Workspace::DrillSettings& settings, const PointerSample& pen);

/// Draws the outline of a tool over a picture: a bright line with a dark rim, visible on bone and
/// on black.
void drawToolOutline(QPainter& painter, const QPolygonF& outline, bool closed = true);

/// Draws the part of a surface that a tool would remove, tinted.
void paintPatch(QPainter& painter, const SurfacePatch& surface, const ViewContext& view);

/// The outline of a mask around a point of the picture, in pixels.
[[nodiscard]] QPolygonF maskOutline(
    const core::ToolMask& mask, const QPointF& centre, double mmPerPixel);

} // namespace ui
