// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/growth/SeedSpread.h"
#include "gpu/gl/Texture3D.h"

#include "core/brick/BrickGrid.h"

namespace gpu {

/// The costs and labels of growing from seeds (spread.glsl), 4 bytes per voxel, for the whole
/// bricks around a box. Engine thread only.
class SpreadField {
public:
    /// Allocates the field for a box. Its content is kept in bricks that stay if @p spread has the
    /// same plane, connectivity and costs as before and the previous computation was finished;
    /// bricks that are new then count as walls.
    /// @return whether content was kept
    bool fit(
        const core::BrickGrid& grid, const core::SpreadLabels& spread, const core::VoxelBox& box);
    void release();

    [[nodiscard]] const Texture3D& words() const { return m_words; }
    [[nodiscard]] const core::VoxelBox& box() const { return m_box; }
    [[nodiscard]] const glm::ivec3& firstBrick() const { return m_firstBrick; } ///< of the volume
    [[nodiscard]] const glm::ivec3& bricks() const { return m_bricks; }
    [[nodiscard]] std::size_t brickCount() const;
    /// The index, in the volume's grid, of the brick at a place of this field; x fastest.
    [[nodiscard]] std::uint32_t brickAt(const core::BrickGrid& grid, std::size_t place) const;
    [[nodiscard]] std::size_t bytes() const { return m_words ? m_words.bytes() : 0; }

    bool finished = false; ///< the content is the complete result for some seeds

private:
    Texture3D m_words;
    core::VoxelBox m_box;
    glm::ivec3 m_firstBrick{0};
    glm::ivec3 m_bricks{0};
    core::SpreadLabels m_spread;
};

} // namespace gpu
