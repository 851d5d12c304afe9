// SPDX-License-Identifier: Apache-2.0
#include "ui/settings/LikelyChunks.h"

#include <utility>

namespace ui {

LikelyChunks::LikelyChunks(QObject* parent)
    : QObject(parent)
{
}

void LikelyChunks::look(const std::shared_ptr<const ChunkLeaves>& leaves, int segment,
    const std::vector<std::uint32_t>& own, int count)
{
    using Found = std::vector<core::DoubtfulChunks::Doubtful>;
    if (std::exchange(m_count, count) != count)
        m_all.clear(); // there are others now
    m_background.replace(
        this,
        [leaves, segment, own, count]() -> Found {
            std::vector<bool> isInside;
            for (std::size_t leaf = 0; leaf < leaves->voxels.size(); ++leaf)
                isInside.push_back(
                    leaf < own.size() && own[leaf] > leaves->voxels[leaf] - own[leaf]);
            return core::DoubtfulChunks(leaves->map->tree(), leaves->map->survey(),
                std::uint8_t(segment), std::move(isInside))
                .of(count, most);
        },
        [this](core::Result<Found> found) {
            // Without them chunks can be clicked on all the same.
            m_all = std::move(found).value_or(Found());
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
