// SPDX-License-Identifier: Apache-2.0
#include "ui/tools/sculpt/LaserTool.h"

#include "core/edits/kinds/sculpt/DrillStroke.h"
#include "core/edits/kinds/sculpt/LaserStroke.h"
#include "ui/tools/sculpt/DrillOptions.h"

namespace ui {

QString LaserTool::name() const
{
    return tr("Laser");
}

QString LaserTool::iconName() const
{
    return QStringLiteral("laser");
}

QString LaserTool::hint() const
{
    if (drawing().isWanted())
        return drawing().hint();
    return tr("Laser: press on the surface; it cuts along the surface's normal, Ctrl or the eraser "
              "end restores");
}

QWidget* LaserTool::createOptions(QWidget* parent)
{
    return connected(new DrillOptions(workspace(), DrillOptions::Of::Laser, parent));
}

core::Edit LaserTool::editIn(const ViewContext& view, bool restore) const
{
    const core::DrillStroke drill = strokeIn(view, restore);
    core::LaserStroke laser;
    laser.layer = drill.layer;
    laser.view = drill.view;
    laser.mask = drill.mask;
    laser.mode = drill.mode;
    laser.depthMm = workspace().drillSettings().laserDepthMm;
    laser.floorMm = drill.floorMm;
    laser.pressureExponent = drill.pressureExponent;
    laser.surfaceThreshold = drill.surfaceThreshold;
    laser.throughGaps = drill.throughGaps;
    laser.restore = restore;
    laser.byTime = true;
    laser.hidden = drill.hidden;
    return laser;
}

double& LaserTool::depthIn(Workspace::DrillSettings& settings) const
{
    return settings.laserDepthMm;
}

} // namespace ui
