// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace core {

/// How much of a voxel a segment fills, 0 … 255, if it was made from the coverage of a sculpt
/// layer.
///
/// It is the voxel's coverage if that agrees with the segment: a value of one half and more (128)
/// belongs to the segment, a lower one does not. Where segment and layer were changed since, the
/// segment decides: what was painted later is full, what was erased is empty. So exactly the
/// segment's voxels have 128 and more.
[[nodiscard]] constexpr std::uint8_t occupancyOf(bool inSegment, std::uint8_t coverage)
{
    if (inSegment)
        return coverage >= 128 ? coverage : 255;
    return coverage < 128 ? coverage : 0;
}

} // namespace core
