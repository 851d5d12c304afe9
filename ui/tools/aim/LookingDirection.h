// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/Volume.h"
#include "gpu/scene/Scene.h"

#include <glm/glm.hpp>

#include <optional>

namespace ui {

/// Along which direction of the volume's index space the user looks at a voxel that is seen on the
/// 3D view; its length means nothing. None where the voxels that are picked are inside what is
/// seen: on brightest voxels.
/// @param piece on which it is seen: the direction is turned back by its pose; 0: on the rest
[[nodiscard]] std::optional<glm::dvec3> lookingDirection(
    const gpu::VolumeScene& scene, int piece, const core::VolumeGeometry& geometry);

} // namespace ui
