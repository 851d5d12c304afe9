// SPDX-License-Identifier: Apache-2.0
#include "core/export/common/LabelMap.h"
#include "core/nifti/NiftiWriter.h"

namespace core {

Result<QStringList> writeNiftiMask(const QString& path, const Volume& volume,
    const ExportRequest& request, const MaskSelection& selection, ExportReport& report)
{
    const VolumeGeometry& geometry = volume.geometry;
    const auto map = labelMapOf(volume, request, selection, QStringLiteral("NIfTI"), report);
    if (!map)
        return tl::unexpected(map.error());
    const QString names = map->names.join(QStringLiteral(", "));
    const auto written = writeNiftiAt(path,
        {.geometry = geometry,
            .voxels = map->labels,
            .description = volume.repair.isEmpty()
                ? QStringLiteral("Burin: ") + names
                : QStringLiteral("Burin, repaired %1: %2").arg(volume.repair, names)});
    if (!written)
        return tl::unexpected(written.error());
    if (!written->qform && geometry.shearAngleDegrees() > 0.01)
        report.cautions +=
            QStringLiteral("The slices are tilted by %1°: only the sform says so, and "
                           "some programs refuse such files.")
                .arg(geometry.shearAngleDegrees(), 0, 'f', 2);
    return QStringList{QStringLiteral("NIfTI label map, %1 × %2 × %3, on %4: %5.")
                           .arg(geometry.size.x)
                           .arg(geometry.size.y)
                           .arg(geometry.size.z)
                           .arg(gridName(volume), names)};
}

} // namespace core
