// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/brick/BrickGrid.h"
#include "gpu/gl/Texture3D.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace gpu {

/// Chunks (core/chunks) as bodies with smooth boundaries, for the 3D view. The colours of their
/// voxels are smoothed over two voxels in every direction: where two chunks meet a ray sees one
/// colour change into the other, and the gradient tells the direction of the boundary. Cells of 8³
/// voxels with a single colour are marked, and a ray leaves them in one step. Computed on the
/// processor, since cells inside chunks cost next to nothing there. Engine thread only.
class ChunkBodies {
public:
    static constexpr int side = 8; ///< of a cell
    static constexpr int reach = 2; ///< of the smoothing
    using Colour = std::array<std::uint8_t, 4>;

    /// @param size of the box
    /// @param leaves chunk of each voxel of the box
    /// @param colours by leaf, the first for voxels without a chunk; all 0: invisible
    /// @param changed voxels whose colour may have changed since the last call; all of them the
    /// first time
    /// Cost ∝ the cells around these, about ten times as much in cells of several colours.
    void update(const glm::ivec3& size, std::span<const std::uint16_t> leaves,
        std::span<const Colour> colours, const core::VoxelBox& changed);
    /// @param colours texture unit for RGBA8, linear, one texel per voxel of the box
    /// @param cells texture unit for R8UI: 0 where no sample between this cell's first voxel and
    /// the next cell's first voxel sees another colour
    void bind(GLuint colours, GLuint cells) const;
    [[nodiscard]] std::size_t bytes() const { return m_colours.bytes() + m_cells.bytes(); }
    explicit operator bool() const { return bool(m_colours); }

private:
    Texture3D m_colours;
    Texture3D m_cells;
};

} // namespace gpu
