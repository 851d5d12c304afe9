// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QPolygonF>
#include <QSizeF>

class QPainter;

namespace ui {

/// How a curve with a mark on it is drawn: of what lies left of the mark the area too.
struct MarkedCurve {
    QPolygonF curve; ///< from left to right, at least one point
    double bottom = 0.0; ///< of the area below it
    double mark = 0.0; ///< pixels from the left
    bool moving = false; ///< the mark is dragged
    bool knob = false; ///< it can be
};
/// The curve and its area.
void paintMarkedCurve(QPainter& painter, const QSizeF& size, const MarkedCurve& marked);
/// The mark, over it.
void paintMark(QPainter& painter, const QSizeF& size, const MarkedCurve& marked);

} // namespace ui
