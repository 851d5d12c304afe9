// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/VolumeGeometry.h"
#include "gpu/scene/PassTarget.h"
#include "gpu/scene/Scene.h"
#include "gpu/scene/TilePlan.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace gpu {

class VolumeTextures;

/// What rays through a picture's blocks of 32 × 32 pixels may come near to. A ray caster that knows
/// of cuts, segments and pieces costs several times as much as one that does not, and on a software
/// renderer a branch saves nothing; so each block is drawn by the simplest program that draws it
/// right. Found by projecting macro-cells and those of pieces; never too little.
class RayBlocks {
public:
    static constexpr int block = 32; ///< drawn pixels
    /// Carved: cuts only. Sculpted: cuts and segments. Pieces: any of it.
    enum class Kind : std::uint8_t { Plain, Carved, Sculpted, Pieces };
    static constexpr std::size_t kinds = 4;

    RayBlocks() = default;
    /// Cost: linear in the macro-cells that are carved, segments or pieces.
    RayBlocks(VolumeTextures& volume, const VolumeScene& scene, const PassTarget& target);

    /// Rectangles that together are the tile, by kind. @param tile begins at a block's corner
    [[nodiscard]] std::array<std::vector<Tile>, kinds> split(const Tile& tile) const;

private:
    void markCells(VolumeTextures& volume, const std::vector<glm::ivec3>& cells, Kind kind,
        const VolumeScene& scene, const PassTarget& target);
    void markPieces(VolumeTextures& volume, const VolumeScene& scene, const PassTarget& target);
    [[nodiscard]] Kind at(const glm::ivec2& place) const;

    glm::ivec2 m_blocks{0};
    std::vector<Kind> m_kinds; ///< empty: all plain
};

/// The blocks of a picture in which a box of the volume is seen, as one rectangle of drawn pixels
/// that may reach beyond it. @param low, high index space
[[nodiscard]] Tile blocksAround(const glm::vec3& low, const glm::vec3& high,
    const glm::dmat4& indexToWorld, const VolumeScene& scene, const PassTarget& target);
[[nodiscard]] Tile blocksAround(const core::VoxelBox& voxels, const core::VolumeGeometry& geometry,
    const VolumeScene& scene, const PassTarget& target);

} // namespace gpu
