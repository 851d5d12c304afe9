// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/document/Measurement.h"
#include "ui/geometry/ViewContext.h"

class QPainter;

namespace ui {

class Workspace;

/// A distance as a line with its length.
void paintMeasurement(
    QPainter& painter, const ViewContext& view, const QPointF& from, const QPointF& to, double mm);

/// The measurements of the document: on a slice those that lie in it, to a voxel; in 3D all, those
/// on a piece where that is shown.
void paintMeasurements(QPainter& painter, const ViewContext& view, const Workspace& workspace);

/// "34.2 mm".
[[nodiscard]] QString lengthText(double mm);

} // namespace ui
