// SPDX-License-Identifier: Apache-2.0
#include "core/export/ExportMask.h"

#include "core/base/StagedFile.h"
#include "core/dicom/SegWriter.h"
#include "core/export/CheckExport.h"
#include "core/export/CheckSources.h"
#include "core/nifti/NiftiWriter.h"

#include <QFileInfo>

#include <algorithm>
#include <array>
#include <bitset>
#include <map>

namespace core {

namespace {

/// A slice step that strays further than this share of itself cannot be called even in NIfTI.
constexpr double unevenLimit = 0.1;

const LabelPlaneView* planeOf(const ExportRequest& request, const Segment& segment)
{
    for (const LabelPlaneView& plane : request.planes) {
        if (plane.plane == segment.plane)
            return &plane;
    }
    return nullptr;
}

std::size_t voxelsPerSlice(const Volume& volume)
{
    return std::size_t(volume.geometry.size.x) * std::size_t(volume.geometry.size.y);
}

/// Which labels occur in each slice of a plane.
std::vector<std::bitset<256>> labelsBySlice(const Volume& volume, const LabelPlaneView& plane)
{
    std::vector<std::bitset<256>> present(std::size_t(volume.geometry.size.z));
    const std::size_t count = voxelsPerSlice(volume);
    for (std::size_t k = 0; k < present.size(); ++k) {
        std::array<bool, 256> seen{};
        for (const std::uint8_t label : plane.labels.subspan(k * count, count))
            seen[label] = true;
        for (std::size_t label = 0; label < seen.size(); ++label)
            present[k].set(label, seen[label]);
    }
    return present;
}

/// What is left of a request once the empty segments are out of it.
struct Selection {
    std::vector<Segment> segments;
    std::vector<std::vector<int>> slices; ///< per segment, those that hold a voxel, ascending
    QStringList empty;
};

Result<Selection> select(const Volume& volume, const ExportRequest& request)
{
    Selection selection;
    std::map<std::uint8_t, std::vector<std::bitset<256>>> presentInPlane;
    for (const Segment& segment : request.segments) {
        const LabelPlaneView* plane = planeOf(request, segment);
        if (plane == nullptr || plane->labels.size() != volume.geometry.voxelCount())
            return failure(ErrorCode::UnknownSegment, segment.name,
                QStringLiteral("its label plane is not there"));
        auto [present, isNew] = presentInPlane.try_emplace(segment.plane);
        if (isNew)
            present->second = labelsBySlice(volume, *plane);
        std::vector<int> slices;
        for (std::size_t k = 0; k < present->second.size(); ++k) {
            if (present->second[k].test(segment.label))
                slices.push_back(int(k));
        }
        if (slices.empty()) {
            selection.empty += segment.name;
            continue;
        }
        selection.segments.push_back(segment);
        selection.slices.push_back(std::move(slices));
    }
    if (selection.segments.empty())
        return failure(ErrorCode::NothingToExport, request.file,
            request.segments.empty() ? QStringLiteral("no segment is chosen")
                                     : QStringLiteral("the chosen segments are empty"));
    return selection;
}

/// True where two segments share a voxel; only segments of different planes can.
bool overlap(const ExportRequest& request, const std::vector<Segment>& segments)
{
    for (std::size_t a = 0; a < segments.size(); ++a) {
        for (std::size_t b = a + 1; b < segments.size(); ++b) {
            if (segments[a].plane == segments[b].plane)
                continue;
            const auto first = planeOf(request, segments[a])->labels;
            const auto second = planeOf(request, segments[b])->labels;
            for (std::size_t i = 0; i < first.size(); ++i) {
                if (first[i] == segments[a].label && second[i] == segments[b].label)
                    return true;
            }
        }
    }
    return false;
}

/// How far the slices stray from the affine; 0 for an even stack.
double unevennessMm(const VolumeGeometry& geometry)
{
    double worst = 0.0;
    for (std::size_t k = 0; k < geometry.slicePositions.size(); ++k)
        worst = std::max(worst,
            glm::distance(geometry.slicePositions[k], geometry.toWorld({0.0, 0.0, double(k)})));
    return worst;
}

Result<QStringList> writeSegFile(const QString& path, const Volume& volume,
    const ExportRequest& request, const Selection& selection, const Progress& progress,
    ExportReport& report)
{
    const VolumeGeometry& geometry = volume.geometry;
    SegContent content;
    content.identity = volume.identity;
    content.sources = volume.sources;
    content.columns = geometry.size.x;
    content.rows = geometry.size.y;
    if (geometry.slicePositions.empty() && geometry.size.z > 1) {
        const glm::dmat3 axes(geometry.indexToWorld);
        content.sliceDistanceMm =
            std::abs(glm::dot(axes[2], glm::normalize(glm::cross(axes[0], axes[1]))));
    }
    content.segments = selection.segments;
    content.category = request.category;
    content.segmentsOverlap = overlap(request, selection.segments);
    FrameBits bits;
    const std::size_t count = voxelsPerSlice(volume);
    for (std::size_t s = 0; s < selection.segments.size(); ++s) {
        const auto labels = planeOf(request, selection.segments[s])->labels;
        for (const int k : selection.slices[s]) {
            content.frames.push_back({.segment = int(s), .slice = k});
            bits.append(labels.subspan(std::size_t(k) * count, count), selection.segments[s].label);
        }
    }
    content.bits = bits.take();
    const auto written = writeSeg(path, content, progress);
    if (!written)
        return tl::unexpected(written.error());
    report.cautions += written->notes;
    if (volume.identity.frameOfReferenceUid.isEmpty())
        report.cautions += QStringLiteral(
            "The source images have no frame of reference in common; the segmentation names none.");
    return QStringList{QStringLiteral(
        "DICOM SEG, binary: %1 in %2 of %3 × %4; slices without a voxel are left out.")
                           .arg(counted(int(content.segments.size()), "segment"),
                               counted(int(content.frames.size()), "frame"))
                           .arg(content.columns)
                           .arg(content.rows)};
}

Result<QStringList> writeNiftiFile(const QString& path, const Volume& volume,
    const ExportRequest& request, const Selection& selection, ExportReport& report)
{
    const VolumeGeometry& geometry = volume.geometry;
    const double uneven = unevennessMm(geometry);
    if (uneven > unevenLimit * geometry.spacingMm().z)
        return failure(ErrorCode::UnsupportedFormat, request.file,
            QStringLiteral("NIfTI has one step for all slices, and these stray from it by up to %1 "
                           "mm; DICOM SEG keeps every slice in its place")
                .arg(uneven, 0, 'f', 2));
    if (uneven > 0.0)
        report.cautions += QStringLiteral("The slices are not evenly spaced; in the NIfTI file, "
                                          "which has one step for all, they lie up to %1 mm off.")
                               .arg(uneven, 0, 'f', 3);
    std::vector<std::uint8_t> merged(geometry.voxelCount(), 0);
    std::bitset<256> used;
    QStringList names;
    for (const Segment& segment : selection.segments) {
        if (used.test(segment.label))
            return failure(ErrorCode::UnsupportedFormat, request.file,
                QStringLiteral(
                    "two of the segments have label %1, which one NIfTI label map cannot "
                    "hold; export them one by one, or as DICOM SEG")
                    .arg(segment.label));
        used.set(segment.label);
        names += QStringLiteral("%1 %2").arg(segment.label).arg(segment.name);
        const auto labels = planeOf(request, segment)->labels;
        for (std::size_t i = 0; i < labels.size(); ++i) {
            if (labels[i] != segment.label)
                continue;
            if (merged[i] != 0)
                return failure(ErrorCode::UnsupportedFormat, request.file,
                    QStringLiteral(
                        "segments overlap, which one NIfTI label map cannot hold; export "
                        "them one by one, or as DICOM SEG"));
            merged[i] = segment.label;
        }
    }
    const auto written = writeNiftiAt(path,
        {.geometry = geometry,
            .voxels = merged,
            .description = QStringLiteral("Burin: ") + names.join(QStringLiteral(", "))});
    if (!written)
        return tl::unexpected(written.error());
    if (!written->qform && geometry.shearAngleDegrees() > 0.01)
        report.cautions +=
            QStringLiteral("The slices are tilted by %1°: only the sform says so, and "
                           "some programs refuse such files.")
                .arg(geometry.shearAngleDegrees(), 0, 'f', 2);
    return QStringList{QStringLiteral("NIfTI label map, %1 × %2 × %3, on the source's grid: %4.")
                           .arg(geometry.size.x)
                           .arg(geometry.size.y)
                           .arg(geometry.size.z)
                           .arg(names.join(QStringLiteral(", ")))};
}

bool isSourceFile(const Volume& volume, const QString& file)
{
    const QString target = QFileInfo(file).canonicalFilePath();
    if (target.isEmpty())
        return false;
    if (QFileInfo(volume.sourcePath).canonicalFilePath() == target)
        return true;
    return std::any_of(volume.sources.begin(), volume.sources.end(), [&](const SourceSlice& slice) {
        return QFileInfo(slice.file).canonicalFilePath() == target;
    });
}

/// Names the user's file where a step knew only the temporary one.
Error renamed(Error error, const StagedFile& staged, const QString& file)
{
    for (QString& argument : error.arguments) {
        if (argument == staged.path())
            argument = file;
    }
    return error;
}

} // namespace

std::optional<ExportFormat> exportFormatNamed(const QString& name)
{
    if (name == QLatin1String("dicom-seg"))
        return ExportFormat::DicomSeg;
    if (name == QLatin1String("nifti"))
        return ExportFormat::Nifti;
    return std::nullopt;
}

CodedConcept anatomicalStructure()
{
    return {.scheme = QStringLiteral("SCT"),
        .value = QStringLiteral("123037004"),
        .meaning = QStringLiteral("Anatomical Structure")};
}

QString dicomSegObstacle(const Volume& volume)
{
    const QString instead = QStringLiteral("; NIfTI can be exported instead");
    if (volume.sourceFormat != QLatin1String("DICOM")
        || volume.sources.size() != std::size_t(volume.geometry.size.z))
        return QStringLiteral(
                   "the study was not read from DICOM images, which a DICOM SEG must name")
            + instead;
    if (volume.identity.studyUid.isEmpty())
        return QStringLiteral("the source images carry no Study Instance UID, so a DICOM SEG could "
                              "not say to which study it belongs")
            + instead;
    if (volume.identity.seriesUid.isEmpty())
        return QStringLiteral(
                   "the source images carry no Series Instance UID, so a DICOM SEG could "
                   "not say on which series it was drawn")
            + instead;
    for (const SourceSlice& slice : volume.sources) {
        if (slice.sopInstanceUid.isEmpty() || slice.sopClassUid.isEmpty())
            return QStringLiteral(
                       "the source images carry no SOP Instance UID, so a DICOM SEG could "
                       "not say on which image a frame was drawn")
                + instead;
    }
    if (std::max(volume.geometry.size.x, volume.geometry.size.y) > 65535)
        return QStringLiteral("DICOM holds at most 65535 rows and columns") + instead;
    return {};
}

Result<ExportReport> exportMask(
    const Volume& volume, const ExportRequest& request, const Progress& progress)
{
    const bool seg = request.format == ExportFormat::DicomSeg;
    if (seg) {
        if (const QString obstacle = dicomSegObstacle(volume); !obstacle.isEmpty())
            return failure(ErrorCode::UnsupportedFormat, request.file, obstacle);
    } else if (!request.file.endsWith(QLatin1String(".nii"), Qt::CaseInsensitive)
        && !request.file.endsWith(QLatin1String(".nii.gz"), Qt::CaseInsensitive)) {
        return failure(ErrorCode::UnsupportedFormat, request.file,
            QStringLiteral("the name of a NIfTI file ends in .nii or .nii.gz"));
    }
    const auto selection = select(volume, request);
    if (!selection)
        return tl::unexpected(selection.error());
    if (seg) {
        for (const Segment& segment : selection->segments) {
            if (!segment.code.isSet())
                return failure(ErrorCode::SegmentNotCoded, segment.name);
        }
    }
    if (isSourceFile(volume, request.file))
        return failure(ErrorCode::FileUnwritable, request.file,
            QStringLiteral("it is a file of the study itself"));
    auto staged = StagedFile::create(request.file, request.force);
    if (!staged)
        return tl::unexpected(staged.error());

    ExportReport report;
    report.file = request.file;
    const auto written = seg
        ? writeSegFile(staged->path(), volume, request, *selection, progress, report)
        : writeNiftiFile(staged->path(), volume, request, *selection, report);
    if (!written)
        return tl::unexpected(renamed(written.error(), *staged, request.file));
    report.written = *written;
    const ExportExpectation expected{volume, selection->segments, request.planes};
    const auto checked = seg ? checkSegExport(staged->path(), expected, progress)
                             : checkNiftiExport(staged->path(), expected, progress);
    if (!checked)
        return tl::unexpected(renamed(checked.error(), *staged, request.file));
    report.checked = *checked;
    for (const QString& name : selection->empty)
        report.cautions += QStringLiteral("Segment '%1' is empty and was left out.").arg(name);
    for (const VolumeProblem& problem : volume.problems) {
        if (problem.caution)
            report.cautions += problem.text;
    }
    if (auto done = staged->commit(); !done)
        return tl::unexpected(done.error());
    return report;
}

} // namespace core
