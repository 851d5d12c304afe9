// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/ClipRegion.h"
#include "ui/geometry/ViewContext.h"

#include <vector>

namespace ui {

/// What a clip region is moved by in a picture: the middle of a face of its box, or a plane's.
struct ClipHandle {
    int face = 0; ///< 0 … 5: box, axis · 2 + (1: the high side); 6 …: planes
    QPointF pixel;
    QPointF pixelsPerMm; ///< along the outward normal
};

/// Those that can be dragged in a view: a face seen straight on has no way to go. The box has its
/// handles whether it is on or not, a plane only while it is.
[[nodiscard]] std::vector<ClipHandle> clipHandles(
    const ViewContext& view, const core::ClipRegion& clip, const core::VolumeGeometry& geometry);

/// The region with one face moved outwards; it stops at the volume's side and one voxel before the
/// face across. A box that is moved is on.
[[nodiscard]] core::ClipRegion movedClip(
    core::ClipRegion clip, int face, double mm, const core::VolumeGeometry& geometry);

} // namespace ui
