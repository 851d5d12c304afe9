// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/growth/WordBricks.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace core {

/// The members of one label among the seed words, with their parents and children (GrowthCut.h,
/// rules 1 and 2).
class LabelMembers {
public:
    using Voxel = WordBricks::Voxel;

    /// @param words linked; must outlive this. The constructor reads all of them.
    LabelMembers(const WordBricks& words, std::uint32_t label);

    [[nodiscard]] const WordBricks& words() const { return m_words; }
    [[nodiscard]] std::uint32_t label() const { return m_label; }
    /// K of GrowthCut.h, rule 9: the most directions in which parents are looked for.
    [[nodiscard]] std::uint32_t reach() const { return m_reach; }
    [[nodiscard]] std::uint32_t greatestGeneration() const { return m_greatest; }
    [[nodiscard]] const std::vector<Voxel>& roots() const { return m_roots; }
    /// The number of members that are no roots.
    [[nodiscard]] std::size_t grown() const { return m_grown; }

    [[nodiscard]] bool isMember(std::uint32_t word) const
    {
        return seedWord::isMember(word) && seedWord::label(word) == m_label;
    }
    [[nodiscard]] static bool isRoot(std::uint32_t word)
    {
        return seedWord::isSeed(word) || seedWord::generation(word) == 0;
    }

    template <class Visit> void forParents(Voxel voxel, const Visit& visit) const
    {
        const std::uint32_t own = m_words[voxel];
        if (isRoot(own))
            return;
        m_words.forNeighbours(
            voxel, 0, parentReach(voxel), [&](Voxel neighbour, std::uint32_t word, std::uint32_t) {
                if (isMember(word) && seedWord::generation(word) < seedWord::generation(own))
                    visit(neighbour);
            });
    }
    template <class Visit> void forChildren(Voxel voxel, const Visit& visit) const
    {
        const std::uint32_t own = seedWord::generation(m_words[voxel]);
        m_words.forNeighbours(
            voxel, 0, m_reach, [&](Voxel neighbour, std::uint32_t word, std::uint32_t direction) {
                if (isMember(word) && seedWord::generation(word) > own && !isRoot(word)
                    && direction < parentReach(neighbour))
                    visit(neighbour);
            });
    }
    /// The members that are one step away (GrowthCut.h, rule 9).
    template <class Visit> void forNext(Voxel voxel, const Visit& visit) const
    {
        m_words.forNeighbours(
            voxel, 0, m_reach, [&](Voxel neighbour, std::uint32_t word, std::uint32_t direction) {
                if (isMember(word))
                    visit(neighbour, word, direction);
            });
    }

private:
    /// Number of directions in which the parents of a member that is no root lie.
    [[nodiscard]] std::uint32_t parentReach(Voxel voxel) const;

    const WordBricks& m_words;
    std::uint32_t m_label;
    std::uint32_t m_reach = 6;
    std::uint32_t m_greatest = 0;
    std::size_t m_grown = 0;
    std::vector<Voxel> m_roots; ///< ascending
};

} // namespace core
