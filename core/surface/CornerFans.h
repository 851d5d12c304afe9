// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>

namespace core {

/// How the border faces that meet at a corner of eight voxels hang together there.
///
/// Voxel v of the eight has bit a set where it lies beyond the corner along axis a; a configuration
/// has bit v set where voxel v is inside. Faces that share an edge hang together; where four do,
/// those of one voxel. Each fan of faces gets a vertex of its own.
struct CornerFans {
    std::uint8_t count = 0;
    std::array<std::uint8_t, 12> fanOf{}; ///< by face, see cornerFace()
    std::uint8_t crossed = 0; ///< bit 2 · axis + beyond: edges at which four faces meet
};

/// The face between the voxels before and beyond the corner along @p axis; the others' bits say on
/// which side along the two axes that follow it, cyclically.
[[nodiscard]] constexpr int cornerFace(int axis, int bitOfNext, int bitOfSecond)
{
    return 4 * axis + bitOfNext + 2 * bitOfSecond;
}

[[nodiscard]] const CornerFans& cornerFans(std::uint8_t configuration);

} // namespace core
