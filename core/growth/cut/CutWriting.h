// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/growth/cut/GrowthCut.h"

#include <cstdint>
#include <map>
#include <vector>

namespace core {

/// The bricks that a cut writes, as they will be (GrowthCut.h, rules 10 and 11).
class CutWriting {
public:
    /// @param words outlive this
    explicit CutWriting(const WordBricks& words);

    /// A voxel of a brick that is there becomes unvisited.
    /// @param label that leaves the plane; 0: none
    void leave(WordBricks::Voxel voxel, std::uint32_t label);
    /// A member stays, with another word.
    void replace(WordBricks::Voxel voxel, std::uint32_t word);
    /// Any voxel of the volume becomes a barrier.
    void shut(const glm::ivec3& place);
    /// So do those of its 26 neighbours that are no member and no pending seed.
    void shutEmptyAround(const glm::ivec3& place);
    /// Ascending; nothing is left here.
    [[nodiscard]] std::vector<CutBrick> take();

private:
    [[nodiscard]] std::uint32_t wordAt(const glm::ivec3& place) const;
    CutBrick& begun(std::size_t place);

    const WordBricks& m_words;
    std::map<std::uint32_t, std::size_t> m_places; ///< of each brick that is there
    std::vector<CutBrick> m_bricks; ///< of those; without words: not written
    std::map<std::uint32_t, CutBrick> m_further;
};

} // namespace core
