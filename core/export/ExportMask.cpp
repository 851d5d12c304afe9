// SPDX-License-Identifier: Apache-2.0
#include "core/export/ExportMask.h"

#include "core/base/StagedFile.h"
#include "core/export/CheckExport.h"
#include "core/export/MaskSelection.h"

#include <QFileInfo>

#include <algorithm>

namespace core {

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

namespace {

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
    const auto selection = selectMask(volume, request);
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
        ? writeSegMask(staged->path(), volume, request, *selection, progress, report)
        : writeNiftiMask(staged->path(), volume, request, *selection, report);
    if (!written)
        return tl::unexpected(renamed(written.error(), *staged, request.file));
    report.written = *written;
    const ExportExpectation expected{volume, selection->segments, request.planes};
    const auto checked = seg ? checkSegExport(staged->path(), expected, progress)
                             : checkNiftiExport(staged->path(), expected, progress);
    if (!checked)
        return tl::unexpected(renamed(checked.error(), *staged, request.file));
    report.checked = *checked;
    if (volume.keptHeaders)
        report.cautions += QStringLiteral("The study's own files were not at hand; the export was "
                                          "checked against the headers that the session holds.");
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
