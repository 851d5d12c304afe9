// SPDX-License-Identifier: Apache-2.0
#include "core/growth/Tolerance.h"

#include <algorithm>
#include <numeric>

namespace core {

bool isSound(const ToleranceRule& rule)
{
    const bool neighbours =
        rule.connectivity == 6 || rule.connectivity == 18 || rule.connectivity == 26;
    const GrowLimits& limits = rule.limits;
    // The voxel itself is one of a majority.
    const bool known = !limits.difference && !limits.gradientDifference && limits.majority <= 1
        && limits.sigmas256 == 0 && !limits.smoothed && !isAsked(limits.passage);
    return neighbours && rule.label != 0 && known && isSound(limits);
}

std::vector<std::int64_t> membersOf(const ToleranceCurve& curve)
{
    std::vector<std::int64_t> members(curve.sizes.begin(), curve.sizes.end());
    std::partial_sum(members.begin(), members.end(), members.begin());
    return members;
}

std::vector<int> jumpsOf(const std::vector<std::int64_t>& members, const JumpRule& rule)
{
    constexpr std::size_t mostSteps = 4096;
    const std::size_t step = std::max<std::size_t>(1, (members.size() + mostSteps - 1) / mostSteps);
    std::vector<int> jumps;
    for (std::size_t before = 0; before + 1 < members.size(); before += step) {
        const std::size_t after = std::min(before + step, members.size() - 1);
        const std::int64_t more = members[after] - members[before];
        if (more >= rule.leastVoxels && members[after] * 256 > members[before] * rule.factor256)
            jumps.push_back(int(after));
    }
    return jumps;
}

} // namespace core
