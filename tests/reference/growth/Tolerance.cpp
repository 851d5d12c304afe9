// SPDX-License-Identifier: Apache-2.0
#include "tests/reference/growth/Tolerance.h"

#include "core/growth/SeedWord.h"
#include "tests/reference/growth/GrowCriterion.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <utility>

namespace reference {

namespace seedWord = core::seedWord;

namespace {

constexpr std::uint16_t none = 0xFFFF;

template <class Visit> void forEachVoxel(const glm::ivec3& size, Visit visit)
{
    for (int z = 0; z < size.z; ++z)
        for (int y = 0; y < size.y; ++y)
            for (int x = 0; x < size.x; ++x)
                visit(glm::ivec3(x, y, z));
}

bool isPainted(std::uint32_t word, std::uint32_t label)
{
    return seedWord::isMember(word) && seedWord::label(word) == label
        && seedWord::generation(word) == 0;
}

bool isSeed(std::uint32_t word, std::uint32_t label)
{
    const bool bears = seedWord::isMember(word) || seedWord::isPendingSeed(word);
    if (!bears || seedWord::label(word) != label)
        return false;
    return seedWord::isPendingSeed(word) || seedWord::isSeed(word) || isPainted(word, label);
}

} // namespace

std::optional<int> ToleranceField::at(const glm::ivec3& voxel) const
{
    const int tolerance = tolerances.at(voxel);
    return tolerance <= core::ToleranceRule::greatest ? std::optional(tolerance) : std::nullopt;
}

core::Result<ToleranceField> traceTolerance(const DenseArray<std::uint16_t>& codes,
    DenseArray<std::uint8_t> coverage, DenseFields& fields, const core::ToleranceRule& rule)
{
    const auto refuse = [](const char* field, const char* reason) {
        return core::failure(
            core::ErrorCode::InvalidField, QLatin1String(field), QLatin1String(reason));
    };
    if (!core::isSound(rule))
        return refuse("rule", "is not sound");
    const DenseArray<std::uint8_t>& labels = fields.labels(rule.plane);
    const DenseArray<std::uint32_t>& words = fields.seedWords(rule.plane);
    const GrowCriterion criterion(codes, std::move(coverage), words,
        {.lowCode = 0, .highCode = 65535, .limits = rule.limits});

    std::uint64_t sum = 0;
    std::uint64_t count = 0;
    forEachVoxel(codes.size, [&](const glm::ivec3& voxel) {
        if (!isSeed(words.at(voxel), rule.label))
            return;
        sum += codes.at(voxel);
        ++count;
    });
    if (count == 0)
        return refuse("seeds", "there are none");
    ToleranceField traced;
    traced.curve.centre = int((2 * sum + count) / (2 * count));

    // What a voxel costs; none: it is not open.
    const auto cost = [&](const glm::ivec3& voxel) -> std::optional<int> {
        const std::uint32_t word = words.at(voxel);
        if (isPainted(word, rule.label))
            return 0;
        if (word == seedWord::barrier
            || (seedWord::isMember(word) && seedWord::label(word) != rule.label))
            return std::nullopt;
        const std::uint8_t held = labels.at(voxel);
        if (held != 0 && held != rule.label && !rule.overwritable.test(held))
            return std::nullopt;
        const bool added = seedWord::isMember(word) && seedWord::generation(word) > 0
            && seedWord::direction(word) != 29 && seedWord::direction(word) != 30
            && held == rule.label;
        const std::uint8_t before = added ? fields.overwritten(rule.plane).at(voxel) : held;
        if (rule.range.closed.test(before) || !criterion.isBetween(voxel, rule.range)
            || !criterion.allows(rule.label, voxel))
            return std::nullopt;
        return std::abs(int(codes.at(voxel)) - traced.curve.centre);
    };

    // One bucket a tolerance: whoever is taken from the lowest one has the least there is.
    DenseArray<std::uint16_t>& tolerances = traced.tolerances;
    tolerances = {codes.size, std::vector<std::uint16_t>(codes.values.size(), none)};
    std::vector<std::vector<glm::ivec3>> buckets(core::ToleranceRule::greatest + 1);
    const auto offer = [&](const glm::ivec3& voxel, int tolerance) {
        const std::optional<int> own = cost(voxel);
        const int least = own ? std::max(*own, tolerance) : int(none);
        if (least > core::ToleranceRule::greatest || least >= tolerances.at(voxel))
            return;
        tolerances.at(voxel) = std::uint16_t(least);
        buckets[std::size_t(least)].push_back(voxel);
    };
    forEachVoxel(codes.size, [&](const glm::ivec3& voxel) {
        if (isSeed(words.at(voxel), rule.label))
            offer(voxel, 0);
    });
    for (int tolerance = 0; tolerance <= core::ToleranceRule::greatest; ++tolerance) {
        std::vector<glm::ivec3>& bucket = buckets[std::size_t(tolerance)];
        for (std::size_t i = 0; i < bucket.size(); ++i) { // it grows meanwhile
            const glm::ivec3 voxel = bucket[i];
            if (tolerances.at(voxel) != tolerance)
                continue;
            for (std::size_t direction = 0; direction < std::size_t(rule.connectivity);
                 ++direction) {
                const std::array<int, 3>& step = seedWord::offsets[direction];
                const glm::ivec3 next = voxel + glm::ivec3(step[0], step[1], step[2]);
                if (codes.contains(next))
                    offer(next, tolerance);
            }
        }
    }
    for (const std::uint16_t tolerance : tolerances.values) {
        if (tolerance > core::ToleranceRule::greatest)
            continue;
        traced.curve.sizes.resize(std::max(traced.curve.sizes.size(), std::size_t(tolerance) + 1));
        ++traced.curve.sizes[tolerance];
    }
    return traced;
}

} // namespace reference
