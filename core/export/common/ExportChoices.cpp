// SPDX-License-Identifier: Apache-2.0
#include "core/export/common/ExportChoices.h"

namespace core {

std::vector<ExportChoice> exportChoices(const Document& document, const std::bitset<256>& growing)
{
    const double voxelMm3 =
        document.volumes.empty() ? 0.0 : document.volumes.front().geometry.voxelVolumeMm3();
    std::vector<ExportChoice> choices;
    for (const Segment& segment : document.segments) {
        ExportChoice choice{.segment = segment,
            .millilitres = double(segment.voxels) * voxelMm3 / 1000.0,
            .chosen = segment.visible && segment.voxels > 0};
        if (segment.voxels == 0)
            choice.remarks.push_back(ExportRemark::Empty);
        if (!segment.visible)
            choice.remarks.push_back(ExportRemark::Hidden);
        if (growing.test(segment.label))
            choice.remarks.push_back(ExportRemark::GrowthNotFinished);
        if (document.surface && document.surface->isApart()
            && document.surface->segment == segment.label)
            choice.remarks.push_back(ExportRemark::SurfaceNotWrittenBack);
        if (!segment.code.isSet())
            choice.remarks.push_back(ExportRemark::NotCoded);
        choices.push_back(choice);
    }
    return choices;
}

} // namespace core
