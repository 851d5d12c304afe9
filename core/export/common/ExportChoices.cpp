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
            .chosen = segment.visible && segment.voxels > 0,
            .remarks = {}};
        if (segment.voxels == 0)
            choice.remarks += QStringLiteral("empty");
        if (!segment.visible)
            choice.remarks += QStringLiteral("hidden");
        if (growing.test(segment.label))
            choice.remarks += QStringLiteral("growth not finished");
        if (document.surface && document.surface->isApart()
            && document.surface->segment == segment.label)
            choice.remarks += QStringLiteral("surface not written back");
        if (!segment.code.isSet())
            choice.remarks += QStringLiteral("not coded yet");
        choices.push_back(choice);
    }
    return choices;
}

} // namespace core
