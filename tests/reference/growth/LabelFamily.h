// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/growth/SeedWord.h"
#include "tests/reference/fields/DenseFields.h"

#include <cstdint>
#include <map>
#include <set>
#include <vector>

namespace reference {

/// The members of one label among the seed words, by the rules in core/growth/cut/GrowthCut.h that
/// say who came from whom (2, 7), who is near to whom (9) and who comes when (10).
class LabelFamily {
public:
    using Words = DenseArray<std::uint32_t>;
    using Set = std::set<std::size_t>; ///< voxels by their offset in the volume
    /// Generations of members that stay.
    using Times = std::map<std::size_t, std::uint32_t>;

    LabelFamily(const Words& words, std::uint32_t label);

    [[nodiscard]] const std::map<std::uint32_t, Set>& byGeneration() const
    {
        return m_byGeneration;
    }
    [[nodiscard]] bool isMember(std::size_t voxel) const;
    [[nodiscard]] bool isRoot(std::size_t voxel) const;
    [[nodiscard]] std::uint32_t generation(std::size_t voxel) const;
    [[nodiscard]] std::vector<std::size_t> parents(std::size_t voxel) const;
    /// Rule 7.
    [[nodiscard]] Set behind(const Set& from) const;
    /// Of some members those that no root is nearer to than the sketch.
    [[nodiscard]] Set notNearerToRoots(const Set& some, const Set& sketch) const;
    /// Those of all members that neither leave nor have lost all that came before them.
    [[nodiscard]] Times timesOf(const Set& staying, const Set& leaving) const;
    /// The word of one that has a time.
    [[nodiscard]] std::uint32_t retimed(std::size_t voxel, const Times& times) const;

private:
    [[nodiscard]] int parentDirections(std::size_t voxel) const;
    [[nodiscard]] bool isEarlierMemberFrom(std::size_t voxel, int direction) const;
    [[nodiscard]] std::map<std::size_t, int> distancesFrom(const Set& from) const;

    const Words& m_words;
    std::uint32_t m_label;
    std::map<std::uint32_t, Set> m_byGeneration;
    int m_steps = 6; ///< K of rule 9
};

[[nodiscard]] glm::ivec3 placeOf(const LabelFamily::Words& words, std::size_t voxel);
/// The neighbours in the first so many directions.
[[nodiscard]] std::vector<std::size_t> neighbours(
    const LabelFamily::Words& words, std::size_t voxel, int directions = 26);

} // namespace reference
