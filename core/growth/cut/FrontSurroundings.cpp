// SPDX-License-Identifier: Apache-2.0
#include "core/growth/cut/FrontSurroundings.h"

#include "core/growth/SeedWord.h"
#include "core/growth/cut/GrowthCut.h"

#include <algorithm>

namespace core {

FrontSurroundings::FrontSurroundings(const WordBricks& words,
    const std::vector<WordBricks::Voxel>& front,
    const std::function<bool(std::uint32_t word)>& isMember)
{
    for (const WordBricks::Voxel voxel : front) {
        const glm::ivec3 place = words.positionOf(voxel);
        m_box = m_box.united({place, place + 1});
    }
    const glm::ivec3 side = m_box.maximum - m_box.minimum;
    m_farthest = std::min(2 + std::max({side.x, side.y, side.z}), farthestPassage);
    m_box = {m_box.minimum - m_farthest, m_box.maximum + m_farthest};
    const glm::ivec3 size = m_box.maximum - m_box.minimum;
    m_nodes.assign(std::size_t(size.x) * std::size_t(size.y) * std::size_t(size.z), none);
    const auto add = [&](WordBricks::Voxel voxel, int steps) {
        std::uint32_t& node = m_nodes[slotOf(words.positionOf(voxel))];
        if (node != none)
            return;
        node = std::uint32_t(m_voxels.size());
        m_voxels.push_back(voxel);
        m_steps.push_back(steps);
    };
    for (const WordBricks::Voxel voxel : front)
        add(voxel, 0);
    for (std::size_t i = 0; i < m_voxels.size() && m_steps[i] != m_farthest; ++i) {
        words.forNeighbours(m_voxels[i], 0, seedWord::directions,
            [&, steps = m_steps[i] + 1](
                WordBricks::Voxel neighbour, std::uint32_t word, std::uint32_t) {
                if (isMember(word))
                    add(neighbour, steps);
            });
    }
}

std::uint32_t FrontSurroundings::nodeAt(const glm::ivec3& place) const
{
    const bool inside = glm::all(glm::greaterThanEqual(place, m_box.minimum))
        && glm::all(glm::lessThan(place, m_box.maximum));
    return inside ? m_nodes[slotOf(place)] : none;
}

std::size_t FrontSurroundings::slotOf(const glm::ivec3& place) const
{
    const glm::ivec3 at = place - m_box.minimum;
    const glm::ivec3 size = m_box.maximum - m_box.minimum;
    return std::size_t(at.x + size.x * (at.y + size.y * at.z));
}

} // namespace core
