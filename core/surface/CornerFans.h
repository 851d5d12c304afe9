// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>

namespace core {

/// How the border faces that meet at a corner of eight voxels are connected there.
///
/// Bit a of the number v of a voxel is set if the voxel lies beyond the corner along axis a; bit v
/// of a configuration is set if voxel v is inside. Faces that share an edge are connected; where
/// four faces share an edge, those of one voxel are. Each fan of connected faces gets a vertex of
/// its own.
struct CornerFans {
    std::uint8_t count = 0;
    std::array<std::uint8_t, 12> fanOf{}; ///< by face, see cornerFace()
    std::uint8_t crossed = 0; ///< bit 2 · axis + beyond: edges at which four faces meet
};

/// The face between the voxels before and beyond the corner along @p axis. The other bits say on
/// which side it is along the two following axes, cyclically.
[[nodiscard]] constexpr int cornerFace(int axis, int bitOfNext, int bitOfSecond)
{
    return 4 * axis + bitOfNext + 2 * bitOfSecond;
}

[[nodiscard]] const CornerFans& cornerFans(std::uint8_t configuration);

} // namespace core
