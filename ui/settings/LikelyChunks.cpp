// SPDX-License-Identifier: Apache-2.0
#include "ui/settings/LikelyChunks.h"

#include <utility>
#include <vector>

namespace ui {

namespace {

using DoubtfulOnes = std::vector<core::DoubtfulChunks::Doubtful>;

/// Without those that a click would treat otherwise. A click goes by voxels, a doubt by leaves as
/// they mostly are, which differ where the segment was painted since.
DoubtfulOnes ofClicks(
    DoubtfulOnes found, const ChunkLeaves& leaves, const std::vector<std::uint32_t>& own, int count)
{
    const std::vector<core::ChunkTree::Chunk> chunks = leaves.map->tree().chunksOfLeaves(count);
    std::erase_if(found, [&](const core::DoubtfulChunks::Doubtful& doubtful) {
        std::int64_t lead = 0;
        for (std::size_t leaf = 0; leaf < chunks.size(); ++leaf) {
            if (chunks[leaf] == doubtful.chunk)
                lead += 2 * std::int64_t(leaf < own.size() ? own[leaf] : 0)
                    - std::int64_t(leaves.voxels[leaf]);
        }
        return doubtful.isInside != (lead > 0);
    });
    return found;
}

} // namespace

LikelyChunks::LikelyChunks(QObject* parent)
    : QObject(parent)
{
}

void LikelyChunks::look(const std::shared_ptr<const ChunkLeaves>& leaves, int segment,
    const std::vector<std::uint32_t>& own, int count)
{
    if (std::exchange(m_count, count) != count)
        m_all.clear(); // there are others now
    m_background.replace(
        this,
        [leaves, segment, own, count]() -> DoubtfulOnes {
            std::vector<bool> isInside;
            for (std::size_t leaf = 0; leaf < leaves->voxels.size(); ++leaf)
                isInside.push_back(
                    leaf < own.size() && own[leaf] > leaves->voxels[leaf] - own[leaf]);
            const core::DoubtfulChunks doubtful(leaves->map->tree(), leaves->map->survey(),
                std::uint8_t(segment), std::move(isInside));
            return ofClicks(doubtful.of(count, most), *leaves, own, count);
        },
        [this](core::Result<DoubtfulOnes> found) {
            // Without them chunks can be clicked on all the same.
            m_all = std::move(found).value_or(DoubtfulOnes());
            Q_EMIT changed();
        });
}

void LikelyChunks::forget()
{
    m_background.cancel();
    m_all.clear();
    m_count = 0;
}

} // namespace ui
