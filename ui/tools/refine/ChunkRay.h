// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/VolumeGeometry.h"
#include "ui/geometry/ViewContext.h"

#include <optional>

namespace ui {

/// A voxel of the chunk that is drawn under a pixel: on a slice the voxel there; in an orthographic
/// 3D view the first voxel of a drawn chunk that the ray meets inside the clip region. None if no
/// chunk is drawn there.
/// @param pixel in logical pixels
[[nodiscard]] std::optional<glm::ivec3> chunkVoxelUnder(
    const ViewContext& view, const QPointF& pixel, const core::VolumeGeometry& geometry);

} // namespace ui
