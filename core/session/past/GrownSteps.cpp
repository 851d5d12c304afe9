// SPDX-License-Identifier: Apache-2.0
#include "core/session/past/GrownSteps.h"

namespace core {

int grownSteps(std::uint32_t first, const EditStatistics& statistics, const ChangeFacts& facts)
{
    // An admitted seed is a member of the generation of the opening.
    return statistics.generations - (facts.admittedSeedsAt(first + 1) ? 1 : 0);
}

} // namespace core
