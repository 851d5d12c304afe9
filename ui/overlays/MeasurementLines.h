// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/document/Measurement.h"
#include "ui/geometry/ViewContext.h"

class QPainter;

namespace ui {

class Workspace;

/// Draws a distance as a line with its length.
void paintMeasurement(
    QPainter& painter, const ViewContext& view, const QPointF& from, const QPointF& to, double mm);

/// Draws the measurements of the document: in a slice those that lie in it, to within a voxel; in a
/// 3D view all of them, those on a piece where that piece is shown.
void paintMeasurements(QPainter& painter, const ViewContext& view, const Workspace& workspace);

/// "34.2 mm".
[[nodiscard]] QString lengthText(double mm);

} // namespace ui
