// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/brick/VoxelRuns.h"

namespace core {

// Sets of voxels made of two others, besides united() (VoxelRuns.h). Cost: the runs.

/// The voxels that are in one of them and not in the other.
[[nodiscard]] VoxelRuns differing(const VoxelRuns& one, const VoxelRuns& other);
/// The voxels that are in both.
[[nodiscard]] VoxelRuns common(const VoxelRuns& one, const VoxelRuns& other);

} // namespace core
