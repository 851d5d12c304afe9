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

/// The plane of another view.
struct ReferencePlane {
    glm::dvec3 pointLps{0.0};
    glm::dvec3 normalLps{0.0, 0.0, 1.0}; ///< unit
    QColor colour;
};

/// Returns the two ends (LPS mm) of the line in which a plane cuts a slice, within the volume. None
/// if they do not meet there or are nearly parallel.
[[nodiscard]] std::optional<std::pair<glm::dvec3, glm::dvec3>> referenceLine(
    const ViewContext& slice, const ReferencePlane& plane, const core::VolumeGeometry& geometry);

/// Draws these lines, thin and unbroken. A gap around @p gapAt (pixels) leaves free what the
/// crosshair marks.
void paintReferenceLines(QPainter& painter, const ViewContext& slice,
    std::span<const ReferencePlane> planes, const core::VolumeGeometry& geometry,
    const QPointF& gapAt);

} // namespace ui
