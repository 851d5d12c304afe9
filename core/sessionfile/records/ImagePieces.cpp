// SPDX-License-Identifier: Apache-2.0
#include "core/sessionfile/records/ImagePieces.h"

#include <QCryptographicHash>

#include <zstd.h>
#include <zstd_errors.h>

#include <new>

namespace core {

namespace {

/// Higher levels gain a hundredth for many times the work (512 × 512 CT).
constexpr int compressionLevel = 1;

} // namespace

QByteArray packed(const QByteArray& bytes)
{
    QByteArray out(qsizetype(ZSTD_compressBound(std::size_t(bytes.size()))), Qt::Uninitialized);
    const std::size_t size = ZSTD_compress(out.data(), std::size_t(out.size()), bytes.constData(),
        std::size_t(bytes.size()), compressionLevel);
    if (ZSTD_isError(size)) // there is room for all
        throw std::bad_alloc();
    out.resize(qsizetype(size));
    return out;
}

std::optional<QByteArray> unpacked(const QByteArray& bytes, qsizetype most)
{
    const unsigned long long size =
        ZSTD_getFrameContentSize(bytes.constData(), std::size_t(bytes.size()));
    if (size == ZSTD_CONTENTSIZE_UNKNOWN || size == ZSTD_CONTENTSIZE_ERROR
        || size > static_cast<unsigned long long>(most))
        return {};
    QByteArray out(qsizetype(size), Qt::Uninitialized);
    const std::size_t done = ZSTD_decompress(
        out.data(), std::size_t(out.size()), bytes.constData(), std::size_t(bytes.size()));
    if (ZSTD_getErrorCode(done) == ZSTD_error_memory_allocation)
        throw std::bad_alloc();
    if (ZSTD_isError(done) || done != size)
        return {};
    return out;
}

QByteArray packedPiece(std::span<const std::uint16_t> codes)
{
    const auto count = qsizetype(codes.size());
    QByteArray planes(2 * count, Qt::Uninitialized);
    char* bytes = planes.data();
    for (qsizetype i = 0; i < count; ++i) {
        bytes[i] = char(codes[std::size_t(i)] & 0xFF);
        bytes[count + i] = char(codes[std::size_t(i)] >> 8);
    }
    return packed(planes);
}

bool unpackPiece(const QByteArray& bytes, std::span<std::uint16_t> codes)
{
    const auto count = qsizetype(codes.size());
    const std::optional<QByteArray> planes = unpacked(bytes, 2 * count);
    if (!planes || planes->size() != 2 * count)
        return false;
    const char* from = planes->constData();
    for (qsizetype i = 0; i < count; ++i)
        codes[std::size_t(i)] =
            std::uint16_t(quint8(from[i]) | (std::uint16_t(quint8(from[count + i])) << 8));
    return true;
}

QString sha256(const QByteArray& bytes)
{
    return QString::fromLatin1(QCryptographicHash::hash(bytes, QCryptographicHash::Sha256).toHex());
}

} // namespace core
