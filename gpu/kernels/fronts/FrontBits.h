// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/growth/GrowthCommands.h"
#include "core/growth/front/BrickFront.h"
#include "gpu/fields/bricks/BrickField.h"
#include "gpu/gl/Buffer.h"
#include "gpu/gl/Program.h"
#include "gpu/shaders/ShaderLibrary.h"

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace gpu {

/// The compiled kernel that finds which voxels a growth may still claim (frontBitsOpen.comp).
/// @param ranged whether the burst has a core::GrowthRange
[[nodiscard]] Program openBitsProgram(
    const ShaderLibrary& shaders, const core::GrowLimits& limits, bool ranged);
/// Runs it over bricks that have pages, and reads what it finds. Engine thread only. Bind what
/// growth.glsl declares before.
/// @param grid size of the volume in bricks
[[nodiscard]] std::vector<core::VoxelBits> openBits(Program& program, const BrickField& words,
    const glm::ivec3& grid, std::uint8_t label, std::span<const std::uint32_t> bricks);

/// The compiled kernels of growth fronts stored as bits (frontBits*.comp).
struct FrontBitsPrograms {
    /// @param overwritten whether they also write the labels that growth takes from other segments
    /// @param ranged whether the burst has a core::GrowthRange
    FrontBitsPrograms(const ShaderLibrary& shaders, int connectivity,
        const core::GrowLimits& limits, bool overwritten, bool ranged);

    Program open;
    Program fill;
    Program reach;
    Program ring;
    Program end;
};

/// The front of a growth as bits, one per voxel, together with the voxels that it may still claim.
/// A wide front costs about one word operation per row, whereas a queue costs something for every
/// voxel and each of its neighbours (ALGORITHMS 1.6.10). It can be used for growths of one label
/// whose limits do not depend on the parent voxel.
///
/// Takes 1.6 KiB per brick of the volume while a burst is open that needed it. The seed words that
/// it writes equal those of growRing.comp, to the bit. Engine thread only. The caller
/// (GrowthKernel) binds what growth.glsl declares, and owns pages and before-images.
class FrontBits {
public:
    /// Whether the limits of a growth allow the use of bits.
    [[nodiscard]] static bool isFor(const core::GrowLimits& limits);
    /// Whether a front is so wide that bits are cheaper than a queue.
    [[nodiscard]] bool pays(std::uint32_t frontVoxels, std::size_t bricksInReach) const;

    /// Whether the front is currently stored here.
    [[nodiscard]] bool holdsFront() const { return m_holdsFront; }
    struct Front {
        std::uint8_t label = 0;
        std::uint32_t generation = 0;
        std::uint32_t voxels = 0; ///< number of voxels in the queue; equals state.counts[0]
    };
    /// Takes the front over from the queue.
    void enter(FrontBitsPrograms& programs, int brickCount, const Front& front);
    void leave() { m_holdsFront = false; }

    /// Runs some generations one after the other.
    /// @param grid size of the volume in bricks
    /// @param bricks all bricks that the front may reach; they have pages
    void advance(FrontBitsPrograms& programs, const BrickField& words, const glm::ivec3& grid,
        std::uint32_t generation, int rings, std::span<const std::uint32_t> bricks);

private:
    void bind(unsigned front) const;

    Buffer m_fronts[2]; ///< one holds the last generation, the other is empty
    Buffer m_open;
    Buffer m_reach; ///< list of the bricks that the generation may change
    unsigned m_front = 0;
    std::vector<bool> m_known; ///< bricks for which m_open is filled
    bool m_holdsFront = false;
    std::uint8_t m_label = 0;
};

} // namespace gpu
