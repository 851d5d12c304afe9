// SPDX-License-Identifier: Apache-2.0
#include "core/dicom/RtStructFile.h"

#include "core/dicom/DicomFile.h"
#include "core/dicom/PatientAndPlane.h"

#include <QFileInfo>
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

/// @return whether the text is triples of numbers
bool readPoints(DcmItem& item, std::vector<glm::dvec3>& points)
{
    DcmElement* element = nullptr;
    char* text = nullptr;
    Uint32 length = 0;
    if (item.findAndGetElement(DCM_ContourData, element).bad())
        return false;
    auto* string = dynamic_cast<DcmByteString*>(element);
    if (string == nullptr || string->getString(text, length).bad() || text == nullptr)
        return false;
    const char* at = text;
    const char* end = text + length;
    std::vector<double> numbers;
    while (at < end) {
        while (at < end && (*at == ' ' || *at == '+'))
            ++at;
        double value = 0.0;
        const auto parsed = std::from_chars(at, end, value);
        if (parsed.ec != std::errc() || !std::isfinite(value))
            return false;
        numbers.push_back(value);
        at = parsed.ptr;
        while (at < end && (*at == ' ' || *at == '\0'))
            ++at;
        if (at < end && *at++ != '\\')
            return false;
    }
    if (numbers.empty() || numbers.size() % 3 != 0)
        return false;
    for (std::size_t i = 0; i < numbers.size(); i += 3)
        points.emplace_back(numbers[i], numbers[i + 1], numbers[i + 2]);
    return true;
}

std::optional<std::uint32_t> colourIn(const ItemReader& item)
{
    const auto parts = item.triple(DCM_ROIDisplayColor);
    std::uint32_t rgb = 0;
    for (int i = 0; parts && i < 3; ++i) {
        const double part = (*parts)[std::size_t(i)];
        if (!(part >= 0.0 && part <= 255.0))
            return std::nullopt;
        rgb = (rgb << 8U) | std::uint32_t(part);
    }
    return parts ? std::optional(rgb) : std::nullopt;
}

/// @return what is wrong; empty if nothing
QString readContour(DcmItem& item, RtContour& contour)
{
    const ItemReader reader(&item);
    contour.geometricType = reader.text(DCM_ContourGeometricType);
    const ItemReader image = reader.item(DCM_ContourImageSequence);
    contour.referencedSopUid = image.text(DCM_ReferencedSOPInstanceUID);
    contour.referencedFrame = image.integer(DCM_ReferencedFrameNumber).value_or(1) - 1;
    if (!readPoints(item, contour.points))
        return QStringLiteral("the points of a contour are not triples of numbers");
    if (reader.integer(DCM_NumberOfContourPoints) != int(contour.points.size()))
        return QStringLiteral("a contour has not as many points as it says");
    return {};
}

} // namespace

Result<RtStructFile> readRtStruct(const QString& path)
{
    if (!QFileInfo::exists(path))
        return failure(ErrorCode::FileNotFound, path);
    const Result<DicomFile> file = DicomFile::open(path);
    if (!file)
        return tl::unexpected<Error>(file.error());
    DcmDataset set;
    if (const Result<void> parsed = file->readInto(set); !parsed)
        return tl::unexpected<Error>(parsed.error());
    const ItemReader reader(&set);
    if (reader.text(DCM_SOPClassUID) != QLatin1String(UID_RTStructureSetStorage))
        return failure(ErrorCode::UnsupportedFormat, path, QStringLiteral("not an RTSTRUCT"));

    RtStructFile read;
    read.patient = readHeaderPatient(set);
    set.convertToUTF8();
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
    QString wrong;
    forEachItem(set, DCM_ROIContourSequence, [&](DcmItem& item) {
        const ItemReader contours(&item);
        const auto roi = roiOf.constFind(contours.integer(DCM_ReferencedROINumber).value_or(-1));
        if (roi == roiOf.constEnd()) {
            wrong = QStringLiteral("contours of a region that is not named");
            return;
        }
        read.rois[*roi].rgb = colourIn(contours);
        forEachItem(item, DCM_ContourSequence, [&](DcmItem& contour) {
            read.rois[*roi].contours.emplace_back();
            if (wrong.isEmpty())
                wrong = readContour(contour, read.rois[*roi].contours.back());
        });
    });
    if (!wrong.isEmpty())
        return failure(ErrorCode::FileUnreadable, path, wrong);
    return read;
}

} // namespace core
