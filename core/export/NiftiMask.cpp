// SPDX-License-Identifier: Apache-2.0
#include "core/export/MaskSelection.h"
#include "core/nifti/NiftiWriter.h"

#include <algorithm>
#include <bitset>

namespace core {

namespace {

/// A slice step that strays further than this share of itself cannot be called even in NIfTI.
constexpr double unevenLimit = 0.1;

/// How far the slices stray from the affine; 0 for an even stack.
double unevennessMm(const VolumeGeometry& geometry)
{
    double worst = 0.0;
    for (std::size_t k = 0; k < geometry.slicePositions.size(); ++k)
        worst = std::max(worst,
            glm::distance(geometry.slicePositions[k], geometry.toWorld({0.0, 0.0, double(k)})));
    return worst;
}

} // namespace

Result<QStringList> writeNiftiMask(const QString& path, const Volume& volume,
    const ExportRequest& request, const MaskSelection& selection, ExportReport& report)
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

} // namespace core
