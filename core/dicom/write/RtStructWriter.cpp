// SPDX-License-Identifier: Apache-2.0
#include "core/dicom/write/RtStructWriter.h"

#include "core/dicom/base/Dcmtk.h"
#include "core/dicom/base/DicomText.h"
#include "core/dicom/base/NewUid.h"
#include "core/dicom/deidentify/Deidentifier.h"
#include "core/dicom/items/ConditionChain.h"
#include "core/dicom/items/PatientHeader.h"
#include "core/dicom/source/ItemWriter.h"
#include "core/dicom/source/SegSource.h"
#include "core/dicom/write/MadeObject.h"
#include "core/dicom/write/SaveDicom.h"
#include "core/repair/SeriesRepair.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>

#include <algorithm>
#include <cmath>

namespace core {

namespace {

/// Millimetres are written so finely that a point strays less than this share of a pixel.
constexpr double finestShare = 1e-3;
constexpr int leastDecimals = 4;
constexpr int mostDecimals = 8; // 16 characters, PS3.5 6.2

/// The plane of an image, from the text of its header.
struct Plane {
    glm::dvec3 position{0.0};
    glm::dvec3 perColumn{0.0};
    glm::dvec3 perRow{0.0};
    int decimals = leastDecimals;
};

Plane planeOf(const SegSlice& slice)
{
    const auto number = [](const std::string& text) { return dicomNumber(text).value_or(0.0); };
    const auto& o = slice.orientation;
    const double betweenRows = number(slice.spacing[0]);
    const double betweenColumns = number(slice.spacing[1]);
    Plane plane;
    plane.position = {
        number(slice.position[0]), number(slice.position[1]), number(slice.position[2])};
    plane.perColumn = glm::dvec3(number(o[0]), number(o[1]), number(o[2])) * betweenColumns;
    plane.perRow = glm::dvec3(number(o[3]), number(o[4]), number(o[5])) * betweenRows;
    const double finest = finestShare * std::min(betweenRows, betweenColumns);
    while (plane.decimals < mostDecimals && std::pow(10.0, -plane.decimals) > finest)
        ++plane.decimals;
    return plane;
}

void appendNumber(QByteArray& text, double value, int decimals)
{
    QByteArray digits = QByteArray::number(value, 'f', decimals);
    while (digits.endsWith('0'))
        digits.chop(1);
    if (digits.endsWith('.'))
        digits.chop(1);
    if (!text.isEmpty())
        text += '\\';
    text += digits == "-0" ? QByteArray("0") : digits;
}

QByteArray contourData(const std::vector<glm::ivec2>& corners, const Plane& plane)
{
    QByteArray text;
    for (const glm::ivec2& corner : corners) {
        const glm::dvec3 point =
            plane.position + plane.perColumn * (corner.x - 0.5) + plane.perRow * (corner.y - 0.5);
        for (int axis = 0; axis < 3; ++axis)
            appendNumber(text, point[axis], plane.decimals);
    }
    return text;
}

QString roiName(const Segment& segment)
{
    const QString name = singleValueText(segment.name, 64);
    return name.isEmpty() ? QStringLiteral("Segment") : name;
}

void describe(DcmDataset& set, const RtStructContent& content, const ItemWriter& items)
{
    const MadeAt made = describeMadeObject(&set,
        madeOf(content.identity, UID_RTStructureSetStorage, "RTSTRUCT", 3000,
            QStringLiteral("Contours")),
        items);
    items.put(&set, DCM_StructureSetLabel, QStringLiteral("SEGMENTATION"));
    if (const QString stamp = repairStamp(content.repair); !stamp.isEmpty())
        items.put(&set, DCM_StructureSetDescription, stamp);
    items.put(&set, DCM_StructureSetDate, made.date);
    items.put(&set, DCM_StructureSetTime, made.time);
    items.put(&set, DCM_ApprovalStatus, QStringLiteral("UNAPPROVED"));
}

/// Names every image of the source, also those without a contour.
void addReferences(DcmDataset& set, const SegSource& source, const std::string& frame,
    const std::string& study, const ItemWriter& items)
{
    DcmItem* frameItem = items.append(&set, DCM_ReferencedFrameOfReferenceSequence);
    items.put(frameItem, DCM_FrameOfReferenceUID, frame);
    DcmItem* studyItem = items.append(frameItem, DCM_RTReferencedStudySequence);
    items.put(studyItem, DCM_ReferencedSOPClassUID,
        std::string(UID_RETIRED_DetachedStudyManagementSOPClass));
    items.put(studyItem, DCM_ReferencedSOPInstanceUID, study);
    items.referAll(
        studyItem, DCM_RTReferencedSeriesSequence, DCM_ContourImageSequence, source.slices);
}

void addRois(DcmDataset& set, const RtStructContent& content, const std::string& frame,
    const ItemWriter& items, std::vector<DcmItem*>& contoursOf)
{
    for (std::size_t i = 0; i < content.segments.size(); ++i) {
        const Segment& segment = content.segments[i];
        const std::string number = std::to_string(i + 1);
        DcmItem* roi = items.append(&set, DCM_StructureSetROISequence);
        items.put(roi, DCM_ROINumber, number);
        items.put(roi, DCM_ReferencedFrameOfReferenceUID, frame);
        items.put(roi, DCM_ROIName, roiName(segment));
        items.put(roi, DCM_ROIGenerationAlgorithm, QStringLiteral("SEMIAUTOMATIC"));

        DcmItem* contours = items.append(&set, DCM_ROIContourSequence);
        items.put(contours, DCM_ROIDisplayColor,
            QStringLiteral("%1\\%2\\%3")
                .arg((segment.rgb >> 16) & 255U)
                .arg((segment.rgb >> 8) & 255U)
                .arg(segment.rgb & 255U));
        items.put(contours, DCM_ReferencedROINumber, number);
        contoursOf.push_back(contours);

        DcmItem* observation = items.append(&set, DCM_RTROIObservationsSequence);
        items.put(observation, DCM_ObservationNumber, number);
        items.put(observation, DCM_ReferencedROINumber, number);
        items.put(observation, DCM_RTROIInterpretedType, std::string());
        items.put(observation, DCM_ROIInterpreter, std::string());
        if (fitsCodeSequence(segment.code))
            items.putCode(observation, DCM_RTROIIdentificationCodeSequence, segment.code);
    }
}

Result<void> addContours(const RtStructContent& content, const SegSource& source,
    const std::vector<DcmItem*>& contoursOf, const ItemWriter& items, const Progress& progress)
{
    int segment = -1;
    int number = 0;
    for (std::size_t i = 0; i < content.contours.size(); ++i) {
        if (progress.cancelled())
            return failure(ErrorCode::Cancelled);
        if (i % 256 == 0)
            progress.report(ProgressStep::WritingContours, int(i), int(content.contours.size()));
        const RtStructContent::Contour& contour = content.contours[i];
        number = contour.segment == segment ? number + 1 : 1;
        segment = contour.segment;
        const SegSlice& slice = source.slices[std::size_t(contour.slice)];
        DcmItem* item = items.append(contoursOf[std::size_t(segment)], DCM_ContourSequence);
        items.refer(items.append(item, DCM_ContourImageSequence), slice);
        items.put(item, DCM_ContourNumber, std::to_string(number));
        items.put(item, DCM_ContourGeometricType, QStringLiteral("CLOSED_PLANAR"));
        items.put(item, DCM_NumberOfContourPoints, std::to_string(contour.corners.size()));
        items.put(
            item, DCM_ContourData, contourData(contour.corners, planeOf(slice)).toStdString());
    }
    return {};
}

} // namespace

Result<RtStructWritten> writeRtStruct(
    const QString& path, const RtStructContent& content, const Progress& progress)
{
    readyDcmtk();
    const auto source = readSegSource(content.sources, content.keptHeaders.get(), progress);
    if (!source)
        return tl::unexpected(source.error());
    DcmFileFormat format;
    DcmDataset& set = *format.getDataset();
    ConditionChain chain;
    takePatientAndStudy(set, *source->header, chain);
    OFString study;
    OFString frame;
    set.findAndGetOFString(DCM_StudyInstanceUID, study);
    // Contours must be in some frame of reference: slices that have none in common get a new one.
    if (content.identity.frameOfReferenceUid.isEmpty()
        || set.findAndGetOFString(DCM_FrameOfReferenceUID, frame).bad()) {
        frame = newUid().toStdString();
        chain(set.putAndInsertString(DCM_FrameOfReferenceUID, frame.c_str()), "frame");
    }
    const ItemWriter items(chain);
    for (const DcmTagKey& tag : {DCM_OperatorsName, DCM_PositionReferenceIndicator})
        chain(set.insertEmptyElement(tag), "empty attribute");
    describe(set, content, items);
    if (!source->bodyPart.empty())
        items.put(&set, DCM_BodyPartExamined, source->bodyPart);
    addReferences(set, *source, frame, study, items);
    std::vector<DcmItem*> contoursOf;
    addRois(set, content, frame, items, contoursOf);
    if (chain.good()) {
        if (const auto added = addContours(content, *source, contoursOf, items, progress); !added)
            return tl::unexpected(added.error());
    }
    if (!chain.good())
        return failure(ErrorCode::Internal, chain.failure());
    if (content.deidentifier)
        content.deidentifier->apply(set);
    if (const Result<void> saved = saveDicom(format, path, UID_LittleEndianImplicitTransferSyntax);
        !saved)
        return tl::unexpected(saved.error());
    return RtStructWritten{source->notes};
}

} // namespace core
