// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/growth/cut/GrowthCut.h"

#include <cstdint>
#include <map>
#include <vector>

namespace core {

/// Collects the bricks that a cut writes, with their new content (GrowthCut.h, rules 10 and 11).
class CutWriting {
public:
    /// @param words must outlive this
    explicit CutWriting(const WordBricks& words);

    /// Makes a voxel unvisited; it must lie in a brick of `words`.
    /// @param label the label that the plane loses there; 0: none
    void leave(WordBricks::Voxel voxel, std::uint32_t label);
    /// Gives a member that stays another word.
    void replace(WordBricks::Voxel voxel, std::uint32_t word);
    /// Sets a barrier at any voxel of the volume.
    void setBarrier(const glm::ivec3& place);
    /// Sets barriers at those of its 26 neighbours that are neither members nor pending seeds.
    void setBarrierAround(const glm::ivec3& place);
    /// The bricks, ascending by number; nothing remains here.
    [[nodiscard]] std::vector<CutBrick> take();

private:
    [[nodiscard]] std::uint32_t wordAt(const glm::ivec3& place) const;
    CutBrick& begun(std::size_t place);

    const WordBricks& m_words;
    std::map<std::uint32_t, std::size_t> m_places; ///< index of each brick of `words`
    std::vector<CutBrick> m_bricks; ///< one for each of them; those without words are not written
    /// By number: bricks that are not in `words` and that receive barriers.
    std::map<std::uint32_t, CutBrick> m_further;
};

} // namespace core
