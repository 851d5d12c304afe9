// SPDX-License-Identifier: Apache-2.0
#include "core/dicom/FrameDecoder.h"

#include "core/dicom/Dcmtk.h"
#include "core/dicom/DicomFile.h"
#include "core/dicom/EncodedFrame.h"
#include "core/dicom/Jpeg2000.h"
#include "core/dicom/JpegCheck.h"
#include "core/dicom/Rle.h"
#include "core/dicom/StoredBits.h"
#include "core/dicom/TransferSyntax.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dcfcache.h>
#include <dcmtk/dcmdata/dcpixel.h>
#include <dcmtk/dcmdata/dcpixseq.h>
#include <dcmtk/dcmdata/dcpxitem.h>
#include <dcmtk/dcmdata/dctk.h>

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
            QStringLiteral("%1 of %2 bytes of pixel data").arg(bytes.size()).arg(first + size));
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

/// Decodes JPEG and JPEG-LS by DCMTK's codecs. They get a data set of our own making that holds
/// what they ask for and nothing else, and write into a buffer of the size they announce.
QString decodeByDcmtk(const Cells& frame, const ImageHeader& header, Cells& cells)
{
    readyDcmtk();
    const PixelLayout& layout = header.layout;
    DcmDataset set;
    set.putAndInsertUint16(DCM_SamplesPerPixel, 1);
    set.putAndInsertString(DCM_PhotometricInterpretation, "MONOCHROME2");
    set.putAndInsertUint16(DCM_Rows, Uint16(layout.rows));
    set.putAndInsertUint16(DCM_Columns, Uint16(layout.columns));
    set.putAndInsertUint16(DCM_BitsAllocated, Uint16(layout.bitsAllocated));
    set.putAndInsertUint16(DCM_BitsStored, Uint16(layout.bitsStored));
    set.putAndInsertUint16(DCM_HighBit, Uint16(layout.highBit));
    set.putAndInsertUint16(DCM_PixelRepresentation, Uint16(layout.isSigned ? 1 : 0));

    auto sequence = std::make_unique<DcmPixelSequence>(DCM_PixelSequenceTag);
    auto offsetTable = std::make_unique<DcmPixelItem>(DCM_PixelItemTag);
    auto item = std::make_unique<DcmPixelItem>(DCM_PixelItemTag);
    if (item->putUint8Array(frame.data(), static_cast<unsigned long>(frame.size())).bad())
        return QStringLiteral("no memory for its pixel data");
    sequence->insert(offsetTable.release());
    sequence->insert(item.release());
    auto pixels = std::make_unique<DcmPixelData>(DCM_PixelData);
    pixels->putOriginalRepresentation(
        DcmXfer(header.transferSyntaxUid.toLatin1().constData()).getXfer(), nullptr,
        sequence.release());
    DcmPixelData& decodable = *pixels;
    if (set.insert(pixels.release(), true).bad())
        return QStringLiteral("no memory for its pixel data");

    Uint32 size = 0;
    if (decodable.getUncompressedFrameSize(&set, size).bad() || size < cells.size())
        return QStringLiteral("its frame size is not the one in its header");
    Cells buffer(size + (size & 1u));
    Uint32 firstFragment = 0;
    OFString colourModel;
    DcmFileCache cache;
    const OFCondition decoded = decodable.getUncompressedFrame(
        &set, 0, firstFragment, buffer.data(), Uint32(buffer.size()), colourModel, &cache);
    if (decoded.bad())
        return QStringLiteral("damaged pixel data (%1)").arg(QLatin1String(decoded.text()));
    std::copy_n(buffer.begin(), cells.size(), cells.begin());
    return {};
}

QString decodeEncapsulated(const DicomFile& file, const ImageHeader& header, Cells& cells)
{
    const PixelCoding coding = transferSyntax(header.transferSyntaxUid).coding;
    const std::optional<Cells> found =
        encodedFrame(file.fragments(), header.frame, header.frames, coding);
    if (!found)
        return QStringLiteral("its pieces of pixel data cannot be told apart as frames");
    const Cells& frame = *found;
    if (frame.empty())
        return QStringLiteral("it holds no pixel data");
    switch (coding) {
    case PixelCoding::Rle:
        return decodeRle(frame, header.layout.bitsAllocated / 8, cells)
            ? QString()
            : QStringLiteral("damaged RLE data");
    case PixelCoding::Jpeg:
    case PixelCoding::JpegLs: {
        const QString wrong = checkJpeg(frame, header.layout);
        return wrong.isEmpty() ? decodeByDcmtk(frame, header, cells) : wrong;
    }
    case PixelCoding::Jpeg2000:
        return decodeJpeg2000(frame, header.layout, cells);
    case PixelCoding::Native:
    case PixelCoding::Unknown:
        break;
    }
    return QStringLiteral("transfer syntax %1").arg(header.transferSyntaxUid);
}

Result<void> decodeFrom(
    const DicomFile& file, const ImageHeader& header, std::span<std::uint16_t> stored)
{
    if (const QString reason = undecodableReason(header); !reason.isEmpty())
        return failure(ErrorCode::UnsupportedFormat, header.file, reason);
    if (header.layout.floatBits != 0)
        return failure(ErrorCode::UnsupportedFormat, header.file,
            QStringLiteral("floating-point pixels where stored ones are wanted"));
    const PixelLayout& layout = header.layout;
    const std::size_t size =
        std::size_t(layout.columns) * std::size_t(layout.rows) * (layout.bitsAllocated / 8u);
    if (!file.isEncapsulated())
        return decodeNative(file, header, size, stored);
    Cells cells(size);
    const QString wrong = decodeEncapsulated(file, header, cells);
    if (!wrong.isEmpty())
        return failure(ErrorCode::FileUnreadable, header.file, wrong);
    extractStoredBits(cells, layout, stored);
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

QString unreadableFloats(const PixelLayout& layout, PixelCoding coding, bool bigEndian)
{
    if (coding != PixelCoding::Native || bigEndian)
        return QStringLiteral("floating-point pixels that are compressed or big endian");
    return layout.bitsAllocated == layout.floatBits
        ? QString()
        : QStringLiteral("floating-point pixels of %1 bits").arg(layout.bitsAllocated);
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
    if (layout.floatBits != 0) {
        const TransferSyntax& syntax = transferSyntax(header.transferSyntaxUid);
        return unreadableFloats(layout, syntax.coding, syntax.bigEndian);
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

Result<void> FrameFile::decodeFloats(const ImageHeader& header, std::span<double> values) const
{
    if (const QString reason = undecodableReason(header); !reason.isEmpty())
        return failure(ErrorCode::UnsupportedFormat, header.file, reason);
    const DicomBytes bytes = m_file->pixels();
    const std::size_t size = values.size() * std::size_t(header.layout.floatBits / 8);
    const std::size_t first = size * std::size_t(header.frame);
    if (m_file->floatBits() != header.layout.floatBits || bytes.size() < first + size) {
        return failure(ErrorCode::FileTruncated, header.file,
            QStringLiteral("%1 of %2 bytes of pixel data").arg(bytes.size()).arg(first + size));
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
    if (const QString reason = undecodableReason(header); !reason.isEmpty())
        return failure(ErrorCode::UnsupportedFormat, header.file, reason);
    const Result<FrameFile> file = FrameFile::open(header.file);
    if (!file)
        return tl::unexpected<Error>(file.error());
    return file->decode(header, stored);
}

} // namespace core
