// SPDX-License-Identifier: Apache-2.0
#include "core/history/MovedGrowth.h"

#include "core/edits/EditNames.h"
#include "core/edits/EditTask.h"

#include <vector>

namespace core {

std::set<std::uint8_t> movedGrowthPlanes(const Edit& edit, const History& history)
{
    std::set<std::uint8_t> planes;
    std::vector<const Edit*> asked{&edit};
    std::set<RowId> known; // what was taken back several times is asked once
    while (!asked.empty()) {
        const Edit& next = *asked.back();
        asked.pop_back();
        if (const auto plane = effectsOf(next).movesGenerationOf)
            planes.insert(*plane);
        for (const RowId row : rowsTakenBackBy(next)) {
            if (known.insert(row).second)
                asked.push_back(&history.row(row).edit);
        }
    }
    return planes;
}

std::uint8_t recordedGrowthPlane(const Edit& edit, const History& history)
{
    const std::set<std::uint8_t> moved = movedGrowthPlanes(edit, history);
    return moved.empty() ? std::uint8_t(0) : *moved.begin();
}

} // namespace core
