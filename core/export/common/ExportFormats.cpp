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
        .title = "DICOM SEG",
        .says = "one object, references the source images"},
    ExportFormatFacts{.format = ExportFormat::DicomSegFractional,
        .name = "dicom-seg-fractional",
        .ending = ".dcm",
        .anyEnding = true,
        .namesSourceImages = true,
        .isSeg = true,
        .title = "DICOM SEG, fractional",
        .says = "how much of each voxel is filled, 0 … 255, where a segment was made of a sculpt "
                "layer; of others every voxel is 0 or 255"},
    ExportFormatFacts{.format = ExportFormat::DicomSegLabelMap,
        .name = "dicom-seg-labelmap",
        .ending = ".dcm",
        .anyEnding = true,
        .namesSourceImages = true,
        .isSeg = true,
        .title = "DICOM SEG, label map",
        .says = "one map for all segments (supplement 243 of 2023): small, but many programs do "
                "not know it yet"},
    ExportFormatFacts{.format = ExportFormat::RtStruct,
        .name = "rtstruct",
        .ending = ".dcm",
        .anyEnding = true,
        .namesSourceImages = true,
        .title = "DICOM RTSTRUCT",
        .says = "closed contours along the borders of the voxels on the source images"},
    ExportFormatFacts{.format = ExportFormat::Nifti,
        .name = "nifti",
        .ending = ".nii.gz",
        .otherEnding = ".nii",
        .title = "NIfTI label map",
        .says = "no patient data"},
    ExportFormatFacts{.format = ExportFormat::SegNrrd,
        .name = "seg-nrrd",
        .ending = ".seg.nrrd",
        .title = "3D Slicer segmentation",
        .says = "names, colours and codes, no patient data"},
    ExportFormatFacts{.format = ExportFormat::Stl,
        .name = "stl",
        .ending = ".stl",
        .isSurface = true,
        .title = "STL surface",
        .says = "closed and smoothed, in mm; all ticked segments in one, which STL cannot keep "
                "apart; no patient data"},
    ExportFormatFacts{.format = ExportFormat::Obj,
        .name = "obj",
        .ending = ".obj",
        .isSurface = true,
        .title = "OBJ surfaces",
        .says = "closed and smoothed, in mm; an object a segment, with name and colour; no patient "
                "data"},
    ExportFormatFacts{.format = ExportFormat::Ply,
        .name = "ply",
        .ending = ".ply",
        .isSurface = true,
        .title = "PLY surfaces",
        .says = "closed and smoothed, in mm; colours and the label of each face; no patient data"},
    ExportFormatFacts{.format = ExportFormat::Gltf,
        .name = "gltf",
        .ending = ".glb",
        .isSurface = true,
        .title = "glTF surfaces",
        .says = "closed and smoothed; a node a segment, with name and colour; no patient data"},
    ExportFormatFacts{.format = ExportFormat::Csv,
        .name = "csv",
        .ending = ".csv",
        .isStatistics = true,
        .title = "Statistics, CSV",
        .says = "a line a segment: volume, place, surface, values; no patient data"},
    ExportFormatFacts{.format = ExportFormat::Json,
        .name = "json",
        .ending = ".json",
        .isStatistics = true,
        .title = "Statistics, JSON",
        .says =
            "the same numbers for programs, with the UIDs of study and series; no patient data"},
    ExportFormatFacts{.format = ExportFormat::Sr,
        .name = "sr",
        .ending = ".dcm",
        .anyEnding = true,
        .namesSourceImages = true,
        .isSeg = true,
        .isStatistics = true,
        .title = "Statistics, DICOM SR",
        .says = "a measurement report (TID 1500); the DICOM SEG that it speaks of is written "
                "beside it"},
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
        "the name of a %1 ends in %2", QLatin1String(facts.title), QLatin1String(facts.ending));
}

} // namespace core
