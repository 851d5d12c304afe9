// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/sculpt/SparseRadiation.h"
#include "gpu/gl/Buffer.h"
#include "gpu/gl/Program.h"
#include "gpu/gl/Texture3D.h"

#include <span>
#include <vector>

namespace gpu {

/// Radiation of sparse points, such as seeds: the integer Gaussians of
/// core/sculpt/SparseRadiation.h added up, tile by tile (sparseRadiation*.comp), and whose point
/// counts most in each voxel.
///
/// Cost: the voxels of every footprint, one atomic addition each; memory for 64 tiles, however many
/// there are. Engine thread only.
class SparseRadiationKernel {
public:
    /// A tile is a brick of 16³ and what filtering and gradients need around it: voxels −1 … 17.
    static constexpr int tileSide = 19;

    struct Point {
        core::radiation::SparseFootprint footprint;
        std::uint8_t label = 0;
    };
    struct Tile {
        glm::ivec3 origin{0}; ///< voxel of its first texel
        glm::ivec3 texel{0}; ///< where that goes in the target
        std::vector<std::uint32_t> points; ///< numbers of those that reach it
    };

    explicit SparseRadiationKernel(const ShaderLibrary& library);

    /// Fills tiles: red the radiation; green the label of the point with the greatest part in it,
    /// of equal parts the greatest label, 0 where no point reaches.
    /// @param target RG8
    void update(
        std::span<const Point> points, std::span<const Tile> tiles, const Texture3D& target);

private:
    void add(std::span<const Point> points, std::span<const Tile> tiles);

    Program m_add;
    Program m_finish;
    Buffer m_footprints;
    Buffer m_tiles;
    Buffer m_sums; ///< two words a voxel: the sum; greatest part and label
};

} // namespace gpu
