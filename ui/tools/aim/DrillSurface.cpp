// SPDX-License-Identifier: Apache-2.0
#include "ui/tools/aim/DrillSurface.h"

#include "ui/base/StudyTexts.h"

#include <algorithm>
#include <cmath>

namespace ui {

double drillThreshold(const Workspace::VolumeDisplay& display, const core::Volume& volume)
{
    const auto& points = display.transferFunction.points;
    if (display.mode != gpu::RenderMode::Dvr || points.empty())
        return display.surfaceThreshold;
    double greatest = 0.0;
    for (const auto& point : points)
        greatest = std::max(greatest, point.opacity);
    if (greatest <= 0.0)
        return display.surfaceThreshold;
    const double enough = std::min(1.0 - std::pow(0.5, 1.0 / opaqueMm), greatest / 2.0);
    double value = volume.minimum; // opaque from the first point down
    for (std::size_t i = 1; i < points.size() && points.front().opacity < enough; ++i) {
        const auto& below = points[i - 1];
        const auto& above = points[i];
        if (above.opacity < enough)
            continue;
        const double along = (enough - below.opacity) / (above.opacity - below.opacity);
        value = below.value + (above.value - below.value) * along;
        break;
    }
    return std::clamp(value, volume.minimum, volume.maximum);
}

QString startText(const Workspace& workspace)
{
    const core::Volume& volume = *workspace.volume();
    return QObject::tr("from %1 on")
        .arg(valueText(drillThreshold(workspace.volumeDisplay(), volume), volume.unit,
            volume.maximum - volume.minimum));
}

} // namespace ui
