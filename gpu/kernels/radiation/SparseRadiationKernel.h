// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/sculpt/radiation/SparseRadiation.h"
#include "gpu/gl/Buffer.h"
#include "gpu/gl/Program.h"
#include "gpu/gl/Texture3D.h"

#include <span>
#include <vector>

namespace gpu {

/// Radiation of sparse points, such as seeds: adds up the integer Gaussians of
/// core/sculpt/radiation/SparseRadiation.h in each voxel, tile by tile (sparseRadiation*.comp), and
/// finds the point with the greatest share.
///
/// Cost: one atomic addition per voxel of each footprint. Memory for 64 tiles, however many there
/// are. Engine thread only.
class SparseRadiationKernel {
public:
    /// A tile is a brick of 16³ voxels with the margin that filtering and gradients need: voxels −1
    /// … 17.
    static constexpr int tileSide = 19;

    struct Point {
        core::radiation::SparseFootprint footprint;
        std::uint8_t label = 0;
    };
    struct Tile {
        glm::ivec3 origin{0}; ///< voxel of its first texel
        glm::ivec3 texel{0}; ///< where that texel is written in the target
        std::vector<std::uint32_t> points; ///< indices of the points that reach the tile
    };

    explicit SparseRadiationKernel(const ShaderLibrary& library);

    /// Fills tiles. Red is the radiation. Green is the label of the point with the greatest share;
    /// of equal shares the greatest label; 0 if no point reaches.
    void update(
        std::span<const Point> points, std::span<const Tile> tiles, const Texture3D& target);

private:
    void add(std::span<const Point> points, std::span<const Tile> tiles);

    Program m_add;
    Program m_finish;
    Buffer m_footprints;
    Buffer m_tiles;
    Buffer m_sums; ///< two words per voxel: the sum; the greatest share and its label
};

} // namespace gpu
