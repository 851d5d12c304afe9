// SPDX-License-Identifier: Apache-2.0
#include "core/volume/VolumeEncoder.h"

#include "core/base/ParallelFor.h"
#include "core/base/Sha256.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <cmath>
#include <cstring>
#include <future>
#include <limits>
#include <mutex>
#include <utility>

namespace core {

namespace {

constexpr int codeCount = VoxelEncoding::codeCount;
using CodeCounts = std::vector<std::uint64_t>;

std::size_t sliceSize(const Volume& volume)
{
    return std::size_t(volume.geometry.size.x) * std::size_t(volume.geometry.size.y);
}

/// Counts of codes that several threads add to, slice by slice.
class CodeCounter {
public:
    explicit CodeCounter(int greatestCode = codeCount - 1)
        : m_used(std::size_t(greatestCode) + 1)
    {
    }
    void add(std::span<const std::uint16_t> codes)
    {
        std::vector<std::uint32_t> own(m_used, 0);
        for (const std::uint16_t code : codes)
            ++own[code];
        const std::lock_guard lock(m_mutex);
        std::transform(own.begin(), own.end(), m_counts.begin(), m_counts.begin(),
            [](std::uint32_t more, std::uint64_t count) { return count + more; });
    }
    [[nodiscard]] CodeCounts take() { return std::move(m_counts); }

private:
    std::size_t m_used; ///< no code is greater
    std::mutex m_mutex;
    CodeCounts m_counts = CodeCounts(codeCount, 0);
};

std::span<const std::uint16_t> codesOf(const LoadedVolume& loaded, int k)
{
    const std::size_t size = sliceSize(loaded.volume);
    return std::span(loaded.codes).subspan(std::size_t(k) * size, size);
}

CodeCounts countCodes(const LoadedVolume& loaded)
{
    CodeCounter counter;
    parallelFor(loaded.volume.geometry.size.z, [&](int k) { counter.add(codesOf(loaded, k)); });
    return counter.take();
}

/// Smallest code with at least @p share of all voxels at or below it.
int percentileCode(const CodeCounts& counts, std::uint64_t total, double share)
{
    std::uint64_t below = 0;
    for (int code = 0; code < codeCount; ++code) {
        below += counts[std::size_t(code)];
        if (double(below) >= share * double(total))
            return code;
    }
    return codeCount - 1;
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

void describe(Volume& volume, const CodeCounts& counts, bool hasWindow)
{
    constexpr int bins = 256;
    const VoxelEncoding& encoding = volume.encoding;
    const auto [minimum, maximum] = countedRange(volume, counts);
    volume.histogram = {
        .minimum = minimum, .maximum = maximum, .counts = std::vector<std::uint32_t>(bins, 0)};
    const double range = maximum - minimum;
    std::uint64_t total = 0;
    for (int code = 0; code < codeCount; ++code) {
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
    const double width = high > low ? high - low : std::max(range, 1.0);
    volume.defaultWindow = {.centre = low + width / 2.0, .width = width};
}

void addFloats(Sha256& hash, std::span<const float> values)
{
    static_assert(std::numeric_limits<float>::is_iec559);
    hash.add(values.data(), values.size_bytes());
}

std::vector<float> valuesOfCodes(const VoxelEncoding& encoding)
{
    std::vector<float> values(codeCount);
    for (int code = 0; code < codeCount; ++code)
        values[std::size_t(code)] = float(encoding.value(code));
    return values;
}

/// Adds the values of a slice to a checksum; what follows from codes by table.
void addByTable(Sha256& hash, std::span<const std::uint16_t> codes, const std::vector<float>& table)
{
    // In pieces that stay in the innermost cache.
    std::array<float, 4096> values;
    while (!codes.empty()) {
        const std::span<const std::uint16_t> piece =
            codes.first(std::min(codes.size(), values.size()));
        std::transform(piece.begin(), piece.end(), values.begin(),
            [&table](std::uint16_t code) { return table[code]; });
        addFloats(hash, std::span(values).first(piece.size()));
        codes = codes.subspan(piece.size());
    }
}

/// Codes that do not count, unless there are no others.
void forget(CodeCounts& counts, const CodeRange& range)
{
    CodeCounts rest = counts;
    const int lowest = std::max(range.lowest, 0);
    for (int code = lowest; code <= std::min(range.highest, codeCount - 1); ++code)
        rest[std::size_t(code)] = 0;
    if (std::any_of(rest.begin(), rest.end(), [](std::uint64_t count) { return count > 0; }))
        counts = std::move(rest);
}

/// Voxels that do not count, of which there is one code.
struct Uncounted {
    int code = 0;
    std::uint64_t voxels = 0;
};

/// Codes are exact: minimum and maximum follow from how often they occur.
void describeExact(
    LoadedVolume& loaded, CodeCounts counts, const Uncounted& uncounted, bool hasWindow)
{
    Volume& volume = loaded.volume;
    int lowest = codeCount - 1;
    int highest = 0;
    for (int code = 0; code < codeCount; ++code) {
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
    describe(volume, counts, hasWindow);
}

int storedValue(std::uint16_t bits, bool isSigned)
{
    return isSigned ? int(std::int16_t(bits)) : int(bits);
}

template <class Stored> StoredRange rangeOf(std::span<const std::uint16_t> bits)
{
    Stored lowest = std::numeric_limits<Stored>::max();
    Stored highest = std::numeric_limits<Stored>::lowest();
    for (const std::uint16_t each : bits) {
        lowest = std::min(lowest, Stored(each));
        highest = std::max(highest, Stored(each));
    }
    return {.lowest = lowest, .highest = highest};
}

StoredRange rangeOfStored(const LoadedVolume& loaded, std::span<const SliceRescale> slices)
{
    std::vector<StoredRange> ranges(slices.size());
    parallelFor(int(slices.size()), [&](int k) {
        const std::span<const std::uint16_t> bits = codesOf(loaded, k);
        ranges[std::size_t(k)] = slices[std::size_t(k)].isSigned ? rangeOf<std::int16_t>(bits)
                                                                 : rangeOf<std::uint16_t>(bits);
    });
    StoredRange all = ranges.front();
    for (const StoredRange& range : ranges) {
        all.lowest = std::min(all.lowest, range.lowest);
        all.highest = std::max(all.highest, range.highest);
    }
    return all;
}

} // namespace

void encodeStoredValues(LoadedVolume& loaded, std::span<const SliceRescale> slices, bool hasWindow)
{
    const std::size_t size = sliceSize(loaded.volume);
    const bool oneScale = std::all_of(slices.begin(), slices.end(), [&](const SliceRescale& slice) {
        return slice.slope == slices[0].slope && slice.intercept == slices[0].intercept;
    });
    const StoredRange all = rangeOfStored(loaded, slices);
    const int least = all.lowest;
    const int greatest = all.highest;
    if (!oneScale || greatest - least >= codeCount) {
        const std::vector<std::uint16_t> stored = loaded.codes;
        encodeValues(
            loaded,
            [&](int k, std::span<double> values) {
                const SliceRescale& slice = slices[std::size_t(k)];
                const std::uint16_t* from = stored.data() + std::size_t(k) * size;
                for (std::size_t voxel = 0; voxel < size; ++voxel) {
                    values[voxel] = slice.slope * double(storedValue(from[voxel], slice.isSigned))
                        + slice.intercept;
                }
            },
            hasWindow);
        return;
    }
    const bool falling = slices[0].slope < 0.0;
    loaded.volume.encoding = {.rescaleSlope = slices[0].slope,
        .rescaleIntercept = slices[0].intercept,
        .storedAtCodeZero = falling ? greatest : least,
        .storedStep = falling ? -1 : 1};
    // The checksum is a chain and takes one core; it follows the others from slice to slice.
    const std::vector<float> valueOfCode = valuesOfCodes(loaded.volume.encoding);
    std::vector<std::atomic<bool>> encoded(slices.size());
    std::future<QByteArray> checksum = std::async(std::launch::async, [&] {
        Sha256 hash;
        for (std::size_t k = 0; k < slices.size(); ++k) {
            encoded[k].wait(false);
            addByTable(hash, codesOf(loaded, int(k)), valueOfCode);
        }
        return hash.takeHex();
    });
    CodeCounter counter(greatest - least);
    parallelFor(int(slices.size()), [&](int k) {
        const std::span<std::uint16_t> codes =
            std::span(loaded.codes).subspan(std::size_t(k) * size, size);
        // As 16 bits, in which signed and unsigned numbers are subtracted alike.
        const auto zero = std::uint16_t(falling ? greatest : least);
        if (falling) {
            for (std::uint16_t& code : codes)
                code = std::uint16_t(zero - code);
        } else {
            for (std::uint16_t& code : codes)
                code = std::uint16_t(code - zero);
        }
        encoded[std::size_t(k)] = true;
        encoded[std::size_t(k)].notify_one();
        counter.add(codes);
    });
    // Slices that do not agree on what is padding have none.
    const bool agreed = std::all_of(slices.begin(), slices.end(),
        [&](const SliceRescale& slice) { return slice.padding == slices[0].padding; });
    if (slices[0].padding && agreed) {
        const StoredRange& stored = *slices[0].padding;
        loaded.padding = falling ? CodeRange{greatest - stored.highest, greatest - stored.lowest}
                                 : CodeRange{stored.lowest - least, stored.highest - least};
    }
    describeExact(loaded, counter.take(), {}, hasWindow);
    loaded.volume.voxelsSha256 = checksum.get();
}

void encodeValues(LoadedVolume& loaded,
    const std::function<void(int k, std::span<double> values)>& slice, bool hasWindow)
{
    Volume& volume = loaded.volume;
    const std::size_t size = sliceSize(volume);
    const int slices = volume.geometry.size.z;
    loaded.codes.resize(volume.geometry.voxelCount());

    double least = std::numeric_limits<double>::infinity();
    double greatest = -least;
    bool whole = true;
    std::mutex mutex;
    parallelFor(slices, [&](int k) {
        std::vector<double> values(size);
        slice(k, values);
        double low = std::numeric_limits<double>::infinity();
        double high = -low;
        bool allWhole = true;
        for (const double value : values) {
            if (!std::isfinite(value))
                continue;
            low = std::min(low, value);
            high = std::max(high, value);
            allWhole = allWhole && value == std::trunc(value);
        }
        const std::lock_guard lock(mutex);
        least = std::min(least, low);
        greatest = std::max(greatest, high);
        whole = whole && allWhole;
    });
    if (!(least <= greatest)) {
        least = 0.0;
        greatest = 0.0;
    }
    // Whole numbers within 16 bits are their own exact scale.
    const bool exact = whole && greatest - least < codeCount && std::abs(least) < 1e9;
    const double step =
        exact ? 1.0 : (greatest > least ? (greatest - least) / (codeCount - 1) : 1.0);
    volume.encoding = exact ? VoxelEncoding{.storedAtCodeZero = int(least)}
                            : VoxelEncoding{.rescaleSlope = step, .rescaleIntercept = least};

    bool allNumbers = true;
    double maxError = 0.0;
    parallelFor(slices, [&](int k) {
        std::vector<double> values(size);
        slice(k, values);
        std::uint16_t* code = loaded.codes.data() + std::size_t(k) * size;
        double error = 0.0;
        bool numbers = true;
        for (std::size_t voxel = 0; voxel < size; ++voxel) {
            const double value = values[voxel];
            const bool isNumber = std::isfinite(value);
            numbers = numbers && isNumber;
            const double position = isNumber ? std::round((value - least) / step) : 0.0;
            code[voxel] = std::uint16_t(std::clamp(position, 0.0, double(codeCount - 1)));
            if (isNumber)
                error = std::max(error, std::abs(volume.encoding.value(code[voxel]) - value));
        }
        const std::lock_guard lock(mutex);
        maxError = std::max(maxError, error);
        allNumbers = allNumbers && numbers;
    });
    volume.encoding.maxError = maxError;
    volume.minimum = least;
    volume.maximum = greatest;
    if (!allNumbers) {
        volume.problems.push_back({.kind = VolumeProblem::Kind::InexactValues,
            .text = QStringLiteral("Some voxels hold no number; they are shown as the minimum.")});
    }
    if (maxError > 0.0) {
        volume.problems.push_back({.kind = VolumeProblem::Kind::InexactValues,
            .text = QStringLiteral("Values are held on a common scale, off by at most %1%2.")
                        .arg(maxError, 0, 'g', 3)
                        .arg(volume.unit.isEmpty() ? QString() : QLatin1Char(' ') + volume.unit)});
    }

    Sha256 hash;
    std::vector<double> values(size);
    std::vector<float> floats(size);
    const std::vector<float> valueOfCode = valuesOfCodes(volume.encoding);
    bool followFromCodes = true;
    for (int k = 0; k < slices; ++k) {
        slice(k, values);
        std::transform(values.begin(), values.end(), floats.begin(),
            [](double value) { return float(value); });
        addFloats(hash, floats);
        const std::uint16_t* code = loaded.codes.data() + std::size_t(k) * size;
        // By their bytes, as the checksum has them.
        followFromCodes = followFromCodes
            && std::equal(floats.begin(), floats.end(), code, [&](float value, std::uint16_t of) {
                   return std::memcmp(&value, &valueOfCode[of], sizeof value) == 0;
               });
    }
    volume.voxelsSha256 = hash.takeHex();
    if (!followFromCodes)
        volume.codesSha256 = sha256OfCodes(loaded);
    describe(volume, countCodes(loaded), hasWindow);
}

void describeCodes(LoadedVolume& loaded, int outsideCode, std::uint64_t outside)
{
    loaded.volume.codesSha256.clear();
    std::future<QByteArray> checksum =
        std::async(std::launch::async, [&] { return sha256OfValues(loaded); });
    CodeCounts counts = countCodes(loaded);
    const QByteArray hash = checksum.get();
    loaded.volume.voxelsSha256 = hash;
    describeExact(loaded, std::move(counts), {.code = outsideCode, .voxels = outside}, true);
}

QByteArray sha256OfValues(const LoadedVolume& loaded)
{
    Sha256 hash;
    addValues(hash, loaded);
    return hash.takeHex();
}

QByteArray sha256OfCodes(const LoadedVolume& loaded)
{
    static_assert(std::endian::native == std::endian::little);
    Sha256 hash;
    hash.add(loaded.codes.data(), loaded.codes.size() * sizeof(std::uint16_t));
    return hash.takeHex();
}

void addValues(Sha256& hash, const LoadedVolume& loaded)
{
    addByTable(hash, loaded.codes, valuesOfCodes(loaded.volume.encoding));
}

} // namespace core
