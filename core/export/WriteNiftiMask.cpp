// SPDX-License-Identifier: Apache-2.0
#include "core/export/common/LabelMap.h"
#include "core/nifti/NiftiWriter.h"
#include "core/repair/RepairVolume.h"

namespace core {

Result<ReportLines> writeNiftiMask(const QString& path, const Volume& volume,
    const ExportRequest& request, const MaskSelection& selection, ExportReport& report)
{
    const VolumeGeometry& geometry = volume.geometry;
    const auto map = labelMapOf(volume, request, selection, QStringLiteral("NIfTI"), report);
    if (!map)
        return tl::unexpected(map.error());
    const QString names = map->names.join(QStringLiteral(", "));
    const QString repair = repairMade(volume);
    const auto written = writeNiftiAt(path,
        {.geometry = geometry,
            .voxels = map->labels,
            .description = repair.isEmpty()
                ? QStringLiteral("Burin: ") + names
                : QStringLiteral("Burin, repaired %1: %2").arg(repair, names)});
    if (!written)
        return tl::unexpected(written.error());
    if (!written->qform && geometry.shearAngleDegrees() > 0.01)
        report.cautions += ReportSentence{
            ReportCode::TiltInSform, {QString::number(geometry.shearAngleDegrees(), 'f', 2)}};
    return ReportLines{ReportSentence{ReportCode::NiftiLabelMap,
        {geometry.size.x, geometry.size.y, geometry.size.z, inReport(gridName(volume)),
            namesInReport(map->names)}}};
}

} // namespace core
