// SPDX-License-Identifier: Apache-2.0
#include "core/chunks/ProbabilityMap.h"

#include <algorithm>
#include <cmath>
#include <new>

#include <zstd.h>
#include <zstd_errors.h>

namespace core {

namespace {

constexpr int compressionLevel = 3;

} // namespace

std::uint8_t ProbabilityMap::byteOf(double probability)
{
    if (std::isnan(probability))
        return 0;
    // One half must belong, and 127.5 is rounded away from zero.
    return std::uint8_t(std::lround(std::clamp(probability, 0.0, 1.0) * certain));
}

QByteArray ProbabilityMap::packed(std::span<const std::uint8_t> probabilities)
{
    QByteArray out(qsizetype(ZSTD_compressBound(probabilities.size())), Qt::Uninitialized);
    const std::size_t size = ZSTD_compress(out.data(), std::size_t(out.size()),
        probabilities.data(), probabilities.size(), compressionLevel);
    if (ZSTD_isError(size)) // there is room for all
        throw std::bad_alloc();
    out.resize(qsizetype(size));
    out.squeeze();
    return out;
}

bool ProbabilityMap::isOf(const QByteArray& bytes, std::uint64_t voxels)
{
    return ZSTD_getFrameContentSize(bytes.constData(), std::size_t(bytes.size())) == voxels;
}

std::optional<std::vector<std::uint8_t>> ProbabilityMap::unpacked(
    const QByteArray& bytes, std::uint64_t voxels)
{
    if (!isOf(bytes, voxels))
        return std::nullopt;
    std::vector<std::uint8_t> plain(std::size_t(voxels), std::uint8_t(0));
    const std::size_t done =
        ZSTD_decompress(plain.data(), plain.size(), bytes.constData(), std::size_t(bytes.size()));
    if (ZSTD_getErrorCode(done) == ZSTD_error_memory_allocation)
        throw std::bad_alloc();
    if (ZSTD_isError(done) || done != plain.size())
        return std::nullopt;
    return plain;
}

} // namespace core
