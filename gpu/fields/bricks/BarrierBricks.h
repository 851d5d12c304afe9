// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/brick/BrickGrid.h"
#include "gpu/gl/Texture3D.h"

#include <cstdint>
#include <set>
#include <span>

namespace gpu {

class BrickField;
struct FieldPrograms;

/// Which bricks of the seed words hold a voxel that is shut to growth, for pictures: they look for
/// barriers nowhere else. Engine thread only.
class BarrierBricks {
public:
    BarrierBricks(FieldPrograms& programs, const core::BrickGrid& grid);

    /// The words of these may be others now.
    void note(std::span<const std::uint32_t> bricks);
    /// Of these words, and wherever there were barriers.
    void noteAll(std::span<const std::uint32_t> bricks);
    [[nodiscard]] bool stale() const { return !m_stale.empty(); }
    /// Looks at what was noted. @return where barriers may look different; empty: nowhere
    core::VoxelBox update(BrickField& words);

    [[nodiscard]] bool any() const { return !m_held.empty(); }
    [[nodiscard]] const core::VoxelBox& box() const { return m_box; } ///< of all that hold some
    /// R8UI, one texel a brick, 1: holds some. There is none before the first.
    [[nodiscard]] const Texture3D& texture() const { return m_texture; }

private:
    FieldPrograms& m_programs;
    core::BrickGrid m_grid;
    std::set<std::uint32_t> m_stale;
    std::set<std::uint32_t> m_held;
    core::VoxelBox m_box;
    Texture3D m_texture;
};

} // namespace gpu
