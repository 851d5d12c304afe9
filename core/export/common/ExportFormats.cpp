// SPDX-License-Identifier: Apache-2.0
#include "core/export/common/ExportFormats.h"

#include <algorithm>
#include <array>

namespace core {

namespace {

constexpr std::array formats{
    ExportFormatFacts{.format = ExportFormat::DicomSeg,
        .name = "dicom-seg",
        .ending = ".dcm",
        .anyEnding = true,
        .namesSourceImages = true,
        .isSeg = true,
        .holdsCodes = true},
    ExportFormatFacts{.format = ExportFormat::DicomSegFractional,
        .name = "dicom-seg-fractional",
        .ending = ".dcm",
        .anyEnding = true,
        .namesSourceImages = true,
        .isSeg = true,
        .holdsCodes = true},
    ExportFormatFacts{.format = ExportFormat::DicomSegLabelMap,
        .name = "dicom-seg-labelmap",
        .ending = ".dcm",
        .anyEnding = true,
        .namesSourceImages = true,
        .isSeg = true,
        .holdsCodes = true},
    ExportFormatFacts{.format = ExportFormat::RtStruct,
        .name = "rtstruct",
        .ending = ".dcm",
        .anyEnding = true,
        .namesSourceImages = true},
    ExportFormatFacts{
        .format = ExportFormat::Nifti, .name = "nifti", .ending = ".nii.gz", .otherEnding = ".nii"},
    ExportFormatFacts{.format = ExportFormat::SegNrrd,
        .name = "seg-nrrd",
        .ending = ".seg.nrrd",
        .holdsCodes = true},
    ExportFormatFacts{
        .format = ExportFormat::Stl, .name = "stl", .ending = ".stl", .isSurface = true},
    ExportFormatFacts{
        .format = ExportFormat::Obj, .name = "obj", .ending = ".obj", .isSurface = true},
    ExportFormatFacts{
        .format = ExportFormat::Ply, .name = "ply", .ending = ".ply", .isSurface = true},
    ExportFormatFacts{
        .format = ExportFormat::Gltf, .name = "gltf", .ending = ".glb", .isSurface = true},
    ExportFormatFacts{
        .format = ExportFormat::Csv, .name = "csv", .ending = ".csv", .isStatistics = true},
    ExportFormatFacts{
        .format = ExportFormat::Json, .name = "json", .ending = ".json", .isStatistics = true},
    ExportFormatFacts{.format = ExportFormat::Sr,
        .name = "sr",
        .ending = ".dcm",
        .anyEnding = true,
        .namesSourceImages = true,
        .isSeg = true,
        .holdsCodes = true,
        .isStatistics = true},
};

bool endsIn(const QString& file, const char* ending)
{
    return *ending != '\0' && file.endsWith(QLatin1String(ending), Qt::CaseInsensitive);
}

} // namespace

std::span<const ExportFormatFacts> exportFormats()
{
    return formats;
}

const ExportFormatFacts& factsOf(ExportFormat format)
{
    return *std::find_if(formats.begin(), formats.end(),
        [format](const ExportFormatFacts& facts) { return facts.format == format; });
}

std::optional<ExportFormat> exportFormatNamed(const QString& name)
{
    for (const ExportFormatFacts& facts : formats) {
        if (name == QLatin1String(facts.name))
            return facts.format;
    }
    return std::nullopt;
}

std::optional<ExportFormat> exportFormatOfFile(const QString& file)
{
    for (const ExportFormatFacts& facts : formats) {
        if (endsIn(file, facts.ending) || endsIn(file, facts.otherEnding))
            return facts.format;
    }
    return std::nullopt;
}

QStringList exportFormatNames()
{
    QStringList names;
    for (const ExportFormatFacts& facts : formats)
        names += QLatin1String(facts.name);
    return names;
}

Clause exportNameObstacle(ExportFormat format, const QString& file)
{
    const ExportFormatFacts& facts = factsOf(format);
    if (facts.anyEnding || endsIn(file, facts.ending) || endsIn(file, facts.otherEnding))
        return {};
    if (format == ExportFormat::Nifti)
        return Clause::saying("the name of a NIfTI file ends in .nii or .nii.gz");
    return Clause::saying(
        "the name of a file in this format ends in %1", QLatin1String(facts.ending));
}

} // namespace core
