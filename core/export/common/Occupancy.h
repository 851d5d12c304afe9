// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace core {

/// How much of a voxel a segment fills, 0 … 255, where it was made of what a sculpt layer covers.
///
/// The voxel's coverage, wherever that agrees with the segment: one half and more (128) is a voxel
/// of it, less is none. Where the two have parted since, the segment is right: what was painted
/// later is whole, what was erased is nothing. So exactly the segment's voxels have 128 and more.
[[nodiscard]] constexpr std::uint8_t occupancyOf(bool inSegment, std::uint8_t coverage)
{
    if (inSegment)
        return coverage >= 128 ? coverage : 255;
    return coverage < 128 ? coverage : 0;
}

} // namespace core
