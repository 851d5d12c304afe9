// SPDX-License-Identifier: Apache-2.0
#include "core/dicom/objects/SegPixels.h"

#include "core/base/ParallelFor.h"
#include "core/dicom/base/DicomFile.h"
#include "core/dicom/base/TransferSyntax.h"
#include "core/dicom/codecs/FrameDecoder.h"
#include "core/dicom/objects/SegReader.h"
#include "core/volume/MemoryLimit.h"

#include <algorithm>
#include <optional>

namespace core {

namespace {

using Bits = std::vector<std::uint8_t>;

Result<Bits> nativeBits(const DicomFile& file, const QString& path, std::uint64_t needed)
{
    if (!file.hasPixels())
        return failure(ErrorCode::FileTruncated, path, Clause::saying("no pixel data"));
    const DicomFile::Bytes pixels = file.pixels();
    if (pixels.size() < needed)
        return failure(ErrorCode::FileTruncated, path,
            Clause::saying(
                "%1 bytes of pixel data where the frames need %2", pixels.size(), needed));
    Bits bits(pixels.begin(), pixels.end());
    // Bits are numbered in a byte stream; words are brought back to it, low byte first.
    for (std::size_t i = 0; file.isBigEndian() && file.pixelsAreWords() && i + 1 < bits.size();
         i += 2)
        std::swap(bits[i], bits[i + 1]);
    return bits;
}

/// Whether pixels come back as they were: a number of a segment that is nearly right is wrong.
bool isExact(const QString& transferSyntaxUid)
{
    constexpr const char* mayLose[] = {"1.2.840.10008.1.2.4.91", "1.2.840.10008.1.2.4.203"};
    return !transferSyntax(transferSyntaxUid).lossy
        && std::none_of(std::begin(mayLose), std::end(mayLose),
            [&](const char* uid) { return transferSyntaxUid == QLatin1String(uid); });
}

ImageHeader headerOf(const DicomFile& file, const QString& path, const SegFile& seg)
{
    ImageHeader header;
    header.file = path;
    header.transferSyntaxUid = file.transferSyntaxUid();
    header.frames = int(seg.frames.size());
    header.layout = {.columns = seg.columns,
        .rows = seg.rows,
        .bitsAllocated = seg.bitsPerPixel,
        .bitsStored = seg.bitsPerPixel,
        .highBit = seg.bitsPerPixel - 1,
        .photometric = QStringLiteral("MONOCHROME2")};
    return header;
}

Result<Bits> decodedBits(
    const DicomFile& file, const QString& path, const SegFile& seg, std::uint64_t needed)
{
    if (seg.bitsPerPixel == 1)
        return failure(ErrorCode::UnsupportedFormat, path,
            Clause::saying("its pixels of one bit each are compressed"));
    if (!isExact(file.transferSyntaxUid()))
        return failure(ErrorCode::UnsupportedFormat, path,
            Clause::saying("its pixels are compressed in a way that may change them"));
    const ImageHeader header = headerOf(file, path, seg);
    if (const Clause reason = undecodableReason(header); !reason.isEmpty())
        return failure(ErrorCode::UnsupportedFormat, path, reason);
    if (const Result<void> fits = checkBytes(double(needed), Clause::saying("the mask")); !fits)
        return tl::unexpected(fits.error());
    const Result<FrameFile> frames = FrameFile::open(path);
    if (!frames)
        return tl::unexpected(frames.error());
    const std::size_t pixels = std::size_t(seg.rows) * std::size_t(seg.columns);
    const std::size_t bytes = std::size_t(seg.bitsPerPixel) / 8;
    Bits bits(needed);
    std::vector<std::optional<Error>> errors(seg.frames.size());
    parallelFor(int(seg.frames.size()), [&](int frame) {
        ImageHeader one = header;
        one.frame = frame;
        std::vector<std::uint16_t> stored(pixels);
        if (const Result<DecodedFrame> decoded = frames->decode(one, stored); !decoded)
            errors[std::size_t(frame)] = decoded.error();
        std::uint8_t* to = bits.data() + std::size_t(frame) * pixels * bytes;
        for (const std::uint16_t value : stored) {
            for (std::size_t byte = 0; byte < bytes; ++byte)
                *to++ = std::uint8_t(value >> (8 * byte));
        }
    });
    for (const std::optional<Error>& error : errors) {
        if (error)
            return tl::unexpected(*error);
    }
    return bits;
}

} // namespace

Result<std::vector<std::uint8_t>> segPixels(
    const DicomFile& file, const QString& path, const SegFile& seg)
{
    const std::uint64_t bits = std::uint64_t(seg.frames.size()) * std::uint64_t(seg.rows)
        * std::uint64_t(seg.columns) * std::uint64_t(seg.bitsPerPixel);
    const std::uint64_t needed = (bits + 7) / 8;
    return file.isEncapsulated() ? decodedBits(file, path, seg, needed)
                                 : nativeBits(file, path, needed);
}

} // namespace core
