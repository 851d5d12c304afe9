// SPDX-License-Identifier: Apache-2.0
#include "ui/workspace/ChunkMembers.h"

#include "ui/workspace/Workspace.h"

#include <QPointer>

#include <utility>

namespace ui {

namespace {

core::VoxelBox common(const core::VoxelBox& one, const core::VoxelBox& other)
{
    const core::VoxelBox box{.minimum = glm::max(one.minimum, other.minimum),
        .maximum = glm::min(one.maximum, other.maximum)};
    return glm::all(glm::lessThan(box.minimum, box.maximum)) ? box : core::VoxelBox{};
}

} // namespace

ChunkMembers::ChunkMembers(Workspace& workspace, QObject* parent, std::size_t bricksAtOnce)
    : QObject(parent)
    , m_workspace(workspace)
    , m_bricksAtOnce(bricksAtOnce)
{
}

void ChunkMembers::begin(std::shared_ptr<const ChunkLeaves> leaves, int segment)
{
    ++m_count;
    m_leaves = std::move(leaves);
    m_asking = false;
    m_dirty.clear();
    m_own.clear();
    m_counting.cancel();
    m_voxels.reset();
    const core::EditSession* session = m_workspace.session();
    const core::Segment* its = session ? session->document().segment(segment) : nullptr;
    if (!m_leaves || !its) {
        m_leaves.reset();
        return;
    }
    m_plane = its->plane;
    m_own.assign(m_leaves->voxels.size(), 0);
    m_voxels = std::make_shared<Voxels>(Voxels{.leaves = m_leaves,
        .segment = segment,
        .isOwn = std::vector<bool>(m_leaves->ofVoxel->size(), false),
        .own = m_own});
    look(m_leaves->map->box());
}

void ChunkMembers::look(const core::VoxelBox& box)
{
    if (!m_leaves)
        return;
    const core::VoxelBox own = common(box, m_leaves->map->box());
    if (own.empty())
        return;
    const core::BrickGrid grid{m_leaves->map->volumeSize()};
    const glm::ivec3 first = own.minimum / core::BrickGrid::side;
    const glm::ivec3 last = (own.maximum - 1) / core::BrickGrid::side;
    for (int z = first.z; z <= last.z; ++z) {
        for (int y = first.y; y <= last.y; ++y) {
            for (int x = first.x; x <= last.x; ++x)
                m_dirty.insert(
                    std::uint32_t(grid.brickOf(glm::ivec3(x, y, z) * core::BrickGrid::side)));
        }
    }
    if (!m_asking)
        askNext();
}

void ChunkMembers::askNext()
{
    if (m_dirty.empty() || !m_workspace.session())
        return;
    std::vector<core::BrickKey> keys;
    while (!m_dirty.empty() && keys.size() < m_bricksAtOnce)
        keys.push_back({core::Field::Labels, m_plane, m_dirty.extract(m_dirty.begin()).value()});
    m_asking = true;
    m_workspace.session()->questions().bricks(std::move(keys),
        [members = QPointer<ChunkMembers>(this), count = m_count](
            core::Result<std::vector<core::BrickImage>> bricks) {
            if (members && members->m_count == count)
                members->take(std::move(bricks).value_or(std::vector<core::BrickImage>()));
        });
}

void ChunkMembers::take(std::vector<core::BrickImage> bricks)
{
    m_counting.start(
        this,
        [voxels = m_voxels, bricks = std::move(bricks)] {
            for (const core::BrickImage& brick : bricks)
                voxels->take(brick);
            return voxels->own;
        },
        [this](core::Result<std::vector<std::uint32_t>> own) {
            m_asking = false;
            const bool changes = own && *own != m_own;
            if (changes)
                m_own = *std::move(own);
            askNext();
            const bool complete = !m_asking;
            if (changes)
                Q_EMIT changed();
            if (complete)
                Q_EMIT counted();
        });
}

void ChunkMembers::Voxels::take(const core::BrickImage& brick)
{
    const core::VoxelBox& box = leaves->map->box();
    const core::BrickGrid grid{leaves->map->volumeSize()};
    const core::VoxelBox part = common(grid.boxOf(int(brick.key.brick)), box);
    const glm::ivec3 size = box.maximum - box.minimum;
    const std::vector<std::uint8_t>& labels = brick.bytes.read();
    for (int z = part.minimum.z; z < part.maximum.z; ++z) {
        for (int y = part.minimum.y; y < part.maximum.y; ++y) {
            const glm::ivec3 from(part.minimum.x, y, z);
            const glm::ivec3 within = from - box.minimum;
            std::size_t at = (std::size_t(within.z) * std::size_t(size.y) + std::size_t(within.y))
                    * std::size_t(size.x)
                + std::size_t(within.x);
            auto offset = std::size_t(core::BrickGrid::offsetInBrick(from));
            for (int x = from.x; x < part.maximum.x; ++x, ++at, ++offset) {
                const bool isIts = !labels.empty() && labels[offset] == segment;
                if (isOwn[at] == isIts)
                    continue;
                isOwn[at] = isIts;
                const std::uint16_t leaf = (*leaves->ofVoxel)[at];
                if (leaf == 0)
                    continue;
                own[leaf - 1U] += isIts ? 1U : ~std::uint32_t(0);
            }
        }
    }
}

} // namespace ui
