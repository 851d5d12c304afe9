// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QPolygonF>
#include <QSizeF>

class QPainter;

namespace ui {

/// A curve with a movable mark on it; the area below the curve is filled to the left of the mark.
struct MarkedCurve {
    QPolygonF curve; ///< from left to right, at least one point
    double bottom = 0.0; ///< y of the lower edge of the area
    double mark = 0.0; ///< pixels from the left
    bool moving = false; ///< the mark is dragged
    bool knob = false; ///< the mark can be dragged
};
/// Draws the background of curves in a widget, and sets the painter to draw smoothly and without
/// outlines from then on.
void paintCurveGround(QPainter& painter, const QSizeF& size);
/// Draws the curve and its area.
void paintMarkedCurve(QPainter& painter, const QSizeF& size, const MarkedCurve& marked);
/// Draws the mark over it.
void paintMark(QPainter& painter, const QSizeF& size, const MarkedCurve& marked);

} // namespace ui
