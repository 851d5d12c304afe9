// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/engine/EngineCommands.h"
#include "gpu/fields/bricks/BrickField.h"
#include "gpu/gl/Buffer.h"
#include "gpu/gl/Program.h"
#include "gpu/shaders/ShaderLibrary.h"

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace gpu {

/// The compiled kernels of fronts as bits (frontBits*.comp).
struct FrontBitsPrograms {
    /// @param beneath what lies beneath members is written
    FrontBitsPrograms(const ShaderLibrary& shaders, int connectivity,
        const core::GrowLimits& limits, bool beneath);

    Program open;
    Program fill;
    Program reach;
    Program ring;
    Program end;
};

/// The front of a growth as bits, one a voxel, and what it may still claim: wide fronts go on at
/// about the price of a word a row, where a queue pays for every voxel and each of its neighbours
/// (ALGORITHMS 1.6.10). For growths of one label whose limits ask nothing about parents.
///
/// 1.6 KiB a brick of the volume while a burst is open that came to need it. The words that it
/// writes are those of growRing.comp, to the bit. Engine thread only; who uses it binds what
/// growth.glsl declares (GrowthKernel), which also owns pages and before-images.
class FrontBits {
public:
    /// Whether limits allow for it.
    [[nodiscard]] static bool isFor(const core::GrowLimits& limits);
    /// Whether a front is wide enough to be cheaper so, or still is.
    [[nodiscard]] bool pays(std::uint32_t frontVoxels, std::size_t bricksInReach) const;

    /// Whether the front stands here.
    [[nodiscard]] bool holdsFront() const { return m_holdsFront; }
    struct Front {
        std::uint8_t label = 0;
        std::uint32_t generation = 0;
        std::uint32_t voxels = 0; ///< in the queue; in state.counts[0] too
    };
    /// Takes the front from the queue.
    void enter(FrontBitsPrograms& programs, int brickCount, const Front& front);
    void leave() { m_holdsFront = false; }

    /// Generations in turn. @param grid in bricks @param bricks all that the front may reach; they
    /// have pages
    void advance(FrontBitsPrograms& programs, const BrickField& words, const glm::ivec3& grid,
        std::uint32_t generation, int rings, std::span<const std::uint32_t> bricks);

private:
    void bind(unsigned front) const;

    Buffer m_fronts[2]; ///< one is that of the last generation, the other empty
    Buffer m_open;
    Buffer m_reach; ///< list of the bricks that a generation may change
    unsigned m_front = 0;
    std::vector<bool> m_known; ///< bricks of which `open` tells
    bool m_holdsFront = false;
    std::uint8_t m_label = 0;
};

} // namespace gpu
