// SPDX-License-Identifier: Apache-2.0
#include "core/volume/encoding/CodeCounts.h"

#include "core/base/ParallelFor.h"

#include <algorithm>
#include <mutex>
#include <span>
#include <utility>

namespace core {

namespace {

/// Smallest code with at least @p share of all voxels at or below it.
int percentileCode(const CodeCounts& counts, std::uint64_t total, double share)
{
    std::uint64_t below = 0;
    for (int code = 0; code < VoxelEncoding::codeCount; ++code) {
        below += counts[std::size_t(code)];
        if (double(below) >= share * double(total))
            return code;
    }
    return VoxelEncoding::codeCount - 1;
}

/// From the least to the greatest value that is counted.
std::pair<double, double> countedRange(const Volume& volume, const CodeCounts& counts)
{
    const auto isCounted = [](std::uint64_t count) { return count > 0; };
    const auto first = std::find_if(counts.begin(), counts.end(), isCounted);
    const auto last = std::find_if(counts.rbegin(), counts.rend(), isCounted);
    // What codes hold inexactly keeps its exact ends.
    const auto lowest = int(first - counts.begin());
    const auto highest = int(counts.rend() - last) - 1;
    const double least = volume.encoding.value(lowest);
    const double greatest = volume.encoding.value(highest);
    return {std::max(least, volume.minimum), std::min(greatest, volume.maximum)};
}

/// Codes that do not count, unless there are no others.
void forget(CodeCounts& counts, const CodeRange& range)
{
    CodeCounts rest = counts;
    const int lowest = std::max(range.lowest, 0);
    for (int code = lowest; code <= std::min(range.highest, VoxelEncoding::codeCount - 1); ++code)
        rest[std::size_t(code)] = 0;
    if (std::any_of(rest.begin(), rest.end(), [](std::uint64_t count) { return count > 0; }))
        counts = std::move(rest);
}

} // namespace

CodeCounts countCodes(const LoadedVolume& loaded)
{
    const glm::ivec3& size = loaded.volume.geometry.size;
    const std::size_t each = std::size_t(size.x) * std::size_t(size.y);
    CodeCounts counts(VoxelEncoding::codeCount, 0);
    std::mutex mutex;
    parallelFor(size.z, [&](int k) {
        std::vector<std::uint32_t> own(VoxelEncoding::codeCount, 0);
        for (const std::uint16_t code :
            std::span(loaded.codes).subspan(std::size_t(k) * each, each))
            ++own[code];
        const std::lock_guard lock(mutex);
        std::transform(own.begin(), own.end(), counts.begin(), counts.begin(),
            [](std::uint32_t more, std::uint64_t count) { return count + more; });
    });
    return counts;
}

void describeCounts(Volume& volume, const CodeCounts& counts, bool hasWindow)
{
    constexpr int bins = 256;
    const VoxelEncoding& encoding = volume.encoding;
    const auto [minimum, maximum] = countedRange(volume, counts);
    volume.histogram = {
        .minimum = minimum, .maximum = maximum, .counts = std::vector<std::uint32_t>(bins, 0)};
    const double range = maximum - minimum;
    std::uint64_t total = 0;
    for (int code = 0; code < VoxelEncoding::codeCount; ++code) {
        const std::uint64_t count = counts[std::size_t(code)];
        if (count == 0)
            continue;
        total += count;
        const double share = range > 0.0 ? (encoding.value(code) - minimum) / range : 0.0;
        const int bin = std::clamp(int(share * bins), 0, bins - 1);
        std::uint32_t& sum = volume.histogram.counts[std::size_t(bin)];
        sum = std::uint32_t(std::min<std::uint64_t>(sum + count, UINT32_MAX));
    }
    if (hasWindow)
        return;
    // Robust against metal, noise and the large dark background around most objects.
    const double low = encoding.value(percentileCode(counts, total, 0.02));
    const double high = encoding.value(percentileCode(counts, total, 0.995));
    // Nearly all of a mask or of a map of probabilities may be the same value.
    const double width = high > low ? high - low : range > 0.0 ? range : 1.0;
    volume.defaultWindow = {.centre = low + width / 2.0, .width = width};
}

void describeExactCounts(
    LoadedVolume& loaded, CodeCounts counts, const Uncounted& uncounted, bool hasWindow)
{
    Volume& volume = loaded.volume;
    int lowest = VoxelEncoding::codeCount - 1;
    int highest = 0;
    for (int code = 0; code < VoxelEncoding::codeCount; ++code) {
        if (counts[std::size_t(code)] == 0)
            continue;
        lowest = std::min(lowest, code);
        highest = std::max(highest, code);
    }
    volume.minimum = volume.encoding.value(lowest);
    volume.maximum = volume.encoding.value(highest);
    counts[std::size_t(uncounted.code)] -= uncounted.voxels;
    if (loaded.padding)
        forget(counts, *loaded.padding);
    describeCounts(volume, counts, hasWindow);
}

} // namespace core
