// SPDX-License-Identifier: Apache-2.0
#include "ui/menus/InterpolationEntries.h"

#include "ui/workspace/Workspace.h"

#include <QActionGroup>
#include <QMenu>

namespace ui {

const std::vector<InterpolationEntry>& interpolationEntries()
{
    using gpu::Interpolation;
    static const std::vector<InterpolationEntry> entries{
        {"view.interpolationUsual", QObject::tr("As usual: linear, the cutting plane cubic"),
            std::nullopt},
        {"view.interpolationNearest", QObject::tr("Nearest voxel, as acquired"),
            Interpolation::Nearest},
        {"view.interpolationLinear", QObject::tr("Linear"), Interpolation::Linear},
        {"view.interpolationCubic", QObject::tr("Cubic, once nothing moves"), Interpolation::Cubic},
    };
    return entries;
}

void interpolate(Workspace& workspace, std::optional<gpu::Interpolation> interpolation)
{
    Workspace::ViewOptions options = workspace.viewOptions();
    options.interpolation = interpolation;
    workspace.setViewOptions(options);
}

void addInterpolations(QMenu& menu, Workspace& workspace)
{
    QMenu* ways = menu.addMenu(QObject::tr("Interpolation of slices"));
    ways->setObjectName(QStringLiteral("interpolationOfSlices"));
    auto* onlyOne = new QActionGroup(ways);
    for (const InterpolationEntry& each : interpolationEntries()) {
        QAction* action = ways->addAction(each.text, &workspace,
            [&workspace, &each] { interpolate(workspace, each.interpolation); });
        action->setCheckable(true);
        action->setChecked(each.interpolation == workspace.viewOptions().interpolation);
        onlyOne->addAction(action);
        if (!each.interpolation)
            ways->addSeparator();
    }
}

} // namespace ui
