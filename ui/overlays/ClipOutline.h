// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/ClipRegion.h"
#include "ui/geometry/ViewContext.h"

#include <QColor>
#include <QPolygonF>

#include <vector>

class QPainter;

namespace ui {

/// Lines of a clip region over pictures that do not obey it: where its box and its planes meet a
/// slice, thin; a tick points to what a plane hides. Nothing where nothing is on.
void paintClipSection(QPainter& painter, const ViewContext& slice, const core::ClipRegion& clip,
    const core::VolumeGeometry& geometry);

/// Where a box along the volume's axes meets a slice.
void paintBoxSection(QPainter& painter, const ViewContext& slice, const core::ClipRegion::Box& box,
    const core::VolumeGeometry& geometry, const QColor& colour);

/// A box in a 3D view: the edges towards the viewer bright, those behind faint. Drawn whether the
/// box is on or not.
void paintBox(QPainter& painter, const ViewContext& view, const core::ClipRegion::Box& box,
    const core::VolumeGeometry& geometry, const QColor& colour);
/// In the colour of clip boxes.
void paintClipBox(QPainter& painter, const ViewContext& view, const core::ClipRegion::Box& box,
    const core::VolumeGeometry& geometry);

/// The planes that are on, in a 3D view, as far as the volume reaches.
void paintClipPlanes(QPainter& painter, const ViewContext& view, const core::ClipRegion& clip,
    const core::VolumeGeometry& geometry);

/// A polygon of the patient in pixels.
[[nodiscard]] QPolygonF toPixels(
    const std::vector<glm::dvec3>& polygonLps, const ViewContext& view);

} // namespace ui
