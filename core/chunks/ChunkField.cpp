// SPDX-License-Identifier: Apache-2.0
#include "core/chunks/ChunkField.h"

#include "core/chunks/BoxWalk.h"

#include <algorithm>
#include <array>
#include <bitset>
#include <cstdlib>
#include <functional>

namespace core {

namespace {

using Owner = std::uint8_t;
constexpr std::uint8_t outside = ChunkSource::outside;
constexpr int most = ChunkField::most;

/// Of the codes that an owner has.
struct OwnerValues {
    int mean = 0;
    int spread = 1; ///< mean deviation from it, at least 1
};

OwnerValues valuesOf(const ChunkSource& source, Owner owner)
{
    std::int64_t sum = 0;
    std::int64_t count = 0;
    for (std::size_t voxel = 0; voxel < source.owners.size(); ++voxel) {
        if (source.owners[voxel] == owner) {
            sum += source.codes[voxel];
            ++count;
        }
    }
    OwnerValues values{.mean = int(sum / count)};
    std::int64_t apart = 0;
    for (std::size_t voxel = 0; voxel < source.owners.size(); ++voxel) {
        if (source.owners[voxel] == owner)
            apart += std::abs(int(source.codes[voxel]) - values.mean);
    }
    values.spread = std::max(1, int(apart / count));
    return values;
}

/// How far apart neighbours of one owner are on average, at least 1.
int noiseOf(const ChunkSource& source, const BoxWalk& box)
{
    std::int64_t apart = 0;
    std::int64_t pairs = 0;
    box.forEachPair([&](std::size_t voxel, std::size_t neighbour) {
        if (source.owners[voxel] == source.owners[neighbour] && source.owners[voxel] != outside) {
            apart += std::abs(int(source.codes[voxel]) - int(source.codes[neighbour]));
            ++pairs;
        }
    });
    return pairs == 0 ? 1 : std::max(1, int(apart / pairs));
}

int inDeviations(int difference, int deviation)
{
    return std::min(most, difference * ChunkField::deviation / deviation);
}

/// Steps from each voxel to the nearest one of another owner, what lies outside included.
std::vector<std::uint16_t> depths(const ChunkSource& source, const BoxWalk& box)
{
    std::vector<std::uint16_t> depth(source.owners.size(), 0);
    std::vector<std::size_t> front;
    box.forEachPair([&](std::size_t voxel, std::size_t neighbour) {
        if (source.owners[voxel] == source.owners[neighbour])
            return;
        for (const std::size_t one : {voxel, neighbour}) {
            if (depth[one] == 0) {
                depth[one] = 1;
                front.push_back(one);
            }
        }
    });
    // The box is small enough that no way through it has more steps than 16 bits hold.
    std::vector<std::size_t> next;
    for (std::uint16_t steps = 2; !front.empty(); ++steps) {
        for (const std::size_t voxel : front) {
            box.forEachNeighbour(voxel, [&](std::size_t neighbour) {
                if (depth[neighbour] == 0) {
                    depth[neighbour] = steps;
                    next.push_back(neighbour);
                }
            });
        }
        front.swap(next);
        next.clear();
    }
    return depth;
}

constexpr std::size_t voxelsBetweenReports = std::size_t(1) << 16;
constexpr int ownerShare = 1000; ///< of an owner in what is reported

/// Rule 3: buckets of a whole number each, so no order of equals matters.
/// @param goOn told now and then how many voxels have their cost; false: it is given up
std::vector<std::uint8_t> costsFor(const ChunkSource& source, const BoxWalk& box, Owner owner,
    const std::vector<std::uint16_t>& depth, int noise,
    const std::function<bool(std::size_t)>& goOn)
{
    const OwnerValues values = valuesOf(source, owner);
    std::vector<std::uint8_t> costs(source.owners.size(), std::uint8_t(most));
    std::array<std::vector<std::size_t>, std::size_t(most) + 1> buckets;
    std::uint16_t deepest = 0;
    for (std::size_t voxel = 0; voxel < costs.size(); ++voxel) {
        if (source.owners[voxel] == owner)
            deepest = std::max(deepest, depth[voxel]);
    }
    for (std::size_t voxel = 0; voxel < costs.size(); ++voxel) {
        if (source.owners[voxel] == owner && 4 * int(depth[voxel]) >= 3 * int(deepest)) {
            costs[voxel] = 0;
            buckets[0].push_back(voxel);
        }
    }
    std::size_t settled = 0;
    for (int level = 0; level < most; ++level) {
        auto& bucket = buckets[std::size_t(level)];
        for (std::size_t i = 0; i < bucket.size(); ++i) {
            const std::size_t voxel = bucket[i];
            if (costs[voxel] != level)
                continue;
            if (++settled % voxelsBetweenReports == 0 && !goOn(settled))
                return costs;
            box.forEachNeighbour(voxel, [&](std::size_t neighbour) {
                if (source.owners[neighbour] == outside)
                    return;
                const int here = source.codes[voxel];
                const int there = source.codes[neighbour];
                const int step = std::max(inDeviations(std::abs(here - there), noise),
                    inDeviations(std::abs(here + there - 2 * values.mean), 2 * values.spread));
                const int cost = std::max(level, step);
                if (cost < costs[neighbour]) {
                    costs[neighbour] = std::uint8_t(cost);
                    buckets[std::size_t(cost)].push_back(neighbour);
                }
            });
        }
        bucket = {};
    }
    return costs;
}

} // namespace

Result<ChunkField> ChunkField::of(const ChunkSource& source, const Progress& progress)
{
    const BoxWalk box(source.size);
    ChunkField field;
    field.m_codes = source.codes;
    field.m_noise = noiseOf(source, box);
    std::bitset<256> owners;
    for (const Owner owner : source.owners)
        owners.set(owner);
    owners.reset(outside);
    const std::vector<std::uint16_t> depth = depths(source, box);
    std::vector<std::uint8_t> own(source.owners.size(), std::uint8_t(most));
    std::vector<std::uint8_t> others(source.owners.size(), std::uint8_t(most));
    int done = 0;
    for (int owner = 0; owner < outside; ++owner) {
        if (!owners.test(std::size_t(owner)))
            continue;
        const auto goOn = [&](std::size_t settled) {
            const auto share = int(std::size_t(ownerShare) * settled / source.owners.size());
            progress.report(QStringLiteral("Finding likely parts"), done * ownerShare + share,
                int(owners.count()) * ownerShare);
            return !progress.cancelled();
        };
        if (!goOn(0))
            return failure(ErrorCode::Cancelled);
        const auto costs = costsFor(source, box, Owner(owner), depth, field.m_noise, goOn);
        ++done;
        for (std::size_t voxel = 0; voxel < costs.size(); ++voxel) {
            std::uint8_t& least = source.owners[voxel] == owner ? own[voxel] : others[voxel];
            least = std::min(least, costs[voxel]);
        }
    }
    if (progress.cancelled())
        return failure(ErrorCode::Cancelled);
    field.m_likelihood.resize(source.owners.size());
    for (std::size_t voxel = 0; voxel < own.size(); ++voxel)
        field.m_likelihood[voxel] = std::int16_t(int(others[voxel]) - int(own[voxel]));
    return field;
}

int ChunkField::step(std::size_t voxel, std::size_t neighbour) const
{
    const int values = std::abs(int(m_codes[voxel]) - int(m_codes[neighbour]));
    const int likelihoods = std::abs(likelihood(voxel) - likelihood(neighbour));
    return std::max(inDeviations(values, m_noise), std::min(most, likelihoods));
}

} // namespace core
