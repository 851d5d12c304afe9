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

/// Finds out for each block of 32 × 32 pixels of a picture what its rays may pass: cuts, segments
/// or pieces. A ray caster that handles these costs several times as much as one that does not, and
/// on a software renderer a branch saves nothing; so each block is drawn by the simplest program
/// that draws it correctly. The blocks are found by projecting macro-cells and the cells of pieces;
/// a block may be classified as too complex but never as too simple.
class RayBlocks {
public:
    static constexpr int block = 32; ///< drawn pixels
    /// Carved: only cuts. Sculpted: cuts and segments. Pieces: any of these.
    enum class Kind : std::uint8_t { Plain, Carved, Sculpted, Pieces };
    static constexpr std::size_t kinds = 4;

    RayBlocks() = default;
    /// Cost: linear in the macro-cells that are carved, segments or pieces.
    RayBlocks(VolumeTextures& volume, const VolumeScene& scene, const PassTarget& target);

    /// The rectangles that together are the tile, by kind.
    /// @param tile begins at the corner of a block
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
/// that may extend beyond the picture.
/// @param low, high in index space
[[nodiscard]] Tile blocksAround(const glm::vec3& low, const glm::vec3& high,
    const glm::dmat4& indexToWorld, const VolumeScene& scene, const PassTarget& target);
[[nodiscard]] Tile blocksAround(const core::VoxelBox& voxels, const core::VolumeGeometry& geometry,
    const VolumeScene& scene, const PassTarget& target);

} // namespace gpu
