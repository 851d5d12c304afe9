// SPDX-License-Identifier: Apache-2.0
#include "core/growth/front/OpenVoxels.h"

#include "core/growth/SeedWord.h"

#include <algorithm>

namespace core {

namespace {

constexpr int rowVoxels = BrickGrid::side;

/// Whether a criterion asks for no more than a voxel's own code and place.
bool asksForCodesOnly(const GrowLimits& limits)
{
    return limits
        == GrowLimits{.gradientWeights = limits.gradientWeights,
            .boxed = limits.boxed,
            .boxFrom = limits.boxFrom,
            .boxTo = limits.boxTo,
            .passage = isAsked(limits.passage) ? Passage{} : limits.passage};
}

/// The bits of a row for which a condition holds.
template <typename Condition> unsigned bitsWhere(const Condition& holds)
{
    unsigned bits = 0;
    for (unsigned x = 0; x < rowVoxels; ++x)
        bits |= unsigned(holds(x)) << x;
    return bits;
}

/// The bits of a row from one voxel to another, both among them; they may lie outside of it.
unsigned bitsBetween(int first, int last)
{
    const int from = std::clamp(first, 0, rowVoxels);
    const int to = std::clamp(last + 1, from, rowVoxels);
    return (1u << to) - (1u << from);
}

} // namespace

std::optional<OpenRule> openRule(
    const GrowBurst& burst, std::uint8_t label, const glm::ivec3& volumeSize)
{
    if (!asksForCodesOnly(burst.limits))
        return std::nullopt;
    OpenRule rule{.lowCode = burst.lowCode,
        .highCode = burst.highCode,
        .mayEnter = burst.overwritable,
        .boxTo = volumeSize - 1};
    rule.mayEnter.set(0).set(label);
    if (burst.range) {
        rule.lowCode = std::max(rule.lowCode, burst.range->lowCode);
        rule.highCode = std::min(rule.highCode, burst.range->highCode);
        rule.mayEnter &= ~burst.range->closed;
    }
    if (burst.limits.boxed) {
        rule.boxFrom = glm::max(rule.boxFrom, burst.limits.boxFrom);
        rule.boxTo = glm::min(rule.boxTo, burst.limits.boxTo);
    }
    return rule;
}

VoxelBits openVoxels(const OpenRule& rule, const AskedBrick& brick)
{
    VoxelBits open{};
    const glm::ivec3 from = rule.boxFrom - brick.origin;
    const glm::ivec3 to = rule.boxTo - brick.origin;
    const unsigned alongRow = bitsBetween(from.x, to.x);
    const auto span = unsigned(rule.highCode - rule.lowCode);
    const auto low = unsigned(rule.lowCode);
    if (alongRow == 0 || rule.lowCode > rule.highCode)
        return open;
    if (brick.labels.empty() && !rule.mayEnter.test(0))
        return open;
    for (int z = std::max(from.z, 0); z <= std::min(to.z, rowVoxels - 1); ++z) {
        for (int y = std::max(from.y, 0); y <= std::min(to.y, rowVoxels - 1); ++y) {
            const auto row = std::size_t(y + rowVoxels * z);
            const std::size_t first = rowVoxels * row;
            unsigned bits = alongRow
                & bitsWhere([&](unsigned x) { return brick.codes[first + x] - low <= span; });
            if (bits != 0 && !brick.words.empty())
                bits &= bitsWhere([&](unsigned x) {
                    return (brick.words[first + x] & seedWord::notMember) != 0;
                });
            if (bits != 0 && !brick.labels.empty())
                bits &= bitsWhere(
                    [&](unsigned x) { return rule.mayEnter.test(brick.labels[first + x]); });
            open[row] = std::uint16_t(bits);
        }
    }
    return open;
}

} // namespace core
