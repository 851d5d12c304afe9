// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/geometry/ViewContext.h"

#include <QColor>

#include <glm/glm.hpp>

#include <optional>
#include <vector>

class QPainter;

namespace ui {

/// Contours of a template on the slices where they were drawn (Mode::Template of RefineTool): LPS,
/// as views show them.
using TemplateContour = std::vector<glm::dvec3>;

/// How near to a contour a rubber has to come, logical pixels.
inline constexpr double rubberPixels = 6.0;

/// The contour that a line drawn in a slice becomes: closed if it comes back to where it began;
/// none if it is too short to be meant.
[[nodiscard]] std::optional<TemplateContour> drawnContour(TemplateContour line, double pixelMm);
/// Whether a movement of the rubber in a slice erases a contour: the contour lies in the plane of
/// the slice, and within rubberPixels of the movement. Contours of other planes are drawn in the
/// slice, too, but are not erased there.
/// @param from, to ends of the movement, a straight line; logical pixels
[[nodiscard]] bool isRubbed(const TemplateContour& contour, const ViewContext& view,
    const QPointF& from, const QPointF& to);
/// Draws a contour, faintly where it lies in another plane than the view.
void paintContour(QPainter& painter, const TemplateContour& contour, const ViewContext& view,
    const QColor& colour);

} // namespace ui
