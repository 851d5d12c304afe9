// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/brick/VoxelRuns.h"

#include <span>

namespace core {

/// The voxels that have a label. Cost: one pass over the volume.
/// @param labels of a whole volume, x fastest
[[nodiscard]] VoxelRuns labelRuns(std::span<const std::uint8_t> labels, std::uint8_t label);

} // namespace core
