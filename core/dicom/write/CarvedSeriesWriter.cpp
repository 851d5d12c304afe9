// SPDX-License-Identifier: Apache-2.0
#include "core/dicom/write/CarvedSeriesWriter.h"

#include "core/dicom/base/Dcmtk.h"
#include "core/dicom/base/NewUid.h"
#include "core/dicom/codecs/FrameDecoder.h"
#include "core/dicom/deidentify/Deidentifier.h"
#include "core/dicom/header/ImageHeaderReader.h"
#include "core/dicom/items/ConditionChain.h"
#include "core/dicom/source/VisitSourceFiles.h"
#include "core/dicom/write/SaveDicom.h"

#include <QCoreApplication>
#include <QDateTime>

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace core {

namespace {

constexpr int longestText = 64; // LO

/// What all images of the new series share.
struct Shared {
    QByteArray seriesUid;
    QByteArray date;
    QByteArray time;
    QByteArray derivation;
};

/// The stored value that stands for a modality value in an image; none: it has no such value.
std::optional<int> storedFor(double value, const ImageHeader& header)
{
    const double stored = std::round((value - header.intercept) / header.slope);
    const int bits = header.layout.bitsStored;
    const double least = header.layout.isSigned ? -std::ldexp(1.0, bits - 1) : 0.0;
    const double greatest = std::ldexp(1.0, header.layout.isSigned ? bits - 1 : bits) - 1.0;
    if (!(stored >= least && stored <= greatest)
        || header.slope * stored + header.intercept != value)
        return std::nullopt;
    return int(stored);
}

QByteArray bytesOf(DcmItem& item, const DcmTagKey& tag)
{
    const char* text = nullptr;
    return item.findAndGetString(tag, text).good() && text != nullptr ? QByteArray(text)
                                                                      : QByteArray();
}

/// "Head 1.0 CARVED". A text that leaves no room is cut only where every byte is a letter.
QByteArray carvedDescription(const QByteArray& before)
{
    const QByteArray mark("CARVED");
    const qsizetype room = longestText - mark.size() - 1;
    const QByteArray text = before.trimmed();
    const bool ascii = std::all_of(text.begin(), text.end(), [](char c) { return c >= ' '; });
    if (text.isEmpty() || (text.size() > room && !ascii))
        return mark;
    return text.left(room).trimmed() + ' ' + mark;
}

QByteArray derivedType(const QByteArray& before)
{
    QList<QByteArray> values = before.split('\\');
    while (values.size() < 2)
        values.append(QByteArray());
    values[0] = "DERIVED";
    values[1] = "SECONDARY";
    return values.join('\\');
}

/// What describes the source's own pixels, or only its maker can keep true.
void removeStale(DcmDataset& set)
{
    for (const DcmTagKey& tag :
        {DCM_PixelData, DCM_SmallestImagePixelValue, DCM_LargestImagePixelValue,
            DCM_SmallestPixelValueInSeries, DCM_LargestPixelValueInSeries, DCM_IconImageSequence,
            DCM_DigitalSignaturesSequence, DCM_MACParametersSequence, DCM_SourceImageSequence,
            DCM_DerivationCodeSequence, DCM_DataSetTrailingPadding})
        delete set.remove(tag);
    for (unsigned long i = set.card(); i > 0; --i) {
        const DcmTag& tag = set.getElement(i - 1)->getTag();
        const bool overlay = tag.getGroup() >= 0x6000 && tag.getGroup() <= 0x60FF;
        if (tag.isPrivate() || overlay)
            delete set.remove(i - 1);
    }
}

void refer(DcmDataset& set, const QByteArray& sopClass, const QByteArray& sopInstance,
    ConditionChain& chain)
{
    DcmItem* source = nullptr;
    chain(set.findOrCreateSequenceItem(DCM_SourceImageSequence, source, -2), "source image");
    DcmItem* purpose = nullptr;
    if (source) {
        chain(source->putAndInsertString(DCM_ReferencedSOPClassUID, sopClass.constData()),
            "source image");
        chain(source->putAndInsertString(DCM_ReferencedSOPInstanceUID, sopInstance.constData()),
            "source image");
        chain(source->findOrCreateSequenceItem(DCM_PurposeOfReferenceCodeSequence, purpose, -2),
            "source image");
    }
    if (purpose) {
        chain(purpose->putAndInsertString(DCM_CodeValue, "121322"), "purpose");
        chain(purpose->putAndInsertString(DCM_CodingSchemeDesignator, "DCM"), "purpose");
        chain(purpose->putAndInsertString(
                  DCM_CodeMeaning, "Source image for image processing operation"),
            "purpose");
    }
}

void describe(DcmDataset& set, const Shared& shared, ConditionChain& chain)
{
    const QByteArray sopClass = bytesOf(set, DCM_SOPClassUID);
    const QByteArray sopInstance = bytesOf(set, DCM_SOPInstanceUID);
    const auto put = [&](const DcmTagKey& tag, const QByteArray& value) {
        chain(set.putAndInsertString(tag, value.constData()), "attribute");
    };
    put(DCM_SOPInstanceUID, newUid().toLatin1());
    put(DCM_SeriesInstanceUID, shared.seriesUid);
    put(DCM_ImageType, derivedType(bytesOf(set, DCM_ImageType)));
    put(DCM_SeriesDescription, carvedDescription(bytesOf(set, DCM_SeriesDescription)));
    put(DCM_DerivationDescription, shared.derivation);
    bool numbered = false;
    const int number = bytesOf(set, DCM_SeriesNumber).trimmed().toInt(&numbered);
    put(DCM_SeriesNumber,
        QByteArray::number(2000 + (numbered && number > 0 && number < 1'000'000 ? number : 0)));
    for (const DcmTagKey& tag : {DCM_InstanceCreationDate, DCM_SeriesDate, DCM_ContentDate})
        put(tag, shared.date);
    for (const DcmTagKey& tag : {DCM_InstanceCreationTime, DCM_SeriesTime, DCM_ContentTime})
        put(tag, shared.time);
    refer(set, sopClass, sopInstance, chain);
}

void putPixels(DcmDataset& set, const PixelLayout& layout, std::vector<std::uint16_t> stored,
    ConditionChain& chain)
{
    const auto word = [&](const DcmTagKey& tag, int value) {
        chain(set.putAndInsertUint16(tag, Uint16(value)), "pixels");
    };
    word(DCM_BitsAllocated, layout.bitsAllocated);
    word(DCM_BitsStored, layout.bitsStored);
    word(DCM_HighBit, layout.bitsStored - 1);
    word(DCM_PixelRepresentation, layout.isSigned ? 1 : 0);
    if (layout.bitsAllocated == 8) {
        const std::vector<Uint8> bytes(stored.begin(), stored.end());
        chain(set.putAndInsertUint8Array(DCM_PixelData, bytes.data(), bytes.size()), "pixels");
        return;
    }
    // Bits above those stored hold nothing; a signed value is cut off there.
    const auto mask = std::uint16_t((1u << layout.bitsStored) - 1u);
    for (std::uint16_t& value : stored)
        value &= mask;
    chain(set.putAndInsertUint16Array(DCM_PixelData, stored.data(), stored.size()), "pixels");
}

} // namespace

Result<ReportLines> writeCarvedSeries(
    const QString& folder, const CarvedSeries& series, const Progress& progress)
{
    readyDcmtk();
    const QDateTime now = QDateTime::currentDateTime();
    const QByteArray fill = QByteArray::number(series.fill, 'g', 12)
        + (series.unit.isEmpty() ? QByteArray() : ' ' + series.unit.toLatin1());
    const Shared shared{.seriesUid = newUid().toLatin1(),
        .date = now.toString(QStringLiteral("yyyyMMdd")).toLatin1(),
        .time = now.toString(QStringLiteral("HHmmss")).toLatin1(),
        .derivation = "Voxels carved away with Burin "
            + QCoreApplication::applicationVersion().toLatin1() + " hold " + fill};
    const auto area = std::size_t(series.size.x) * std::size_t(series.size.y);
    bool lossy = false;
    const auto write = [&](const QString& file, DcmDataset& header,
                           const std::vector<std::size_t>& slices) -> Result<void> {
        if (slices.size() != 1 || series.sources[slices.front()].frame != 0)
            return failure(ErrorCode::UnsupportedFormat, file,
                Clause::saying("it holds several images in one file; a carved series of single "
                               "images cannot be made of it, but NIfTI can"));
        const std::size_t k = slices.front();
        const Result<ImageHeader> image = readImageHeader(file);
        if (!image)
            return tl::unexpected(image.error());
        if (image->frames > 1 || image->isEnhanced || image->modalityLut)
            return failure(ErrorCode::UnsupportedFormat, file,
                Clause::saying("it is no single image with a slope and an intercept; a carved "
                               "series cannot be made of it, but NIfTI can"));
        if (image->layout.isWide())
            return failure(ErrorCode::UnsupportedFormat, file,
                Clause::saying("its pixels have more than 16 bits; a carved series cannot be made "
                               "of it, but NIfTI can"));
        const std::optional<int> fillStored = storedFor(series.fill, *image);
        if (!fillStored)
            return failure(ErrorCode::UnsupportedFormat, file,
                Clause::saying("its stored values cannot be %1 exactly; choose another fill value, "
                               "or NIfTI",
                    QString::fromLatin1(fill)));
        std::vector<std::uint16_t> stored(area);
        if (const Result<DecodedFrame> decoded = decodeFrame(*image, stored); !decoded)
            return tl::unexpected(decoded.error());
        for (std::size_t i = 0; i < area; ++i) {
            if (series.coverage[k * area + i] >= 128)
                stored[i] = std::uint16_t(*fillStored);
        }
        lossy = lossy || image->isLossy;

        DcmFileFormat format;
        DcmDataset& set = *format.getDataset();
        ConditionChain chain;
        chain(set.copyFrom(header), "source attributes");
        removeStale(set);
        describe(set, shared, chain);
        putPixels(set, image->layout, std::move(stored), chain);
        if (!chain.good())
            return failure(ErrorCode::Internal, chain.failure());
        if (series.deidentifier) {
            if (bytesOf(set, DCM_BurnedInAnnotation).trimmed() == "YES")
                return failure(ErrorCode::UnsupportedFormat, file,
                    Clause::saying(
                        "its pixels show text (Burned In Annotation), which may name the "
                        "patient; such images are not de-identified"));
            series.deidentifier->apply(set);
        }
        const QString target =
            QStringLiteral("%1/IM%2.dcm").arg(folder).arg(k + 1, 4, 10, QLatin1Char('0'));
        return saveDicom(format, target, UID_LittleEndianExplicitTransferSyntax);
    };
    if (const Result<void> all = visitSourceFiles(series.sources, nullptr, progress, write); !all)
        return tl::unexpected(all.error());
    ReportLines notes;
    if (lossy)
        notes += ReportSentence{ReportCode::StillLossy};
    return notes;
}

} // namespace core
