// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/document/Measurement.h"
#include "ui/geometry/ViewContext.h"

#include <QPolygonF>
#include <QRectF>
#include <QStringList>

#include <vector>

class QPainter;

namespace ui {

class Workspace;

/// A measurement in logical pixels of a view, at places that were found for its points there.
struct MeasurementDrawing {
    std::vector<QPolygonF> lines{}; ///< open ones
    std::vector<QPolygonF> outlines{}; ///< closed ones
    std::vector<QPointF> marks{}; ///< places with a cross
    QPointF text; ///< beside which its words stand
    QPointF away{0.0, -1.0}; ///< on which side of it, a unit vector
};

/// @param measurement its points as the view shows them
/// Nothing of a ball that the view's slice does not cut.
[[nodiscard]] MeasurementDrawing drawingOf(
    const core::Measurement& measurement, const ViewContext& view);

/// Draws lines with a dark rim, and words on a dark ground that stays in the view.
/// @param taken where no words are to stand, as far as there is room elsewhere
/// @returns where the words stand; empty: nowhere
QRectF paintMeasurement(QPainter& painter, const ViewContext& view,
    const MeasurementDrawing& drawing, const QStringList& words,
    const std::vector<QRectF>& taken = {});

/// Whether a view shows a measurement of the document with all its points: a slice, if they lie in
/// it.
[[nodiscard]] bool isShown(
    const core::Measurement& measurement, const ViewContext& view, const Workspace& workspace);

/// What a measurement of the document comes to, in lines; its values as far as they are known.
[[nodiscard]] QStringList measurementLines(
    const core::Measurement& measurement, const Workspace& workspace);

/// Draws the measurements of the document with what they come to: in a slice those that lie in it,
/// to within a voxel, and the balls that it cuts; in a 3D view all of them, those on a piece where
/// that piece is shown.
void paintMeasurements(QPainter& painter, const ViewContext& view, const Workspace& workspace);

} // namespace ui
