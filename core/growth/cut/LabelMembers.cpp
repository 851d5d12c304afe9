// SPDX-License-Identifier: Apache-2.0
#include "core/growth/cut/LabelMembers.h"

#include <algorithm>

namespace core {

namespace {

constexpr std::uint32_t faces = 6;
constexpr std::uint32_t facesAndEdges = 18;

/// The first so many directions: faces; edges too; corners too.
std::uint32_t reachOf(std::uint32_t direction)
{
    return direction < faces        ? faces
        : direction < facesAndEdges ? facesAndEdges
                                    : seedWord::directions;
}

} // namespace

LabelMembers::LabelMembers(const WordBricks& words, std::uint32_t label)
    : m_words(words)
    , m_label(label)
{
    for (std::size_t i = 0; i < words.count(); ++i) {
        const auto voxel = Voxel(i);
        const std::uint32_t word = words[voxel];
        if (!isMember(word))
            continue;
        m_greatest = std::max(m_greatest, seedWord::generation(word));
        if (isRoot(word)) {
            m_roots.push_back(voxel);
            continue;
        }
        ++m_grown;
        m_reach = std::max(m_reach, parentReach(voxel));
    }
}

std::uint32_t LabelMembers::parentReach(Voxel voxel) const
{
    const std::uint32_t own = m_words[voxel];
    if (seedWord::direction(own) != seedWord::heldDirection)
        return reachOf(seedWord::direction(own));
    std::uint32_t lowest = seedWord::directions;
    m_words.forNeighbours(
        voxel, 0, seedWord::directions, [&](Voxel, std::uint32_t word, std::uint32_t direction) {
            if (isMember(word) && seedWord::generation(word) < seedWord::generation(own))
                lowest = std::min(lowest, direction ^ 1u);
        });
    return lowest == seedWord::directions ? faces : reachOf(lowest);
}

} // namespace core
