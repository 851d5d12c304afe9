// SPDX-License-Identifier: Apache-2.0
#include "core/dicom/FrameDecoder.h"

#include "core/dicom/DicomFile.h"
#include "core/dicom/StoredBits.h"
#include "core/dicom/TransferSyntax.h"

#include <exception>
#include <vector>

namespace core {

namespace {

using Cells = std::vector<std::uint8_t>;

Result<void> decodeNative(const DicomFile& file, const ImageHeader& header, std::size_t size,
    std::span<std::uint16_t> stored)
{
    const DicomFile::Bytes bytes = file.pixels();
    if (bytes.size() < size) {
        return failure(ErrorCode::FileTruncated, header.file,
            QStringLiteral("%1 of %2 bytes of pixel data").arg(bytes.size()).arg(size));
    }
    // Big endian swaps the bytes of every word, also where a word holds two 8-bit pixels.
    if (!file.isBigEndian() || !file.pixelsAreWords()) {
        extractStoredBits(bytes.first(size), header.layout, stored);
        return {};
    }
    Cells cells(bytes.begin(), bytes.end());
    for (std::size_t byte = 0; byte + 1 < cells.size(); byte += 2)
        std::swap(cells[byte], cells[byte + 1]);
    extractStoredBits(std::span(cells).first(size), header.layout, stored);
    return {};
}

Result<void> decode(const ImageHeader& header, std::span<std::uint16_t> stored)
{
    if (const QString reason = undecodableReason(header); !reason.isEmpty())
        return failure(ErrorCode::UnsupportedFormat, header.file, reason);
    const Result<DicomFile> file = DicomFile::open(header.file);
    if (!file)
        return tl::unexpected<Error>(file.error());
    const PixelLayout& layout = header.layout;
    const std::size_t size =
        std::size_t(layout.columns) * std::size_t(layout.rows) * (layout.bitsAllocated / 8u);
    if (!file->isEncapsulated())
        return decodeNative(*file, header, size, stored);
    return failure(ErrorCode::UnsupportedFormat, header.file, header.transferSyntaxUid);
}

} // namespace

QString undecodableReason(const ImageHeader& header)
{
    const PixelLayout& layout = header.layout;
    constexpr int longestSide = 32768;
    if (transferSyntax(header.transferSyntaxUid).coding == PixelCoding::Unknown)
        return QStringLiteral("transfer syntax %1").arg(header.transferSyntaxUid);
    if (layout.rows < 1 || layout.columns < 1 || layout.rows > longestSide
        || layout.columns > longestSide) {
        return QStringLiteral("an image of %1 × %2 pixels (Rows, Columns)")
            .arg(layout.columns)
            .arg(layout.rows);
    }
    const bool sensible = (layout.bitsAllocated == 8 || layout.bitsAllocated == 16)
        && layout.bitsStored >= 1 && layout.bitsStored <= layout.bitsAllocated
        && layout.highBit >= layout.bitsStored - 1 && layout.highBit < layout.bitsAllocated;
    if (!sensible) {
        return QStringLiteral("pixels of %1 bits (%2 stored, high bit %3)")
            .arg(layout.bitsAllocated)
            .arg(layout.bitsStored)
            .arg(layout.highBit);
    }
    return {};
}

Result<void> decodeFrame(const ImageHeader& header, std::span<std::uint16_t> stored)
{
    try {
        return decode(header, stored);
    } catch (const std::exception& exception) {
        return failure(
            ErrorCode::FileUnreadable, header.file, QString::fromLatin1(exception.what()));
    }
}

} // namespace core
