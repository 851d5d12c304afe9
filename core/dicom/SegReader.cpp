// SPDX-License-Identifier: Apache-2.0
#include "core/dicom/SegReader.h"

#include "core/dicom/Dcmtk.h"
#include "core/dicom/PatientAndPlane.h"

#include <QFile>
#include <QFileInfo>

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>

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
    }
    return segment;
}

Result<std::vector<std::uint8_t>> bitsIn(
    DcmDataset& dataset, const QString& file, std::uint64_t needed)
{
    DcmElement* element = nullptr;
    if (dataset.findAndGetElement(DCM_PixelData, element).bad() || element == nullptr)
        return failure(ErrorCode::FileTruncated, file, QStringLiteral("no pixel data"));
    if (element->getLength() < needed)
        return failure(ErrorCode::FileTruncated, file,
            QStringLiteral("%1 bytes of pixel data where the frames need %2")
                .arg(element->getLength())
                .arg(needed));
    std::vector<std::uint8_t> bits(element->getLength());
    // Bits are numbered in a byte stream; words are brought back to it, low byte first.
    Uint8* bytes = nullptr;
    Uint16* words = nullptr;
    if (element->getUint8Array(bytes).good() && bytes != nullptr) {
        std::copy_n(bytes, bits.size(), bits.begin());
    } else if (element->getUint16Array(words).good() && words != nullptr) {
        for (std::size_t i = 0; i < bits.size(); ++i)
            bits[i] = std::uint8_t(words[i / 2] >> (8 * (i % 2)));
    } else {
        return failure(ErrorCode::FileUnreadable, file, QStringLiteral("the pixel data"));
    }
    return bits;
}

} // namespace

bool SegFile::pixel(std::size_t frame, int column, int row) const
{
    const std::size_t bit =
        (frame * std::size_t(rows) + std::size_t(row)) * std::size_t(columns) + std::size_t(column);
    return ((bits[bit / 8] >> (bit % 8)) & 1U) != 0;
}

Result<SegFile> readSeg(const QString& file)
{
    if (!QFileInfo::exists(file))
        return failure(ErrorCode::FileNotFound, file);
    readyDcmtk();
    DcmFileFormat format;
    const OFCondition loaded = format.loadFile(QFile::encodeName(file).constData());
    if (loaded.bad())
        return failure(ErrorCode::FileUnreadable, file, QString::fromLatin1(loaded.text()));
    DcmDataset& dataset = *format.getDataset();
    const ItemReader reader(&dataset);
    if (reader.text(DCM_SOPClassUID) != QLatin1String(UID_SegmentationStorage))
        return failure(ErrorCode::UnsupportedFormat, file, QStringLiteral("not a DICOM SEG"));
    if (reader.text(DCM_SegmentationType) != QLatin1String("BINARY")
        || reader.integer(DCM_BitsAllocated) != 1)
        return failure(ErrorCode::UnsupportedFormat, file, QStringLiteral("not of type BINARY"));
    if (DcmXfer(dataset.getOriginalXfer()).isEncapsulated())
        return failure(ErrorCode::UnsupportedFormat, file, QStringLiteral("compressed"));

    SegFile seg;
    seg.patient = readHeaderPatient(dataset);
    dataset.convertToUTF8();
    seg.studyUid = reader.text(DCM_StudyInstanceUID);
    seg.seriesUid = reader.text(DCM_SeriesInstanceUID);
    seg.sopInstanceUid = reader.text(DCM_SOPInstanceUID);
    seg.frameOfReferenceUid = reader.text(DCM_FrameOfReferenceUID);
    seg.segmentsOverlap = reader.text(DCM_SegmentsOverlap);
    seg.rows = reader.integer(DCM_Rows).value_or(0);
    seg.columns = reader.integer(DCM_Columns).value_or(0);
    const int frameCount = reader.integer(DCM_NumberOfFrames).value_or(0);
    if (seg.rows < 1 || seg.columns < 1 || frameCount < 1)
        return failure(ErrorCode::FileUnreadable, file, QStringLiteral("rows, columns or frames"));
    if (reader.itemCount(DCM_PerFrameFunctionalGroupsSequence) != frameCount)
        return failure(
            ErrorCode::InvalidGeometry, file, QStringLiteral("not every frame is described"));

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
            return failure(ErrorCode::InvalidGeometry, file,
                QStringLiteral("frame %1 has no position, orientation or spacing").arg(i + 1));
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

    const std::uint64_t bitCount =
        std::uint64_t(frameCount) * std::uint64_t(seg.rows) * std::uint64_t(seg.columns);
    auto bits = bitsIn(dataset, file, (bitCount + 7) / 8);
    if (!bits)
        return tl::unexpected(bits.error());
    seg.bits = std::move(*bits);
    return seg;
}

} // namespace core
