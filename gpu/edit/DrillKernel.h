// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/engine/EngineCommands.h"
#include "gpu/edit/BeforeImages.h"
#include "gpu/edit/VoxelFields.h"

#include <map>
#include <set>
#include <vector>

namespace gpu {

/// The compiled kernels of drilling (drillCast.comp, drillCut.comp).
struct DrillPrograms {
    explicit DrillPrograms(const ShaderLibrary& library);

    Program cast;
    Program cut;
};

/// One drill stroke while the pen is down (rules: core/sculpt/DrillCut.h).
///
/// The depth map lives in tiles of 16 × 16 mask elements, on the processor and mirrored on the GPU.
/// extend() casts the elements that the mask reaches for the first time, cuts the bricks below the
/// elements that went deeper and brings radiation up to date there; radiation as it was at pen-down
/// is kept for the rays to come. Cost ∝ what the piece of path touches. Engine thread only.
class DrillKernel {
public:
    DrillKernel(DrillPrograms& programs, VoxelFields& fields, BeforeImages& before,
        const core::DrillCut& cut);

    void extend(const std::vector<core::DrillSample>& samples);

    /// Bricks whose coverage was raised.
    [[nodiscard]] std::vector<std::uint32_t> touchedBricks() const;

private:
    struct Element {
        std::int32_t depth = 0;
        std::int32_t surface = 0; ///< INT_MAX: none
        std::int32_t exit = 0;
    };
    struct Tile {
        std::vector<Element> elements;
        std::uint32_t slot = 0;
    };
    /// A stretch of plane space that a piece of path may have cut.
    struct PlaneBox {
        glm::ivec3 minimum{0}; ///< mm16
        glm::ivec3 maximum{0};
    };

    /// Rule 1 over the samples; returns elements that went deeper.
    [[nodiscard]] std::vector<glm::ivec2> deepen(const std::vector<core::DrillSample>& samples);
    void castNew();
    void mirrorTiles();
    [[nodiscard]] std::vector<PlaneBox> boxesOf(const std::vector<glm::ivec2>& elements);
    [[nodiscard]] std::vector<std::uint32_t> candidateBricks(
        const std::vector<PlaneBox>& boxes) const;
    /// Returns the bricks that changed.
    [[nodiscard]] std::vector<std::uint32_t> cutBricks(
        const std::vector<std::uint32_t>& candidates);
    void keepRadiation(const std::vector<std::uint32_t>& bricks);
    [[nodiscard]] glm::ivec3 planeBase(std::uint32_t brick) const;
    [[nodiscard]] Element& element(const glm::ivec2& at);
    [[nodiscard]] Tile& tileOf(const glm::ivec2& at);

    DrillPrograms& m_programs;
    VoxelFields& m_fields;
    BeforeImages& m_before;
    core::DrillCut m_cut;
    glm::ivec3 m_perI{0}; ///< mm16 per voxel
    glm::ivec3 m_perJ{0};
    glm::ivec3 m_perK{0};
    glm::ivec2 m_firstTile{0};
    glm::ivec2 m_tileCount{0};
    std::map<std::pair<int, int>, Tile> m_tiles;
    std::set<std::pair<int, int>> m_staleTiles;
    std::vector<glm::ivec2> m_uncast;
    Buffer m_tileSlots;
    Buffer m_elements;
    std::uint32_t m_elementSlots = 0;
    Buffer m_snapshotSlots;
    std::vector<std::uint32_t> m_snapshotOf;
    std::uint32_t m_snapshotCount = 0;
    std::uint32_t m_snapshotCapacity = 0;
    Buffer m_snapshots;
    std::set<std::uint32_t> m_touched;
};

} // namespace gpu
