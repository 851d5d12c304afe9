// SPDX-License-Identifier: Apache-2.0
#include "core/growth/front/GrownBrick.h"

#include "core/growth/SeedWord.h"

namespace core {

GrownBrick grownBrick(std::span<const std::uint32_t> words, const std::bitset<256>& lockedLabels)
{
    GrownBrick brick;
    std::uint32_t label = 0; // of the last member, since few labels follow each other
    bool mayGrow = false;
    for (std::size_t i = 0; i < words.size(); ++i) {
        const std::uint32_t word = words[i];
        if (!seedWord::isMember(word)) {
            brick.hasPendingSeeds = brick.hasPendingSeeds || seedWord::isPendingSeed(word);
            continue;
        }
        if (!mayGrow || seedWord::label(word) != label) {
            label = seedWord::label(word);
            mayGrow = !lockedLabels.test(label);
            brick.labels.set(label, mayGrow);
        }
        if (mayGrow)
            brick.members[i / BrickGrid::side] |= std::uint16_t(1u << i % BrickGrid::side);
    }
    return brick;
}

} // namespace core
