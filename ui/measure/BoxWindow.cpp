// SPDX-License-Identifier: Apache-2.0
#include "ui/measure/BoxWindow.h"

#include "ui/workspace/Workspace.h"

namespace ui {

BoxWindow::BoxWindow(Workspace& workspace, QObject* parent)
    : QObject(parent)
    , m_workspace(workspace)
    , m_reader(workspace)
{
    connect(&workspace, &Workspace::sessionClosing, this, [this] { m_reader.drop(); });
    connect(&workspace, &Workspace::sessionChanged, this, [this] { m_reader.drop(); });
}

void BoxWindow::setFrom(const core::Measurement& box)
{
    m_reader.read(box, [this](const RegionReader::Found& found) { take(found); });
}

void BoxWindow::take(const RegionReader::Found& found)
{
    if (found.error)
        return m_workspace.fail(*found.error);
    const core::VoxelEncoding& encoding = m_workspace.volume()->encoding;
    // Additions by code; the voxels are counted.
    const auto black = found.tally.percentile(blackPercent, encoding);
    const auto white = found.tally.percentile(whitePercent, encoding);
    if (!black || !white)
        return m_workspace.say(tr("No voxel of the study has its middle in the box."));
    if (*white <= *black)
        return m_workspace.say(
            tr("The values in the box are all the same; the grey scale stays as it is."));
    m_workspace.setWindowLevel({0.5 * (*black + *white), *white - *black});
}

} // namespace ui
