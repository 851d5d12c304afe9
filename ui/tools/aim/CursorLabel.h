// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QColor>
#include <QPointF>
#include <QSizeF>
#include <QStringList>

class QPainter;

namespace ui {

/// The colour of outlines and words of tools at the cursor.
[[nodiscard]] QColor toolColour();

/// Draws the outline of a brush or mask around the cursor.
/// @param radius logical pixels; of a square, half a side
void drawCursorRing(
    QPainter& painter, const QPointF& cursor, double radius, const QColor& colour, bool dashed);
void drawCursorSquare(
    QPainter& painter, const QPointF& cursor, double radius, const QColor& colour, bool dashed);
/// Marks the middle of a brush.
void drawCursorCross(QPainter& painter, const QPointF& cursor, const QColor& colour);

/// Words beside the cursor, led to by a short line from the rim of a mask; kept inside the view.
/// The first line is what the tool will do and stands out.
/// @param radius of the mask, logical pixels
void drawCursorLabel(QPainter& painter, const QSizeF& view, const QPointF& cursor, double radius,
    const QStringList& lines);

} // namespace ui
