// SPDX-License-Identifier: Apache-2.0
#include "core/export/CarvedVolume.h"

#include "core/base/files/StagedFile.h"
#include "core/base/files/StagedFolder.h"
#include "core/dicom/deidentify/Deidentifier.h"
#include "core/dicom/write/CarvedSeriesWriter.h"
#include "core/export/checks/CheckCarved.h"
#include "core/export/common/LabelMap.h"
#include "core/export/common/MaskSelection.h"
#include "core/nifti/NiftiReader.h"
#include "core/nifti/NiftiWriter.h"
#include "core/repair/RepairVolume.h"
#include "core/repair/SeriesRepair.h"

#include <QCryptographicHash>
#include <QDir>
#include <QFile>
#include <QFileInfo>

#include <algorithm>
#include <cmath>

namespace core {

namespace {

Error renamed(Error error, const QString& path, const QString& target)
{
    error.arguments.replace(path, target);
    return error;
}

Result<ReportLine> checkFolderDeidentified(const QString& folder, const Deidentifier& by)
{
    const QStringList names = QDir(folder).entryList(QDir::Files);
    for (const QString& name : names) {
        if (const auto clean = checkDeidentified(QDir(folder).filePath(name), by); !clean)
            return clean;
    }
    return ReportSentence{ReportCode::FilesAreAnonymous, {std::int64_t(names.size())}};
}

/// What stands at a voxel of the carved volume.
ExpectedValue carvedValue(const Volume& volume, const CarvedRequest& request, double fill)
{
    return [&volume, &request, fill](std::size_t i) {
        return request.coverage[i] >= 128 ? fill : volume.encoding.value(request.codes[i]);
    };
}

QString numberText(double value, const QString& unit)
{
    const QString number = QString::number(value, 'g', 12);
    return unit.isEmpty() ? number : number + QLatin1Char(' ') + unit;
}

Result<StagedFile> stagedNifti(const Volume& volume, const QString& file, bool force)
{
    if (isSourceFile(volume, file))
        return failure(
            ErrorCode::FileUnwritable, file, Clause::saying("it is a file of the study itself"));
    return StagedFile::create(file, force);
}

/// In one call, since the voxels' type is known only after a look at all of them.
Result<NiftiWritten> writeValues(
    const QString& path, const Volume& volume, const ExpectedValue& value, bool* isFloat)
{
    const std::size_t count = volume.geometry.voxelCount();
    bool whole = true;
    for (std::size_t i = 0; i < count && whole; ++i) {
        const double each = value(i);
        whole = each == std::floor(each) && each >= -32768.0 && each <= 32767.0;
    }
    *isFloat = !whole;
    NiftiImage image{.geometry = volume.geometry,
        .voxels = {},
        .description = QStringLiteral("Burin: carved volume")};
    if (whole) {
        std::vector<std::int16_t> voxels(count);
        for (std::size_t i = 0; i < count; ++i)
            voxels[i] = std::int16_t(value(i));
        image.voxels = std::span<const std::int16_t>(voxels);
        return writeNiftiAt(path, image);
    }
    std::vector<float> voxels(count);
    for (std::size_t i = 0; i < count; ++i)
        voxels[i] = float(value(i));
    image.voxels = std::span<const float>(voxels);
    return writeNiftiAt(path, image);
}

Result<ExportReport> exportNifti(
    const Volume& volume, const CarvedRequest& request, double fill, ExportReport report)
{
    const Clause uneven = oneStepObstacle(volume, QStringLiteral("NIfTI"),
        Clause::saying("a DICOM series keeps every slice in its place"), report.cautions);
    if (!uneven.isEmpty())
        return failure(ErrorCode::UnsupportedFormat, request.target, uneven);
    auto staged = stagedNifti(volume, request.target, request.force);
    if (!staged)
        return tl::unexpected(staged.error());
    const ExpectedValue value = carvedValue(volume, request, fill);
    bool isFloat = false;
    const auto written = writeValues(staged->path(), volume, value, &isFloat);
    if (!written)
        return tl::unexpected(renamed(written.error(), staged->path(), request.target));
    report.written +=
        ReportSentence{isFloat ? ReportCode::NiftiFloats : ReportCode::NiftiWholeNumbers};
    const auto checked = checkNiftiValues(staged->path(), volume, value);
    if (!checked)
        return tl::unexpected(renamed(checked.error(), staged->path(), request.target));
    report.checked = *checked;
    const auto sum = sha256OfFile(staged->path());
    if (!sum)
        return tl::unexpected(renamed(sum.error(), staged->path(), request.target));
    report.sha256 = *sum;
    if (volume.encoding.maxError > 0.0)
        report.cautions +=
            ReportSentence{ReportCode::ValuesRounded, {QString::number(volume.encoding.maxError)}};
    if (auto done = staged->commit(); !done)
        return tl::unexpected(done.error());
    return report;
}

/// Of all files of a folder, one after the other by name. Errors: FileUnreadable.
Result<QString> sha256OfFolder(const QString& path)
{
    QCryptographicHash hash(QCryptographicHash::Sha256);
    const QDir folder(path);
    for (const QString& name : folder.entryList(QDir::Files, QDir::Name)) {
        QFile file(folder.filePath(name));
        if (!file.open(QIODevice::ReadOnly) || !hash.addData(&file))
            return failure(ErrorCode::FileUnreadable, file.fileName(), file.errorString());
    }
    return QString::fromLatin1(hash.result().toHex());
}

Result<ExportReport> exportSeries(const Volume& volume, const CarvedRequest& request, double fill,
    ExportReport report, const Progress& progress)
{
    if (const Clause obstacle = carvedSeriesObstacle(volume); !obstacle.isEmpty())
        return failure(ErrorCode::UnsupportedFormat, request.target, obstacle);
    Result<StagedFolder> staged = StagedFolder::create(request.target);
    if (!staged)
        return tl::unexpected(staged.error());
    const auto written = writeCarvedSeries(staged->path(),
        {.sources = volume.sources,
            .size = volume.geometry.size,
            .coverage = request.coverage,
            .fill = fill,
            .unit = volume.unit,
            .deidentifier = request.deidentifier},
        progress);
    if (!written)
        return tl::unexpected(renamed(written.error(), staged->path(), request.target));
    report.cautions += *written;
    report.written += ReportSentence{ReportCode::CarvedSeries, {volume.geometry.size.z}};
    Volume expected = volume;
    if (request.deidentifier)
        expected.identity = request.deidentifier->deidentified(volume.identity);
    const auto checked = checkCarvedSeries(staged->path(), expected,
        carvedValue(volume, request, fill), volume.encoding.maxError, progress);
    if (!checked)
        return tl::unexpected(renamed(checked.error(), staged->path(), request.target));
    report.checked = *checked;
    if (request.deidentifier) {
        const auto clean = checkFolderDeidentified(staged->path(), *request.deidentifier);
        if (!clean)
            return tl::unexpected(renamed(clean.error(), staged->path(), request.target));
        report.checked += *clean;
        report.written += ReportSentence{ReportCode::Deidentified,
            {request.deidentifier->method(), request.deidentifier->patientId()}};
        report.cautions += ReportSentence{ReportCode::FaceCanBeRecognised};
    }
    const auto sum = sha256OfFolder(staged->path());
    if (!sum)
        return tl::unexpected(renamed(sum.error(), staged->path(), request.target));
    report.sha256 = *sum;
    if (auto done = staged->commit(); !done)
        return tl::unexpected(done.error());
    return report;
}

} // namespace

Clause carvedSeriesObstacle(const Volume& volume)
{
    if (volume.asIs && volume.sources.empty())
        return Clause::saying("the series was repaired, so that its voxels are no longer those of "
                              "its images; NIfTI can be exported");
    if (volume.sourceFormat != QLatin1String("DICOM")
        || volume.sources.size() != std::size_t(volume.geometry.size.z))
        return Clause::saying("the study was not read from DICOM images; NIfTI can be exported");
    if (volume.keptHeaders)
        return Clause::saying("the study's own files are not at hand, which the new images are "
                              "made of; NIfTI can be exported");
    if (volume.identity.studyUid.isEmpty() || volume.identity.seriesUid.isEmpty())
        return Clause::saying("the source images do not say of which study and series they are; "
                              "NIfTI can be exported");
    for (std::size_t k = 0; k < volume.sources.size(); ++k) {
        if (volume.sources[k].frame != 0
            || (k > 0 && volume.sources[k].file == volume.sources[k - 1].file))
            return Clause::saying("the study is a file of several frames; NIfTI can be exported");
    }
    return {};
}

Result<ExportReport> exportCarvedVolume(
    const Volume& volume, const CarvedRequest& request, const Progress& progress)
{
    const auto carved = std::count_if(request.coverage.begin(), request.coverage.end(),
        [](std::uint8_t each) { return each >= 128; });
    if (carved == 0)
        return failure(
            ErrorCode::NothingToExport, request.target, Clause::saying("nothing is carved away"));
    const double fill = request.fill.value_or(volume.minimum);
    ExportReport report;
    report.file = request.target;
    report.written += ReportSentence{ReportCode::CarvedVolume,
        {std::int64_t(carved), std::int64_t(request.coverage.size()),
            numberText(fill, volume.unit)}};
    if (const QString made = repairMade(volume); !made.isEmpty())
        report.cautions +=
            ReportSentence{ReportCode::Repaired, {SeriesRepair::fromText(made)->inWords()}};
    for (const VolumeProblem& problem : volume.problems) {
        if (problem.caution)
            report.cautions += problem.said;
    }
    return isNiftiName(request.target)
        ? exportNifti(volume, request, fill, std::move(report))
        : exportSeries(volume, request, fill, std::move(report), progress);
}

Result<ExportReport> exportCoverage(
    const Volume& volume, const CoverageRequest& request, const Progress&)
{
    if (!isNiftiName(request.file))
        return failure(ErrorCode::UnsupportedFormat, request.file,
            Clause::saying("the name of a NIfTI file ends in .nii or .nii.gz"));
    ExportReport report;
    report.file = request.file;
    report.written += ReportSentence{ReportCode::LayerCoverage, {request.layer}};
    const Clause uneven = oneStepObstacle(volume, QStringLiteral("NIfTI"),
        Clause::saying("opened with even spacing (a repair) the study has a step for all"),
        report.cautions);
    if (!uneven.isEmpty())
        return failure(ErrorCode::UnsupportedFormat, request.file, uneven);
    auto staged = stagedNifti(volume, request.file, request.force);
    if (!staged)
        return tl::unexpected(staged.error());
    const auto written = writeNiftiAt(staged->path(),
        {.geometry = volume.geometry,
            .voxels = request.coverage,
            .description = QStringLiteral("Burin: coverage of ") + request.layer,
            .labels = false});
    if (!written)
        return tl::unexpected(renamed(written.error(), staged->path(), request.file));
    const auto checked = checkNiftiValues(
        staged->path(), volume, [&request](std::size_t i) { return double(request.coverage[i]); });
    if (!checked)
        return tl::unexpected(renamed(checked.error(), staged->path(), request.file));
    report.checked = *checked;
    const auto sum = sha256OfFile(staged->path());
    if (!sum)
        return tl::unexpected(renamed(sum.error(), staged->path(), request.file));
    report.sha256 = *sum;
    if (auto done = staged->commit(); !done)
        return tl::unexpected(done.error());
    return report;
}

} // namespace core
