// SPDX-License-Identifier: Apache-2.0
#include "core/growth/cut/CutRetiming.h"

#include <algorithm>
#include <map>

namespace core {

namespace {

using Voxel = WordBricks::Voxel;

constexpr std::uint32_t settled = 0; ///< of those that stay where they are
constexpr std::uint32_t unsettled = 0xFFFFFFFFu; ///< no root comes first here: 0 is never t + 1

/// The least generations that the members who stay can have, worked out from the earliest on.
class Times {
public:
    Times(const LabelMembers& members, const std::vector<Voxel>& staying,
        const std::function<bool(Voxel)>& leaves)
        : m_members(members)
        , m_leaves(leaves)
        , m_times(members.words().count(), settled)
    {
        for (const Voxel voxel : staying)
            m_times[voxel] = unsettled;
        std::map<std::uint32_t, std::vector<Voxel>> waiting;
        const auto offer = [&](Voxel voxel, std::uint32_t earlier) {
            waiting[std::max(generation(voxel), earlier + 1)].push_back(voxel);
        };
        for (const Voxel voxel : staying) {
            std::uint32_t earliest = unsettled;
            members.forNext(voxel, [&](Voxel next, std::uint32_t word, std::uint32_t) {
                if (m_times[next] == settled && !leaves(next))
                    earliest = std::min(earliest, seedWord::generation(word));
            });
            if (earliest != unsettled)
                offer(voxel, earliest);
        }
        while (!waiting.empty() && waiting.begin()->first <= seedWord::maxGeneration) {
            const std::uint32_t time = waiting.begin()->first;
            const std::vector<Voxel> now = std::move(waiting.begin()->second);
            waiting.erase(waiting.begin());
            for (const Voxel voxel : now) {
                if (m_times[voxel] != unsettled)
                    continue;
                m_times[voxel] = time;
                members.forNext(voxel, [&](Voxel next, std::uint32_t, std::uint32_t) {
                    if (m_times[next] == unsettled)
                        offer(next, time);
                });
            }
        }
    }

    [[nodiscard]] bool known(Voxel voxel) const { return m_times[voxel] != unsettled; }
    /// What becomes of the word; itself, where it still holds.
    [[nodiscard]] std::uint32_t wordOf(Voxel voxel) const
    {
        const std::uint32_t own = m_members.words()[voxel];
        const std::uint32_t time = m_times[voxel];
        bool holds = false;
        m_members.forParents(voxel, [&](Voxel parent) {
            holds = holds || (!m_leaves(parent) && known(parent) && timeOf(parent) < time);
        });
        if (holds && time == seedWord::generation(own))
            return own;
        std::uint32_t lowest = seedWord::directions;
        m_members.forNext(voxel, [&](Voxel next, std::uint32_t, std::uint32_t direction) {
            if (!m_leaves(next) && known(next) && timeOf(next) < time)
                lowest = std::min(lowest, direction ^ 1u);
        });
        return seedWord::member(
            time, m_members.label(), seedWord::wasHeld(own) ? seedWord::heldDirection : lowest);
    }

private:
    [[nodiscard]] std::uint32_t generation(Voxel voxel) const
    {
        return seedWord::generation(m_members.words()[voxel]);
    }
    [[nodiscard]] std::uint32_t timeOf(Voxel voxel) const
    {
        return m_times[voxel] == settled ? generation(voxel) : m_times[voxel];
    }

    const LabelMembers& m_members;
    const std::function<bool(Voxel)>& m_leaves;
    std::vector<std::uint32_t> m_times; ///< of each voxel
};

} // namespace

CutRetiming retime(const LabelMembers& members, const std::vector<Voxel>& staying,
    const std::function<bool(Voxel)>& leaves)
{
    CutRetiming retiming;
    if (staying.empty())
        return retiming;
    const Times times(members, staying, leaves);
    for (const Voxel voxel : staying) {
        if (!times.known(voxel)) {
            retiming.lost.push_back(voxel);
            continue;
        }
        const std::uint32_t word = times.wordOf(voxel);
        if (word != members.words()[voxel])
            retiming.words.emplace_back(voxel, word);
    }
    return retiming;
}

} // namespace core
