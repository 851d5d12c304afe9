// SPDX-License-Identifier: Apache-2.0
#include "tests/reference/FrontWatch.h"

#include "core/growth/SeedWord.h"

#include <algorithm>
#include <tuple>

namespace reference {

namespace {

std::vector<glm::ivec3> around(const DenseArray<int>& array, const glm::ivec3& voxel)
{
    std::vector<glm::ivec3> found;
    for (const auto& offset : core::seedWord::offsets) {
        const glm::ivec3 next = voxel + glm::ivec3(offset[0], offset[1], offset[2]);
        if (array.contains(next))
            found.push_back(next);
    }
    return found;
}

constexpr int untold = 1 << 30; ///< added, in no front yet

} // namespace

FrontWatch::FrontWatch(const glm::ivec3& size, const core::GuardRule& rule)
    : m_rule(rule)
    , m_grid{size}
    , m_front{size,
          std::vector<int>(std::size_t(size.x) * std::size_t(size.y) * std::size_t(size.z), 0)}
{
}

bool FrontWatch::isLess(const glm::ivec3& a, const glm::ivec3& b) const
{
    return std::pair(m_grid.brickOf(a), core::BrickGrid::offsetInBrick(a))
        < std::pair(m_grid.brickOf(b), core::BrickGrid::offsetInBrick(b));
}

std::optional<core::LeakAlarm> FrontWatch::look(
    std::uint32_t generation, const std::vector<glm::ivec3>& added)
{
    // Fronts of the generation before have negative numbers, those of this one positive ones.
    for (int& number : m_front.values)
        number = number > 0 ? -number : 0;
    for (const glm::ivec3& voxel : added)
        m_front.at(voxel) = untold;
    std::vector<Front> fronts;
    for (const glm::ivec3& first : added) {
        if (m_front.at(first) != untold)
            continue;
        const int number = int(fronts.size()) + 1;
        Front front{.voxels = {first}, .sizes = {}};
        m_front.at(first) = number;
        const Front* trunk = nullptr;
        for (std::size_t i = 0; i < front.voxels.size(); ++i) {
            for (const glm::ivec3& next : around(m_front, front.voxels[i])) {
                int& other = m_front.at(next);
                if (other == untold) {
                    other = number;
                    front.voxels.push_back(next);
                } else if (other < 0) {
                    const Front& before = m_before[std::size_t(-other - 1)];
                    if (!trunk || before.sizes.front() > trunk->sizes.front()
                        || (before.sizes.front() == trunk->sizes.front()
                            && isLess(before.least, trunk->least)))
                        trunk = &before;
                }
            }
        }
        front.least = *std::min_element(front.voxels.begin(), front.voxels.end(),
            [this](const glm::ivec3& a, const glm::ivec3& b) { return isLess(a, b); });
        front.sizes.push_back(std::int64_t(front.voxels.size()));
        if (trunk)
            front.sizes.insert(front.sizes.end(), trunk->sizes.begin(), trunk->sizes.end());
        fronts.push_back(std::move(front));
    }
    m_before = std::move(fronts);

    std::optional<core::LeakAlarm> alarm;
    for (const Front& front : m_before) {
        const int k = narrowPlace(front);
        if (k == 0)
            continue;
        const core::LeakAlarm found{.generation = generation,
            .narrow = generation - std::uint32_t(k),
            .voxels = front.sizes.front(),
            .voxel = front.least};
        if (!alarm || found.voxels > alarm->voxels
            || (found.voxels == alarm->voxels && isLess(found.voxel, alarm->voxel)))
            alarm = found;
    }
    return alarm;
}

int FrontWatch::narrowPlace(const Front& front) const
{
    const std::vector<std::int64_t>& s = front.sizes;
    const auto last = int(s.size()) - 1;
    for (int k = 1; k <= m_rule.window && k <= last; ++k) {
        const std::int64_t narrow = s[std::size_t(k)];
        if (s[0] * 256 < narrow * m_rule.factor256 || s[0] < narrow + m_rule.excess)
            continue;
        bool wasWider = false;
        for (int j = k + 1; j <= last; ++j)
            wasWider = wasWider || s[std::size_t(j)] * 2 >= narrow * 3;
        bool wasNarrow = k + m_rule.window <= last;
        for (int j = k + 1; j <= k + m_rule.window && wasNarrow; ++j)
            wasNarrow = s[std::size_t(j)] * 2 <= narrow * 3 && s[std::size_t(j)] * 2 >= narrow;
        if (wasWider || wasNarrow)
            return k;
    }
    return 0;
}

} // namespace reference
