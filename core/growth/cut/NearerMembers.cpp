// SPDX-License-Identifier: Apache-2.0
#include "core/growth/cut/NearerMembers.h"

namespace core {

NearerMembers::NearerMembers(
    const LabelMembers& members, const std::vector<WordBricks::Voxel>& sketch)
    : m_whose(members.words().count(), nobody)
{
    // In one queue, the sketch first: so it comes first in every ring. Whoever is nearer to a voxel
    // is nearer to all of its own shortest way there, so none has to pass through the other.
    std::vector<WordBricks::Voxel> queue = sketch;
    for (const WordBricks::Voxel voxel : sketch)
        m_whose[voxel] = sketched;
    for (const WordBricks::Voxel voxel : members.roots()) {
        m_whose[voxel] = roots;
        queue.push_back(voxel);
    }
    for (std::size_t i = 0; i < queue.size(); ++i) {
        const std::uint8_t whose = m_whose[queue[i]];
        members.forNext(queue[i], [&](WordBricks::Voxel next, std::uint32_t, std::uint32_t) {
            if (m_whose[next] != nobody)
                return;
            m_whose[next] = whose;
            queue.push_back(next);
        });
    }
}

} // namespace core
