// SPDX-License-Identifier: Apache-2.0
#include "core/export/CheckExport.h"

#include "core/dicom/SegReader.h"
#include "core/dicom/SourceHeader.h"

#include <QHash>

#include <algorithm>
#include <cmath>
#include <set>

namespace core {

namespace {

/// Copied text can only differ where it had to be shortened to 16 characters.
constexpr double copiedPositionToleranceMm = 1e-4;
constexpr double copiedDirectionTolerance = 1e-6;
constexpr double copiedSpacingTolerance = 1e-6; ///< relative
/// Slices of one stack may differ in orientation by the rounding of their text.
constexpr double cornerToleranceVoxels = 0.1;

QString inMm(const glm::dvec3& point)
{
    return QStringLiteral("(%1, %2, %3) mm").arg(point.x).arg(point.y).arg(point.z);
}

/// A name for comparison: letters as they are, marks between its parts not.
QString nameParts(const QString& name)
{
    QString plain = name;
    for (QChar& character : plain) {
        if (character == QLatin1Char('^') || character == QLatin1Char(',')
            || character == QLatin1Char('='))
            character = QLatin1Char(' ');
    }
    return plain.simplified();
}

QString digits(QString date)
{
    return date.remove(QLatin1Char('-'));
}

/// @returns what differs, or nothing
QString differenceOfPatients(const HeaderPatient& a, const HeaderPatient& b)
{
    if (a.decoded && b.decoded && nameParts(a.name) != nameParts(b.name))
        return QStringLiteral("the patient's name");
    if (a.decoded && b.decoded && a.id.simplified() != b.id.simplified())
        return QStringLiteral("the patient ID");
    // A birth date that DICOM cannot hold is left out of the export, and said so.
    if (!a.birthDate.isEmpty() && !b.birthDate.isEmpty() && a.birthDate != b.birthDate)
        return QStringLiteral("the patient's birth date");
    return {};
}

QString differenceOfPlanes(const HeaderPlane& a, const HeaderPlane& b)
{
    if (glm::distance(a.position, b.position) > copiedPositionToleranceMm)
        return QStringLiteral("position %1 instead of %2").arg(inMm(a.position), inMm(b.position));
    if (glm::distance(a.rowDirection, b.rowDirection) > copiedDirectionTolerance
        || glm::distance(a.columnDirection, b.columnDirection) > copiedDirectionTolerance)
        return QStringLiteral("orientation %1, %2 instead of %3, %4")
            .arg(inMm(a.rowDirection), inMm(a.columnDirection), inMm(b.rowDirection),
                inMm(b.columnDirection))
            .remove(QStringLiteral(" mm"));
    if (std::abs(a.rowSpacing - b.rowSpacing) > copiedSpacingTolerance * b.rowSpacing
        || std::abs(a.columnSpacing - b.columnSpacing) > copiedSpacingTolerance * b.columnSpacing)
        return QStringLiteral("spacing %1 by %2 mm instead of %3 by %4 mm")
            .arg(a.rowSpacing)
            .arg(a.columnSpacing)
            .arg(b.rowSpacing)
            .arg(b.columnSpacing);
    return {};
}

/// The slice's header against the volume as it was shown and drawn on.
QString differenceFromVolume(const SourceHeader& header, const Volume& volume, int k)
{
    const VolumeGeometry& geometry = volume.geometry;
    const StudyIdentity& identity = volume.identity;
    const HeaderPatient shown{.name = identity.patientName,
        .id = identity.patientId,
        .birthDate = digits(identity.birthDate),
        .decoded = true};
    if (const QString what = differenceOfPatients(header.patient, shown); !what.isEmpty())
        return what + QStringLiteral(" is not that of the study that was opened");
    if (header.studyUid != identity.studyUid)
        return QStringLiteral("the study is not the one that was opened");
    // Slices without a frame of reference in common have none in the volume (nor in the export).
    if (!identity.frameOfReferenceUid.isEmpty()
        && header.frameOfReferenceUid != identity.frameOfReferenceUid)
        return QStringLiteral("the frame of reference is not the one that was opened");
    if (header.sopInstanceUid != volume.sources[std::size_t(k)].sopInstanceUid)
        return QStringLiteral("the file now holds another image");
    if (header.columns != geometry.size.x || header.rows != geometry.size.y)
        return QStringLiteral("rows or columns are not those of the volume");

    const glm::dvec3 origin = sliceOrigin(geometry, k);
    if (glm::distance(header.plane.position, origin) > positionToleranceMm(geometry))
        return QStringLiteral("its header puts it at %1, the volume has it at %2")
            .arg(inMm(header.plane.position), inMm(origin));
    for (const glm::ivec2 corner :
        {glm::ivec2(geometry.size.x - 1, 0), glm::ivec2(0, geometry.size.y - 1)}) {
        const glm::dvec3 inVolume =
            origin + glm::dmat3(geometry.indexToWorld) * glm::dvec3(corner.x, corner.y, 0.0);
        const glm::dvec3 inHeader = header.plane.at(corner.x, corner.y);
        const double tolerance = positionToleranceMm(geometry)
            + cornerToleranceVoxels * std::min(geometry.spacingMm().x, geometry.spacingMm().y);
        if (glm::distance(inVolume, inHeader) > tolerance)
            return QStringLiteral("its header puts a corner at %1, the volume has it at %2")
                .arg(inMm(inHeader), inMm(inVolume));
    }
    return {};
}

const LabelPlaneView* planeOf(const ExportExpectation& expected, const Segment& segment)
{
    for (const LabelPlaneView& plane : expected.planes) {
        if (plane.plane == segment.plane)
            return &plane;
    }
    return nullptr;
}

/// Compares one frame's pixels with a slice of the labels.
QString differenceOfPixels(const SegFile& seg, std::size_t frame, const LabelPlaneView& plane,
    std::uint8_t label, std::size_t sliceOffset)
{
    std::size_t wrong = 0;
    std::size_t i = sliceOffset;
    for (int row = 0; row < seg.rows; ++row) {
        for (int column = 0; column < seg.columns; ++column, ++i)
            wrong += seg.pixel(frame, column, row) != (plane.labels[i] == label) ? 1U : 0U;
    }
    return wrong == 0 ? QString() : QStringLiteral("%1 voxels are not as drawn").arg(wrong);
}

bool holdsLabel(
    const LabelPlaneView& plane, std::uint8_t label, std::size_t offset, std::size_t count)
{
    const auto slice = plane.labels.subspan(offset, count);
    return std::find(slice.begin(), slice.end(), label) != slice.end();
}

} // namespace

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

Result<QStringList> checkSegExport(
    const QString& file, const ExportExpectation& expected, const Progress& progress)
{
    const Volume& volume = expected.volume;
    const glm::ivec3 size = volume.geometry.size;
    const auto mismatch = [&](const QString& what) {
        return failure(ErrorCode::ExportMismatch, file, what);
    };
    const auto read = readSeg(file);
    if (!read)
        return tl::unexpected(read.error());
    const SegFile& seg = *read;
    if (seg.columns != size.x || seg.rows != size.y)
        return mismatch(QStringLiteral("rows or columns"));
    if (seg.segments.size() != expected.segments.size())
        return mismatch(QStringLiteral("the number of segments"));
    for (std::size_t i = 0; i < seg.segments.size(); ++i) {
        if (seg.segments[i].number != int(i) + 1
            || !(seg.segments[i].type == expected.segments[i].code))
            return mismatch(QStringLiteral("number or code of segment %1").arg(i + 1));
    }

    const auto headers = readSourceHeaders(volume.sources, progress);
    if (!headers)
        return tl::unexpected(headers.error());
    QHash<QString, int> sliceOfInstance;
    for (int k = 0; k < int(headers->size()); ++k) {
        const SourceHeader& header = (*headers)[std::size_t(k)];
        const QString name = volume.sources[std::size_t(k)].file;
        if (const QString what = differenceFromVolume(header, volume, k); !what.isEmpty())
            return mismatch(QStringLiteral("source %1: %2").arg(name, what));
        const QString key = QStringLiteral("%1/%2")
                                .arg(header.sopInstanceUid)
                                .arg(volume.sources[std::size_t(k)].frame);
        if (sliceOfInstance.contains(key))
            return mismatch(QStringLiteral("two slices come from one image"));
        sliceOfInstance.insert(key, k);
        if (!seg.referencedSopUids.contains(header.sopInstanceUid))
            return mismatch(QStringLiteral("source %1 is not referenced").arg(name));
    }

    const std::size_t sliceVoxels = std::size_t(size.x) * std::size_t(size.y);
    std::set<std::pair<int, int>> seen;
    for (std::size_t i = 0; i < seg.frames.size(); ++i) {
        if (progress.cancelled())
            return failure(ErrorCode::Cancelled);
        progress.report(QStringLiteral("Checking frames"), int(i), int(seg.frames.size()));
        const SegFrame& frame = seg.frames[i];
        const auto atFrame = [&](const QString& what) {
            return mismatch(QStringLiteral("frame %1: %2").arg(i + 1).arg(what));
        };
        const QString key =
            QStringLiteral("%1/%2").arg(frame.referencedSopUid).arg(frame.referencedFrame);
        if (!sliceOfInstance.contains(key))
            return atFrame(QStringLiteral("its source image is none of the volume's"));
        const int k = sliceOfInstance.value(key);
        const SourceHeader& header = (*headers)[std::size_t(k)];
        if (const QString what = differenceOfPlanes(frame.plane, header.plane); !what.isEmpty())
            return atFrame(what);
        if (seg.frameOfReferenceUid
            != (volume.identity.frameOfReferenceUid.isEmpty() ? QString()
                                                              : header.frameOfReferenceUid))
            return atFrame(QStringLiteral("frame of reference"));
        if (const QString what = differenceOfPatients(seg.patient, header.patient); !what.isEmpty())
            return atFrame(what);
        if (seg.studyUid != header.studyUid)
            return atFrame(QStringLiteral("study"));
        if (frame.segment < 1 || frame.segment > int(expected.segments.size()))
            return atFrame(QStringLiteral("segment number"));
        const Segment& segment = expected.segments[std::size_t(frame.segment - 1)];
        const LabelPlaneView* plane = planeOf(expected, segment);
        if (plane == nullptr || plane->labels.size() != volume.geometry.voxelCount())
            return mismatch(QStringLiteral("labels to compare with are missing"));
        if (const QString what =
                differenceOfPixels(seg, i, *plane, segment.label, std::size_t(k) * sliceVoxels);
            !what.isEmpty())
            return atFrame(what);
        if (!seen.emplace(frame.segment, k).second)
            return atFrame(QStringLiteral("the slice occurs twice"));
    }
    for (std::size_t s = 0; s < expected.segments.size(); ++s) {
        const LabelPlaneView* plane = planeOf(expected, expected.segments[s]);
        for (int k = 0; k < size.z; ++k) {
            if (seen.count({int(s) + 1, k}) == 0 && plane != nullptr
                && holdsLabel(
                    *plane, expected.segments[s].label, std::size_t(k) * sliceVoxels, sliceVoxels))
                return mismatch(QStringLiteral("slice %1 of segment '%2' is missing")
                                    .arg(k + 1)
                                    .arg(expected.segments[s].name));
        }
    }
    return QStringList{
        QStringLiteral("Position, orientation, spacing, frame of reference, patient and study of "
                       "%1 frames equal those of the source images they name (%2 source headers "
                       "read again).")
            .arg(seg.frames.size())
            .arg(headers->size()),
        QStringLiteral("All voxels of %1 segments are as drawn.").arg(expected.segments.size())};
}

} // namespace core
