// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/ClipRegion.h"
#include "ui/geometry/ViewContext.h"

#include <vector>

namespace ui {

/// A handle by which the user moves a clip region in a picture: at the middle of a face of its box,
/// or of a plane.
struct ClipHandle {
    int face = 0; ///< 0 … 5: box, axis · 2 + (1: the high side); 6 …: planes
    QPointF pixel;
    QPointF pixelsPerMm; ///< along the outward normal
};

/// The handles that can be dragged in a view. A face seen straight on has none, since it could not
/// be moved in the picture. The box has handles whether it is on or not, a plane only while it is
/// on.
[[nodiscard]] std::vector<ClipHandle> clipHandles(
    const ViewContext& view, const core::ClipRegion& clip, const core::VolumeGeometry& geometry);

/// The region with one face moved outwards by @p mm; the face stops at the volume's border and one
/// voxel before the opposite face. A box that is moved is switched on.
[[nodiscard]] core::ClipRegion movedClip(
    core::ClipRegion clip, int face, double mm, const core::VolumeGeometry& geometry);

} // namespace ui
