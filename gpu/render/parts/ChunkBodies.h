// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/brick/BrickGrid.h"
#include "gpu/gl/Texture3D.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace gpu {

/// Chunks as bodies with smooth boundaries, for the 3D view: the colours of their voxels smoothed
/// over two voxels on all sides, so that where two meet a ray sees one colour go over into the
/// other and knows the way across; and which cells of 8³ voxels are of one colour all over, which
/// it leaves in one step. Worked out on the processor, since the cells inside chunks cost next to
/// nothing there. Engine thread only.
class ChunkBodies {
public:
    static constexpr int side = 8; ///< of a cell
    static constexpr int reach = 2; ///< of the smoothing
    using Colour = std::array<std::uint8_t, 4>;

    /// @param size of the box @param leaves by voxel of it @param colours by leaf, the first of
    /// none; all 0: not to be seen
    /// @param changed voxels whose colour may be another one than last time; all of them the first
    /// time
    /// Cost ∝ the cells about these, some ten times as much where they are of several colours.
    void update(const glm::ivec3& size, std::span<const std::uint16_t> leaves,
        std::span<const Colour> colours, const core::VoxelBox& changed);
    /// @param colours unit of RGBA8, linear, by voxel of the box @param cells unit of R8UI: 0 where
    /// no sample between this cell's first voxel and the next one's sees another colour
    void bind(GLuint colours, GLuint cells) const;
    [[nodiscard]] std::size_t bytes() const { return m_colours.bytes() + m_cells.bytes(); }
    explicit operator bool() const { return bool(m_colours); }

private:
    Texture3D m_colours;
    Texture3D m_cells;
};

} // namespace gpu
