// SPDX-License-Identifier: Apache-2.0
#include "core/dicom/codecs/FrameDecoder.h"

#include "core/dicom/base/DicomFile.h"
#include "core/dicom/base/TransferSyntax.h"
#include "core/dicom/codecs/EncodedFrame.h"
#include "core/dicom/codecs/FrameCodec.h"
#include "core/dicom/codecs/StoredBits.h"

#include <bit>
#include <cstring>
#include <exception>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace core {

namespace {

using Cells = std::vector<std::uint8_t>;

using TakeCells = std::function<void(DicomBytes cells)>;

Result<void> decodeNative(
    const DicomFile& file, const ImageHeader& header, std::size_t size, const TakeCells& take)
{
    const DicomFile::Bytes bytes = file.pixels();
    const std::size_t first = size * std::size_t(header.frame);
    if (bytes.size() < first + size) {
        return failure(ErrorCode::FileTruncated, header.file,
            Clause::saying("%1 of %2 bytes of pixel data", bytes.size(), first + size));
    }
    if (!file.isBigEndian() || !file.pixelsAreWords()) {
        take(bytes.subspan(first, size));
        return {};
    }
    // Big endian swaps the bytes of every word, also where a word holds two 8-bit pixels. Pixels of
    // 32 bits are written with all four bytes reversed, not word by word.
    const std::size_t reversed = header.layout.bitsAllocated == 32 ? 3 : 1;
    Cells cells(size);
    for (std::size_t byte = 0; byte < size; ++byte) {
        const std::size_t other = (first + byte) ^ reversed;
        cells[byte] = other < bytes.size() ? bytes[other] : bytes[first + byte];
    }
    take(cells);
    return {};
}

Clause decodeEncapsulated(const DicomFile& file, const ImageHeader& header, const TakeCells& take)
{
    const PixelCoding coding = transferSyntax(header.transferSyntaxUid).coding;
    const std::optional<Cells> found =
        encodedFrame(file.fragments(), header.frame, header.frames, coding);
    if (!found)
        return Clause::saying("its pieces of pixel data cannot be told apart as frames");
    const Cells& frame = *found;
    if (frame.empty())
        return Clause::saying("it holds no pixel data");
    return decodeFenced(
        {.coding = coding, .transferSyntaxUid = header.transferSyntaxUid, .layout = header.layout},
        frame, take);
}

/// @param pixels that there is room for
Result<void> decodeCells(
    const DicomFile& file, const ImageHeader& header, std::size_t pixels, const TakeCells& take)
{
    const PixelLayout& layout = header.layout;
    if (pixels != std::size_t(layout.columns) * std::size_t(layout.rows))
        return failure(ErrorCode::Internal, header.file, Clause::saying("a frame of another size"));
    if (!file.isEncapsulated())
        return decodeNative(file, header, pixels * (layout.bitsAllocated / 8u), take);
    const Clause wrong = decodeEncapsulated(file, header, take);
    if (!wrong.isEmpty())
        return failure(ErrorCode::FileUnreadable, header.file, wrong);
    return {};
}

Result<DecodedFrame> decodeFrom(
    const DicomFile& file, const ImageHeader& header, std::span<std::uint16_t> stored)
{
    if (const Clause reason = undecodableReason(header); !reason.isEmpty())
        return failure(ErrorCode::UnsupportedFormat, header.file, reason);
    if (header.layout.floatBits != 0)
        return failure(ErrorCode::UnsupportedFormat, header.file,
            Clause::saying("floating-point pixels where stored ones are wanted"));
    if (header.layout.isWide())
        return failure(ErrorCode::UnsupportedFormat, header.file,
            Clause::saying(
                "pixels of %1 bits where at most 16 are wanted", header.layout.bitsAllocated));
    DecodedFrame decoded;
    const auto take = [&](DicomBytes cells) {
        decoded.cutOff = areCutOff(cells, header.layout);
        extractStoredBits(cells, header.layout, stored);
    };
    if (const Result<void> all = decodeCells(file, header, stored.size(), take); !all)
        return tl::unexpected<Error>(all.error());
    return decoded;
}

template <typename Number> void readNumbers(DicomBytes bytes, std::span<double> numbers)
{
    static_assert(std::endian::native == std::endian::little);
    for (std::size_t pixel = 0; pixel < numbers.size(); ++pixel) {
        Number number = 0;
        std::memcpy(&number, bytes.data() + pixel * sizeof(Number), sizeof(Number));
        numbers[pixel] = double(number);
    }
}

Result<void> decodeFloats(
    const DicomFile& file, const ImageHeader& header, std::span<double> numbers)
{
    const DicomBytes bytes = file.pixels();
    const std::size_t size = numbers.size() * std::size_t(header.layout.floatBits / 8);
    const std::size_t first = size * std::size_t(header.frame);
    if (file.floatBits() != header.layout.floatBits || bytes.size() < first + size) {
        return failure(ErrorCode::FileTruncated, header.file,
            Clause::saying("%1 of %2 bytes of pixel data", bytes.size(), first + size));
    }
    if (header.layout.floatBits == 32)
        readNumbers<float>(bytes.subspan(first, size), numbers);
    else
        readNumbers<double>(bytes.subspan(first, size), numbers);
    return {};
}

Result<void> decodeNumbersFrom(
    const DicomFile& file, const ImageHeader& header, std::span<double> numbers)
{
    if (const Clause reason = undecodableReason(header); !reason.isEmpty())
        return failure(ErrorCode::UnsupportedFormat, header.file, reason);
    if (header.layout.floatBits != 0)
        return decodeFloats(file, header, numbers);
    if (!header.layout.isWide())
        return failure(ErrorCode::UnsupportedFormat, header.file,
            Clause::saying("pixels of %1 bits where 32 are wanted", header.layout.bitsAllocated));
    return decodeCells(file, header, numbers.size(),
        [&](DicomBytes cells) { extractStoredNumbers(cells, header.layout, numbers); });
}

Clause unreadableFloats(const PixelLayout& layout, PixelCoding coding, bool bigEndian)
{
    if (coding != PixelCoding::Native || bigEndian)
        return Clause::saying("floating-point pixels that are compressed or big endian");
    return layout.bitsAllocated == layout.floatBits
        ? Clause()
        : Clause::saying("floating-point pixels of %1 bits", layout.bitsAllocated);
}

Clause unreadableWide(const ImageHeader& header)
{
    const PixelCoding coding = transferSyntax(header.transferSyntaxUid).coding;
    if (coding != PixelCoding::Native && coding != PixelCoding::Rle)
        return Clause::saying("compressed pixels of 32 bits");
    return header.hasModalityLut ? Clause::saying("pixels of 32 bits with a modality lookup table")
                                 : Clause();
}

} // namespace

