// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/brick/VoxelRuns.h"

namespace core {

// Set operations on voxel runs, besides united() (VoxelRuns.h). The cost is linear in the runs.

/// The voxels that are in exactly one of them.
[[nodiscard]] VoxelRuns differing(const VoxelRuns& one, const VoxelRuns& other);
/// The voxels that are in both.
[[nodiscard]] VoxelRuns common(const VoxelRuns& one, const VoxelRuns& other);

} // namespace core
