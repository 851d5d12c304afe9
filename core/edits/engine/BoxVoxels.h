// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"
#include "core/edits/kinds/parts/GrowBox.h"
#include "core/volume/Volume.h"

namespace core {

/// The voxels of a box, as indices of two opposite corners; both corners belong to it.
struct VoxelSpan {
    glm::ivec3 from{0};
    glm::ivec3 to{0};
};
/// The voxels whose cells the corners of a box lie in, and all between them; cut to the volume.
/// Errors: InvalidField (@p field: no part of the box lies in the volume).
[[nodiscard]] Result<VoxelSpan> voxelsOf(
    const GrowBox& box, const VolumeGeometry& geometry, const QString& field);

} // namespace core
