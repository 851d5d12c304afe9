// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/kinds/sculpt/MaskShape.h"
#include "ui/input/Tool.h"
#include "ui/tools/aim/SurfacePatch.h"
#include "ui/workspace/Workspace.h"

#include <QPolygonF>

class QPainter;

namespace ui {

/// The mask that the drill's settings stand for, in a pen held like this: turned with it (by the
/// way it leans, where it does not tell its rotation) and, where that is set, foreshortened as a
/// disc across the pen is when it leans. What comes out is all that an edit needs to know.
[[nodiscard]] core::MaskShape drillMask(
    const Workspace::DrillSettings& settings, const PointerSample& pen = {});

/// What drillMask() makes of an outline, backwards: what is to be kept of a curve that was drawn
/// with a pen held like this, so that the same pen presses the curve.
[[nodiscard]] std::vector<glm::dvec2> withoutPen(std::vector<glm::dvec2> curve,
    const Workspace::DrillSettings& settings, const PointerSample& pen);

/// Outlines of tools over a picture: a bright line with a dark rim, to be seen on bone and on black
/// alike.
void drawToolOutline(QPainter& painter, const QPolygonF& outline, bool closed = true);

/// The part of a surface that a tool would take, tinted.
void paintPatch(QPainter& painter, const SurfacePatch& surface, const ViewContext& view);

/// A mask around a point of the picture, as the viewer sees it.
[[nodiscard]] QPolygonF maskOutline(
    const core::MaskShape& mask, const QPointF& centre, double mmPerPixel);

} // namespace ui
