// SPDX-License-Identifier: Apache-2.0
#include "gpu/kernels/radiation/SparseRadiationKernel.h"

#include <algorithm>
#include <array>

namespace gpu {

namespace {

constexpr std::size_t tilesPerPass = 64;
constexpr std::size_t footprintsPerDispatch = 8192;
constexpr int tileSide = SparseRadiationKernel::tileSide;
constexpr std::size_t tileVoxels = std::size_t(tileSide) * tileSide * tileSide;
constexpr unsigned finishGroups = (unsigned(tileVoxels) + 63) / 64;
constexpr std::size_t longest = core::radiation::SparseFootprint::longest;

/// As sparseRadiation.comp reads it (std430).
struct GpuFootprint {
    glm::ivec4 first; ///< in its tile; w: the tile's number in the pass
    glm::ivec4 count; ///< w: label
    std::array<std::uint32_t, 3 * longest + 1> weights;
};
static_assert(sizeof(GpuFootprint) == 240);

GpuFootprint gpuFootprint(
    const SparseRadiationKernel::Point& point, const glm::ivec3& tileOrigin, std::size_t slot)
{
    GpuFootprint result{
        .first = glm::ivec4(point.footprint.first - tileOrigin, int(slot)),
        .count = glm::ivec4(point.footprint.count, int(point.label)),
        .weights = {},
    };
    for (std::size_t axis = 0; axis < 3; ++axis)
        std::copy(point.footprint.weights[axis].begin(), point.footprint.weights[axis].end(),
            result.weights.begin() + std::ptrdiff_t(axis * longest));
    return result;
}

} // namespace

SparseRadiationKernel::SparseRadiationKernel(const ShaderLibrary& library)
    : m_add(library,
        ComputeProgramOptions{
            .label = "sparse radiation", .path = "kernels/radiation/sparseRadiation.comp"})
    , m_finish(library,
          ComputeProgramOptions{.label = "sparse radiation, tiles",
              .path = "kernels/radiation/sparseRadiationTile.comp"})
    , m_footprints({.label = "sparse radiation footprints",
          .bytes = footprintsPerDispatch * sizeof(GpuFootprint)})
    , m_tiles({.label = "sparse radiation tiles", .bytes = tilesPerPass * sizeof(glm::ivec4)})
    , m_sums({.label = "sparse radiation sums",
          .bytes = 2 * tileVoxels * tilesPerPass * sizeof(std::uint32_t)})
{
}

void SparseRadiationKernel::update(
    std::span<const Point> points, std::span<const Tile> tiles, const Texture3D& target)
{
    for (std::size_t start = 0; start < tiles.size(); start += tilesPerPass) {
        const auto pass = tiles.subspan(start, std::min(tilesPerPass, tiles.size() - start));
        std::vector<glm::ivec4> texels;
        for (const Tile& tile : pass)
            texels.emplace_back(tile.texel, 0);
        m_tiles.write(std::span<const glm::ivec4>(texels));
        m_sums.fill(0);
        glMemoryBarrier(GL_ALL_BARRIER_BITS);
        add(points, pass);

        m_tiles.bindBase(GL_SHADER_STORAGE_BUFFER, 0);
        m_sums.bindBase(GL_SHADER_STORAGE_BUFFER, 1);
        target.bindImage(0, GL_WRITE_ONLY);
        m_finish.dispatch({finishGroups, unsigned(pass.size()), 1});
    }
    glMemoryBarrier(GL_ALL_BARRIER_BITS);
}

void SparseRadiationKernel::add(std::span<const Point> points, std::span<const Tile> tiles)
{
    std::vector<GpuFootprint> waiting;
    const auto flush = [&] {
        if (waiting.empty())
            return;
        m_footprints.write(std::span<const GpuFootprint>(waiting));
        m_footprints.bindBase(GL_SHADER_STORAGE_BUFFER, 0);
        m_sums.bindBase(GL_SHADER_STORAGE_BUFFER, 1);
        m_add.dispatch({unsigned(waiting.size()), 1, 1});
        glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_BUFFER_UPDATE_BARRIER_BIT);
        waiting.clear();
    };
    for (std::size_t slot = 0; slot < tiles.size(); ++slot) {
        for (const std::uint32_t point : tiles[slot].points) {
            waiting.push_back(gpuFootprint(points[point], tiles[slot].origin, slot));
            if (waiting.size() == footprintsPerDispatch)
                flush();
        }
    }
    flush();
}

} // namespace gpu
