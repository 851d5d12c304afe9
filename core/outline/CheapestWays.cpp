// SPDX-License-Identifier: Apache-2.0
#include "core/outline/CheapestWays.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <limits>
#include <utility>

namespace core {

namespace {

constexpr std::array<glm::ivec2, 4> waySteps{
    glm::ivec2(1, 0), glm::ivec2(0, 1), glm::ivec2(-1, 0), glm::ivec2(0, -1)};
constexpr int wayDirections = 4;

/// The distance of a corner from the straight line from the anchor to the end, times the length of
/// that line.
std::int64_t besideLine(const glm::ivec2& corner, const glm::ivec2& anchor, const glm::ivec2& end)
{
    const glm::ivec2 line = end - anchor;
    const glm::ivec2 way = corner - anchor;
    return std::abs(std::int64_t(line.x) * way.y - std::int64_t(line.y) * way.x);
}

} // namespace

CheapestWays::CheapestWays(
    std::shared_ptr<const SideCosts> costs, const glm::ivec2& anchor, int reach)
    : m_costs(std::move(costs))
    , m_anchor(anchor)
    , m_low(glm::max(anchor - reach, glm::ivec2(0)))
    , m_high(glm::min(anchor + reach, m_costs->pixels))
{
    spread();
}

bool CheapestWays::leadsOn(const glm::ivec2& corner, int direction) const
{
    const glm::ivec2 next = corner + waySteps[std::size_t(direction)];
    return next.x >= m_low.x && next.y >= m_low.y && next.x <= m_high.x && next.y <= m_high.y;
}

std::uint32_t CheapestWays::costOf(const glm::ivec2& corner, int direction) const
{
    switch (direction) {
    case 0:
        return m_costs->along[m_costs->at(corner)];
    case 1:
        return m_costs->down[m_costs->at(corner)];
    case 2:
        return m_costs->along[m_costs->at(corner) - 1];
    default:
        return m_costs->down[m_costs->at({corner.x, corner.y - 1})];
    }
}

void CheapestWays::spread()
{
    const glm::ivec2 size = m_high - m_low + 1;
    m_sums.assign(
        std::size_t(size.x) * std::size_t(size.y), std::numeric_limits<std::uint32_t>::max());
    // Open sums differ by at most the cost of one side, so this many buckets suffice.
    constexpr std::size_t bucketCount = SideCosts::greatest + 1;
    std::array<std::vector<glm::ivec2>, bucketCount> buckets;
    std::size_t open = 1;
    m_sums[at(m_anchor)] = 0;
    buckets[0].push_back(m_anchor);
    for (std::uint32_t sum = 0; open > 0; ++sum) {
        std::vector<glm::ivec2>& bucket = buckets[sum % bucketCount];
        open -= bucket.size();
        // No side is free, so nothing is added to the bucket that is emptied.
        for (const glm::ivec2& corner : bucket) {
            if (m_sums[at(corner)] != sum)
                continue; // a cheaper way was found since
            for (int direction = 0; direction < wayDirections; ++direction) {
                if (!leadsOn(corner, direction))
                    continue;
                const glm::ivec2 next = corner + waySteps[std::size_t(direction)];
                const std::uint32_t through = sum + costOf(corner, direction);
                if (through >= m_sums[at(next)])
                    continue;
                m_sums[at(next)] = through;
                buckets[through % bucketCount].push_back(next);
                ++open;
            }
        }
        bucket.clear();
    }
}

std::uint32_t CheapestWays::costTo(const glm::ivec2& corner) const
{
    return m_sums[at(corner)];
}

std::vector<glm::ivec2> CheapestWays::wayTo(const glm::ivec2& corner) const
{
    const glm::ivec2 end = glm::clamp(corner, m_low, m_high);
    std::vector<glm::ivec2> backwards;
    if (end != corner)
        backwards.push_back(corner);
    glm::ivec2 here = end;
    int before = -1; // the direction of the last step
    while (here != m_anchor) {
        int best = -1;
        std::int64_t nearest = 0;
        for (int direction = 0; direction < wayDirections; ++direction) {
            if (!leadsOn(here, direction))
                continue;
            const glm::ivec2 next = here + waySteps[std::size_t(direction)];
            if (m_sums[at(next)] + costOf(here, direction) != m_sums[at(here)])
                continue;
            const std::int64_t beside = besideLine(next, m_anchor, end);
            if (best < 0 || beside < nearest) {
                best = direction;
                nearest = beside;
            }
        }
        if (best != before)
            backwards.push_back(here);
        before = best;
        here += waySteps[std::size_t(best)];
    }
    backwards.push_back(m_anchor);
    std::reverse(backwards.begin(), backwards.end());
    return backwards;
}

} // namespace core
