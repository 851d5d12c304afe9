// SPDX-License-Identifier: Apache-2.0
#include "core/growth/cut/LabelCut.h"

#include "core/growth/cut/CutRetiming.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <utility>

// What lies behind a set of members, and what becomes of it when that set leaves.

namespace core {

LabelCut::Voxels LabelCut::takeOut(Voxels leaving, const Voxels& rim, WordChanges& changes)
{
    for (const Voxel voxel : std::exchange(m_lost, {}))
        m_marks[voxel] &= std::uint8_t(~leaves);
    for (const Voxel voxel : leaving)
        m_marks[voxel] |= leaves;
    return settle(std::move(leaving), orphans(rim), changes);
}

/// @param all what lies behind what leaves, marked
LabelCut::Voxels LabelCut::leave(Voxels leaving, const Voxels& all, WordChanges& changes)
{
    for (const Voxel voxel : leaving)
        m_marks[voxel] |= leaves;
    Voxels staying;
    std::copy_if(all.begin(), all.end(), std::back_inserter(staying),
        [this](Voxel voxel) { return !has(voxel, leaves); });
    forgetBehind();
    return settle(std::move(leaving), staying, changes);
}

/// Rule 10. @param staying what lies behind what leaves, and stays
LabelCut::Voxels LabelCut::settle(Voxels leaving, const Voxels& staying, WordChanges& changes)
{
    CutRetiming retiming =
        retime(m_members, staying, [this](Voxel voxel) { return has(voxel, leaves); });
    changes.insert(changes.end(), retiming.words.begin(), retiming.words.end());
    if (m_command.how != CutGrowth::How::Here) {
        for (const Voxel voxel : retiming.lost)
            m_marks[voxel] |= leaves;
        leaving.insert(leaving.end(), retiming.lost.begin(), retiming.lost.end());
        m_lost = std::move(retiming.lost);
    }
    return leaving;
}

/// What lies behind what is marked to leave, and is not among it. As behind(), without following
/// all that leaves.
LabelCut::Voxels LabelCut::orphans(const Voxels& rim)
{
    Voxels all;
    std::map<std::uint32_t, Voxels> waiting;
    const auto look = [&](Voxel voxel) {
        if (has(voxel, looked))
            return;
        m_marks[voxel] |= looked;
        m_seen.push_back(voxel);
        waiting[seedWord::generation(m_words[voxel])].push_back(voxel);
    };
    for (const Voxel voxel : rim)
        look(voxel);
    while (!waiting.empty()) {
        const Voxels next = std::move(waiting.begin()->second);
        waiting.erase(waiting.begin());
        for (const Voxel voxel : next) {
            bool stays = false;
            m_members.forParents(voxel, [&](Voxel parent) {
                stays = stays || !(has(parent, leaves) || has(parent, liesBehind));
            });
            if (stays)
                continue;
            m_marks[voxel] |= liesBehind;
            all.push_back(voxel);
            m_members.forChildren(voxel, [&](Voxel child) {
                if (!has(child, leaves))
                    look(child);
            });
        }
    }
    forgetBehind();
    return all;
}

/// Rule 7, up to a generation. It stays marked until forgetBehind(). @return each once
LabelCut::Voxels LabelCut::behind(const Voxels& from, std::uint32_t latest)
{
    Voxels all;
    std::map<std::uint32_t, Voxels> waiting; // children of what lies behind, by generation
    const auto add = [&](Voxel voxel) {
        m_marks[voxel] |= liesBehind;
        all.push_back(voxel);
        m_members.forChildren(voxel, [&](Voxel child) {
            if (has(child, looked))
                return;
            m_marks[child] |= looked;
            m_seen.push_back(child);
            waiting[seedWord::generation(m_words[child])].push_back(child);
        });
    };
    Voxels first;
    for (const Voxel voxel : from) {
        if (LabelMembers::isRoot(m_words[voxel]) || has(voxel, looked))
            continue;
        m_marks[voxel] |= std::uint8_t(liesBehind | looked);
        m_seen.push_back(voxel);
        first.push_back(voxel);
    }
    for (const Voxel voxel : first)
        add(voxel);
    while (!waiting.empty() && waiting.begin()->first <= latest) {
        const Voxels next = std::move(waiting.begin()->second);
        waiting.erase(waiting.begin());
        for (const Voxel voxel : next) {
            bool stays = false;
            m_members.forParents(
                voxel, [&](Voxel parent) { stays = stays || !has(parent, liesBehind); });
            if (!stays)
                add(voxel);
        }
    }
    return all;
}

void LabelCut::forgetBehind()
{
    for (const Voxel voxel : m_seen)
        m_marks[voxel] &= std::uint8_t(~(liesBehind | looked));
    m_seen.clear();
}

} // namespace core
