// SPDX-License-Identifier: Apache-2.0
#include "ui/tools/sculpt/CarveBrushTool.h"

#include "core/edits/engine/HalfSpaces.h"
#include "core/edits/kinds/parts/BrushPath.h"
#include "core/edits/kinds/sculpt/BrushStroke.h"
#include "ui/tools/aim/CursorLabel.h"
#include "ui/tools/common/BrushOptions.h"
#include "ui/workspace/LayerActions.h"

#include <algorithm>

namespace ui {

CarveBrushTool::CarveBrushTool(Workspace& workspace, QObject* parent)
    : BrushTool(workspace, Workspace::Brush::Carve, parent)
{
}

QString CarveBrushTool::name() const
{
    return tr("Carve");
}

QString CarveBrushTool::iconName() const
{
    return QStringLiteral("carve");
}

QString CarveBrushTool::hint() const
{
    return tr("Carve brush: draw in the 3D view or on a slice; Ctrl or the eraser end restores");
}

QString CarveBrushTool::keys() const
{
    return tr("[ ] radius · Ctrl restores · Esc cancels");
}

QWidget* CarveBrushTool::createOptions(QWidget* parent)
{
    return new BrushOptions(workspace(), Workspace::Brush::Carve, parent);
}

QString CarveBrushTool::action(bool inverted) const
{
    return carvingTarget(workspace(), inverted);
}

QColor CarveBrushTool::colour() const
{
    return toolColour();
}

BrushTool::StrokeMaker CarveBrushTool::strokeMaker(bool inverted, const ViewContext& view)
{
    core::BrushStroke stroke;
    stroke.layer = workspace().activeLayer();
    stroke.restore = inverted;
    if (const auto* scene = std::get_if<gpu::VolumeScene>(&view.scene))
        stroke.hidden = core::clipHalfSpaces(scene->clip, workspace().volume()->geometry);
    return [stroke](const core::BrushPath& path) -> core::Result<core::Edit> {
        core::BrushStroke made = stroke;
        made.path = path;
        return core::Edit(made);
    };
}

double CarveBrushTool::reachMm() const
{
    // The edge of a cut is soft, and radiation blurs it by three voxels.
    const glm::dvec3 spacing = workspace().volume()->geometry.spacingMm();
    return settings().radiusMm + 5.0 * std::max({spacing.x, spacing.y, spacing.z});
}

} // namespace ui
