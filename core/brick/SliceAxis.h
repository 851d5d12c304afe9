// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace core {

/// The index axis along which slices follow each other: those of K are the acquired ones. Axial,
/// coronal or sagittal is what the volume's position makes of it.
enum class SliceAxis : std::uint8_t { I, J, K };

/// The places in a vector of index space: of the axis itself,
[[nodiscard]] constexpr int alongOf(SliceAxis axis)
{
    return int(axis);
}
/// and of the two within a slice, first the one whose voxels lie closer in memory.
[[nodiscard]] constexpr int acrossOf(SliceAxis axis)
{
    return axis == SliceAxis::I ? 1 : 0;
}
[[nodiscard]] constexpr int downOf(SliceAxis axis)
{
    return axis == SliceAxis::K ? 1 : 2;
}

} // namespace core
