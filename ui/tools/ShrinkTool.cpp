// SPDX-License-Identifier: Apache-2.0
#include "ui/tools/ShrinkTool.h"

#include "ui/Theme.h"
#include "ui/Workspace.h"

#include <QPainter>

namespace ui {

QString ShrinkTool::name() const
{
    return tr("Shrink");
}

QString ShrinkTool::iconName() const
{
    return QStringLiteral("shrink-here");
}

QString ShrinkTool::hint() const
{
    return tr("Shrink here: sketch over what grew too far; it goes, cut off at its narrowest "
              "passage, and the cut is shut");
}

QString ShrinkTool::target() const
{
    return tr("takes back what grew through here");
}

QString ShrinkTool::keys() const
{
    return tr("Ctrl: only the sketched voxels · %1").arg(SketchTool::keys());
}

void ShrinkTool::commit(const std::vector<glm::ivec3>& voxels)
{
    core::ShrinkAt shrink;
    for (const glm::ivec3& voxel : voxels)
        shrink.pointsLps.push_back(workspace().volume()->geometry.toWorld(glm::dvec3(voxel)));
    shrink.onlyHere = modifiers().testFlag(Qt::ControlModifier);
    if (const auto applied = workspace().session()->apply(shrink); !applied)
        workspace().fail(applied.error());
}

QColor ShrinkTool::colour() const
{
    return theme::caution;
}

QString ShrinkTool::outsideText() const
{
    return tr("Nothing was taken back: the sketch lies outside the volume");
}

QString ShrinkTool::nothingSeenText() const
{
    return tr("Nothing was taken back: nothing is seen under the sketch");
}

} // namespace ui
