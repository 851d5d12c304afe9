// SPDX-License-Identifier: Apache-2.0
#include "ui/tools/contour/ContourTexts.h"

#include "core/contour/ContourTrack.h"
#include "core/document/Document.h"
#include "ui/base/StudyTexts.h"
#include "ui/settings/growth/GrowSettings.h"
#include "ui/tools/contour/ContourTool.h"

namespace ui {

QString contourHint(ContourSettings::Start start)
{
    using Start = ContourSettings::Start;
    switch (start) {
    case Start::Segment:
        return ContourTool::tr("Contour: click a slice and accept what the segment evolves to; "
                               "Ctrl or the eraser end erases from all around it");
    case Start::Seeds:
        return ContourTool::tr("Contour: click a slice and accept what evolves from the sketched "
                               "seeds; Ctrl or the eraser end erases");
    case Start::Bubbles:
        return ContourTool::tr("Contour: each click on a slice adds a bubble; accept what evolves "
                               "from them. Ctrl or the eraser end erases");
    case Start::Bubble:
        break;
    }
    return ContourTool::tr("Contour: click a bubble on a slice, more of them with Shift, and "
                           "accept what evolves; Ctrl or the eraser end erases");
}

QString contourTarget(const core::Segment* segment, bool erases, bool fromBubbles)
{
    if (!segment)
        return erases      ? ContourTool::tr("no segment to erase")
            : !fromBubbles ? ContourTool::tr("no segment to begin with")
                           : ContourTool::tr("fills a new segment");
    return (segment->locked ? ContourTool::tr("%1 is locked")
            : erases        ? ContourTool::tr("erases %1")
                            : ContourTool::tr("evolves %1"))
        .arg(segment->name);
}

QString nothingToEvolveText(bool erases, bool fromBubbles)
{
    return !erases     ? ContourTool::tr("The segment has no voxels to begin with: click a bubble "
                                             "instead")
        : !fromBubbles ? ContourTool::tr("The segment has no voxels to erase")
                       : ContourTool::tr("The segment has no voxels in the bubble");
}

QString contourText(const core::ContourTrack& track, const core::Volume& volume, bool erases)
{
    if (erases)
        return ContourTool::tr("generation %1 · erases %2")
            .arg(QString::number(track.shown()), volumeText(volume, track.lost()));
    return ContourTool::tr("generation %1 · +%2, −%3")
        .arg(QString::number(track.shown()), volumeText(volume, track.gained()),
            volumeText(volume, track.lost()));
}

QString contourInterval(const GrowSettings& growth, const core::Volume& volume)
{
    const double span = volume.maximum - volume.minimum;
    return ContourTool::tr("%1 … %2").arg(
        valueText(growth.lower, {}, span), valueText(growth.upper, volume.unit, span));
}

} // namespace ui
