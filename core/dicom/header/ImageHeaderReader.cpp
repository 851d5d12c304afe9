// SPDX-License-Identifier: Apache-2.0
#include "core/dicom/header/ImageHeaderReader.h"

#include "core/dicom/base/DicomFile.h"
#include "core/dicom/base/DicomText.h"
#include "core/dicom/base/TransferSyntax.h"
#include "core/dicom/header/ImageMacros.h"
#include "core/dicom/header/ImageQuantity.h"
#include "core/dicom/header/ModalityLut.h"
#include "core/dicom/header/MultiframeHeader.h"
#include "core/dicom/header/PhaseAttributes.h"
#include "core/dicom/items/SopClass.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>

#include <algorithm>
#include <cstdint>
#include <exception>

namespace core {

namespace {

StudyIdentity readIdentity(const HeaderAttributes& from)
{
    return {.patientName = from.text(DCM_PatientName),
        .patientId = from.text(DCM_PatientID),
        .birthDate = dicomDate(from.text(DCM_PatientBirthDate)),
        .sex = from.text(DCM_PatientSex),
        .studyUid = from.text(DCM_StudyInstanceUID),
        .studyDate = dicomDate(from.text(DCM_StudyDate)),
        .studyDescription = from.text(DCM_StudyDescription),
        .accessionNumber = from.text(DCM_AccessionNumber),
        .seriesUid = from.text(DCM_SeriesInstanceUID),
        .seriesNumber = from.text(DCM_SeriesNumber),
        .seriesDescription = from.text(DCM_SeriesDescription),
        .modality = from.text(DCM_Modality),
        .frameOfReferenceUid = from.text(DCM_FrameOfReferenceUID),
        .patientPosition = from.text(DCM_PatientPosition)};
}

/// Which bits of a cell hold overlays, as older files have them (retired, PS3.3 C.9.2).
std::uint32_t readOverlayBits(const HeaderAttributes& from)
{
    std::uint32_t bits = 0;
    for (Uint16 group = 0x6000; group <= 0x601e; group += 2) {
        const int position = from.integer(DcmTagKey(group, DCM_OverlayBitPosition.getElement()));
        if (position > 0 && position < 32)
            bits |= 1u << position;
    }
    return bits;
}

PixelLayout readLayout(const HeaderAttributes& from)
{
    PixelLayout layout;
    layout.columns = from.integer(DCM_Columns);
    layout.rows = from.integer(DCM_Rows);
    layout.samplesPerPixel = from.integer(DCM_SamplesPerPixel, 1);
    layout.bitsAllocated = from.integer(DCM_BitsAllocated);
    layout.bitsStored = from.integer(DCM_BitsStored, layout.bitsAllocated);
    layout.highBit = from.integer(DCM_HighBit, layout.bitsStored - 1);
    if (const int least = layout.bitsStored - 1; layout.highBit < least) {
        layout.falseHighBit = layout.highBit;
        layout.highBit = least;
    }
    layout.isSigned = from.integer(DCM_PixelRepresentation) == 1;
    layout.overlayBits = readOverlayBits(from);
    layout.photometric = from.text(DCM_PhotometricInterpretation);
    return layout;
}

void takeModalityLut(DcmDataset& set, ImageHeader& header)
{
    header.modalityLut = readModalityLut(set, header.layout.isSigned);
    if (!header.modalityLut)
        return;
    // The table takes the place of slope and intercept (PS3.3 C.11.1.1).
    header.slope = 1.0;
    header.intercept = 0.0;
    header.hasRescale = true;
    DcmItem* item = nullptr;
    OFString type;
    if (set.findAndGetSequenceItem(DCM_ModalityLUTSequence, item).good()
        && item->findAndGetOFString(DCM_ModalityLUTType, type).good())
        header.rescaleType = QString::fromLatin1(type.c_str());
}

/// A number of sixteen bits that is signed if pixels are, whatever its VR says.
std::optional<int> storedNumber(DcmDataset& set, const DcmTagKey& key, bool isSigned)
{
    Uint16 bits = 0;
    Sint16 withSign = 0;
    if (set.findAndGetUint16(key, bits).bad()) {
        if (set.findAndGetSint16(key, withSign).bad())
            return std::nullopt;
        bits = Uint16(withSign);
    }
    return isSigned ? int(std::int16_t(bits)) : int(bits);
}

std::optional<StoredRange> readPadding(DcmDataset& set, bool isSigned)
{
    const std::optional<int> value = storedNumber(set, DCM_PixelPaddingValue, isSigned);
    if (!value)
        return std::nullopt;
    const int limit = storedNumber(set, DCM_PixelPaddingRangeLimit, isSigned).value_or(*value);
    return StoredRange{.lowest = std::min(*value, limit), .highest = std::max(*value, limit)};
}

/// Native pixel data show how many of the frames are there.
void countFrames(std::size_t bytes, ImageHeader& header)
{
    const PixelLayout& layout = header.layout;
    const auto frame = std::uint64_t(layout.columns) * std::uint64_t(layout.rows)
        * std::uint64_t(layout.samplesPerPixel) * std::uint64_t(layout.bitsAllocated) / 8;
    if (frame == 0)
        return;
    header.framesPresent = int(std::min<std::uint64_t>(bytes / frame, INT32_MAX));
    header.pixelsCut = header.pixelsCut || *header.framesPresent < 1;
}

Result<std::vector<ImageHeader>> read(const QString& path)
{
    const Result<DicomFile> file = DicomFile::open(path);
    if (!file)
        return tl::unexpected<Error>(file.error());
    DcmDataset set;
    if (const Result<void> parsed = file->readInto(set); !parsed)
        return tl::unexpected<Error>(parsed.error());

    const QByteArray characterSet = HeaderAttributes(set, {}).bytes(DCM_SpecificCharacterSet);
    const HeaderAttributes from(set, characterSet);
    ImageHeader header;
    header.file = path;
    header.identity = readIdentity(from);
    header.sopInstanceUid = from.text(DCM_SOPInstanceUID);
    header.sopClassUid = from.text(DCM_SOPClassUID);
    if (header.sopClassUid.isEmpty()) {
        // DICOMDIR and files that lost the attribute still say it in their file meta information.
        header.sopClassUid = file->mediaSopClassUid();
    }
    header.transferSyntaxUid = file->transferSyntaxUid();
    header.imageType = from.text(DCM_ImageType).split(QLatin1Char('\\'));
    header.quantity = imageQuantity(from.text(DCM_ImageType), from.text(DCM_ComplexImageComponent));
    header.hasPixels = file->hasPixels();
    header.pixelsCut = file->pixelsCut();
    header.isEnhanced = from.has(DCM_SharedFunctionalGroupsSequence)
        || from.has(DCM_PerFrameFunctionalGroupsSequence);
    header.isLossy = from.text(DCM_LossyImageCompression) == QLatin1String("01")
        || transferSyntax(header.transferSyntaxUid).lossy;
    header.frames = int(std::clamp(from.number(DCM_NumberOfFrames).value_or(1.0), 1.0, 1e6));
    header.layout = readLayout(from);
    header.layout.floatBits = file->floatBits();
    if (file->hasPixels() && !file->isEncapsulated())
        countFrames(file->pixelBytes(), header);
    readPosition(from, header);
    readOrientation(from, header);
    readMeasures(from, header);
    readRescale(from, header);
    header.units = from.text(DCM_Units);
    if (isDose(header.sopClassUid))
        readDoseScale(from, header);
    readWindow(from, header);
    header.suvType = from.text(DCM_SUVType);
    header.hasModalityLut = hasModalityLut(set);
    if (header.hasModalityLut)
        takeModalityLut(set, header);
    header.padding = readPadding(set, header.layout.isSigned);
    header.inverted = header.layout.photometric == QLatin1String("MONOCHROME1")
        || from.text(DCM_PresentationLUTShape) == QLatin1String("INVERSE");
    header.instanceNumber =
        int(std::clamp(from.number(DCM_InstanceNumber).value_or(0.0), -2e9, 2e9));
    header.phases = readPhases(from);
    return framesOf(set, characterSet, header);
}

} // namespace

Result<std::vector<ImageHeader>> readImageHeaders(const QString& path)
{
    try {
        return read(path);
    } catch (const std::exception& exception) {
        return failure(ErrorCode::FileUnreadable, path, QString::fromLatin1(exception.what()));
    }
}

Result<ImageHeader> readImageHeader(const QString& path)
{
    Result<std::vector<ImageHeader>> headers = readImageHeaders(path);
    if (!headers)
        return tl::unexpected<Error>(headers.error());
    return std::move(headers->front());
}

} // namespace core
