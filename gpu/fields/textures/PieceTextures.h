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

/// What a piece is made of: a sculpt layer's cut, or a segment's voxels; the other is 0.
struct PieceSource {
    int layer = 0;
    int segment = 0;
    auto operator<=>(const PieceSource&) const = default;
};

/// Footprints of pieces: for each source a box of the volume whose texels are ≥ 0.5 where a voxel
/// belongs to the piece, radiated like a cut. All of them lie in one texture, so that a ray may
/// meet any number. Beside it, for every cell of 8³ voxels the greatest footprint that a sample in
/// it can meet. Engine thread.
class PieceTextures {
public:
    struct Entry {
        core::VoxelBox box; ///< of the volume; begins at the border of a cell
        glm::ivec3 place{0}; ///< texel of box.minimum, whole cells
        core::VoxelBox filled; ///< whole cells in which something is; empty: nothing is
        std::vector<glm::ivec3> cells; ///< those cells, of the volume
    };

    /// Makes room for these boxes, empty.
    void arrange(const std::map<PieceSource, core::VoxelBox>& boxes);
    /// Looks at one box again. Waits for the GPU. @param kernel fields/textures/pieceCells.comp
    void updateCells(Program& kernel, const PieceSource& source);

    /// null: no room was made for it
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
