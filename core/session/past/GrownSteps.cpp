// SPDX-License-Identifier: Apache-2.0
#include "core/session/past/GrownSteps.h"

#include "core/growth/SeedWord.h"

namespace core {

namespace {

std::uint32_t wordAt(const std::vector<std::uint8_t>& bytes, std::size_t voxel)
{
    const std::uint8_t* word = &bytes[voxel * 4];
    return std::uint32_t(word[0]) | std::uint32_t(word[1]) << 8 | std::uint32_t(word[2]) << 16
        | std::uint32_t(word[3]) << 24;
}

/// Whether the opening admitted a pending seed: it is a member of that generation then.
bool openingAdmittedSeeds(const std::vector<BrickChange>& changes, std::uint32_t generation)
{
    for (const BrickChange& change : changes) {
        if (change.key.field != Field::SeedWords || change.after.empty())
            continue;
        for (std::size_t voxel = 0; voxel < BrickGrid::voxelsPerBrick; ++voxel) {
            const std::uint32_t word = wordAt(change.after, voxel);
            if (seedWord::isMember(word) && seedWord::generation(word) == generation
                && seedWord::isSeed(word))
                return true;
        }
    }
    return false;
}

} // namespace

int grownSteps(
    std::uint32_t first, const EditStatistics& statistics, const std::vector<BrickChange>& changes)
{
    return statistics.generations - (openingAdmittedSeeds(changes, first + 1) ? 1 : 0);
}

} // namespace core
