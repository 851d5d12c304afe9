// SPDX-License-Identifier: Apache-2.0
#include "gpu/fields/bricks/SpreadField.h"

namespace gpu {

namespace {

constexpr int side = core::BrickGrid::side;

bool sameCosts(const core::SpreadLabels& a, const core::SpreadLabels& b)
{
    return a.plane == b.plane && a.connectivity == b.connectivity
        && a.differenceWeight == b.differenceWeight && a.lengths == b.lengths;
}

} // namespace

bool SpreadField::fit(
    const core::BrickGrid& grid, const core::SpreadLabels& spread, const core::VoxelBox& box)
{
    const glm::ivec3 first = box.minimum / side;
    const glm::ivec3 bricks = (box.maximum + side - 1) / side - first;
    const bool keep = m_words && finished && sameCosts(spread, m_spread);
    const bool fits = m_words && first == m_firstBrick && bricks == m_bricks;
    if (!fits) {
        if (!keep)
            m_words = {}; // so that both are never there at once
        Texture3D words({.label = "spread words", .size = bricks * side, .format = GL_R32UI});
        if (keep) {
            words.clear();
            const glm::ivec3 low = glm::max(first, m_firstBrick);
            const glm::ivec3 high = glm::min(first + bricks, m_firstBrick + m_bricks);
            if (glm::all(glm::lessThan(low, high)))
                m_words.copyTo(
                    words, (low - m_firstBrick) * side, (low - first) * side, (high - low) * side);
        }
        m_words = std::move(words);
    }
    m_box = {glm::max(box.minimum, glm::ivec3(0)), glm::min(box.maximum, grid.volumeSize)};
    m_firstBrick = first;
    m_bricks = bricks;
    m_spread = spread;
    finished = false;
    return keep;
}

void SpreadField::release()
{
    m_words = {};
    finished = false;
}

std::size_t SpreadField::brickCount() const
{
    return std::size_t(m_bricks.x) * std::size_t(m_bricks.y) * std::size_t(m_bricks.z);
}

std::uint32_t SpreadField::brickAt(const core::BrickGrid& grid, std::size_t place) const
{
    const glm::ivec3 local(int(place) % m_bricks.x, int(place) / m_bricks.x % m_bricks.y,
        int(place) / (m_bricks.x * m_bricks.y));
    return std::uint32_t(grid.brickOf((m_firstBrick + local) * side));
}

} // namespace gpu
