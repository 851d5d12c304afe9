// SPDX-License-Identifier: Apache-2.0
#include "core/chunks/ChunkField.h"

#include "core/base/LargePages.h"
#include "core/base/ParallelFor.h"
#include "core/chunks/OwnerCosts.h"
#include "core/chunks/OwnerDepths.h"
#include "core/chunks/SharedProgress.h"

#include <algorithm>
#include <array>
#include <cstdlib>

namespace core {

namespace {

using Owner = std::uint8_t;
constexpr std::uint8_t outside = ChunkSource::outside;
constexpr int mostDeviations = ChunkField::most;
constexpr std::size_t ownersAtOnce = 8; ///< each takes as much memory as half the codes

/// A sum of whole numbers, slice by slice, on all cores.
template <class Sum, class Add> Sum sumOfSlices(int slices, const Add& add)
{
    std::vector<Sum> sums(std::size_t(slices), Sum{});
    parallelFor(slices, [&](int z) { add(z, sums[std::size_t(z)]); });
    Sum all{};
    for (const Sum& sum : sums)
        all += sum;
    return all;
}

struct Share {
    std::int64_t sum = 0;
    std::int64_t count = 0;
    Share& operator+=(const Share& other)
    {
        sum += other.sum;
        count += other.count;
        return *this;
    }
};

struct OwnerShares {
    std::array<Share, 256> of{};
    OwnerShares& operator+=(const OwnerShares& other)
    {
        for (std::size_t owner = 0; owner < of.size(); ++owner)
            of[owner] += other.of[owner];
        return *this;
    }
};

/// How far apart neighbours of one owner are on average, at least 1.
int noiseOf(const ChunkSource& source)
{
    const auto columns = std::size_t(source.size.x);
    const std::size_t slice = columns * std::size_t(source.size.y);
    const Share apart = sumOfSlices<Share>(source.size.z, [&](int z, Share& sum) {
        const auto addPairs = [&](std::size_t first, std::size_t count, std::size_t way) {
            std::int64_t codes = 0;
            std::int64_t pairs = 0;
            for (std::size_t voxel = first; voxel < first + count; ++voxel) {
                const bool counts = source.owners[voxel] == source.owners[voxel + way]
                    && source.owners[voxel] != outside;
                const int step =
                    std::abs(int(source.codes[voxel]) - int(source.codes[voxel + way]));
                codes += counts ? step : 0;
                pairs += counts ? 1 : 0;
            }
            sum += Share{.sum = codes, .count = pairs};
        };
        const std::size_t begin = std::size_t(z) * slice;
        for (std::size_t row = begin; row < begin + slice; row += columns)
            addPairs(row, columns - 1, 1);
        addPairs(begin, slice - columns, columns);
        if (z + 1 < source.size.z)
            addPairs(begin, slice, slice);
    });
    return apart.count == 0 ? 1 : std::max(1, int(apart.sum / apart.count));
}

/// Of all owners that there are; the places of the others stay empty.
std::vector<OwnerCosts> ownersOf(const ChunkSource& source, std::vector<Owner>& numbers)
{
    const std::size_t slice = std::size_t(source.size.x) * std::size_t(source.size.y);
    const auto forEachIn = [&](int z, const auto& visit) {
        for (std::size_t voxel = std::size_t(z) * slice; voxel < std::size_t(z + 1) * slice;
             ++voxel)
            visit(source.owners[voxel], int(source.codes[voxel]));
    };
    const auto sums = sumOfSlices<OwnerShares>(source.size.z, [&](int z, OwnerShares& sum) {
        forEachIn(z, [&](Owner owner, int code) {
            sum.of[owner].sum += code;
            ++sum.of[owner].count;
        });
    });
    std::array<int, 256> means{};
    for (std::size_t owner = 0; owner < means.size(); ++owner)
        means[owner] =
            sums.of[owner].count == 0 ? 0 : int(sums.of[owner].sum / sums.of[owner].count);
    const auto spreads = sumOfSlices<OwnerShares>(source.size.z, [&](int z, OwnerShares& sum) {
        forEachIn(
            z, [&](Owner owner, int code) { sum.of[owner].sum += std::abs(code - means[owner]); });
    });
    std::vector<OwnerCosts> owners;
    for (std::size_t owner = 0; owner < outside; ++owner) {
        const std::int64_t count = sums.of[owner].count;
        if (count == 0)
            continue;
        numbers.push_back(Owner(owner));
        owners.push_back(
            {.mean = means[owner], .spread = std::max(1, int(spreads.of[owner].sum / count))});
    }
    return owners;
}

/// Rule 2.
void addCores(const ChunkSource& source, const BorderedBox& box, const std::vector<Owner>& numbers,
    std::vector<OwnerCosts>& owners)
{
    const std::vector<std::uint16_t> depth = ownerDepths(source);
    std::array<int, 256> deepest{};
    for (std::size_t voxel = 0; voxel < depth.size(); ++voxel) {
        int& its = deepest[source.owners[voxel]];
        its = std::max(its, int(depth[voxel]));
    }
    std::array<std::size_t, 256> places{};
    for (std::size_t i = 0; i < numbers.size(); ++i)
        places[numbers[i]] = i;
    std::size_t voxel = 0;
    for (int z = 0; z < source.size.z; ++z) {
        for (int y = 0; y < source.size.y; ++y) {
            const std::size_t row = box.rowAt(y, z);
            for (int x = 0; x < source.size.x; ++x, ++voxel) {
                const Owner owner = source.owners[voxel];
                if (owner != outside && 4 * int(depth[voxel]) >= 3 * deepest[owner])
                    owners[places[owner]].cores.push_back(std::uint32_t(row + std::size_t(x)));
            }
        }
    }
}

/// Rule 4; the likelihoods hold the least of the others' costs until the own ones are known.
struct Likelihoods {
    std::vector<std::uint8_t> own;
    std::vector<std::uint8_t> others;

