// SPDX-License-Identifier: Apache-2.0
#include "gpu/scene/TilePlan.h"

#include <algorithm>

namespace gpu {

Tile TilePlan::take(double pixels)
{
    const int blocks = std::max(1, int(std::min(pixels / (block * block), 1e6)));
    const int perRow = (m_size.x + block - 1) / block;
    Tile tile{m_next, {m_size.x, block}};
    if (m_next.x == 0 && blocks >= perRow) {
        tile.size.y = blocks / perRow * block;
    } else {
        tile.size.x = std::min(blocks * block, m_size.x - m_next.x);
    }
    tile.size.y = std::min(tile.size.y, m_size.y - m_next.y);
    m_next.x += tile.size.x;
    if (m_next.x >= m_size.x)
        m_next = {0, m_next.y + tile.size.y};
    return tile;
}

} // namespace gpu
