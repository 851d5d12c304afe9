// SPDX-License-Identifier: Apache-2.0
#include "core/dicom/RtStructReader.h"

#include "core/dicom/DicomFile.h"
#include "core/dicom/PatientAndPlane.h"

#include <QFileInfo>

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>

#include <cmath>
#include <map>

namespace core {

namespace {

/// The text of a long value, also where a writer gave it no type since its length fits none.
QByteArray longText(DcmItem* item, const DcmTagKey& tag)
{
    DcmElement* element = nullptr;
    if (!item || item->findAndGetElement(tag, element).bad() || !element)
        return {};
    if (element->ident() == EVR_DS) {
        OFString text;
        return element->getOFStringArray(text).good()
            ? QByteArray(text.data(), qsizetype(text.size()))
            : QByteArray();
    }
    Uint8* bytes = nullptr;
    if (element->getUint8Array(bytes).bad() || !bytes)
        return {};
    return {reinterpret_cast<const char*>(bytes), qsizetype(element->getLength())};
}

/// None: a number is none, or there are not three a point.
std::optional<std::vector<glm::dvec3>> pointsIn(const QByteArray& text)
{
    std::vector<glm::dvec3> points;
    const QList<QByteArray> words = text.split('\\');
    if (words.size() % 3 != 0)
        return std::nullopt;
    for (qsizetype word = 0; word < words.size(); word += 3) {
        glm::dvec3 point(0.0);
        for (int axis = 0; axis < 3; ++axis) {
            QByteArray number = words[word + axis];
            number.replace('\0', ' '); // what fills an odd length up
            bool isNumber = false;
            point[axis] = number.trimmed().toDouble(&isNumber);
            if (!isNumber || !std::isfinite(point[axis]))
                return std::nullopt;
        }
        points.push_back(point);
    }
    while (points.size() > 1 && points.front() == points.back())
        points.pop_back();
    return points;
}

bool isClosed(const QString& type)
{
    return type == QLatin1String("CLOSED_PLANAR") || type == QLatin1String("CLOSEDPLANAR_XOR");
}

/// The item of a sequence and the next ones, without starting anew for each.
template <class Visit> void eachItem(DcmItem* item, const DcmTagKey& tag, const Visit& visit)
{
    DcmSequenceOfItems* sequence = nullptr;
    if (!item || item->findAndGetSequence(tag, sequence).bad() || !sequence)
        return;
    for (DcmObject* one = sequence->nextInContainer(nullptr); one;
         one = sequence->nextInContainer(one)) {
        if (auto* found = dynamic_cast<DcmItem*>(one))
            visit(*found);
    }
}

std::optional<std::uint32_t> colourIn(const ItemReader& item)
{
    const auto shares = item.triple(DCM_ROIDisplayColor);
    if (!shares)
        return std::nullopt;
    std::uint32_t rgb = 0;
    for (const double share : *shares) {
        if (!(share >= 0.0 && share <= 255.0))
            return std::nullopt;
        rgb = (rgb << 8U) | std::uint32_t(std::lround(share));
    }
    return rgb;
}

Result<void> addContours(RtRoi& roi, DcmItem& item, const QString& path)
{
    roi.rgb = colourIn(ItemReader(&item));
    Result<void> result;
    eachItem(&item, DCM_ContourSequence, [&](DcmItem& contour) {
        if (!result)
            return;
        if (!isClosed(ItemReader(&contour).text(DCM_ContourGeometricType))) {
            ++roi.others;
            return;
        }
        auto points = pointsIn(longText(&contour, DCM_ContourData));
        if (!points)
            result = failure(ErrorCode::FileUnreadable, path,
                QStringLiteral("a contour of '%1' has numbers that are no points").arg(roi.name));
        else if (points->size() < 3)
            ++roi.others;
        else
            roi.contours.push_back({*std::move(points)});
    });
    return result;
}

} // namespace

Result<QString> sopClassOf(const QString& path)
{
    const Result<DicomFile> file = DicomFile::open(path);
    if (!file)
        return tl::unexpected<Error>(file.error());
    if (!file->mediaSopClassUid().isEmpty())
        return file->mediaSopClassUid();
    DcmDataset dataset;
    if (const Result<void> parsed = file->readInto(dataset); !parsed)
        return tl::unexpected<Error>(parsed.error());
    return ItemReader(&dataset).text(DCM_SOPClassUID);
}

Result<RtStructFile> readRtStruct(const QString& path)
{
    if (!QFileInfo::exists(path))
        return failure(ErrorCode::FileNotFound, path);
    const Result<DicomFile> file = DicomFile::open(path);
    if (!file)
        return tl::unexpected<Error>(file.error());
    DcmDataset dataset;
    if (const Result<void> parsed = file->readInto(dataset); !parsed)
        return tl::unexpected<Error>(parsed.error());
    const ItemReader reader(&dataset);
    if (reader.text(DCM_SOPClassUID) != QLatin1String(UID_RTStructureSetStorage))
        return failure(
            ErrorCode::UnsupportedFormat, path, QStringLiteral("not a DICOM RT Structure Set"));
    RtStructFile set;
    set.patient = readHeaderPatient(dataset);
    dataset.convertToUTF8();
    std::map<int, std::size_t> places;
    eachItem(&dataset, DCM_StructureSetROISequence, [&](DcmItem& item) {
        const ItemReader one(&item);
        RtRoi roi;
        roi.number = one.integer(DCM_ROINumber).value_or(0);
        roi.name = one.text(DCM_ROIName);
        if (set.frameOfReferenceUid.isEmpty())
            set.frameOfReferenceUid = one.text(DCM_ReferencedFrameOfReferenceUID);
        places.emplace(roi.number, set.rois.size());
        set.rois.push_back(std::move(roi));
    });
    Result<void> read;
    eachItem(&dataset, DCM_ROIContourSequence, [&](DcmItem& item) {
        const auto place =
            places.find(ItemReader(&item).integer(DCM_ReferencedROINumber).value_or(0));
        if (read && place != places.end())
            read = addContours(set.rois[place->second], item, path);
    });
    if (!read)
        return tl::unexpected<Error>(read.error());
    eachItem(&dataset, DCM_RTROIObservationsSequence, [&](DcmItem& item) {
        const ItemReader one(&item);
        const auto place = places.find(one.integer(DCM_ReferencedROINumber).value_or(0));
        const ItemReader code = one.item(DCM_RTROIIdentificationCodeSequence);
        if (place != places.end() && code.valid())
            set.rois[place->second].code = {.scheme = code.text(DCM_CodingSchemeDesignator),
                .value = code.text(DCM_CodeValue),
                .meaning = code.text(DCM_CodeMeaning)};
    });
    return set;
}

} // namespace core
