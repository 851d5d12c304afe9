// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/brick/BrickGrid.h"
#include "gpu/gl/SoftwareDriver.h"
#include "gpu/gl/Texture3D.h"

#include <cstdint>
#include <set>
#include <span>
#include <vector>

namespace gpu {

class BrickField;
struct FieldPrograms;

/// The set of bricks that hold a barrier (a voxel that is closed to growth, stored in the seed
/// words). Pictures look for barriers only there. Engine thread only.
class BarrierBricks {
public:
    /// @param by whether kernels or the processor search the bricks
    BarrierBricks(FieldPrograms& programs, const core::BrickGrid& grid, WorkBy by = WorkBy::Driver);

    /// Notes that the seed words of these bricks may have changed.
    void note(std::span<const std::uint32_t> bricks);
    /// Notes these bricks and every brick that may have been in the set before.
    void noteAll(std::span<const std::uint32_t> bricks);
    [[nodiscard]] bool stale() const { return !m_stale.empty(); }
    /// Checks the noted bricks. Waits for the GPU if any of them has words.
    /// @return the box in which barriers may look different; empty if nowhere
    core::VoxelBox update(BrickField& words);

    [[nodiscard]] bool any() const { return !m_held.empty(); }
    /// The bricks of the set, ascending; those that were noted are searched, and stay noted. Waits
    /// for the GPU if any of them has words.
    [[nodiscard]] std::vector<std::uint32_t> bricks(BrickField& words);
    /// Those of @p bricks that hold a barrier, in the same order. All of them must have pages.
    [[nodiscard]] std::vector<std::uint32_t> found(
        BrickField& words, std::span<const std::uint32_t> bricks);
    /// Around all bricks that hold barriers.
    [[nodiscard]] const core::VoxelBox& box() const { return m_box; }
    /// R8UI, one texel per brick, 1 if it holds a barrier. There is no texture before the first
    /// barrier.
    [[nodiscard]] const Texture3D& texture() const { return m_texture; }

private:
    [[nodiscard]] std::vector<std::uint32_t> foundByKernel(
        BrickField& words, std::span<const std::uint32_t> bricks);

    FieldPrograms& m_programs;
    core::BrickGrid m_grid;
    bool m_byProcessor;
    std::set<std::uint32_t> m_stale;
    std::set<std::uint32_t> m_held;
    core::VoxelBox m_box;
    Texture3D m_texture;
};

} // namespace gpu
