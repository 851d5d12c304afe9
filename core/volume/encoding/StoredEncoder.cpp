// SPDX-License-Identifier: Apache-2.0
#include "core/volume/encoding/StoredEncoder.h"

#include "core/base/ParallelFor.h"
#include "core/volume/encoding/ValueHash.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

namespace core {

namespace {

/// Counts are by stored value, from this one on to the greatest unsigned one.
constexpr int leastStored = -0x8000;
constexpr std::size_t storedCount = 0x8000 + 0x10000;

int storedValue(std::uint16_t bits, bool isSigned)
{
    return isSigned ? int(std::int16_t(bits)) : int(bits);
}

bool haveOneScale(std::span<const SliceRescale> slices)
{
    return std::all_of(slices.begin(), slices.end(), [&](const SliceRescale& slice) {
        return slice.slope == slices[0].slope && slice.intercept == slices[0].intercept;
    });
}

/// The intercept where it is all there is to a scale, and every value is exact as float32.
std::optional<int> wholeShift(const SliceRescale& scale)
{
    constexpr double greatest = 1 << 20;
    const bool isWhole = scale.slope == 1.0 && std::abs(scale.intercept) <= greatest
        && scale.intercept == std::trunc(scale.intercept);
    return isWhole ? std::optional(int(scale.intercept)) : std::nullopt;
}

std::vector<float> valuesOfBits(const SliceRescale& scale, bool isSigned)
{
    std::vector<float> values(VoxelEncoding::codeCount);
    for (int bits = 0; bits < VoxelEncoding::codeCount; ++bits)
        values[std::size_t(bits)] =
            float(scale.slope * storedValue(std::uint16_t(bits), isSigned) + scale.intercept);
    return values;
}

} // namespace

void encodeSlice(Volume& volume, std::span<std::uint16_t> codes, const SliceRescale& rescale)
{
    const int least = rescale.isSigned ? leastStored : 0;
    const int greatest = least + VoxelEncoding::codeCount - 1;
    const bool falling = rescale.slope < 0.0;
    for (std::uint16_t& code : codes) {
        const int stored = storedValue(code, rescale.isSigned);
        code = std::uint16_t(falling ? greatest - stored : stored - least);
    }
    volume.encoding = {.rescaleSlope = rescale.slope,
        .rescaleIntercept = rescale.intercept,
        .storedAtCodeZero = falling ? greatest : least,
        .storedStep = falling ? -1 : 1};
    const auto [lowest, highest] = std::minmax_element(codes.begin(), codes.end());
    volume.minimum = volume.encoding.value(*lowest);
    volume.maximum = volume.encoding.value(*highest);
}

StoredEncoder::StoredEncoder(LoadedVolume& loaded, std::vector<SliceRescale> slices)
    : m_loaded(loaded)
    , m_slices(std::move(slices))
    , m_oneScale(haveOneScale(m_slices))
    , m_chain(int(m_slices.size()), [this](int k) { addToHash(k); })
{
    if (!m_oneScale)
        return;
    m_shift = wholeShift(m_slices[0]);
    if (!m_shift)
        m_valueOfBits = {valuesOfBits(m_slices[0], false), valuesOfBits(m_slices[0], true)};
}

void StoredEncoder::addToHash(int k)
{
    const bool isSigned = m_slices[std::size_t(k)].isSigned;
    if (m_shift)
        addShifted(m_hash, codesOf(k), isSigned, *m_shift);
    else
        addByTable(m_hash, codesOf(k), m_valueOfBits[isSigned ? 1 : 0]);
}

std::span<std::uint16_t> StoredEncoder::codesOf(int k)
{
    const glm::ivec3& size = m_loaded.volume.geometry.size;
    const std::size_t each = std::size_t(size.x) * std::size_t(size.y);
    return std::span(m_loaded.codes).subspan(std::size_t(k) * each, each);
}

void StoredEncoder::sliceIsThere(int k)
{
    if (!m_oneScale)
        return;
    count(k);
    m_chain.sliceIsThere(k);
}

void StoredEncoder::count(int k)
{
    std::unique_ptr<Counts> counts;
    {
        const std::lock_guard lock(m_mutex);
        if (!m_counts.empty()) {
            counts = std::move(m_counts.back());
            m_counts.pop_back();
        }
    }
    if (!counts)
        counts = std::make_unique<Counts>(storedCount, 0);
    const bool isSigned = m_slices[std::size_t(k)].isSigned;
    std::uint64_t* of = counts->data() + (isSigned ? 0 : -leastStored);
    const auto flipped = std::uint16_t(isSigned ? -leastStored : 0);
    for (const std::uint16_t bits : codesOf(k))
        ++of[bits ^ flipped];
    const std::lock_guard lock(m_mutex);
    m_counts.push_back(std::move(counts));
}

void StoredEncoder::finish(bool hasWindow)
{
    if (!m_oneScale)
        return encodeOnCommonScale(hasWindow);
    Counts counts(storedCount, 0);
    for (const std::unique_ptr<Counts>& some : m_counts)
        std::transform(some->begin(), some->end(), counts.begin(), counts.begin(), std::plus<>());
    const auto isCounted = [](std::uint64_t count) { return count > 0; };
    const auto first = std::find_if(counts.begin(), counts.end(), isCounted);
    const auto last = std::find_if(counts.rbegin(), counts.rend(), isCounted);
    const int least = leastStored + int(first - counts.begin());
    const int greatest = leastStored + int(counts.rend() - last) - 1;
    if (greatest - least >= VoxelEncoding::codeCount)
        return encodeOnCommonScale(hasWindow);
    encodeOneScale(least, greatest, counts, hasWindow);
}

void StoredEncoder::encodeOneScale(int least, int greatest, const Counts& counts, bool hasWindow)
{
    const SliceRescale& scale = m_slices[0];
    const bool falling = scale.slope < 0.0;
    // As 16 bits, in which signed and unsigned numbers are subtracted alike.
    const auto zero = std::uint16_t(falling ? greatest : least);
    // What the checksum has not seen yet stays as it is until it has.
    const auto encode = [&](int k) {
        m_chain.waitFor(k);
        if (falling) {
            for (std::uint16_t& code : codesOf(k))
                code = std::uint16_t(zero - code);
        } else {
            for (std::uint16_t& code : codesOf(k))
                code = std::uint16_t(code - zero);
        }
    };
    const bool areCodes = zero == 0 && !falling;
    parallelFor(areCodes ? 1 : int(m_slices.size()) + 1, [&](int part) {
        if (part == 0)
            m_chain.finish();
        else
            encode(part - 1);
    });
    m_loaded.volume.encoding = {.rescaleSlope = scale.slope,
        .rescaleIntercept = scale.intercept,
        .storedAtCodeZero = falling ? greatest : least,
        .storedStep = falling ? -1 : 1};
    m_loaded.volume.voxelsSha256 = m_hash.takeHex();
    CodeCounts ofCodes(VoxelEncoding::codeCount, 0);
    for (int stored = least; stored <= greatest; ++stored)
        ofCodes[std::size_t(falling ? greatest - stored : stored - least)] =
            counts[std::size_t(stored - leastStored)];
    // Slices that do not agree on what is padding have none.
    const bool agreed = std::all_of(m_slices.begin(), m_slices.end(),
        [&](const SliceRescale& slice) { return slice.padding == scale.padding; });
    if (scale.padding && agreed) {
        const StoredRange& stored = *scale.padding;
        m_loaded.padding = falling ? CodeRange{greatest - stored.highest, greatest - stored.lowest}
                                   : CodeRange{stored.lowest - least, stored.highest - least};
    }
    describeExactCounts(m_loaded, std::move(ofCodes), {}, hasWindow);
}

void StoredEncoder::encodeOnCommonScale(bool hasWindow)
{
    const std::vector<std::uint16_t> stored = m_loaded.codes;
    const glm::ivec3& size = m_loaded.volume.geometry.size;
    const std::size_t each = std::size_t(size.x) * std::size_t(size.y);
    encodeValues(
        m_loaded,
        [&](int k, std::span<double> values) {
            const SliceRescale& slice = m_slices[std::size_t(k)];
            const std::uint16_t* from = stored.data() + std::size_t(k) * each;
            for (std::size_t voxel = 0; voxel < each; ++voxel)
                values[voxel] = slice.slope * double(storedValue(from[voxel], slice.isSigned))
                    + slice.intercept;
        },
        hasWindow);
}

} // namespace core
