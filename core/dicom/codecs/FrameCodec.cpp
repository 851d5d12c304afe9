// SPDX-License-Identifier: Apache-2.0
#include "core/dicom/codecs/FrameCodec.h"

#include "core/dicom/base/Dcmtk.h"
#include "core/dicom/base/DicomElement.h"
#include "core/dicom/base/Rle.h"
#include "core/dicom/codecs/Jpeg2000.h"
#include "core/dicom/codecs/JpegCheck.h"
#include "core/fence/FencedDecoder.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dcfcache.h>
#include <dcmtk/dcmdata/dcpixel.h>
#include <dcmtk/dcmdata/dcpixseq.h>
#include <dcmtk/dcmdata/dcpxitem.h>
#include <dcmtk/dcmdata/dctk.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <memory>
#include <type_traits>
#include <vector>

namespace core {

namespace {

/// A CodedFrame on its way to a decoder, which is the same program.
struct FrameParameters {
    PixelCoding coding = PixelCoding::Unknown;
    std::int32_t columns = 0;
    std::int32_t rows = 0;
    std::int32_t bitsAllocated = 0;
    std::int32_t bitsStored = 0;
    std::int32_t highBit = 0;
    std::int32_t isSigned = 0;
    std::array<char, 68> uid{}; ///< ends with a zero; DICOM's have 64 letters at most
};
static_assert(std::is_trivially_copyable_v<FrameParameters>);

FrameParameters parametersOf(const CodedFrame& frame)
{
    FrameParameters parameters{.coding = frame.coding,
        .columns = frame.layout.columns,
        .rows = frame.layout.rows,
        .bitsAllocated = frame.layout.bitsAllocated,
        .bitsStored = frame.layout.bitsStored,
        .highBit = frame.layout.highBit,
        .isSigned = frame.layout.isSigned ? 1 : 0};
    const QByteArray uid = frame.transferSyntaxUid.toLatin1();
    std::copy_n(
        uid.begin(), std::min<std::size_t>(std::size_t(uid.size()), 67), parameters.uid.begin());
    return parameters;
}

CodedFrame frameOf(const FrameParameters& parameters)
{
    return {.coding = parameters.coding,
        .transferSyntaxUid = QString::fromLatin1(parameters.uid.data()),
        .layout = {.columns = parameters.columns,
            .rows = parameters.rows,
            .bitsAllocated = parameters.bitsAllocated,
            .bitsStored = parameters.bitsStored,
            .highBit = parameters.highBit,
            .isSigned = parameters.isSigned != 0,
            .photometric = {}}};
}

/// Decodes JPEG and JPEG-LS by DCMTK's codecs. They get a data set of our own making that holds
/// what they ask for and nothing else, and write into a buffer of the size they announce.
QString decodeByDcmtk(DicomBytes bytes, const CodedFrame& frame, std::span<std::uint8_t> cells)
{
    readyDcmtk();
    const PixelLayout& layout = frame.layout;
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
    if (item->putUint8Array(bytes.data(), static_cast<unsigned long>(bytes.size())).bad())
        return QStringLiteral("no memory for its pixel data");
    sequence->insert(offsetTable.release());
    sequence->insert(item.release());
    auto pixels = std::make_unique<DcmPixelData>(DCM_PixelData);
    pixels->putOriginalRepresentation(
        DcmXfer(frame.transferSyntaxUid.toLatin1().constData()).getXfer(), nullptr,
        sequence.release());
    DcmPixelData& decodable = *pixels;
    if (set.insert(pixels.release(), true).bad())
        return QStringLiteral("no memory for its pixel data");

    Uint32 size = 0;
    if (decodable.getUncompressedFrameSize(&set, size).bad() || size < cells.size())
        return QStringLiteral("its frame size is not the one in its header");
    std::vector<std::uint8_t> buffer(size + (size & 1u));
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

/// Decodes a stream of at most 8 bits into cells of 16. DCMTK goes by the stream: it would fill the
/// first half of them with bytes, or refuse them if they are JPEG-LS.
QString decodeAndWiden(DicomBytes bytes, CodedFrame frame, std::span<std::uint8_t> cells)
{
    PixelLayout& layout = frame.layout;
    if (layout.highBit >= layout.bitsStored) {
        return QStringLiteral("its JPEG image has 8 bits or fewer where %1 bits up to bit %2 are "
                              "wanted")
            .arg(layout.bitsStored)
            .arg(layout.highBit);
    }
    layout.bitsAllocated = 8;
    layout.bitsStored = std::min(layout.bitsStored, 8);
    layout.highBit = layout.bitsStored - 1;
    std::vector<std::uint8_t> narrow(cells.size() / 2);
    const QString wrong = decodeByDcmtk(bytes, frame, narrow);
    for (std::size_t pixel = 0; pixel < narrow.size(); ++pixel) {
        const bool isNegative = layout.isSigned && narrow[pixel] >= 0x80;
        cells[2 * pixel] = narrow[pixel];
        cells[2 * pixel + 1] = isNegative ? 0xff : 0;
    }
    return wrong;
}

} // namespace

std::size_t CodedFrame::cellBytes() const
{
    return std::size_t(layout.columns) * std::size_t(layout.rows)
        * std::size_t(layout.bitsAllocated / 8);
}

QString decodeHere(std::span<const std::uint8_t> parameters, std::span<const std::uint8_t> bytes,
    std::span<std::uint8_t> cells)
{
    FrameParameters known;
    if (parameters.size() != sizeof(known))
        return QStringLiteral("a frame of unknown form");
    std::memcpy(&known, parameters.data(), sizeof(known));
    const CodedFrame frame = frameOf(known);
    switch (frame.coding) {
    case PixelCoding::Rle:
        return decodeRle(bytes, frame.layout.bitsAllocated / 8, cells)
            ? QString()
            : QStringLiteral("damaged RLE data");
    case PixelCoding::Jpeg:
    case PixelCoding::JpegLs: {
        const JpegFacts jpeg = checkJpeg(bytes, frame.layout);
        if (!jpeg.wrong.isEmpty())
            return jpeg.wrong;
        return jpeg.precision <= 8 && frame.layout.bitsAllocated == 16
            ? decodeAndWiden(bytes, frame, cells)
            : decodeByDcmtk(bytes, frame, cells);
    }
    case PixelCoding::Jpeg2000:
        return decodeJpeg2000(bytes, frame.layout, cells);
    case PixelCoding::Native:
    case PixelCoding::Unknown:
        break;
    }
    return QStringLiteral("transfer syntax %1").arg(frame.transferSyntaxUid);
}

Clause decodeFenced(const CodedFrame& frame, std::span<const std::uint8_t> bytes,
    const std::function<void(std::span<const std::uint8_t> cells)>& take)
{
    const FrameParameters parameters = parametersOf(frame);
    const std::span<const std::uint8_t> words(
        reinterpret_cast<const std::uint8_t*>(&parameters), sizeof(parameters));
    if (frame.coding != PixelCoding::Rle)
        return FencedDecoder::instance().decode(words, bytes, frame.cellBytes(), take);
    std::vector<std::uint8_t> cells(frame.cellBytes());
    const QString wrong = decodeHere(words, bytes, cells);
    if (wrong.isEmpty())
        take(cells);
    return wrong;
}

void readyCodecs()
{
    readyDcmtk();
}

} // namespace core
