// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/Workspace.h"

#include <QPolygonF>

class QPainter;

namespace ui {

/// The mask that the drill's settings stand for.
[[nodiscard]] core::MaskShape drillMask(const Workspace::DrillSettings& settings);

/// Outlines of tools over a picture: a bright line with a dark rim, to be seen on bone and on black
/// alike.
void drawToolOutline(QPainter& painter, const QPolygonF& outline, bool closed = true);

/// A mask around a point of the picture, as the viewer sees it.
[[nodiscard]] QPolygonF maskOutline(
    const core::MaskShape& mask, const QPointF& centre, double mmPerPixel);

} // namespace ui
