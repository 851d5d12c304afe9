// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/brick/VoxelRuns.h"

#include <span>

namespace core {

/// The voxels that bear a label. @param labels of a whole volume, x fastest. Cost: one pass.
[[nodiscard]] VoxelRuns labelRuns(std::span<const std::uint8_t> labels, std::uint8_t label);

} // namespace core
