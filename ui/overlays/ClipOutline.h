// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/ClipRegion.h"
#include "ui/geometry/ViewContext.h"

#include <QColor>
#include <QPolygonF>

#include <vector>

class QPainter;

namespace ui {

/// Draws the outline of a clip region over a slice, which is not clipped: thin lines where its box
/// and planes meet the slice, with a tick to the side that a plane hides. Draws nothing if nothing
/// is on.
void paintClipSection(QPainter& painter, const ViewContext& slice, const core::ClipRegion& clip,
    const core::VolumeGeometry& geometry);

/// Draws where a box along the volume's axes meets a slice.
void paintBoxSection(QPainter& painter, const ViewContext& slice, const core::ClipRegion::Box& box,
    const core::VolumeGeometry& geometry, const QColor& colour);

/// Draws a box in a 3D view: the edges towards the viewer bright, the others faint. The box need
/// not be on.
void paintBox(QPainter& painter, const ViewContext& view, const core::ClipRegion::Box& box,
    const core::VolumeGeometry& geometry, const QColor& colour);
/// The same in the colour of clip boxes.
void paintClipBox(QPainter& painter, const ViewContext& view, const core::ClipRegion::Box& box,
    const core::VolumeGeometry& geometry);

/// Draws the planes that are on in a 3D view, cut to the volume.
void paintClipPlanes(QPainter& painter, const ViewContext& view, const core::ClipRegion& clip,
    const core::VolumeGeometry& geometry);

/// Converts a polygon in the patient to pixels of the view.
[[nodiscard]] QPolygonF toPixels(
    const std::vector<glm::dvec3>& polygonLps, const ViewContext& view);

} // namespace ui
