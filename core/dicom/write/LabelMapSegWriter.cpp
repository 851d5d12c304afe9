// SPDX-License-Identifier: Apache-2.0
#include "core/dicom/write/LabelMapSegWriter.h"

#include "core/dicom/base/Dcmtk.h"
#include "core/dicom/base/NewUid.h"
#include "core/dicom/items/PatientHeader.h"
#include "core/dicom/source/ItemWriter.h"
#include "core/dicom/source/SegSource.h"
#include "core/dicom/write/MadeObject.h"
#include "core/dicom/write/SegCompletion.h"
#include "core/dicom/write/SegParts.h"

#include <QFile>

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>

#include <algorithm>

namespace core {

namespace {

// DCMTK 3.6.7 has no name for it yet.
constexpr const char* labelMapStorage = "1.2.840.10008.5.1.4.1.1.66.7";

void describe(
    DcmDataset& set, const SegContent& content, const SegSource& source, const ItemWriter& items)
{
    describeMadeContent(&set,
        {.sopClassUid = labelMapStorage,
            .modality = "SEG",
            .seriesNumber = segSeriesNumber(content.identity),
            .seriesDescription = seriesDescription(content)},
        items);
    items.put(&set, DCM_DeviceSerialNumber, "0");
    items.put(&set, DCM_ImageType, "DERIVED\\PRIMARY");
    items.put(&set, DCM_ContentLabel, "SEGMENTATION");
    items.put(&set, DCM_ContentDescription, contentDescription(content));
    items.put(&set, DCM_ContentCreatorName, "");
    items.put(&set, DCM_SegmentationType, "LABELMAP");
    items.put(&set, DCM_SegmentsOverlap, "NO");
    if (!source.bodyPart.empty())
        items.put(&set, DCM_BodyPartExamined, source.bodyPart);
    items.put(&set, DCM_LossyImageCompression,
        source.lossyCompression.empty() ? std::string("00") : source.lossyCompression);
    if (!source.lossyRatio.empty())
        items.put(&set, DCM_LossyImageCompressionRatio, source.lossyRatio);
    if (!source.lossyMethod.empty())
        items.put(&set, DCM_LossyImageCompressionMethod, source.lossyMethod);
}

void describePixels(
    DcmDataset& set, const SegContent& content, const ItemWriter& items, ConditionChain& chain)
{
    items.putWord(&set, DCM_SamplesPerPixel, 1);
    items.put(&set, DCM_PhotometricInterpretation, "MONOCHROME2");
    items.put(&set, DCM_NumberOfFrames, std::to_string(content.frames.size()));
    items.putWord(&set, DCM_Rows, content.rows);
    items.putWord(&set, DCM_Columns, content.columns);
    items.putWord(&set, DCM_BitsAllocated, 8);
    items.putWord(&set, DCM_BitsStored, 8);
    items.putWord(&set, DCM_HighBit, 7);
    items.putWord(&set, DCM_PixelRepresentation, 0);
    items.putWord(&set, DCM_PixelPaddingValue, 0);
    chain(set.putAndInsertUint8Array(DCM_PixelData, content.pixels.data(),
              static_cast<unsigned long>(content.pixels.size())),
        "pixel data");
}

/// Every number that a pixel can have is described, also that of the background.
Result<void> addSegments(DcmDataset& set, const SegContent& content, const ItemWriter& items)
{
    const CodedConcept background{.scheme = QStringLiteral("DCM"),
        .value = QStringLiteral("125040"),
        .meaning = QStringLiteral("Background")};
    DcmItem* none = items.append(&set, DCM_SegmentSequence);
    items.putCode(none, DCM_SegmentedPropertyCategoryCodeSequence, background);
    items.putWord(none, DCM_SegmentNumber, 0);
    items.put(none, DCM_SegmentLabel, "Background");
    items.put(none, DCM_SegmentAlgorithmType, "AUTOMATIC");
    items.put(none, DCM_SegmentAlgorithmName, "Burin");
    items.putCode(none, DCM_SegmentedPropertyTypeCodeSequence, background);
    for (std::size_t i = 0; i < content.segments.size(); ++i) {
        const Segment& segment = content.segments[i];
        const SegCodes codes = segCodesOf(content, segment);
        if (const Result<void> valid = checkSegCodes(segment, codes); !valid)
            return valid;
        DcmItem* item = items.append(&set, DCM_SegmentSequence);
        items.putCode(item, DCM_SegmentedPropertyCategoryCodeSequence, codes.category);
        items.putWord(item, DCM_SegmentNumber, int(i) + 1);
        items.put(item, DCM_SegmentLabel, segmentLabel(segment));
        items.put(item, DCM_SegmentAlgorithmType, algorithmTypeText(content.settings));
        if (content.settings.algorithm != SegAlgorithm::Manual) {
            const QString name = singleValueText(content.settings.algorithmName, 64);
            items.put(
                item, DCM_SegmentAlgorithmName, name.isEmpty() ? QStringLiteral("Burin") : name);
        }
        items.putCode(item, DCM_SegmentedPropertyTypeCodeSequence, segment.code);
        const std::array<std::uint16_t, 3> lab = cieLabOf(segment.rgb);
        if (item != nullptr)
            item->putAndInsertUint16Array(DCM_RecommendedDisplayCIELabValue, lab.data(), 3);
        items.put(item, DCM_TrackingID, segmentLabel(segment));
        items.put(item, DCM_TrackingUID, newUid());
        putSegDetails(item, codes, items);
    }
    return {};
}

void putOrientation(DcmItem* group, const SegSlice& slice, const ItemWriter& items)
{
    std::string text;
    for (const std::string& each : slice.orientation)
        text += (text.empty() ? "" : "\\") + each;
    items.put(items.append(group, DCM_PlaneOrientationSequence), DCM_ImageOrientationPatient, text);
}

void putMeasures(
    DcmItem* group, const SegSlice& slice, double sliceDistanceMm, const ItemWriter& items)
{
    DcmItem* measures = items.append(group, DCM_PixelMeasuresSequence);
    items.put(measures, DCM_PixelSpacing, slice.spacing[0] + "\\" + slice.spacing[1]);
    if (sliceDistanceMm > 0.0) {
        items.put(measures, DCM_SliceThickness, decimalString(sliceDistanceMm));
        items.put(measures, DCM_SpacingBetweenSlices, decimalString(sliceDistanceMm));
    } else if (!slice.sliceThickness.empty()) {
        items.put(measures, DCM_SliceThickness, slice.sliceThickness);
    }
}

/// @param description how the frame was made
void putDerivation(
    DcmItem* group, const SegSlice& slice, const QString& description, const ItemWriter& items)
{
    DcmItem* derivation = items.append(group, DCM_DerivationImageSequence);
    items.put(derivation, DCM_DerivationDescription, description);
    items.putCode(derivation, DCM_DerivationCodeSequence,
        {.scheme = QStringLiteral("DCM"),
            .value = QStringLiteral("113076"),
            .meaning = QStringLiteral("Segmentation")});
    DcmItem* source = items.append(derivation, DCM_SourceImageSequence);
    items.refer(source, slice);
    items.put(source, DCM_SpatialLocationsPreserved, "YES");
    items.putCode(source, DCM_PurposeOfReferenceCodeSequence,
        {.scheme = QStringLiteral("DCM"),
            .value = QStringLiteral("121322"),
            .meaning = QStringLiteral("Source Image for Image Processing Operation")});
}

void addFrames(
    DcmDataset& set, const SegContent& content, const SegSource& source, const ItemWriter& items)
{
    const SegSlice& first = source.slices.front();
    const bool even = content.sliceDistanceMm > 0.0;
    const auto all = [&](const auto& equals) {
        return std::all_of(source.slices.begin(), source.slices.end(), equals);
    };
    const bool sharedOrientation =
        all([&](const SegSlice& slice) { return slice.orientation == first.orientation; });
    const bool sharedMeasures = all([&](const SegSlice& slice) {
        return slice.spacing == first.spacing
            && (even || slice.sliceThickness == first.sliceThickness);
    });
    DcmItem* shared = items.append(&set, DCM_SharedFunctionalGroupsSequence);
    if (sharedOrientation)
        putOrientation(shared, first, items);
    if (sharedMeasures)
        putMeasures(shared, first, content.sliceDistanceMm, items);

    const QString organization = newUid();
    items.put(items.append(&set, DCM_DimensionOrganizationSequence), DCM_DimensionOrganizationUID,
        organization);
    DcmItem* dimension = items.append(&set, DCM_DimensionIndexSequence);
    items.put(dimension, DCM_DimensionOrganizationUID, organization);
    items.put(dimension, DCM_DimensionDescriptionLabel, "ImagePositionPatient");
    if (dimension != nullptr) {
        dimension->putAndInsertTagKey(DCM_DimensionIndexPointer, DCM_ImagePositionPatient);
        dimension->putAndInsertTagKey(DCM_FunctionalGroupPointer, DCM_PlanePositionSequence);
    }
    const QString description = derivationDescription(content);
    for (const SegContent::Frame& frame : content.frames) {
        const SegSlice& slice = source.slices[std::size_t(frame.slice)];
        DcmItem* group = items.append(&set, DCM_PerFrameFunctionalGroupsSequence);
        DcmItem* indices = items.append(group, DCM_FrameContentSequence);
        if (indices != nullptr)
            indices->putAndInsertUint32(DCM_DimensionIndexValues, Uint32(frame.slice + 1));
        items.put(items.append(group, DCM_PlanePositionSequence), DCM_ImagePositionPatient,
            slice.position[0] + "\\" + slice.position[1] + "\\" + slice.position[2]);
        putDerivation(group, slice, description, items);
        if (!sharedOrientation)
            putOrientation(group, slice, items);
        if (!sharedMeasures)
            putMeasures(group, slice, content.sliceDistanceMm, items);
    }
}

} // namespace

Result<SegWritten> writeLabelMapSeg(
    const QString& path, const SegContent& content, const Progress& progress)
{
    readyDcmtk();
    if (content.segments.size() > 255)
        return failure(ErrorCode::UnsupportedFormat, path,
            Clause::saying("a label map of bytes holds at most 255 segments"));
    const auto source = readSegSource(content.sources, content.keptHeaders.get(), progress);
    if (!source)
        return tl::unexpected(source.error());
    DcmFileFormat format;
    DcmDataset& set = *format.getDataset();
    ConditionChain chain;
    const ItemWriter items(chain);
    takePatientAndStudy(set, *source->header, chain);
    if (content.identity.frameOfReferenceUid.isEmpty())
        set.findAndDeleteElement(DCM_FrameOfReferenceUID);
    else
        chain(set.insertEmptyElement(DCM_PositionReferenceIndicator), "frame of reference");
    describe(set, content, *source, items);
    describePixels(set, content, items, chain);
    if (const Result<void> added = addSegments(set, content, items); !added)
        return tl::unexpected(added.error());
    addFrames(set, content, *source, items);
    items.referAll(
        &set, DCM_ReferencedSeriesSequence, DCM_ReferencedInstanceSequence, source->slices);
    if (!chain.good())
        return failure(ErrorCode::Internal, chain.failure());
    if (progress.cancelled())
        return failure(ErrorCode::Cancelled);
    return saveSeg(path, content, format, source->notes);
}

} // namespace core
