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
/// Whether a contour lies in the plane of a view, a slice, and within rubberPixels of a straight
/// line in it. Those of other planes are only seen through it.
/// @param from logical pixels, as @p to
[[nodiscard]] bool isRubbed(const TemplateContour& contour, const ViewContext& view,
    const QPointF& from, const QPointF& to);
/// Draws a contour, faintly where it lies in another plane than the view.
void paintContour(QPainter& painter, const TemplateContour& contour, const ViewContext& view,
    const QColor& colour);

} // namespace ui
