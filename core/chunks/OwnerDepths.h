// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/chunks/ChunkField.h"

#include <cstdint>
#include <vector>

namespace core {

/// For each voxel of a box the number of steps (six neighbours) to the nearest one of another
/// owner, what is left out included; 0 everywhere if all are of one owner. Cost: a few passes, on
/// all cores.
[[nodiscard]] std::vector<std::uint16_t> ownerDepths(const ChunkSource& source);

} // namespace core
