// SPDX-License-Identifier: Apache-2.0
#include "tests/reference/growth/FrontWatch.h"

#include "core/growth/SeedWord.h"

#include <algorithm>
#include <numeric>
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
        const auto count = std::int64_t(front.voxels.size());
        std::int64_t area = 0;
        for (const glm::ivec3& voxel : front.voxels)
            area += m_rule.measure ? areaOf(voxel) : 1;
        const std::int64_t thickness =
            m_rule.measure ? m_rule.measure->volumeUm3 / (area / count) : 1;
        front.sizes.push_back(area);
        front.thicknesses.push_back(std::max<std::int64_t>(thickness, 1));
        if (trunk) {
            front.sizes.insert(front.sizes.end(), trunk->sizes.begin(), trunk->sizes.end());
            front.thicknesses.insert(
                front.thicknesses.end(), trunk->thicknesses.begin(), trunk->thicknesses.end());
        }
        fronts.push_back(std::move(front));
    }
    m_before = std::move(fronts);

    std::optional<core::LeakAlarm> alarm;
    std::int64_t largest = 0;
    for (const Front& front : m_before) {
        const int k = narrowPlace(front);
        if (k == 0)
            continue;
        const core::LeakAlarm found{.generation = generation,
            .narrow = generation - std::uint32_t(k),
            .voxels = std::int64_t(front.voxels.size()),
            .areaUm2 = m_rule.measure ? front.sizes.front() : 0,
            .voxel = front.least};
        const std::int64_t size = front.sizes.front();
        if (!alarm || size > largest || (size == largest && isLess(found.voxel, alarm->voxel))) {
            alarm = found;
            largest = size;
        }
    }
    return alarm;
}

std::int64_t FrontWatch::areaOf(const glm::ivec3& voxel) const
{
    for (int away = 1; away <= 3; ++away) {
        std::size_t axes = 0;
        for (const glm::ivec3& next : around(m_front, voxel)) {
            const glm::ivec3 step = glm::abs(next - voxel);
            if (m_front.at(next) >= 0 || step.x + step.y + step.z != away)
                continue;
            axes |= std::size_t(step.x + 2 * step.y + 4 * step.z);
        }
        if (axes != 0)
            return m_rule.measure->areaUm2[axes];
    }
    return m_rule.measure->areaUm2[0];
}

int FrontWatch::narrowPlace(const Front& front) const
{
    constexpr int mostBack = 1000;
    const std::vector<std::int64_t>& s = front.sizes;
    const auto last = int(s.size()) - 1;
    // From a front back to another: what lies between them is as thick as this.
    const auto between = [&front](int from, int to) {
        return std::accumulate(
            front.thicknesses.begin() + from, front.thicknesses.begin() + to, std::int64_t(0));
    };
    for (int k = 1; k <= mostBack && k <= last && between(0, k) <= m_rule.window; ++k) {
        const std::int64_t narrow = s[std::size_t(k)];
        if (s[0] * 256 < narrow * m_rule.factor256 || s[0] < narrow + m_rule.excess)
            continue;
        bool wasWider = false;
        for (int j = k + 1; j <= last; ++j)
            wasWider = wasWider || s[std::size_t(j)] * 2 >= narrow * 3;
        int l = k + 1;
        while (l <= last && l <= k + mostBack && between(k, l) < m_rule.window)
            ++l;
        bool wasNarrow = l <= last && l <= k + mostBack;
        for (int j = k + 1; j <= l && wasNarrow; ++j)
            wasNarrow = s[std::size_t(j)] * 2 <= narrow * 3 && s[std::size_t(j)] * 2 >= narrow;
        if (wasWider || wasNarrow)
            return k;
    }
    return 0;
}

} // namespace reference
