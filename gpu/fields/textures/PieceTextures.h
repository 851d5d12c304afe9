// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/brick/BrickGrid.h"
#include "gpu/gl/Program.h"
#include "gpu/gl/Texture3D.h"

#include <glm/glm.hpp>

#include <compare>
#include <map>
#include <vector>

namespace gpu {

/// What a piece consists of: the cut of a sculpt layer or the voxels of a segment. The other one is
/// 0.
struct PieceSource {
    int layer = 0;
    int segment = 0;
    auto operator<=>(const PieceSource&) const = default;
};

/// The footprints of pieces (core::Piece). For each source there is a box of the volume whose
/// texels are ≥ 0.5 where a voxel belongs to the piece, smoothed like a cut. All boxes lie in one
/// texture, so that a ray may pass through any number of pieces. A second texture holds, for every
/// cell of 8³ voxels, the greatest footprint that a sample in it can read. Engine thread.
class PieceTextures {
public:
    struct Entry {
        core::VoxelBox box; ///< in the volume; begins at the border of a cell
        glm::ivec3 place{0}; ///< the texel where box.minimum lies; a multiple of the cell size
        /// The whole cells that hold any of the piece; empty if there are none.
        core::VoxelBox filled;
        std::vector<glm::ivec3> cells; ///< those cells, in cells of the volume
    };

    /// Allocates these boxes, with empty footprints. Throws GlFailure where that is refused, or
    /// they do not fit into a texture; then there are none.
    void arrange(const std::map<PieceSource, core::VoxelBox>& boxes);
    /// Updates the cells of one source. Waits for the GPU.
    /// @param kernel fields/textures/pieceCells.comp
    void updateCells(Program& kernel, const PieceSource& source);

    /// Null if arrange() was not given this source.
    [[nodiscard]] const Entry* entry(const PieceSource& source) const;
    [[nodiscard]] const std::map<PieceSource, Entry>& entries() const { return m_entries; }
    [[nodiscard]] const Texture3D& footprints() const { return m_footprints; } ///< R8, linear
    [[nodiscard]] const Texture3D& footprintBytes() const { return m_bytes; } ///< R8UI view
    [[nodiscard]] const Texture3D& cells() const { return m_cells; } ///< R8UI
    [[nodiscard]] std::size_t bytes() const;

private:
    std::map<PieceSource, Entry> m_entries;
    Texture3D m_footprints;
    Texture3D m_bytes;
    Texture3D m_cells;
};

} // namespace gpu
