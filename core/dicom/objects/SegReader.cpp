// SPDX-License-Identifier: Apache-2.0
#include "core/dicom/objects/SegReader.h"

#include "core/dicom/base/DicomFile.h"
#include "core/dicom/base/TextsToUtf8.h"
#include "core/dicom/objects/SegPixels.h"
#include "core/dicom/source/PatientAndPlane.h"

#include <QFileInfo>

#include <algorithm>
#include <cmath>

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>
#include <dcmtk/dcmiod/cielabutil.h>

namespace core {

namespace {

CodedConcept conceptIn(const ItemReader& item)
{
    return {.scheme = item.text(DCM_CodingSchemeDesignator),
        .value = item.text(DCM_CodeValue),
        .meaning = item.text(DCM_CodeMeaning)};
}

SegSegment segmentIn(const ItemReader& item)
{
    SegSegment segment;
    segment.number = item.integer(DCM_SegmentNumber).value_or(0);
    segment.label = item.text(DCM_SegmentLabel);
    segment.category = conceptIn(item.item(DCM_SegmentedPropertyCategoryCodeSequence));
    segment.type = conceptIn(item.item(DCM_SegmentedPropertyTypeCodeSequence));
    segment.algorithmType = item.text(DCM_SegmentAlgorithmType);
    segment.algorithmName = item.text(DCM_SegmentAlgorithmName);
    if (const auto lab = item.triple(DCM_RecommendedDisplayCIELabValue)) {
        segment.cieLab = {
            std::uint16_t((*lab)[0]), std::uint16_t((*lab)[1]), std::uint16_t((*lab)[2])};
        std::array<double, 3> shares{};
        IODCIELabUtil::dicomLab2RGB(
            shares[0], shares[1], shares[2], (*lab)[0], (*lab)[1], (*lab)[2]);
        std::uint32_t rgb = 0;
        for (const double share : shares)
            rgb = (rgb << 8U) | std::uint32_t(std::lround(std::clamp(share, 0.0, 1.0) * 255.0));
        segment.rgb = rgb;
    }
    return segment;
}

/// What the pixels mean, and how many bits each has.
Result<void> setType(SegFile& seg, const ItemReader& reader, const QString& path)
{
    const QString sopClass = reader.text(DCM_SOPClassUID);
    // DCMTK 3.6.7 does not know it yet.
    const bool labelMap = sopClass == QLatin1String("1.2.840.10008.5.1.4.1.1.66.7");
    if (!labelMap && sopClass != QLatin1String(UID_SegmentationStorage))
        return failure(ErrorCode::UnsupportedFormat, path, Clause::saying("not a DICOM SEG"));
    const QString type = reader.text(DCM_SegmentationType);
    seg.bitsPerPixel = reader.integer(DCM_BitsAllocated).value_or(0);
    bool fits = seg.bitsPerPixel == 1;
    if (labelMap || type == QLatin1String("LABELMAP")) {
        seg.type = SegFile::Type::LabelMap;
        fits = seg.bitsPerPixel == 8 || seg.bitsPerPixel == 16;
    } else if (type == QLatin1String("FRACTIONAL")) {
        seg.type = SegFile::Type::Fractional;
        seg.fullPixel = reader.integer(DCM_MaximumFractionalValue).value_or(255);
        fits = seg.bitsPerPixel == 8 && seg.fullPixel >= 1;
    } else if (type != QLatin1String("BINARY")) {
        return failure(
            ErrorCode::UnsupportedFormat, path, Clause::saying("of type '%1'", type.left(20)));
    }
    if (fits)
        return {};
    return failure(ErrorCode::UnsupportedFormat, path,
        Clause::saying("of type %1 with %2 bits a pixel", type, seg.bitsPerPixel));
}

} // namespace

bool SegFile::pixel(std::size_t frame, int column, int row) const
{
    const std::size_t bit =
        (frame * std::size_t(rows) + std::size_t(row)) * std::size_t(columns) + std::size_t(column);
    return ((bits[bit / 8] >> (bit % 8)) & 1U) != 0;
}

int SegFile::value(std::size_t frame, int column, int row) const
{
    if (bitsPerPixel == 1)
        return pixel(frame, column, row) ? 1 : 0;
    const std::size_t place =
        (frame * std::size_t(rows) + std::size_t(row)) * std::size_t(columns) + std::size_t(column);
    return bitsPerPixel == 8 ? bits[place] : bits[2 * place] | (bits[2 * place + 1] << 8);
}

Result<SegFile> readSeg(const QString& path)
{
    if (!QFileInfo::exists(path))
        return failure(ErrorCode::FileNotFound, path);
    const Result<DicomFile> file = DicomFile::openWithPixels(path);
    if (!file)
        return tl::unexpected<Error>(file.error());
    DcmDataset dataset;
    if (const Result<void> parsed = file->readInto(dataset); !parsed)
        return tl::unexpected<Error>(parsed.error());
    const ItemReader reader(&dataset);
    SegFile seg;
    if (const Result<void> typed = setType(seg, reader, path); !typed)
        return tl::unexpected<Error>(typed.error());

    seg.patient = readHeaderPatient(dataset);
    textsToUtf8(dataset);
    seg.studyUid = reader.text(DCM_StudyInstanceUID);
    seg.seriesUid = reader.text(DCM_SeriesInstanceUID);
    seg.sopInstanceUid = reader.text(DCM_SOPInstanceUID);
    seg.frameOfReferenceUid = reader.text(DCM_FrameOfReferenceUID);
    seg.segmentsOverlap = reader.text(DCM_SegmentsOverlap);
    seg.rows = reader.integer(DCM_Rows).value_or(0);
    seg.columns = reader.integer(DCM_Columns).value_or(0);
    const int frameCount = reader.integer(DCM_NumberOfFrames).value_or(0);
    if (seg.rows < 1 || seg.columns < 1 || frameCount < 1)
        return failure(ErrorCode::FileUnreadable, path, Clause::saying("rows, columns or frames"));
    if (reader.itemCount(DCM_PerFrameFunctionalGroupsSequence) != frameCount)
        return failure(
            ErrorCode::InvalidGeometry, path, Clause::saying("not every frame is described"));

    for (int i = 0; i < reader.itemCount(DCM_SegmentSequence); ++i)
        seg.segments.push_back(segmentIn(reader.item(DCM_SegmentSequence, i)));
    for (int i = 0; i < reader.itemCount(DCM_ReferencedSeriesSequence); ++i) {
        const ItemReader series = reader.item(DCM_ReferencedSeriesSequence, i);
        for (int k = 0; k < series.itemCount(DCM_ReferencedInstanceSequence); ++k)
            seg.referencedSopUids.push_back(
                series.item(DCM_ReferencedInstanceSequence, k).text(DCM_ReferencedSOPInstanceUID));
    }
    for (int i = 0; i < frameCount; ++i) {
        const auto plane = readHeaderPlane(reader, i);
        if (!plane)
            return failure(ErrorCode::InvalidGeometry, path,
                Clause::saying("frame %1 has no position, orientation or spacing", i + 1));
        SegFrame frame;
        frame.plane = *plane;
        frame.segment = reader.functionalGroup(DCM_SegmentIdentificationSequence, i)
                            .integer(DCM_ReferencedSegmentNumber)
                            .value_or(0);
        const ItemReader source =
            reader.functionalGroup(DCM_DerivationImageSequence, i).item(DCM_SourceImageSequence);
        frame.referencedSopUid = source.text(DCM_ReferencedSOPInstanceUID);
        frame.referencedFrame = source.integer(DCM_ReferencedFrameNumber).value_or(1) - 1;
        seg.frames.push_back(frame);
    }

    const ItemReader measures = reader.functionalGroup(DCM_PixelMeasuresSequence, 0);
    for (const DcmTagKey& tag : {DCM_SliceThickness, DCM_SpacingBetweenSlices}) {
        bool isNumber = false;
        const double distance = measures.text(tag).toDouble(&isNumber);
        if (!isNumber || !std::isfinite(distance) || distance <= 0.0)
            continue;
        seg.planeDistance = distance;
        if (tag == DCM_SpacingBetweenSlices)
            seg.spacingBetweenSlices = distance;
    }
    auto bits = segPixels(*file, path, seg);
    if (!bits)
        return tl::unexpected(bits.error());
    seg.bits = std::move(*bits);
    return seg;
}

} // namespace core
