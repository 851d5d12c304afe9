// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace core {

/// The index axis along which slices follow each other. Slices across K are the acquired ones.
/// Which of the three is axial, coronal or sagittal depends on how the volume lies in the patient.
enum class SliceAxis : std::uint8_t { I, J, K };

/// The component of an index vector that belongs to the axis itself.
[[nodiscard]] constexpr int alongOf(SliceAxis axis)
{
    return int(axis);
}
/// The components of the two axes within a slice; acrossOf() is the one whose voxels lie closer
/// together in memory.
[[nodiscard]] constexpr int acrossOf(SliceAxis axis)
{
    return axis == SliceAxis::I ? 1 : 0;
}
[[nodiscard]] constexpr int downOf(SliceAxis axis)
{
    return axis == SliceAxis::K ? 1 : 2;
}

} // namespace core
