// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/kinds/parts/EditableRange.h"
#include "core/volume/Volume.h"
#include "ui/geometry/ViewContext.h"

#include <QPainterPath>

namespace ui {

/// Returns the part of a path over the 3D view in which an edit through all of the depth may change
/// voxels, as far as the view can tell: the part over the range's box. Limits of values and
/// segments cannot be shown, since some voxel on each line of sight may lie within them; but if the
/// range is inside of no segment, the result is empty.
/// @param path logical pixels of the view
[[nodiscard]] QPainterPath editablePart(const core::EditableRange& range, const QPainterPath& path,
    const core::VolumeGeometry& geometry, const ViewContext& view);

} // namespace ui
