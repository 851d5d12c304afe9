// SPDX-License-Identifier: Apache-2.0
#include "core/export/ExportFormats.h"

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
        .title = "DICOM SEG",
        .says = "one object, references the source images"},
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

QString exportNameObstacle(ExportFormat format, const QString& file)
{
    const ExportFormatFacts& facts = factsOf(format);
    if (facts.anyEnding || endsIn(file, facts.ending) || endsIn(file, facts.otherEnding))
        return {};
    if (format == ExportFormat::Nifti)
        return QStringLiteral("the name of a NIfTI file ends in .nii or .nii.gz");
    return QStringLiteral("the name of a %1 ends in %2")
        .arg(QLatin1String(facts.title), QLatin1String(facts.ending));
}

} // namespace core