    explicit Likelihoods(std::size_t voxels)
    {
        resizeInLargePages(own, voxels, std::uint8_t(mostDeviations));
        resizeInLargePages(others, voxels, std::uint8_t(mostDeviations));
    }
    void take(const ChunkSource& source, const BorderedBox& box, Owner owner,
        const std::vector<std::uint8_t>& costs)
    {
        parallelFor(source.size.z, [&](int z) {
            std::size_t voxel =
                std::size_t(z) * std::size_t(source.size.x) * std::size_t(source.size.y);
            for (int y = 0; y < source.size.y; ++y) {
                std::size_t from = box.rowAt(y, z);
                for (int x = 0; x < source.size.x; ++x, ++voxel, ++from) {
                    if (source.owners[voxel] == owner)
                        own[voxel] = costs[from];
                    else
                        others[voxel] = std::min(others[voxel], costs[from]);
                }
            }
        });
    }
};

/// What a probability map says of each voxel, seen from the voxel's own owner.
std::vector<std::int16_t> mappedLikelihoods(const ChunkSource& source)
{
    std::vector<std::int16_t> likelihoods(source.owners.size());
    const std::size_t slice = std::size_t(source.size.x) * std::size_t(source.size.y);
    parallelFor(source.size.z, [&](int z) {
        for (std::size_t voxel = std::size_t(z) * slice; voxel < std::size_t(z + 1) * slice;
             ++voxel) {
            const int likely = 2 * int(source.probabilities[voxel]) - mostDeviations;
            const Owner owner = source.owners[voxel];
            likelihoods[voxel] = std::int16_t(owner == outside ? 0
                    : owner == source.likely                   ? likely
                                                               : -likely);
        }
    });
    return likelihoods;
}

} // namespace

Result<ChunkField> ChunkField::of(const ChunkSource& source, const Progress& progress)
{
    ChunkField field;
    field.m_noise = noiseOf(source);
    if (!source.probabilities.empty()) {
        progress.report(ProgressStep::FindingLikelyParts, 0, 1);
        field.m_likelihoods = mappedLikelihoods(source);
        return field;
    }
    std::vector<Owner> numbers;
    std::vector<OwnerCosts> owners = ownersOf(source, numbers);
    const BorderedBox box(source);
    addCores(source, box, numbers, owners);
    Likelihoods likelihoods(source.owners.size());
    SharedProgress shared(progress, ProgressStep::FindingLikelyParts,
        std::int64_t(owners.size()) * std::int64_t(source.owners.size()));
    for (std::size_t first = 0; first < owners.size(); first += ownersAtOnce) {
        const std::size_t count = std::min(ownersAtOnce, owners.size() - first);
        std::vector<std::vector<std::uint8_t>> costs(count);
        parallelFor(int(count), [&](int i) {
            costs[std::size_t(i)] = owners[first + std::size_t(i)].of(box, field.m_noise,
                [&shared](std::size_t more) { return shared.advance(std::int64_t(more)); });
        });
        if (progress.cancelled())
            return failure(ErrorCode::Cancelled);
        for (std::size_t i = 0; i < count; ++i)
            likelihoods.take(source, box, numbers[first + i], costs[i]);
    }
    if (progress.cancelled())
        return failure(ErrorCode::Cancelled);
    resizeInLargePages(field.m_likelihoods, source.owners.size());
    for (std::size_t voxel = 0; voxel < field.m_likelihoods.size(); ++voxel)
        field.m_likelihoods[voxel] = source.owners[voxel] == outside
            ? std::int16_t(0)
            : std::int16_t(int(likelihoods.others[voxel]) - int(likelihoods.own[voxel]));
    return field;
}

int ChunkField::codesWithin(int deviations) const
{
    return ((deviations + 1) * m_noise - 1) / deviation;
}

} // namespace core
