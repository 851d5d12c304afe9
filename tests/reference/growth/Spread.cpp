// SPDX-License-Identifier: Apache-2.0
#include "tests/reference/growth/Spread.h"

#include "core/growth/SeedWord.h"

#include <queue>
#include <set>
#include <tuple>

namespace reference {

namespace seedWord = core::seedWord;

namespace {

template <class Visit> void forEachVoxel(const core::VoxelBox& box, Visit visit)
{
    for (int z = box.minimum.z; z < box.maximum.z; ++z)
        for (int y = box.minimum.y; y < box.maximum.y; ++y)
            for (int x = box.minimum.x; x < box.maximum.x; ++x)
                visit(glm::ivec3(x, y, z));
}

/// Whether a voxel that is no seed may receive another label.
bool mayChange(
    std::uint32_t held, int code, const glm::ivec3& voxel, const core::SpreadLabels& spread)
{
    const core::GrowthRange& range = spread.range;
    if (spread.within
        && (glm::any(glm::lessThan(voxel, spread.within->minimum))
            || glm::any(glm::greaterThanEqual(voxel, spread.within->maximum))))
        return false;
    return (held == 0 || spread.overwritable.test(held)) && !range.closed.test(held)
        && range.lowCode <= code && code <= range.highCode;
}

/// The label that a voxel is a seed of; 0: none.
std::uint32_t seedLabel(std::uint32_t held, std::uint32_t word, int code, const glm::ivec3& voxel,
    const core::SpreadLabels& spread)
{
    if (spread.seeds.test(held))
        return held;
    if (mayChange(held, code, voxel, spread) && seedWord::isPendingSeed(word)
        && spread.seeds.test(seedWord::label(word)))
        return seedWord::label(word);
    return 0;
}

} // namespace

core::Result<void> spreadLabels(
    const DenseArray<std::uint16_t>& codes, DenseFields& fields, const core::SpreadLabels& spread)
{
    auto& labels = fields.labels(spread.plane);
    auto& words = fields.seedWords(spread.plane);
    const core::VoxelBox volume{glm::ivec3(0), codes.size};
    core::VoxelBox seedBox;
    std::set<std::uint32_t> seeded;
    forEachVoxel(volume, [&](const glm::ivec3& voxel) {
        const std::uint32_t label =
            seedLabel(labels.at(voxel), words.at(voxel), codes.at(voxel), voxel, spread);
        if (label == 0)
            return;
        seeded.insert(label);
        seedBox = seedBox.united({voxel, voxel + 1});
    });
    if (seeded.size() < 2)
        return core::failure(core::ErrorCode::InvalidField, QStringLiteral("seeds"),
            QStringLiteral("fewer than two segments have any"));

    // Dijkstra: whatever leaves the queue first has the least (cost, label) there is.
    using Offer = std::tuple<std::uint32_t, std::uint32_t, std::size_t>; // cost, label, voxel
    std::priority_queue<Offer, std::vector<Offer>, std::greater<>> queue;
    const core::VoxelBox box = core::spreadBox(spread, seedBox, codes.size);
    DenseArray<char> open{codes.size, std::vector<char>(codes.values.size(), 0)};
    DenseArray<std::uint32_t> won{codes.size, std::vector<std::uint32_t>(codes.values.size(), 0)};
    forEachVoxel(box, [&](const glm::ivec3& voxel) {
        const std::uint32_t held = labels.at(voxel);
        const std::uint32_t label =
            seedLabel(held, words.at(voxel), codes.at(voxel), voxel, spread);
        if (label != 0)
            queue.emplace(0, label, codes.offset(voxel));
        open.at(voxel) = label != 0
            || (mayChange(held, codes.at(voxel), voxel, spread)
                && words.at(voxel) != seedWord::barrier);
    });
    while (!queue.empty()) {
        const auto [cost, label, at] = queue.top();
        queue.pop();
        if (won.values[at] != 0)
            continue;
        won.values[at] = label;
        const glm::ivec3 voxel(int(at) % codes.size.x, int(at) / codes.size.x % codes.size.y,
            int(at) / (codes.size.x * codes.size.y));
        for (std::size_t direction = 0; direction < std::size_t(spread.connectivity); ++direction) {
            const auto& offset = seedWord::offsets[direction];
            const glm::ivec3 next = voxel + glm::ivec3(offset[0], offset[1], offset[2]);
            if (!codes.contains(next) || !open.at(next) || won.at(next) != 0)
                continue;
            const int difference = std::abs(int(codes.at(next)) - int(codes.at(voxel)));
            const std::uint32_t sum = cost + std::uint32_t(difference) * spread.differenceWeight
                + spread.lengths[direction / 2];
            if (sum < core::SpreadLabels::maxCost)
                queue.emplace(sum, label, codes.offset(next));
        }
    }
    forEachVoxel(box, [&](const glm::ivec3& voxel) {
        const std::uint32_t label = won.at(voxel);
        if (label == 0 || labels.at(voxel) == label)
            return;
        labels.at(voxel) = std::uint8_t(label);
        std::uint32_t& word = words.at(voxel);
        const bool bears = seedWord::isMember(word) || seedWord::isPendingSeed(word);
        if (bears && seedWord::label(word) != label)
            word = seedWord::unvisited;
    });
    return {};
}

} // namespace reference
