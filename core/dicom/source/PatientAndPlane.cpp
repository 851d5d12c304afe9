// SPDX-License-Identifier: Apache-2.0
#include "core/dicom/source/PatientAndPlane.h"

#include "core/dicom/base/DicomText.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>

#include <algorithm>

namespace core {

namespace {

QString digitsOf(const QString& date)
{
    QString digits;
    std::copy_if(date.begin(), date.end(), std::back_inserter(digits),
        [](QChar character) { return character.isDigit(); });
    return digits;
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
    const auto position = source(DCM_PlanePositionSequence).triple(DCM_ImagePositionPatient);
    const auto orientation =
        source(DCM_PlaneOrientationSequence).sextuple(DCM_ImageOrientationPatient);
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
    return plane;
}

} // namespace core
