// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/geometry/ViewPlane.h"

#include <QColor>
#include <QRect>
#include <QRegion>
#include <QStringList>

#include <glm/glm.hpp>

class QPainter;

namespace ui {

/// The colour of a standard plane: of its view's bar, and of the lines in which others show it.
[[nodiscard]] QColor sliceColour(SliceOrientation orientation);

/// The texts in the four corners of a view. Each list of lines starts at the edge of the view:
/// upper lists run downwards, lower ones upwards.
struct CornerTexts {
    QString title;
    QColor titleColour;
    QStringList topLeft; ///< under the title
    QStringList topRight;
    QStringList bottomLeft;
    QStringList bottomRight;
};
void paintCorners(QPainter& painter, const QRect& view, const CornerTexts& texts);
/// What these texts cover, in pixels, for lines to leave it free.
[[nodiscard]] QRegion cornersRegion(const QRect& view, const CornerTexts& texts);

/// Draws orientation letters at the middle of the four edges of a picture.
void paintEdgeLetters(
    QPainter& painter, const QRect& view, const glm::dvec3& rightLps, const glm::dvec3& downLps);
/// What these letters cover, in pixels.
[[nodiscard]] QRegion edgeLettersRegion(
    const QRect& view, const glm::dvec3& rightLps, const glm::dvec3& downLps);

/// Draws a scale bar of a round length, right-aligned, its lower end at @p baseline.
void paintScaleBar(QPainter& painter, const QRect& view, int baseline, double mmPerPixel);
/// The length of the scale bar in millimetres: the longest of 1, 2 or 5 times a power of ten that
/// fits.
[[nodiscard]] double scaleBarLengthMm(double mmPerPixel, double maximumPixels);

/// Draws dashed lines through @p centre, with a gap in the middle so that they never cover what
/// they mark.
void paintCrosshair(QPainter& painter, const QRect& view, const QPointF& centre,
    const QColor& horizontal, const QColor& vertical);

/// Draws one such line in any direction.
/// @param direction on the screen, of length 1
void paintCrosshairLine(QPainter& painter, const QRect& view, const QPointF& centre,
    const QPointF& direction, const QColor& colour);

/// Draws text that stays readable on any picture.
void paintText(
    QPainter& painter, const QRectF& box, int flags, const QString& text, const QColor& colour);

} // namespace ui
