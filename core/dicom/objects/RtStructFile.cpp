// SPDX-License-Identifier: Apache-2.0
#include "core/dicom/objects/RtStructFile.h"

#include "core/dicom/base/DicomFile.h"
#include "core/dicom/base/TextsToUtf8.h"
#include "core/dicom/source/PatientAndPlane.h"

#include <QHash>

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>

#include <charconv>
#include <cmath>
#include <functional>

namespace core {

namespace {

/// In order, without counting from the front for each as DCMTK's access by number does.
void forEachItem(
    DcmItem& parent, const DcmTagKey& sequence, const std::function<void(DcmItem&)>& take)
{
    DcmSequenceOfItems* items = nullptr;
    if (parent.findAndGetSequence(sequence, items).bad() || items == nullptr)
        return;
    for (DcmObject* object = items->nextInContainer(nullptr); object != nullptr;
         object = items->nextInContainer(object)) {
        if (auto* item = dynamic_cast<DcmItem*>(object))
            take(*item);
    }
}

/// The text of a long value, also where a writer gave it no type since its length fits none.
QByteArray longText(DcmItem& item, const DcmTagKey& tag)
{
    DcmElement* element = nullptr;
    if (item.findAndGetElement(tag, element).bad() || element == nullptr)
        return {};
    if (auto* string = dynamic_cast<DcmByteString*>(element)) {
        char* text = nullptr;
        Uint32 length = 0;
        if (string->getString(text, length).bad() || text == nullptr)
            return {};
        return {text, qsizetype(length)};
    }
    Uint8* bytes = nullptr;
    if (element->getUint8Array(bytes).bad() || bytes == nullptr)
        return {};
    return {reinterpret_cast<const char*>(bytes), qsizetype(element->getLength())};
}

/// None: a number is none, or there are not three a point.
std::optional<std::vector<glm::dvec3>> pointsIn(const QByteArray& text)
{
    const char* at = text.constData();
    const char* end = at + text.size();
    std::vector<double> numbers;
    while (at < end) {
        while (at < end && (*at == ' ' || *at == '+'))
            ++at;
        double value = 0.0;
        const auto parsed = std::from_chars(at, end, value);
        if (parsed.ec != std::errc() || !std::isfinite(value))
            return std::nullopt;
        numbers.push_back(value);
        at = parsed.ptr;
        while (at < end && (*at == ' ' || *at == '\0'))
            ++at;
        if (at < end && *at++ != '\\')
            return std::nullopt;
    }
    if (numbers.empty() || numbers.size() % 3 != 0)
        return std::nullopt;
    std::vector<glm::dvec3> points;
    for (std::size_t i = 0; i < numbers.size(); i += 3)
        points.emplace_back(numbers[i], numbers[i + 1], numbers[i + 2]);
    return points;
}

std::optional<std::uint32_t> colourIn(const ItemReader& item)
{
    const auto parts = item.triple(DCM_ROIDisplayColor);
    std::uint32_t rgb = 0;
    for (int i = 0; parts && i < 3; ++i) {
        const double part = (*parts)[std::size_t(i)];
        if (!(part >= 0.0 && part <= 255.0))
            return std::nullopt;
        rgb = (rgb << 8U) | std::uint32_t(std::lround(part));
    }
    return parts ? std::optional(rgb) : std::nullopt;
}

/// @return whether its numbers are points
bool readContour(DcmItem& item, RtContour& contour)
{
    const ItemReader reader(&item);
    contour.geometricType = reader.text(DCM_ContourGeometricType);
    const ItemReader image = reader.item(DCM_ContourImageSequence);
    contour.referencedSopUid = image.text(DCM_ReferencedSOPInstanceUID);
    contour.referencedFrame = image.integer(DCM_ReferencedFrameNumber).value_or(1) - 1;
    contour.saidPoints = reader.integer(DCM_NumberOfContourPoints);
    auto points = pointsIn(longText(item, DCM_ContourData));
    if (points)
        contour.points = *std::move(points);
    return points.has_value();
}

} // namespace

Result<RtStructFile> readRtStruct(const QString& path)
{
    DcmDataset set;
    if (const Result<void> header = DicomFile::readHeader(path, set); !header)
        return tl::unexpected<Error>(header.error());
    const ItemReader reader(&set);
    if (reader.text(DCM_SOPClassUID) != QLatin1String(UID_RTStructureSetStorage))
        return failure(
            ErrorCode::UnsupportedFormat, path, Clause::saying("not a DICOM RT Structure Set"));

    RtStructFile read;
    read.patient = readHeaderPatient(set);
    textsToUtf8(set);
    read.studyUid = reader.text(DCM_StudyInstanceUID);
    const ItemReader frame = reader.item(DCM_ReferencedFrameOfReferenceSequence);
    read.frameOfReferenceUid = frame.text(DCM_FrameOfReferenceUID);
    forEachItem(set, DCM_ReferencedFrameOfReferenceSequence, [&](DcmItem& frameItem) {
        forEachItem(frameItem, DCM_RTReferencedStudySequence, [&](DcmItem& study) {
            forEachItem(study, DCM_RTReferencedSeriesSequence, [&](DcmItem& series) {
                forEachItem(series, DCM_ContourImageSequence, [&](DcmItem& image) {
                    read.referencedSopUids += ItemReader(&image).text(DCM_ReferencedSOPInstanceUID);
                });
            });
        });
    });
    QHash<int, std::size_t> roiOf;
    forEachItem(set, DCM_StructureSetROISequence, [&](DcmItem& item) {
        const ItemReader roi(&item);
        RtRoi made;
        made.number = roi.integer(DCM_ROINumber).value_or(-1);
        made.name = roi.text(DCM_ROIName);
        made.frameOfReferenceUid = roi.text(DCM_ReferencedFrameOfReferenceUID);
        roiOf.insert(made.number, read.rois.size());
        read.rois.push_back(std::move(made));
    });
    const auto named = [&](const ItemReader& item) -> RtRoi* {
        const auto roi = roiOf.constFind(item.integer(DCM_ReferencedROINumber).value_or(-1));
        return roi == roiOf.constEnd() ? nullptr : &read.rois[*roi];
    };
    Clause wrong;
    forEachItem(set, DCM_ROIContourSequence, [&](DcmItem& item) {
        RtRoi* roi = named(ItemReader(&item));
        if (roi == nullptr) {
            ++read.contoursOfNone;
            return;
        }
        roi->rgb = colourIn(ItemReader(&item));
        forEachItem(item, DCM_ContourSequence, [&](DcmItem& contour) {
            if (!wrong.isEmpty())
                return;
            if (!readContour(contour, roi->contours.emplace_back()))
                wrong =
                    Clause::saying("a contour of '%1' has numbers that are no points", roi->name);
        });
    });
    if (!wrong.isEmpty())
        return failure(ErrorCode::FileUnreadable, path, wrong);
    forEachItem(set, DCM_RTROIObservationsSequence, [&](DcmItem& item) {
        RtRoi* roi = named(ItemReader(&item));
        const ItemReader code = ItemReader(&item).item(DCM_RTROIIdentificationCodeSequence);
        if (roi != nullptr && code.valid())
            roi->code = {.scheme = code.text(DCM_CodingSchemeDesignator),
                .value = code.text(DCM_CodeValue),
                .meaning = code.text(DCM_CodeMeaning)};
    });
    return read;
}

} // namespace core
