// SPDX-License-Identifier: Apache-2.0
#include "core/export/common/CheckSources.h"

#include "core/dicom/deidentify/Deidentifier.h"
#include "core/dicom/items/PatientHeader.h"

#include <algorithm>

namespace core {

namespace {

/// Slices of one stack may differ in orientation by the rounding of their text.
constexpr double cornerToleranceVoxels = 0.1;

/// A name for comparison: letters as they are, marks between its parts not.
QString nameParts(const QString& name)
{
    QString plain = name;
    for (QChar& character : plain) {
        if (character.category() == QChar::Other_Control || character == QLatin1Char('^')
            || character == QLatin1Char(',') || character == QLatin1Char('='))
            character = QLatin1Char(' ');
    }
    return plain.simplified();
}

QString digits(QString date)
{
    return date.remove(QLatin1Char('-'));
}

/// The slice's header against the volume as it was shown and drawn on.
Clause differenceFromVolume(const SourceHeader& header, const Volume& volume, int k)
{
    const VolumeGeometry& geometry = volume.geometry;
    const StudyIdentity& identity = volume.identity;
    const HeaderPatient shown{.name = identity.patientName,
        .id = identity.patientId,
        .birthDate = digits(identity.birthDate)};
    if (const Clause what = differenceOfPatients(header.patient, shown); !what.isEmpty())
        return Clause::saying("%1 is not that of the study that was opened", what);
    if (header.studyUid != identity.studyUid)
        return Clause::saying("the study is not the one that was opened");
    // Slices without a frame of reference in common have none in the volume (nor in the export).
    if (!identity.frameOfReferenceUid.isEmpty()
        && header.frameOfReferenceUid != identity.frameOfReferenceUid)
        return Clause::saying("the frame of reference is not the one that was opened");
    if (header.sopInstanceUid != volume.sources[std::size_t(k)].sopInstanceUid)
        return Clause::saying("the file now holds another image");
    if (header.columns != geometry.size.x || header.rows != geometry.size.y)
        return Clause::saying("rows or columns are not those of the volume");

    const glm::dvec3 origin = sliceOrigin(geometry, k);
    if (glm::distance(header.plane.position, origin) > positionToleranceMm(geometry))
        return Clause::saying("its header puts it at %1, the volume has it at %2",
            inMm(header.plane.position), inMm(origin));
    for (const glm::ivec2 corner :
        {glm::ivec2(geometry.size.x - 1, 0), glm::ivec2(0, geometry.size.y - 1)}) {
        const glm::dvec3 inVolume =
            origin + glm::dmat3(geometry.indexToWorld) * glm::dvec3(corner.x, corner.y, 0.0);
        const glm::dvec3 inHeader = header.plane.at(corner.x, corner.y);
        const double tolerance = positionToleranceMm(geometry)
            + cornerToleranceVoxels * std::min(geometry.spacingMm().x, geometry.spacingMm().y);
        if (glm::distance(inVolume, inHeader) > tolerance)
            return Clause::saying("its header puts a corner at %1, the volume has it at %2",
                inMm(inHeader), inMm(inVolume));
    }
    return {};
}

} // namespace

QString inMm(const glm::dvec3& point)
{
    return QStringLiteral("(%1, %2, %3) mm").arg(point.x).arg(point.y).arg(point.z);
}

Clause differenceOfPatients(const HeaderPatient& a, const HeaderPatient& b)
{
    if (nameParts(a.name) != nameParts(b.name))
        return Clause::saying("the patient's name");
    if (a.id.simplified() != b.id.simplified())
        return Clause::saying("the patient ID");
    // A birth date that DICOM cannot hold is left out of the export, and said so.
    if (!a.birthDate.isEmpty() && !b.birthDate.isEmpty() && a.birthDate != b.birthDate)
        return Clause::saying("the patient's birth date");
    return {};
}

Clause differenceFromSource(const HeaderPatient& written, const HeaderPatient& source)
{
    return differenceOfPatients(written,
        {.name = keptPatientName(source.name),
            .id = keptPatientId(source.id),
            .birthDate = source.birthDate});
}

double positionToleranceMm(const VolumeGeometry& geometry)
{
    const glm::dvec3 spacing = geometry.spacingMm();
    return std::min(0.015, 0.02 * std::min({spacing.x, spacing.y, spacing.z}));
}

glm::dvec3 sliceOrigin(const VolumeGeometry& geometry, int k)
{
    return geometry.slicePositions.empty() ? geometry.toWorld({0.0, 0.0, double(k)})
                                           : geometry.slicePositions[std::size_t(k)];
}

Result<std::vector<SourceHeader>> checkedSourceHeaders(
    const QString& file, const Volume& volume, const Progress& progress)
{
    auto headers = readSourceHeaders(volume.sources, volume.keptHeaders.get(), progress);
    if (!headers)
        return headers;
    for (std::size_t k = 0; k < headers->size(); ++k) {
        const Clause what = differenceFromVolume((*headers)[k], volume, int(k));
        if (!what.isEmpty())
            return failure(ErrorCode::ExportMismatch, file,
                Clause::saying("source %1: %2", volume.sources[k].file, what));
    }
    return headers;
}

Result<std::vector<SourceHeader>> checkedSourceHeaders(
    const QString& file, const ExportExpectation& expected, const Progress& progress)
{
    auto headers = checkedSourceHeaders(file, expected.volume, progress);
    if (headers && expected.deidentifier) {
        for (SourceHeader& header : *headers)
            header = expected.deidentifier->deidentified(header);
    }
    return headers;
}

} // namespace core
