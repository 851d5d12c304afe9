// SPDX-License-Identifier: Apache-2.0
#include "core/voxelfile/VoxelSource.h"

#include "core/volume/MemoryLimit.h"
#include "core/voxelfile/InflateFile.h"
#include "core/voxelfile/TextVoxels.h"

#include <QFile>
#include <QFileInfo>

#include <algorithm>
#include <array>
#include <bit>

namespace core {

namespace {

using Encoding = VoxelSource::Encoding;

constexpr qint64 piece = qint64(1) << 24;
/// More than that before the voxels of a packed file is no header any more.
constexpr qint64 mostPackedSkip = qint64(1) << 26;

tl::unexpected<Error> truncated(const VoxelSource& source, const QString& file)
{
    return file == source.header ? failure(
               ErrorCode::FileTruncated, source.header, Clause::saying("its voxels are incomplete"))
                                 : failure(ErrorCode::FileTruncated, source.header,
                                     Clause::saying("its voxels in %1 are incomplete", file));
}

tl::unexpected<Error> unreadable(
    const VoxelSource& source, const QString& file, const Clause& reason)
{
    return failure(ErrorCode::FileUnreadable, source.header,
        file == source.header ? reason : Clause::saying("its voxels in %1: %2", file, reason));
}

/// The least that a file must hold after its header so that the voxels can be in it.
double leastBytes(const VoxelSource& source, std::size_t share)
{
    switch (source.encoding) {
    case Encoding::Raw:
        return double(share) + double(source.byteSkip);
    case Encoding::Gzip:
    case Encoding::Zlib:
        return (double(share) + double(source.byteSkip)) / InflateFile::greatestRatio;
    case Encoding::Text:
        return 2.0 * double(share / bytesPerScalar(source.type)) - 1.0;
    case Encoding::Hex:
        break;
    }
    return 2.0 * double(share);
}

/// Reads on until so many lines are behind; their length does not matter. False: there are fewer.
bool skipLines(QFile& file, qint64 lines, const Progress& progress)
{
    std::array<char, 65536> buffer{};
    while (lines > 0 && !progress.cancelled()) {
        const qint64 from = file.pos();
        const qint64 got = file.read(buffer.data(), qint64(buffer.size()));
        if (got <= 0)
            return false;
        for (qint64 at = 0; at < got && lines > 0; ++at) {
            if (buffer[std::size_t(at)] == '\n' && --lines == 0)
                return file.seek(from + at + 1);
        }
    }
    return true;
}

/// Fills @p into from an open file at its place. An empty reason: the file ends too soon.
using Filled = tl::expected<bool, Clause>;

Filled fillRaw(
    QFile& file, const VoxelSource& source, std::span<char> into, const Progress& progress)
{
    const auto wanted = qint64(into.size());
    const qint64 from = source.atEnd ? file.size() - wanted : file.pos() + source.byteSkip;
    if (from < file.pos() || !file.seek(from))
        return tl::unexpected(QString());
    qint64 done = 0;
    while (done < wanted && !progress.cancelled()) {
        const qint64 got = file.read(into.data() + done, std::min(piece, wanted - done));
        if (got < 0)
            return tl::unexpected(file.errorString());
        if (got == 0)
            return tl::unexpected(QString());
        done += got;
    }
    return file.pos() < file.size();
}

Filled fillInflated(
    QFile& file, const VoxelSource& source, std::span<char> into, const Progress& progress)
{
    InflateFile unpacked(file, source.encoding == Encoding::Gzip);
    std::array<char, 4096> before{};
    for (qint64 left = source.byteSkip; left > 0;) {
        const auto part = std::size_t(std::min(left, qint64(before.size())));
        if (unpacked.read({before.data(), part}) < part)
            return tl::unexpected(unpacked.reason());
        left -= qint64(part);
    }
    for (std::size_t done = 0; done < into.size() && !progress.cancelled();) {
        const std::size_t part = std::min(std::size_t(piece), into.size() - done);
        if (unpacked.read(into.subspan(done, part)) < part)
            return tl::unexpected(unpacked.reason());
        done += part;
    }
    // To the end of the stream: only there is its checksum.
    const bool surplus = unpacked.read({before.data(), 1}) != 0;
    if (!surplus && !unpacked.reason().isEmpty())
        return tl::unexpected(unpacked.reason());
    return surplus;
}

Filled fill(QFile& file, const VoxelSource& source, std::span<char> into, const Progress& progress)
{
    switch (source.encoding) {
    case Encoding::Raw:
        return fillRaw(file, source, into, progress);
    case Encoding::Gzip:
    case Encoding::Zlib:
        return fillInflated(file, source, into, progress);
    case Encoding::Text:
        return readTextVoxels(file, source.type, into, progress);
    case Encoding::Hex:
        break;
    }
    return readHexBytes(file, into, progress);
}

} // namespace

Result<void> checkVoxelFiles(const VoxelSource& source)
{
    const std::size_t share = source.byteCount() / std::size_t(source.files.size());
    const bool packed = source.encoding == Encoding::Gzip || source.encoding == Encoding::Zlib;
    for (const QString& name : source.files) {
        const QFileInfo info(name);
        if (!info.exists())
            return unreadable(source, name, Clause::saying("no such file"));
        if (!info.isFile())
            return unreadable(source, name, Clause::saying("not a file"));
        if (packed && source.byteSkip > mostPackedSkip)
            return unreadable(source, name, Clause::saying("it begins behind too many bytes"));
        if (double(info.size() - source.start) < leastBytes(source, share))
            return truncated(source, name);
    }
    return {};
}

Result<VoxelBytes> readVoxels(const VoxelSource& source, const Progress& progress)
{
    if (const Result<void> there = checkVoxelFiles(source); !there)
        return tl::unexpected(there.error());
    // Beside the voxels as they are stored, their codes.
    const std::size_t bytes = source.byteCount();
    if (const Result<void> fits = checkMemory(bytes / 2 + source.voxels); !fits)
        return tl::unexpected(fits.error());
    VoxelBytes result{.data = std::make_unique_for_overwrite<char[]>(bytes), .size = bytes};
    const Result<bool> surplus = readVoxelsInto(source, {result.data.get(), result.size}, progress);
    if (!surplus)
        return tl::unexpected(surplus.error());
    result.surplus = *surplus;
    return result;
}

Result<bool> readVoxelsInto(
    const VoxelSource& source, std::span<char> into, const Progress& progress)
{
    const std::size_t share = into.size() / std::size_t(source.files.size());
    bool surplus = false;
    for (qsizetype part = 0; part < source.files.size(); ++part) {
        const QString& name = source.files[part];
        progress.report(ProgressStep::ReadingVoxels, int(part), int(source.files.size()));
        QFile file(name);
        if (!file.open(QIODevice::ReadOnly))
            return unreadable(source, name, file.errorString());
        if (!file.seek(source.start) || !skipLines(file, source.lineSkip, progress))
            return truncated(source, name);
        const Filled filled =
            fill(file, source, into.subspan(std::size_t(part) * share, share), progress);
        if (progress.cancelled())
            return failure(ErrorCode::Cancelled);
        if (!filled)
            return filled.error().isEmpty() ? truncated(source, name)
                                            : unreadable(source, name, filled.error());
        surplus = surplus || *filled;
    }
    const bool foreign = source.bigEndian != (std::endian::native == std::endian::big);
    if (foreign && source.encoding != Encoding::Text)
        swapScalars(into, source.type);
    return surplus;
}

} // namespace core
