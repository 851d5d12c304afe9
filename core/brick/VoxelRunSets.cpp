// SPDX-License-Identifier: Apache-2.0
#include "core/brick/VoxelRunSets.h"

#include <algorithm>
#include <cstddef>

namespace core {

VoxelRuns differing(const VoxelRuns& one, const VoxelRuns& other)
{
    // Where either set begins or ends; where both do, nothing changes.
    std::vector<std::uint64_t> places;
    places.reserve(2 * (one.runs().size() + other.runs().size()));
    for (const VoxelRuns* set : {&one, &other}) {
        for (const VoxelRun& run : set->runs()) {
            places.push_back(run.first);
            places.push_back(run.first + run.count);
        }
    }
    std::inplace_merge(
        places.begin(), places.begin() + std::ptrdiff_t(2 * one.runs().size()), places.end());
    VoxelRuns result;
    for (std::size_t i = 0; i + 1 < places.size(); i += 2)
        result.append(places[i], places[i + 1] - places[i]);
    return result;
}

VoxelRuns common(const VoxelRuns& one, const VoxelRuns& other)
{
    VoxelRuns result;
    auto run = other.runs().begin();
    for (const VoxelRun& here : one.runs()) {
        const std::uint64_t end = here.first + here.count;
        while (run != other.runs().end() && run->first + run->count <= here.first)
            ++run;
        for (auto next = run; next != other.runs().end() && next->first < end; ++next) {
            const std::uint64_t first = std::max(here.first, next->first);
            result.append(first, std::min(end, next->first + next->count) - first);
        }
    }
    return result;
}

} // namespace core
