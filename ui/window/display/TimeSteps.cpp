// SPDX-License-Identifier: Apache-2.0
#include "ui/window/display/TimeSteps.h"

#include "core/repair/SeriesRepair.h"
#include "core/session/SessionDisplay.h"
#include "ui/settings/StudyOpener.h"
#include "ui/window/display/DisplayState.h"

#include <utility>

namespace ui {

TimeSteps::TimeSteps(
    Workspace& workspace, StudyOpener& opener, DisplayState& display, QObject* parent)
    : QObject(parent)
    , m_workspace(workspace)
    , m_opener(opener)
    , m_display(display)
{
    connect(&workspace, &Workspace::sessionChanged, this, &TimeSteps::takeAlong);
    connect(&opener, &StudyOpener::finished, this, [this] { m_awaited.clear(); });
}

bool TimeSteps::hasPoint(int later) const
{
    const core::Volume* volume = m_workspace.volume();
    if (!volume || !volume->alternatives)
        return false;
    const int time = volume->alternatives->time + later;
    return time >= 0 && time < int(volume->alternatives->times.size());
}

void TimeSteps::go(int later)
{
    if (hasPoint(later))
        openPoint(m_workspace.volume()->alternatives->time + later);
}

void TimeSteps::openPoint(int time)
{
    if (m_opener.busy())
        return;
    const core::Volume& volume = *m_workspace.volume();
    const QString& series = volume.alternatives->key;
    const QString key = time == 0 ? series : QStringLiteral("%1@%2").arg(series).arg(time + 1);
    m_look = m_display.composed();
    m_opener.open(volume.sourcePath, core::withRepair(key, volume.repair));
    m_awaited = key;
}

void TimeSteps::takeAlong()
{
    const core::Volume* volume = m_workspace.volume();
    if (!volume || m_awaited.isEmpty() || volume->seriesKey != m_awaited)
        return;
    m_awaited.clear();
    QJsonObject look = std::exchange(m_look, {});
    if (!m_workspace.session()->display().kept().isEmpty())
        look.remove(QStringLiteral("volume"));
    m_display.applyLook(look);
}

} // namespace ui
