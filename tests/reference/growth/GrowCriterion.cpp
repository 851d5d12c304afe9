// SPDX-License-Identifier: Apache-2.0
#include "tests/reference/growth/GrowCriterion.h"

#include "core/growth/SeedWord.h"

#include <algorithm>
#include <cstdlib>
#include <utility>

namespace reference {

namespace seedWord = core::seedWord;

namespace {

template <class Visit> void forEachVoxel(const glm::ivec3& from, const glm::ivec3& to, Visit visit)
{
    for (int z = from.z; z <= to.z; ++z)
        for (int y = from.y; y <= to.y; ++y)
            for (int x = from.x; x <= to.x; ++x)
                visit(glm::ivec3(x, y, z));
}

} // namespace

core::GroupedSeedSums seedSums(const DenseArray<std::uint16_t>& codes,
    const DenseArray<std::uint32_t>& words, const core::ProbeSeeds& question)
{
    const auto isSeedOf = [&words](const glm::ivec3& voxel, std::uint32_t label) {
        const std::uint32_t word = words.at(voxel);
        return seedWord::label(word) == label
            && (seedWord::isPendingSeed(word)
                || (seedWord::isMember(word) && seedWord::isSeed(word)));
    };
    const auto addAround = [&](const glm::ivec3& seed, core::SeedSums& sums) {
        forEachVoxel(seed - core::seedReach, seed + core::seedReach, [&](const glm::ivec3& voxel) {
            if (!codes.contains(voxel))
                return;
            const std::uint64_t code = codes.at(voxel);
            if (int(code) < question.lowCode || int(code) > question.highCode)
                return;
            ++sums.voxels;
            sums.codes += code;
            sums.squares += code * code;
        });
    };
    core::GroupedSeedSums sums;
    for (const core::SeedGroup& group : question.seedGroups) {
        core::SeedSums& own = sums.groups.emplace_back();
        for (const glm::ivec3& voxel : group.voxels) {
            if (isSeedOf(voxel, group.label))
                addAround(voxel, own);
        }
    }
    forEachVoxel(glm::ivec3(0), words.size - 1, [&](const glm::ivec3& voxel) {
        const std::uint32_t label = seedWord::label(words.at(voxel));
        if (!isSeedOf(voxel, label))
            return;
        for (const core::SeedGroup& group : question.seedGroups) {
            if (group.label == label
                && std::find(group.voxels.begin(), group.voxels.end(), voxel) != group.voxels.end())
                return;
        }
        addAround(voxel, sums.others[label]);
    });
    return sums;
}

GrowCriterion::GrowCriterion(const DenseArray<std::uint16_t>& codes,
    DenseArray<std::uint8_t> coverage, const DenseArray<std::uint32_t>& words,
    const core::GrowBurst& burst)
    : m_codes(codes)
    , m_coverage(std::move(coverage))
    , m_limits(burst.limits)
    , m_interval{.low = burst.lowCode, .high = burst.highCode}
{
    if (m_limits.sigmas256 == 0)
        return;
    const core::GroupedSeedSums sums =
        seedSums(codes, words, {burst.plane, burst.lowCode, burst.highCode, burst.seedGroups});
    const auto add = [this](std::size_t label, const core::SeedSums& around) {
        m_seedIntervals[label].push_back(core::seedInterval(around, m_limits.sigmas256));
    };
    for (std::size_t group = 0; group < sums.groups.size(); ++group)
        add(burst.seedGroups[group].label, sums.groups[group]);
    for (std::size_t label = 0; label < sums.others.size(); ++label)
        add(label, sums.others[label]);
}

int GrowCriterion::code(const glm::ivec3& voxel) const
{
    return m_codes.at(glm::clamp(voxel, glm::ivec3(0), m_codes.size - 1));
}

int GrowCriterion::median(const glm::ivec3& voxel) const
{
    constexpr std::array<int, 4> weights{9, 4, 2, 1}; // by axes on which one lies aside
    std::array<int, 65> weighted{}; // each code as often as it weighs
    auto end = weighted.begin();
    forEachVoxel(voxel - 1, voxel + 1, [&](const glm::ivec3& near) {
        const glm::ivec3 aside = glm::abs(near - voxel);
        end = std::fill_n(end, weights[std::size_t(aside.x + aside.y + aside.z)], code(near));
    });
    const auto middle = weighted.begin() + weighted.size() / 2;
    std::nth_element(weighted.begin(), middle, weighted.end());
    return *middle;
}

bool GrowCriterion::suits(std::uint32_t label, int code) const
{
    const auto isIn = [code](const core::CodeInterval& interval) {
        return interval.low <= code && code <= interval.high;
    };
    const std::vector<core::CodeInterval>& seeds = m_seedIntervals[label];
    return isIn(m_interval)
        && (m_limits.sigmas256 == 0 || std::any_of(seeds.begin(), seeds.end(), isIn));
}

bool GrowCriterion::within(std::uint32_t label, const glm::ivec3& voxel) const
{
    return suits(label, m_limits.smoothed ? median(voxel) : code(voxel));
}

std::int64_t GrowCriterion::magnitude(const glm::ivec3& voxel) const
{
    std::int64_t square = 0;
    for (int axis = 0; axis < 3; ++axis) {
        glm::ivec3 step(0);
        step[axis] = 1;
        const std::int64_t difference = std::abs(code(voxel + step) - code(voxel - step));
        const std::int64_t part =
            std::min<std::int64_t>(m_limits.gradientWeights[axis] * difference / 1024, 32767);
        square += part * part;
    }
    std::int64_t root = 0;
    for (std::int64_t digit = 65536; digit > 0; digit /= 2) {
        if ((root + digit) * (root + digit) <= square)
            root += digit;
    }
    return root;
}

bool GrowCriterion::allows(std::uint32_t label, const glm::ivec3& voxel) const
{
    if (!within(label, voxel))
        return false;
    if (m_limits.gradient && magnitude(voxel) > *m_limits.gradient)
        return false;
    int count = 0;
    if (m_limits.majority > 0)
        forEachVoxel(voxel - 1, voxel + 1,
            [&](const glm::ivec3& near) { count += suits(label, code(near)) ? 1 : 0; });
    if (count < m_limits.majority)
        return false;
    if (m_limits.onlyVisible && m_coverage.at(voxel) >= 128)
        return false;
    for (int axis = 0; axis < 3 && m_limits.boxed; ++axis) {
        if (voxel[axis] < m_limits.boxFrom[axis] || voxel[axis] > m_limits.boxTo[axis])
            return false;
    }
    return true;
}

bool GrowCriterion::follows(const glm::ivec3& parent, const glm::ivec3& voxel) const
{
    if (m_limits.difference && std::abs(code(voxel) - code(parent)) > *m_limits.difference)
        return false;
    return !m_limits.gradientDifference
        || std::abs(magnitude(voxel) - magnitude(parent)) <= *m_limits.gradientDifference;
}

} // namespace reference
