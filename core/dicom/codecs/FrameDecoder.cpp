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
#include <memory>
#include <optional>
#include <vector>

namespace core {

namespace {

using Cells = std::vector<std::uint8_t>;

Result<void> decodeNative(const DicomFile& file, const ImageHeader& header, std::size_t size,
    std::span<std::uint16_t> stored)
{
    const DicomFile::Bytes bytes = file.pixels();
    const std::size_t first = size * std::size_t(header.frame);
    if (bytes.size() < first + size) {
        return failure(ErrorCode::FileTruncated, header.file,
            Clause::saying("%1 of %2 bytes of pixel data", bytes.size(), first + size));
    }
    // Big endian swaps the bytes of every word, also where a word holds two 8-bit pixels.
    if (!file.isBigEndian() || !file.pixelsAreWords()) {
        extractStoredBits(bytes.subspan(first, size), header.layout, stored);
        return {};
    }
    Cells cells(size);
    for (std::size_t byte = 0; byte < size; ++byte) {
        const std::size_t other = (first + byte) ^ 1u;
        cells[byte] = other < bytes.size() ? bytes[other] : bytes[first + byte];
    }
    extractStoredBits(cells, header.layout, stored);
    return {};
}

Clause decodeEncapsulated(
    const DicomFile& file, const ImageHeader& header, std::span<std::uint16_t> stored)
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
        frame, [&](std::span<const std::uint8_t> cells) {
            extractStoredBits(cells, header.layout, stored);
        });
}

Result<void> decodeFrom(
    const DicomFile& file, const ImageHeader& header, std::span<std::uint16_t> stored)
{
    if (const Clause reason = undecodableReason(header); !reason.isEmpty())
        return failure(ErrorCode::UnsupportedFormat, header.file, reason);
    if (header.layout.floatBits != 0)
        return failure(ErrorCode::UnsupportedFormat, header.file,
            Clause::saying("floating-point pixels where stored ones are wanted"));
    const PixelLayout& layout = header.layout;
    const std::size_t pixels = std::size_t(layout.columns) * std::size_t(layout.rows);
    if (stored.size() != pixels)
        return failure(ErrorCode::Internal, header.file, Clause::saying("a frame of another size"));
    if (!file.isEncapsulated())
        return decodeNative(file, header, pixels * (layout.bitsAllocated / 8u), stored);
    const Clause wrong = decodeEncapsulated(file, header, stored);
    if (!wrong.isEmpty())
        return failure(ErrorCode::FileUnreadable, header.file, wrong);
    return {};
}

template <typename Number> void readNumbers(DicomBytes bytes, std::span<double> values)
{
    static_assert(std::endian::native == std::endian::little);
    for (std::size_t pixel = 0; pixel < values.size(); ++pixel) {
        Number number = 0;
        std::memcpy(&number, bytes.data() + pixel * sizeof(Number), sizeof(Number));
        values[pixel] = double(number);
    }
}

Clause unreadableFloats(const PixelLayout& layout, PixelCoding coding, bool bigEndian)
{
    if (coding != PixelCoding::Native || bigEndian)
        return Clause::saying("floating-point pixels that are compressed or big endian");
    return layout.bitsAllocated == layout.floatBits
        ? Clause()
        : Clause::saying("floating-point pixels of %1 bits", layout.bitsAllocated);
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
    const bool sensible = (layout.bitsAllocated == 8 || layout.bitsAllocated == 16)
        && layout.bitsStored >= 1 && layout.bitsStored <= layout.bitsAllocated
        && layout.highBit >= layout.bitsStored - 1 && layout.highBit < layout.bitsAllocated;
    if (!sensible) {
        return Clause::saying("pixels of %1 bits (%2 stored, high bit %3)", layout.bitsAllocated,
            layout.bitsStored, layout.highBit);
    }
    return {};
}

Result<void> FrameFile::decodeFloats(const ImageHeader& header, std::span<double> values) const
{
    if (const Clause reason = undecodableReason(header); !reason.isEmpty())
        return failure(ErrorCode::UnsupportedFormat, header.file, reason);
    const DicomBytes bytes = m_file->pixels();
    const std::size_t size = values.size() * std::size_t(header.layout.floatBits / 8);
    const std::size_t first = size * std::size_t(header.frame);
    if (m_file->floatBits() != header.layout.floatBits || bytes.size() < first + size) {
        return failure(ErrorCode::FileTruncated, header.file,
            Clause::saying("%1 of %2 bytes of pixel data", bytes.size(), first + size));
    }
    if (header.layout.floatBits == 32)
        readNumbers<float>(bytes.subspan(first, size), values);
    else
        readNumbers<double>(bytes.subspan(first, size), values);
    return {};
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

Result<void> FrameFile::decode(const ImageHeader& header, std::span<std::uint16_t> stored) const
{
    try {
        return decodeFrom(*m_file, header, stored);
    } catch (const std::exception& exception) {
        return failure(
            ErrorCode::FileUnreadable, header.file, QString::fromLatin1(exception.what()));
    }
}

Result<void> decodeFrame(const ImageHeader& header, std::span<std::uint16_t> stored)
{
    if (const Clause reason = undecodableReason(header); !reason.isEmpty())
        return failure(ErrorCode::UnsupportedFormat, header.file, reason);
    const Result<FrameFile> file = FrameFile::open(header.file);
    if (!file)
        return tl::unexpected<Error>(file.error());
    return file->decode(header, stored);
}

} // namespace core
