// SPDX-License-Identifier: Apache-2.0
#include "core/chunks/OwnerCosts.h"

#include "core/base/LargePages.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <limits>

namespace core {

namespace {

constexpr int highestCost = ChunkField::most;
constexpr int highestCode = std::numeric_limits<std::uint16_t>::max();
constexpr std::size_t voxelsBetweenReports = std::size_t(1) << 13;

/// inDeviations() for each difference, up to and including the first one that is clamped.
std::vector<std::uint8_t> deviationsTable(int greatest, int deviation)
{
    std::vector<std::uint8_t> table;
    for (int difference = 0; difference <= greatest; ++difference) {
        table.push_back(std::uint8_t(inDeviations(difference, deviation)));
        if (table.back() == highestCost)
            break;
    }
    return table;
}

} // namespace

int inDeviations(int difference, int deviation)
{
    return std::min(highestCost, difference * ChunkField::deviation / deviation);
}

BorderedBox::BorderedBox(const ChunkSource& source)
    : size(source.size)
{
    // Paths go through them in all directions, so with small pages nearly every step would miss the
    // cache of page addresses (TLB).
    resizeInLargePages(codes, slice() * (std::size_t(size.z) + 2));
    resizeInLargePages(costs, codes.size());
    std::size_t from = 0;
    for (int z = 0; z < size.z; ++z) {
        for (int y = 0; y < size.y; ++y) {
            std::size_t to = rowAt(y, z);
            for (int x = 0; x < size.x; ++x, ++from, ++to) {
                codes[to] = source.codes[from];
                costs[to] =
                    std::uint8_t(source.owners[from] == ChunkSource::outside ? 0 : highestCost);
            }
        }
    }
}

std::vector<std::uint8_t> OwnerCosts::of(
    const BorderedBox& box, int noise, const std::function<bool(std::size_t)>& goOn) const
{
    const std::vector<std::uint8_t> apart = deviationsTable(highestCode, noise);
    const std::vector<std::uint8_t> fromMean = deviationsTable(2 * highestCode, 2 * spread);
    const auto stepOf = [&](const std::vector<std::uint8_t>& table, int difference) {
        return int(table[std::min(std::size_t(std::abs(difference)), table.size() - 1)]);
    };
    std::vector<std::uint8_t> costs;
    reserveInLargePages(costs, box.costs.size());
    costs.assign(box.costs.begin(), box.costs.end());
    // One bucket for each cost; the order within a bucket does not matter. The last voxel is taken
    // first, because it lies near the previous one.
    std::array<std::vector<std::uint32_t>, std::size_t(highestCost)> buckets;
    for (const std::uint32_t voxel : cores)
        costs[voxel] = 0;
    buckets[0] = cores;
    const auto row = std::ptrdiff_t(box.row());
    const auto slice = std::ptrdiff_t(box.slice());
    const std::array<std::ptrdiff_t, 6> neighbours{-slice, slice, -row, row, -1, 1};
    std::size_t settled = 0;
    for (int level = 0; level < highestCost; ++level) {
        auto& bucket = buckets[std::size_t(level)];
        while (!bucket.empty()) {
            const std::uint32_t voxel = bucket.back();
            bucket.pop_back();
            if (costs[voxel] != level)
                continue;
            if (++settled % voxelsBetweenReports == 0 && !goOn(voxelsBetweenReports))
                return costs;
            const int here = box.codes[voxel];
            for (const std::ptrdiff_t way : neighbours) {
                const auto neighbour = std::size_t(std::ptrdiff_t(voxel) + way);
                const int known = costs[neighbour];
                if (known <= level)
                    continue;
                const int there = box.codes[neighbour];
                const int cost = std::max({level, stepOf(apart, here - there),
                    stepOf(fromMean, here + there - 2 * mean)});
                if (cost < known) {
                    costs[neighbour] = std::uint8_t(cost);
                    buckets[std::size_t(cost)].push_back(std::uint32_t(neighbour));
                }
            }
        }
        bucket = {};
    }
    return costs;
}

} // namespace core
