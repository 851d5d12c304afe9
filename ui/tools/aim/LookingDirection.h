// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/Volume.h"
#include "gpu/scene/Scene.h"

#include <glm/glm.hpp>

#include <optional>

namespace ui {

/// Returns the direction in which the user looks at a voxel in the 3D view, in the volume's index
/// space; its length has no meaning. None in modes that show projections (MIP, X-ray), because the
/// picked voxels then lie inside of what is seen.
/// @param piece on which the voxel is seen; the direction is rotated back by its pose; 0: on no
/// piece
[[nodiscard]] std::optional<glm::dvec3> lookingDirection(
    const gpu::VolumeScene& scene, int piece, const core::VolumeGeometry& geometry);

} // namespace ui
