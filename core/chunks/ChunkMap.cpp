// SPDX-License-Identifier: Apache-2.0
#include "core/chunks/ChunkMap.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <utility>

namespace core {

std::optional<VoxelBox> ChunkMap::boxAround(std::span<const std::uint8_t> labels,
    std::uint8_t label, const VolumeGeometry& geometry, double marginMm)
{
    const glm::ivec3& size = geometry.size;
    VoxelBox box{.minimum = size, .maximum = glm::ivec3(0)};
    std::size_t at = 0;
    for (int z = 0; z < size.z; ++z) {
        for (int y = 0; y < size.y; ++y) {
            for (int x = 0; x < size.x; ++x, ++at) {
                if (labels[at] != label)
                    continue;
                box.minimum = glm::min(box.minimum, glm::ivec3(x, y, z));
                box.maximum = glm::max(box.maximum, glm::ivec3(x, y, z) + 1);
            }
        }
    }
    if (box.empty())
        return std::nullopt;
    return withMargin(box, geometry, marginMm);
}

VoxelBox ChunkMap::withMargin(const VoxelBox& box, const VolumeGeometry& geometry, double marginMm)
{
    // More than the volume's size is never needed, and would not fit an int.
    const glm::dvec3 most(geometry.size);
    const glm::ivec3 margin(glm::min(glm::ceil(glm::dvec3(marginMm) / geometry.spacingMm()), most));
    return {.minimum = glm::max(box.minimum - margin, glm::ivec3(0)),
        .maximum = glm::min(box.maximum + margin, geometry.size)};
}

double ChunkMap::suitableMarginMm(std::int64_t voxels, const VolumeGeometry& geometry)
{
    constexpr double leastMm = 10.0;
    constexpr double mostMm = 60.0;
    constexpr double stepMm = 5.0;
    constexpr double mostVoxels = 24e6;
    // Organs are no balls: the box around one is about so much larger than around a ball.
    constexpr double boxOverBall = 1.5;
    const glm::dvec3 spacing = geometry.spacingMm();
    const double voxelMm3 = spacing.x * spacing.y * spacing.z;
    const double diameterMm = std::cbrt(6.0 / std::numbers::pi * double(voxels) * voxelMm3);
    double margin = std::clamp(diameterMm / 3.0, leastMm, mostMm);
    margin = stepMm * std::round(margin / stepMm);
    const auto boxVoxels = [&](double marginMm) {
        return boxOverBall * std::pow(diameterMm + 2.0 * marginMm, 3.0) / voxelMm3;
    };
    while (margin > leastMm && boxVoxels(margin) > mostVoxels)
        margin -= stepMm;
    return margin;
}

ChunkMap::ChunkMap(
    const glm::ivec3& volumeSize, const VoxelBox& box, ChunkTree tree, ChunkSurvey survey)
    : m_volumeSize(volumeSize)
    , m_box(box)
    , m_tree(std::move(tree))
    , m_survey(std::move(survey))
{
}

std::optional<ChunkTree::Chunk> ChunkMap::chunkAt(const glm::ivec3& voxel, int division) const
{
    const glm::ivec3 size = m_box.maximum - m_box.minimum;
    const glm::ivec3 within = voxel - m_box.minimum;
    if (glm::any(glm::lessThan(within, glm::ivec3(0)))
        || glm::any(glm::greaterThanEqual(within, size)))
        return std::nullopt;
    return m_tree.chunkAt(
        (std::size_t(within.z) * std::size_t(size.y) + std::size_t(within.y)) * std::size_t(size.x)
            + std::size_t(within.x),
        division);
}

std::uint64_t ChunkMap::inVolume(std::uint32_t boxVoxel) const
{
    const glm::ivec3 size = m_box.maximum - m_box.minimum;
    const auto columns = std::uint32_t(size.x);
    const auto rows = std::uint32_t(size.y);
    const auto x = std::uint64_t(m_box.minimum.x) + boxVoxel % columns;
    const auto y = std::uint64_t(m_box.minimum.y) + boxVoxel / columns % rows;
    const auto z = std::uint64_t(m_box.minimum.z) + boxVoxel / columns / rows;
    return (z * std::uint64_t(m_volumeSize.y) + y) * std::uint64_t(m_volumeSize.x) + x;
}

std::vector<ChunkTree::Chunk> ChunkMap::chunksAt(
    const std::vector<glm::ivec3>& voxels, int division) const
{
    std::set<ChunkTree::Chunk> chunks;
    for (const glm::ivec3& voxel : voxels) {
        if (const auto chunk = chunkAt(voxel, division))
            chunks.insert(*chunk);
    }
    return {chunks.begin(), chunks.end()};
}

VoxelRuns ChunkMap::voxels(ChunkTree::Chunk chunk) const
{
    // Within a chunk voxels stand piece by piece, not in the volume's order.
    const auto inBox = m_tree.voxels(chunk);
    std::vector<std::uint32_t> ascending(inBox.begin(), inBox.end());
    std::sort(ascending.begin(), ascending.end());
    VoxelRuns runs;
    for (const std::uint32_t voxel : ascending)
        runs.append(inVolume(voxel), 1);
    return runs;
}

ChunkChange ChunkMap::toggled(const std::vector<glm::ivec3>& clicked, int division,
    std::span<const std::uint8_t> labels, std::uint8_t label) const
{
    ChunkChange change;
    for (const ChunkTree::Chunk chunk : chunksAt(clicked, division)) {
        const VoxelRuns runs = voxels(chunk);
        std::uint64_t held = 0;
        for (const VoxelRun& run : runs.runs()) {
            const auto first = labels.begin() + std::ptrdiff_t(run.first);
            held += std::uint64_t(std::count(first, first + std::ptrdiff_t(run.count), label));
        }
        VoxelRuns& target = 2 * held > runs.voxelCount() ? change.taken : change.given;
        target = united(target, runs);
    }
    return change;
}

} // namespace core
