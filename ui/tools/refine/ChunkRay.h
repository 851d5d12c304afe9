// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/VolumeGeometry.h"
#include "ui/geometry/ViewContext.h"

#include <optional>

namespace ui {

/// The voxel of the chunk that is drawn under a pixel: on a slice the one that lies there, in an
/// orthographic 3D view the first that its ray meets, of those that are drawn, in what is not
/// clipped. None: no chunk is drawn there.
/// @param pixel logical
[[nodiscard]] std::optional<glm::ivec3> chunkVoxelUnder(
    const ViewContext& view, const QPointF& pixel, const core::VolumeGeometry& geometry);

} // namespace ui
