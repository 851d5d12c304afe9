// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/VolumeGeometry.h"
#include "ui/geometry/ViewContext.h"

#include <QColor>

#include <optional>
#include <span>
#include <utility>

class QPainter;

namespace ui {

/// A plane that another view shows.
struct ReferencePlane {
    glm::dvec3 pointLps{0.0};
    glm::dvec3 normalLps{0.0, 0.0, 1.0}; ///< unit
    QColor colour;
};

/// The two ends (LPS) of the line where a plane meets a slice, within the volume. None if it does
/// not meet it there, or lies nearly in it.
[[nodiscard]] std::optional<std::pair<glm::dvec3, glm::dvec3>> referenceLine(
    const ViewContext& slice, const ReferencePlane& plane, const core::VolumeGeometry& geometry);

/// Draws those lines, thin and whole, with a gap around a pixel so that they never cover what the
/// crosshair marks.
void paintReferenceLines(QPainter& painter, const ViewContext& slice,
    std::span<const ReferencePlane> planes, const core::VolumeGeometry& geometry,
    const QPointF& gapAt);

} // namespace ui
