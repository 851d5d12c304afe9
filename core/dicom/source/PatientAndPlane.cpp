// SPDX-License-Identifier: Apache-2.0
#include "core/dicom/source/PatientAndPlane.h"

#include "core/dicom/base/DicomText.h"
#include "core/dicom/items/SopClass.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>

#include <algorithm>
#include <vector>

namespace core {

namespace {

QString digitsOf(const QString& date)
{
    QString digits;
    std::copy_if(date.begin(), date.end(), std::back_inserter(digits),
        [](QChar character) { return character.isDigit(); });
    return digits;
}

/// How far along the normal a frame lies from the one position of its file (PS3.3 C.8.8.3.2,
/// C.8.4.15). None if that is not said.
std::optional<double> offsetInARow(const ItemReader& dataset, int frame)
{
    if (frame == 0)
        return 0.0;
    if (isDose(dataset.text(DCM_SOPClassUID))) {
        const std::vector<double> offsets = dataset.numbers(DCM_GridFrameOffsetVector);
        if (std::size_t(frame) >= offsets.size())
            return std::nullopt;
        return offsets[std::size_t(frame)] - offsets.front();
    }
    const std::vector<double> distance = dataset.numbers(DCM_SpacingBetweenSlices);
    return distance.size() == 1 ? std::optional(distance.front() * frame) : std::nullopt;
}

/// The item that may hold the plane of such a file: the first detector's, of reconstructed slices.
ItemReader detectorOf(const ItemReader& dataset)
{
    const bool isReconstructed = dataset.text(DCM_ImageType).split(QLatin1Char('\\')).value(2)
        == QLatin1String("RECON TOMO");
    return isReconstructed ? dataset.item(DCM_DetectorInformationSequence) : ItemReader(nullptr);
}

} // namespace

glm::dvec3 HeaderPlane::at(double column, double row) const
{
    return position + rowDirection * (columnSpacing * column)
        + columnDirection * (rowSpacing * row);
}

HeaderPatient readHeaderPatient(DcmDataset& dataset)
{
    const auto bytesOf = [&](const DcmTagKey& tag) {
        OFString value;
        dataset.findAndGetOFStringArray(tag, value);
        return QByteArray(value.data(), qsizetype(value.size()));
    };
    const QByteArray characterSet = bytesOf(DCM_SpecificCharacterSet);
    HeaderPatient patient;
    patient.name = dicomText(bytesOf(DCM_PatientName), characterSet);
    patient.id = dicomText(bytesOf(DCM_PatientID), characterSet);
    patient.birthDate = digitsOf(QString::fromLatin1(bytesOf(DCM_PatientBirthDate)));
    return patient;
}

std::optional<HeaderPlane> readHeaderPlane(const ItemReader& dataset, int frame)
{
    const auto source = [&](const DcmTagKey& macro) {
        const ItemReader group = dataset.functionalGroup(macro, frame);
        return group.valid() ? group : dataset;
    };
    auto position = source(DCM_PlanePositionSequence).triple(DCM_ImagePositionPatient);
    auto orientation = source(DCM_PlaneOrientationSequence).sextuple(DCM_ImageOrientationPatient);
    const bool inARow = haveFramesInARow(dataset.text(DCM_SOPClassUID));
    if (inARow) {
        const ItemReader detector = detectorOf(dataset);
        if (const auto own = detector.triple(DCM_ImagePositionPatient))
            position = own;
        if (const auto own = detector.sextuple(DCM_ImageOrientationPatient))
            orientation = own;
    }
    const auto spacing = source(DCM_PixelMeasuresSequence).pair(DCM_PixelSpacing);
    if (!position || !orientation || !spacing)
        return std::nullopt;
    const auto& o = *orientation;
    HeaderPlane plane;
    plane.position = {(*position)[0], (*position)[1], (*position)[2]};
    plane.rowDirection = {o[0], o[1], o[2]};
    plane.columnDirection = {o[3], o[4], o[5]};
    plane.rowSpacing = (*spacing)[0];
    plane.columnSpacing = (*spacing)[1];
    if (inARow) {
        const std::optional<double> offset = offsetInARow(dataset, frame);
        if (!offset)
            return std::nullopt;
        const glm::dvec3 normal = glm::cross(plane.rowDirection, plane.columnDirection);
        plane.position += *offset * glm::normalize(normal);
    }
    return plane;
}

} // namespace core
