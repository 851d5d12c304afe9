// SPDX-License-Identifier: Apache-2.0
#include "ui/tools/growth/BarrierTool.h"

#include "core/edits/kinds/growth/BarrierStroke.h"
#include "core/edits/kinds/parts/BrushPath.h"
#include "core/edits/kinds/parts/GrowthPlane.h"
#include "ui/tools/common/BrushOptions.h"

namespace ui {

BarrierTool::BarrierTool(Workspace& workspace, QObject* parent)
    : BrushTool(workspace, Workspace::Brush::Barrier, parent)
{
}

QString BarrierTool::name() const
{
    return tr("Barrier");
}

QString BarrierTool::iconName() const
{
    return QStringLiteral("barrier");
}

QString BarrierTool::hint() const
{
    return tr("Barrier: draw where growth must not pass; Ctrl or the eraser end opens it again");
}

QString BarrierTool::keys() const
{
    return tr("[ ] radius · Ctrl opens · Esc cancels");
}

QWidget* BarrierTool::createOptions(QWidget* parent)
{
    return new BrushOptions(workspace(), Workspace::Brush::Barrier, parent);
}

QString BarrierTool::action(bool inverted) const
{
    if (!workspace().session())
        return {};
    return inverted ? tr("opens to growth") : tr("shuts to growth");
}

QColor BarrierTool::colour() const
{
    return {237, 64, 92}; // as slices show it (gpu/render/slice.frag)
}

BrushTool::StrokeMaker BarrierTool::strokeMaker(bool inverted, const ViewContext&)
{
    return [inverted, plane = core::namedPlane(workspace().growthPlane())](
               const core::BrushPath& path) -> core::Result<core::Edit> {
        return core::Edit(core::BarrierStroke{.path = path, .erase = inverted, .plane = plane});
    };
}

} // namespace ui
