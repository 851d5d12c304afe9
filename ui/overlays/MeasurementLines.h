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

/// How a measurement is drawn, in logical pixels of a view.
struct MeasurementDrawing {
    std::vector<QPolygonF> lines{}; ///< open lines
    std::vector<QPolygonF> outlines{}; ///< closed lines
    std::vector<QPointF> marks{}; ///< places marked by a cross
    QPointF text; ///< the place beside which its text stands
    QPointF away{0.0, -1.0}; ///< unit vector towards the side on which the text stands
};

/// Returns the drawing of a measurement. It is empty for a ball that the view's slice does not cut.
/// @param measurement with its points at the places where the view shows them
[[nodiscard]] MeasurementDrawing drawingOf(
    const core::Measurement& measurement, const ViewContext& view);

/// Draws the lines with a dark rim, and the text on a dark ground that stays within the view.
/// @param words lines of the text
/// @param taken rectangles that the text avoids if there is room elsewhere
/// @return the rectangle of the text; empty: there is none
QRectF paintMeasurement(QPainter& painter, const ViewContext& view,
    const MeasurementDrawing& drawing, const QStringList& words,
    const std::vector<QRectF>& taken = {});

/// Whether a view shows a measurement of the document with all its points. A slice does if they lie
/// in it.
[[nodiscard]] bool isShown(
    const core::Measurement& measurement, const ViewContext& view, const Workspace& workspace);

/// Returns the size of a measurement of the document, and its values if they are known, in lines of
/// text.
[[nodiscard]] QStringList measurementLines(
    const core::Measurement& measurement, const Workspace& workspace);

/// Draws the measurements of the document with their sizes and values. A slice shows those that lie
/// in it to within a voxel, and balls that it cuts. A 3D view shows all; those on a piece appear
/// where the piece is shown.
void paintMeasurements(QPainter& painter, const ViewContext& view, const Workspace& workspace);

} // namespace ui
