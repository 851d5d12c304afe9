// SPDX-License-Identifier: Apache-2.0
#include "core/export/common/ExportMask.h"

#include "core/base/Guarded.h"
#include "core/base/files/FileInUse.h"
#include "core/base/files/StagedError.h"
#include "core/base/files/StagedFile.h"
#include "core/dicom/deidentify/Deidentifier.h"
#include "core/dicom/items/SopClass.h"
#include "core/export/common/CheckExport.h"
#include "core/export/common/CheckWayBack.h"
#include "core/export/common/MaskSelection.h"
#include "core/export/common/StatisticsText.h"
#include "core/repair/RepairVolume.h"
#include "core/repair/SeriesRepair.h"
#include "core/repair/WayBack.h"
#include "core/study/SourceFiles.h"

#include <QCryptographicHash>
#include <QFile>
#include <QFileInfo>

#include <algorithm>

namespace core {

Result<QString> sha256OfFile(const QString& path)
{
    QFile file(path);
    QCryptographicHash hash(QCryptographicHash::Sha256);
    if (!file.open(QIODevice::ReadOnly) || !hash.addData(&file))
        return failure(ErrorCode::FileUnreadable, path, file.errorString());
    return QString::fromLatin1(hash.result().toHex());
}

bool isSourceFile(const Volume& volume, const QString& file)
{
    if (!QFileInfo::exists(file))
        return false;
    const std::optional<FileIdentity> target = FileIdentity::of(file);
    const QStringList sources = sourceFiles(volume);
    return std::any_of(sources.begin(), sources.end(),
        [&target](const QString& source) { return FileIdentity::of(source) == target; });
}

namespace {

/// Names the user's file where a step knew only the temporary one.
Error renamed(Error error, const StagedFile& staged, const QString& file)
{
    error.arguments.exchange(staged.path(), file);
    return error;
}

Result<ReportLines> write(const QString& path, const Volume& volume, const ExportRequest& request,
    const MaskSelection& selection, const StagedExport* beside, const Progress& progress,
    ExportReport& report)
{
    switch (request.format) {
    case ExportFormat::DicomSeg:
    case ExportFormat::DicomSegFractional:
    case ExportFormat::DicomSegLabelMap:
        return writeSegMask(path, volume, request, selection, progress, report);
    case ExportFormat::RtStruct:
        return writeRtStructMask(path, volume, request, selection, progress, report);
    case ExportFormat::Nifti:
        return writeNiftiMask(path, volume, request, selection, report);
    case ExportFormat::SegNrrd:
        return writeSegNrrdMask(path, volume, request, selection, report);
    case ExportFormat::Csv:
    case ExportFormat::Json:
    case ExportFormat::Sr:
        return writeStatistics(path, volume, request, selection, beside, progress, report);
    case ExportFormat::Stl:
    case ExportFormat::Obj:
    case ExportFormat::Ply:
    case ExportFormat::Gltf:
        break;
    }
    return writeSurfaces(path, volume, request, selection, progress, report);
}

Result<ReportLines> check(
    const QString& path, const ExportExpectation& expected, const Progress& progress)
{
    switch (expected.format) {
    case ExportFormat::DicomSeg:
    case ExportFormat::DicomSegFractional:
    case ExportFormat::DicomSegLabelMap:
        return checkSegExport(path, expected, progress);
    case ExportFormat::RtStruct:
        return checkRtStructExport(path, expected, progress);
    case ExportFormat::Nifti:
        return checkNiftiExport(path, expected, progress);
    case ExportFormat::SegNrrd:
        return checkSegNrrdExport(path, expected, progress);
    case ExportFormat::Csv:
    case ExportFormat::Json:
    case ExportFormat::Sr:
        return checkStatisticsExport(path, expected, progress);
    case ExportFormat::Stl:
    case ExportFormat::Obj:
    case ExportFormat::Ply:
    case ExportFormat::Gltf:
        break;
    }
    return checkSurfaceExport(expected.format, path, expected, progress);
}

/// What is written in place of names that may say who the patient is.
ExportRequest neutral(ExportRequest request)
{
    if (request.deidentifier) {
        for (Segment& segment : request.segments)
            segment.name = request.deidentifier->segmentName(
                segment.label, segment.name, segment.code.meaning);
        for (SegmentCoverage& coverage : request.coverages)
            coverage.layer = request.deidentifier->options().keepDescriptions
                ? request.deidentifier->cleanText(coverage.layer)
                : QStringLiteral("its own");
    }
    return request;
}

Result<StagedExport> stageOn(const Volume& volume, const ExportRequest& request,
    const Progress& progress, ExportReport report)
{
    if (const Clause obstacle = exportNameObstacle(request.format, request.file);
        !obstacle.isEmpty())
        return failure(ErrorCode::UnsupportedFormat, request.file, obstacle);
    const auto selection = selectMask(volume, request);
    if (!selection)
        return tl::unexpected(selection.error());
    if (factsOf(request.format).isSeg) {
        for (const Segment& segment : selection->segments) {
            if (!segment.code.isSet())
                return failure(ErrorCode::SegmentNotCoded, segment.name);
        }
    }
    if (factsOf(request.format).isStatistics
        && request.codes.size() != volume.geometry.voxelCount())
        return failure(ErrorCode::UnsupportedFormat, request.file,
            Clause::saying("the values of the study are not at hand"));
    if (isSourceFile(volume, request.file))
        return failure(ErrorCode::FileUnwritable, request.file,
            Clause::saying("it is a file of the study itself"));
    auto staged = StagedFile::create(request.file, request.force);
    if (!staged)
        return tl::unexpected(staged.error());

    std::shared_ptr<StagedExport> beside;
    if (request.format == ExportFormat::Sr) {
        // What a report speaks of is written with it, and comes and goes with it.
        ExportRequest seg = request;
        seg.format = ExportFormat::DicomSeg;
        seg.file = segBeside(request.file);
        auto stagedSeg = stageOn(volume, seg, progress, {});
        if (!stagedSeg)
            return tl::unexpected(stagedSeg.error());
        stagedSeg->report.file = seg.file;
        beside = std::make_shared<StagedExport>(*std::move(stagedSeg));
    }
    const auto written =
        write(staged->path(), volume, request, *selection, beside.get(), progress, report);
    if (!written)
        return tl::unexpected(renamed(written.error(), *staged, request.file));
    report.written = *written + report.written;
    std::map<int, SegCodes> segmentCodes;
    for (const Segment& segment : selection->segments)
        segmentCodes[segment.label] = codesIn(request.seg, segment.label, request.category);
    const ExportExpectation expected{.volume = volume,
        .segments = selection->segments,
        .planes = request.planes,
        .space = request.space,
        .format = request.format,
        .coverages = request.coverages,
        .codes = request.codes,
        .imported = request.imported,
        .deidentifier = request.deidentifier.get(),
        .measurements = request.measurements,
        .segmentCodes = std::move(segmentCodes)};
    const auto checked = check(staged->path(), expected, progress);
    if (!checked)
        return tl::unexpected(renamed(checked.error(), *staged, request.file));
    report.checked = *checked + report.checked;
    if (request.deidentifier) {
        if (factsOf(request.format).namesSourceImages) {
            const auto clean = checkDeidentified(staged->path(), *request.deidentifier);
            if (!clean)
                return tl::unexpected(renamed(clean.error(), *staged, request.file));
            report.checked += *clean;
        }
        report.written += ReportSentence{ReportCode::Deidentified,
            {request.deidentifier->method(), request.deidentifier->patientId()}};
    }
    const auto sum = sha256OfFile(staged->path());
    if (!sum)
        return tl::unexpected(renamed(sum.error(), *staged, request.file));
    report.sha256 = *sum;
    if (volume.keptHeaders)
        report.cautions += ReportSentence{ReportCode::CheckedAgainstSession};
    for (const QString& name : selection->empty)
        report.cautions += ReportSentence{ReportCode::SegmentEmpty, {name}};
    if (const QString made = repairMade(volume); !made.isEmpty())
        report.cautions +=
            ReportSentence{ReportCode::Repaired, {SeriesRepair::fromText(made)->inWords()}};
    for (const VolumeProblem& problem : volume.problems) {
        if (problem.caution)
            report.cautions += problem.said;
    }
    return StagedExport{*std::move(staged), std::move(report), std::move(beside)};
}

/// Writes and checks on the voxels of @p volume.
Result<ExportReport> exportOn(const Volume& volume, const ExportRequest& request,
    const Progress& progress, ExportReport report)
{
    auto staged = stageOn(volume, request, progress, std::move(report));
    if (!staged)
        return tl::unexpected(staged.error());
    if (staged->beside) {
        if (const Result<void> placed = staged->beside->file.commit(); !placed)
            return tl::unexpected(placed.error());
    }
    // Both or none, also where there is no memory for the second one.
    if (const Result<void> placed = guarded([&] { return staged->file.commit(); }); !placed)
        return tl::unexpected(
            staged->beside ? takingBack(placed.error(), staged->beside->file) : placed.error());
    return std::move(staged->report);
}

/// Labels of the repaired voxels on the slices of the images that they were made of.
Result<ExportReport> exportOnSlices(const WayBack& back, const Volume& volume,
    const ExportRequest& request, const Progress& progress)
{
    if (factsOf(request.format).isStatistics)
        return failure(ErrorCode::UnsupportedFormat, request.file,
            Clause::saying("a report names the images, on which the repaired voxels do not lie; "
                           "CSV and JSON can be written"));
    std::vector<std::vector<std::uint8_t>> labels;
    ExportRequest onSlices = request;
    for (SegmentCoverage& coverage : onSlices.coverages) {
        labels.push_back(back.labels(coverage.coverage));
        coverage.coverage = labels.back();
    }
    for (LabelPlaneView& plane : onSlices.planes) {
        if (plane.labels.size() != volume.geometry.voxelCount())
            return failure(ErrorCode::UnknownSegment, QString(),
                Clause::saying("its label plane is not there"));
        labels.push_back(back.labels(plane.labels));
        plane.labels = labels.back();
    }
    if (const Clause wrong = differenceOfWayBack(back, volume, onSlices, request); !wrong.isEmpty())
        return failure(ErrorCode::ExportMismatch, request.file, wrong);
    ExportReport report;
    report.file = request.file;
    report.written = {ReportSentence{ReportCode::OnOwnSlices, {back.slices().geometry.size.z}}};
    report.checked = {ReportSentence{ReportCode::SlicesFoundAgain}};
    report.cautions = beyondSlices(back, volume, request);
    return exportOn(back.slices(), onSlices, progress, std::move(report));
}

} // namespace

CodedConcept anatomicalStructure()
{
    return {.scheme = QStringLiteral("SCT"),
        .value = QStringLiteral("123037004"),
        .meaning = QStringLiteral("Anatomical Structure")};
}

Clause dicomSegObstacle(const Volume& volume)
{
    if (const std::optional<WayBack> back = WayBack::of(volume))
        return dicomSegObstacle(back->slices());
    const auto orNifti = [](const Clause& why) {
        return Clause::saying("%1; NIfTI can be exported instead", why);
    };
    if (volume.sourceFormat != QLatin1String("DICOM")
        || volume.sources.size() != std::size_t(volume.geometry.size.z))
        return orNifti(
            Clause::saying("the study was not read from DICOM images, which a DICOM SEG or "
                           "RTSTRUCT must name"));
    if (volume.identity.studyUid.isEmpty())
        return orNifti(
            Clause::saying("the source images carry no Study Instance UID, so a DICOM SEG or "
                           "RTSTRUCT could not say to which study it belongs"));
    if (volume.identity.seriesUid.isEmpty())
        return orNifti(
            Clause::saying("the source images carry no Series Instance UID, so a DICOM SEG or "
                           "RTSTRUCT could not say on which series it was drawn"));
    for (const SourceSlice& slice : volume.sources) {
        if (slice.sopInstanceUid.isEmpty() || slice.sopClassUid.isEmpty())
            return orNifti(
                Clause::saying("the source images carry no SOP Instance UID, so a DICOM SEG or "
                               "RTSTRUCT could not say on which image it was drawn"));
    }
    const bool inARow =
        std::any_of(volume.sources.begin(), volume.sources.end(), [](const SourceSlice& slice) {
            return slice.frame > 0 && haveFramesInARow(slice.sopClassUid);
        });
    if (inARow)
        return orNifti(
            Clause::saying("the source is one file whose frames have one position for all of them "
                           "(a dose, or reconstructed nuclear medicine)"));
    if (std::max(volume.geometry.size.x, volume.geometry.size.y) > 65535)
        return orNifti(Clause::saying("DICOM holds at most 65535 rows and columns"));
    return {};
}

Result<ExportReport> exportMask(
    const Volume& volume, const ExportRequest& asked, const Progress& progress)
{
    const ExportRequest request = neutral(asked);
    if (factsOf(request.format).namesSourceImages) {
        if (const Clause obstacle = dicomSegObstacle(volume); !obstacle.isEmpty())
            return failure(ErrorCode::UnsupportedFormat, request.file, obstacle);
        if (const std::optional<WayBack> back = WayBack::of(volume))
            return exportOnSlices(*back, volume, request, progress);
    }
    ExportReport report;
    report.file = request.file;
    return exportOn(volume, request, progress, std::move(report));
}

} // namespace core
