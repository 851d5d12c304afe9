// SPDX-License-Identifier: Apache-2.0
#include "core/session/past/LabelReader.h"

#include "core/engine/EngineCommands.h"

#include <algorithm>

namespace core {

namespace {

constexpr int leastPortion = 1024; ///< bricks
constexpr int mostPortion = 8 * leastPortion;
/// Of so much of a usual portion the next one may cover more.
constexpr std::size_t little = leastPortion / 4;

template <class Does>
void forEachVoxel(const BrickGrid& grid, const BrickImage& brick, std::uint8_t label, Does does)
{
    const std::vector<std::uint8_t>& bytes = brick.bytes.read();
    const glm::ivec3 first = grid.boxOf(int(brick.key.brick)).minimum;
    int offset = 0;
    for (int z = 0; z < BrickGrid::side; ++z) {
        for (int y = 0; y < BrickGrid::side; ++y) {
            for (int x = 0; x < BrickGrid::side; ++x, ++offset) {
                if (bytes[std::size_t(offset)] == label)
                    does(first + glm::ivec3(x, y, z));
            }
        }
    }
}

} // namespace

LabelReader::LabelReader(const glm::ivec3& size, std::uint8_t plane, Field field)
    : m_grid{size}
    , m_plane(plane)
    , m_field(field)
    , m_portion(leastPortion)
{
}

std::optional<ReadBricks> LabelReader::next()
{
    if (m_next >= m_grid.brickCount())
        return std::nullopt;
    const int end = std::min(m_next + m_portion, m_grid.brickCount());
    ReadBricks read;
    read.keys.reserve(std::size_t(end - m_next));
    for (; m_next < end; ++m_next)
        read.keys.push_back({m_field, m_plane, std::uint32_t(m_next)});
    return read;
}

Result<void> LabelReader::take(const EngineResult& answer)
{
    if (answer.error)
        return tl::unexpected(*answer.error);
    const std::size_t before = m_bricks.size();
    for (const BrickChange& brick : answer.changes) {
        if (!brick.after.empty())
            m_bricks.push_back({.key = brick.key, .bytes = brick.after});
    }
    m_portion =
        m_bricks.size() - before <= little ? std::min(2 * m_portion, mostPortion) : leastPortion;
    return {};
}

std::optional<LabelPlace> LabelReader::placeOf(std::uint8_t label) const
{
    std::optional<VoxelBox> box;
    for (const BrickImage& brick : m_bricks) {
        forEachVoxel(m_grid, brick, label, [&box](const glm::ivec3& voxel) {
            const VoxelBox here{voxel, voxel + 1};
            box = box ? box->united(here) : here;
        });
    }
    if (!box)
        return std::nullopt;
    LabelPlace place{.box = *box};
    const glm::ivec3 twiceMiddle = box->minimum + box->maximum - 1;
    std::optional<std::int64_t> least;
    for (const BrickImage& brick : m_bricks) {
        forEachVoxel(m_grid, brick, label, [&](const glm::ivec3& voxel) {
            const glm::i64vec3 away(2 * voxel - twiceMiddle);
            const std::int64_t distance = away.x * away.x + away.y * away.y + away.z * away.z;
            if (!least || distance < *least) {
                least = distance;
                place.middle = voxel;
            }
        });
    }
    return place;
}

std::int64_t LabelReader::voxelsOf(std::uint8_t label) const
{
    std::int64_t count = 0;
    for (const BrickImage& brick : m_bricks)
        forEachVoxel(m_grid, brick, label, [&count](const glm::ivec3&) { ++count; });
    return count;
}

std::vector<std::uint8_t> LabelReader::sampled(const CoarseGrid& grid) const
{
    std::vector<std::uint8_t> labels;
    if (m_bricks.empty())
        return labels;
    labels.resize(grid.cellCount());
    for (const BrickImage& brick : m_bricks) {
        const std::vector<std::uint8_t>& bytes = brick.bytes.read();
        const VoxelBox box = m_grid.boxOf(int(brick.key.brick));
        const glm::ivec3 first = box.minimum / grid.cell;
        const glm::ivec3 last = (box.maximum - 1) / grid.cell;
        for (int z = first.z; z <= last.z; ++z) {
            for (int y = first.y; y <= last.y; ++y) {
                for (int x = first.x; x <= last.x; ++x) {
                    const glm::ivec3 voxel = grid.sampleOf({x, y, z});
                    if (glm::all(glm::greaterThanEqual(voxel, box.minimum))
                        && glm::all(glm::lessThan(voxel, box.maximum)))
                        labels[grid.numberOf({x, y, z})] =
                            bytes[std::size_t(BrickGrid::offsetInBrick(voxel))];
                }
            }
        }
    }
    return labels;
}

std::vector<std::uint8_t> LabelReader::takeLabels()
{
    const glm::ivec3 size = m_grid.volumeSize;
    std::vector<std::uint8_t> labels(
        std::size_t(size.x) * std::size_t(size.y) * std::size_t(size.z));
    for (BrickImage& brick : m_bricks) {
        place(brick, labels);
        brick.bytes.clear();
    }
    m_bricks.clear();
    return labels;
}

void LabelReader::place(const BrickImage& brick, std::vector<std::uint8_t>& labels) const
{
    const glm::ivec3 size = m_grid.volumeSize;
    const VoxelBox box = m_grid.boxOf(int(brick.key.brick));
    const int width = box.maximum.x - box.minimum.x;
    const std::vector<std::uint8_t>& bytes = brick.bytes.read();
    for (int z = box.minimum.z; z < box.maximum.z; ++z) {
        for (int y = box.minimum.y; y < box.maximum.y; ++y) {
            const std::size_t from = std::size_t(BrickGrid::offsetInBrick({box.minimum.x, y, z}));
            const std::size_t to = std::size_t(box.minimum.x)
                + std::size_t(size.x) * (std::size_t(y) + std::size_t(size.y) * std::size_t(z));
            std::copy_n(&bytes[from], width, &labels[to]);
        }
    }
}

} // namespace core