Clause undecodableReason(const ImageHeader& header)
{
    const PixelLayout& layout = header.layout;
    constexpr int longestSide = 32768;
    if (transferSyntax(header.transferSyntaxUid).coding == PixelCoding::Unknown)
        return Clause::saying("transfer syntax %1", header.transferSyntaxUid);
    if (layout.rows < 1 || layout.columns < 1 || layout.rows > longestSide
        || layout.columns > longestSide) {
        return Clause::saying(
            "an image of %1 × %2 pixels (Rows, Columns)", layout.columns, layout.rows);
    }
    if (layout.floatBits != 0) {
        const TransferSyntax& syntax = transferSyntax(header.transferSyntaxUid);
        return unreadableFloats(layout, syntax.coding, syntax.bigEndian);
    }
    const bool sensible =
        (layout.bitsAllocated == 8 || layout.bitsAllocated == 16 || layout.bitsAllocated == 32)
        && layout.bitsStored >= 1 && layout.bitsStored <= layout.bitsAllocated
        && layout.highBit >= layout.bitsStored - 1 && layout.highBit < layout.bitsAllocated;
    if (!sensible) {
        return Clause::saying("pixels of %1 bits (%2 stored, high bit %3)", layout.bitsAllocated,
            layout.bitsStored, layout.highBit);
    }
    return layout.isWide() ? unreadableWide(header) : Clause();
}

FrameFile::FrameFile(std::unique_ptr<const DicomFile> file)
    : m_file(std::move(file))
{
}

FrameFile::FrameFile(FrameFile&&) noexcept = default;
FrameFile& FrameFile::operator=(FrameFile&&) noexcept = default;
FrameFile::~FrameFile() = default;

Result<FrameFile> FrameFile::open(const QString& path)
{
    try {
        Result<DicomFile> file = DicomFile::openWithPixels(path);
        if (!file)
            return tl::unexpected<Error>(file.error());
        return FrameFile(std::make_unique<const DicomFile>(std::move(*file)));
    } catch (const std::exception& exception) {
        return failure(ErrorCode::FileUnreadable, path, QString::fromLatin1(exception.what()));
    }
}

Result<DecodedFrame> FrameFile::decode(
    const ImageHeader& header, std::span<std::uint16_t> stored) const
{
    try {
        return decodeFrom(*m_file, header, stored);
    } catch (const std::exception& exception) {
        return failure(
            ErrorCode::FileUnreadable, header.file, QString::fromLatin1(exception.what()));
    }
}

Result<void> FrameFile::decodeNumbers(const ImageHeader& header, std::span<double> numbers) const
{
    try {
        return decodeNumbersFrom(*m_file, header, numbers);
    } catch (const std::exception& exception) {
        return failure(
            ErrorCode::FileUnreadable, header.file, QString::fromLatin1(exception.what()));
    }
}

Result<DecodedFrame> decodeFrame(const ImageHeader& header, std::span<std::uint16_t> stored)
{
    if (const Clause reason = undecodableReason(header); !reason.isEmpty())
        return failure(ErrorCode::UnsupportedFormat, header.file, reason);
    const Result<FrameFile> file = FrameFile::open(header.file);
    if (!file)
        return tl::unexpected<Error>(file.error());
    return file->decode(header, stored);
}

} // namespace core
