// SPDX-License-Identifier: Apache-2.0
#include "core/brick/VoxelRuns.h"

#include "core/brick/ThreadWithoutVoxels.h"

#include <zstd.h>
#include <zstd_errors.h>

#include <algorithm>
#include <new>

namespace core {

namespace {

constexpr int compressionLevel = 6;
constexpr int mostDigits = 10; // of 64 bits

void putNumber(QByteArray& bytes, std::uint64_t number)
{
    for (; number >= 128; number >>= 7)
        bytes.append(char(number | 0x80U));
    bytes.append(char(number));
}

/// None: the bytes end in it, or it has more than 64 bits.
std::optional<std::uint64_t> takeNumber(const QByteArray& bytes, qsizetype& at)
{
    std::uint64_t number = 0;
    for (int digit = 0; digit < mostDigits && at < bytes.size(); ++digit) {
        const auto byte = std::uint64_t(std::uint8_t(bytes[at++]));
        if (digit == mostDigits - 1 && byte > 1)
            return std::nullopt;
        number |= (byte & 0x7fU) << (7 * digit);
        if (byte < 0x80)
            return number;
    }
    return std::nullopt;
}

} // namespace

void VoxelRuns::append(std::uint64_t first, std::uint64_t count)
{
    if (count == 0)
        return;
    if (!m_runs.empty() && end() == first)
        m_runs.back().count += count;
    else
        m_runs.push_back({.first = first, .count = count});
}

void VoxelRuns::append(const VoxelRuns& behind)
{
    for (const VoxelRun& run : behind.m_runs)
        append(run.first, run.count);
}

std::uint64_t VoxelRuns::voxelCount() const
{
    std::uint64_t count = 0;
    for (const VoxelRun& run : m_runs)
        count += run.count;
    return count;
}

std::uint64_t VoxelRuns::end() const
{
    return m_runs.empty() ? 0 : m_runs.back().first + m_runs.back().count;
}

VoxelRuns united(const VoxelRuns& one, const VoxelRuns& other)
{
    std::vector<VoxelRun> all;
    all.reserve(one.runs().size() + other.runs().size());
    std::merge(one.runs().begin(), one.runs().end(), other.runs().begin(), other.runs().end(),
        std::back_inserter(all),
        [](const VoxelRun& a, const VoxelRun& b) { return a.first < b.first; });
    VoxelRuns result;
    for (const VoxelRun& run : all) {
        const std::uint64_t first = std::max(run.first, result.end());
        const std::uint64_t end = run.first + run.count;
        result.append(first, end > first ? end - first : 0);
    }
    return result;
}

std::uint64_t sharedVoxels(const VoxelRuns& one, const VoxelRuns& other)
{
    return one.voxelCount() + other.voxelCount() - united(one, other).voxelCount();
}

QByteArray packedRuns(const VoxelRuns& runs)
{
    QByteArray plain;
    std::uint64_t at = 0;
    for (const VoxelRun& run : runs.runs()) {
        putNumber(plain, run.first - at);
        putNumber(plain, run.count);
        at = run.first + run.count;
        if (plain.size() > mostPackedRunBytes)
            return {};
    }
    QByteArray out(qsizetype(ZSTD_compressBound(std::size_t(plain.size()))), Qt::Uninitialized);
    const std::size_t size = ZSTD_compress(out.data(), std::size_t(out.size()), plain.constData(),
        std::size_t(plain.size()), compressionLevel);
    if (ZSTD_isError(size)) // there is room for all
        throw std::bad_alloc();
    out.resize(qsizetype(size));
    return out;
}

std::optional<VoxelRuns> unpackedRuns(const QByteArray& bytes, std::uint64_t voxels)
{
    noteVoxelsLookedAt();
    const unsigned long long size =
        ZSTD_getFrameContentSize(bytes.constData(), std::size_t(bytes.size()));
    if (size == ZSTD_CONTENTSIZE_UNKNOWN || size == ZSTD_CONTENTSIZE_ERROR
        || size > static_cast<unsigned long long>(mostPackedRunBytes) + 2 * mostDigits)
        return std::nullopt;
    QByteArray plain(qsizetype(size), Qt::Uninitialized);
    const std::size_t done = ZSTD_decompress(
        plain.data(), std::size_t(plain.size()), bytes.constData(), std::size_t(bytes.size()));
    if (ZSTD_getErrorCode(done) == ZSTD_error_memory_allocation)
        throw std::bad_alloc();
    if (ZSTD_isError(done) || done != size)
        return std::nullopt;
    VoxelRuns runs;
    for (qsizetype place = 0; place < plain.size();) {
        const auto before = takeNumber(plain, place);
        const auto count = takeNumber(plain, place);
        const std::uint64_t at = runs.end();
        const bool apart = before && (*before > 0 || runs.empty());
        if (!apart || !count || *count == 0 || *before > voxels - at
            || *count > voxels - at - *before)
            return std::nullopt;
        runs.append(at + *before, *count);
    }
    return runs;
}

} // namespace core
