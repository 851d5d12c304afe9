// SPDX-License-Identifier: Apache-2.0
#include "gpu/render/SeedDots.h"

#include "gpu/fields/textures/VolumeTextures.h"
#include "gpu/render/parts/RayBlocks.h"

#include <algorithm>

namespace gpu {

namespace {

constexpr int side = core::BrickGrid::side;
constexpr int tileSide = SparseRadiationKernel::tileSide;
constexpr int tilesPerRow = 16;
constexpr int tilesPerSlice = tilesPerRow * tilesPerRow;

glm::ivec3 placeOf(int tile)
{
    return tileSide
        * glm::ivec3(tile % tilesPerRow, tile / tilesPerRow % tilesPerRow, tile / tilesPerSlice);
}

/// Bricks whose tile a footprint reaches.
core::VoxelBox bricksOf(
    const core::radiation::SparseFootprint& footprint, const glm::ivec3& volumeBricks)
{
    // Tiles reach from one voxel before their brick to one after the voxel behind it.
    const glm::ivec3 last = footprint.first + footprint.count - 1;
    const auto brick = [](const glm::ivec3& voxel) { return voxel >> 4; };
    return {glm::clamp(brick(footprint.first - 1), glm::ivec3(0), volumeBricks - 1),
        glm::clamp(brick(last + 1), glm::ivec3(0), volumeBricks - 1) + 1};
}

} // namespace

SeedDots::SeedDots(const ShaderLibrary& library)
    : m_library(library)
{
}

bool SeedDots::set(const VolumeTextures& volume, const VolumeScene& scene)
{
    if (!scene.seeds || scene.seeds->empty()) {
        if (m_seeds)
            clear();
        return false;
    }
    const core::VolumeGeometry& geometry = volume.geometry();
    if (scene.seeds != m_seeds || geometry.size != m_volumeSize
        || geometry.indexToWorld != m_indexToWorld) {
        m_seeds = scene.seeds;
        m_volumeSize = geometry.size;
        m_indexToWorld = geometry.indexToWorld;
        radiate(volume, *m_seeds);
    }
    return bool(m_tiles);
}

void SeedDots::clear()
{
    m_seeds.reset();
    m_pages = {};
    m_tiles = {};
}

void SeedDots::radiate(const VolumeTextures& volume, const std::vector<SceneSeed>& seeds)
{
    const core::BrickGrid grid = volume.grid();
    const core::VolumeGeometry& geometry = volume.geometry();
    const glm::dvec3 radii =
        core::radiation::sparseRadii(core::radiation::sparseRadius, geometry.spacingMm());
    std::vector<SparseRadiationKernel::Point> points;
    std::vector<SparseRadiationKernel::Tile> tiles;
    std::vector<std::uint32_t> pages(std::size_t(grid.brickCount()), 0);
    glm::ivec3 low(volume.size());
    glm::ivec3 high(0);
    for (const SceneSeed& seed : seeds) {
        const glm::dvec3 index = geometry.toIndex(seed.lps);
        if (!geometry.contains(glm::ivec3(glm::round(index))))
            continue;
        const auto number = std::uint32_t(points.size());
        points.push_back({core::radiation::sparseFootprint(index, radii), seed.label});
        const core::radiation::SparseFootprint& footprint = points.back().footprint;
        const core::VoxelBox bricks = bricksOf(footprint, grid.bricks());
        for (int z = bricks.minimum.z; z < bricks.maximum.z; ++z) {
            for (int y = bricks.minimum.y; y < bricks.maximum.y; ++y) {
                for (int x = bricks.minimum.x; x < bricks.maximum.x; ++x) {
                    const glm::ivec3 brick(x, y, z);
                    std::uint32_t& page = pages[std::size_t(grid.brickOf(brick * side))];
                    if (page == 0) {
                        if (tiles.size() == mostTiles)
                            continue;
                        tiles.push_back({.origin = brick * side - 1,
                            .texel = placeOf(int(tiles.size())),
                            .points = {}});
                        page = std::uint32_t(tiles.size());
                    }
                    tiles[page - 1].points.push_back(number);
                }
            }
        }
        low = glm::min(low, footprint.first);
        high = glm::max(high, footprint.first + footprint.count - 1);
    }
    m_pages = {};
    m_tiles = {};
    if (tiles.empty())
        return;
    m_low = glm::vec3(low);
    m_high = glm::vec3(high);
    m_pages = Texture3D({.label = "pages of seeds", .size = grid.bricks(), .format = GL_R32UI});
    m_pages.upload(std::span<const std::uint32_t>(pages));
    const int slices = (int(tiles.size()) + tilesPerSlice - 1) / tilesPerSlice;
    const glm::ivec3 last = placeOf(int(std::min<std::size_t>(tiles.size(), tilesPerSlice)) - 1);
    m_tiles = Texture3D({.label = "tiles of seeds",
        .size = {int(tiles.size()) < tilesPerRow ? last.x + tileSide : tilesPerRow * tileSide,
            last.y + tileSide, slices * tileSide},
        .format = GL_RG8,
        .linear = true});
    if (!m_kernel)
        m_kernel.emplace(m_library);
    m_kernel->update(points, tiles, m_tiles);
}

Tile SeedDots::blocksIn(const VolumeScene& scene, const PassTarget& target) const
{
    return blocksAround(m_low - 1.0f, m_high + 1.0f, m_indexToWorld, scene, target);
}

void SeedDots::bind(Program& program) const
{
    m_pages.bindUnit(12);
    m_tiles.bindUnit(13);
    program.set("seedLow", m_low).set("seedHigh", m_high);
}

} // namespace gpu
