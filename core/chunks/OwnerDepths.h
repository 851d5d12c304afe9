// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/chunks/ChunkField.h"

#include <cstdint>
#include <vector>

namespace core {

/// For each voxel of a box, the number of steps between face neighbours to the nearest voxel of
/// another owner; voxels that are left out (ChunkSource::outside) count as an owner. 0 everywhere
/// if the whole box has one owner. Cost: a few passes over the box, on all cores.
[[nodiscard]] std::vector<std::uint16_t> ownerDepths(const ChunkSource& source);

} // namespace core
