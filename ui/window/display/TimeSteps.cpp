// SPDX-License-Identifier: Apache-2.0
#include "ui/window/display/TimeSteps.h"

#include "core/repair/SeriesRepair.h"
#include "core/session/SessionDisplay.h"
#include "ui/settings/StudyOpener.h"
#include "ui/views/ViewGrid.h"
#include "ui/window/display/DisplayState.h"

#include <QApplication>

#include <utility>

namespace ui {

TimeSteps::TimeSteps(Workspace& workspace, StudyOpener& opener, DisplayState& display,
    ViewGrid& views, QObject* parent)
    : QObject(parent)
    , m_workspace(workspace)
    , m_opener(opener)
    , m_display(display)
    , m_views(views)
{
    connect(&workspace, &Workspace::sessionClosing, this, &TimeSteps::holdPictures);
    connect(&workspace, &Workspace::sessionChanged, this, &TimeSteps::takeAlong);
    connect(&opener, &StudyOpener::finished, this, &TimeSteps::finishOpening);
    connect(&workspace, &Workspace::documentChanged, this, [this] {
        if (m_isPlaying && rows() != m_rowsAtFirst)
            pause();
    });
    m_next.setSingleShot(true);
    connect(&m_next, &QTimer::timeout, this, &TimeSteps::playOn);
}

std::size_t TimeSteps::rows() const
{
    return m_workspace.session() ? m_workspace.session()->history().rows().size() : 0;
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
    m_growth = m_workspace.growSettings();
    m_opener.open(volume.sourcePath, core::withRepair(key, volume.repair));
    m_awaited = key;
    m_awaitedText =
        tr("Opening point %1 of %2").arg(time + 1).arg(volume.alternatives->times.size());
}

void TimeSteps::holdPictures()
{
    // The point before is closed for the one that is awaited: nothing else closes it meanwhile.
    if (!m_awaited.isEmpty())
        m_views.holdPictures(m_awaitedText);
    else if (m_views.holdsPictures())
        m_views.releasePictures(); // one that was never drawn is closed
}

void TimeSteps::play(double pointsPerSecond)
{
    if (!hasPoint(1) && !hasPoint(-1))
        return;
    m_next.setInterval(int(1000.0 / pointsPerSecond));
    m_rowsAtFirst = rows();
    m_next.start();
    if (std::exchange(m_isPlaying, true))
        return;
    Q_EMIT playingChanged(true);
}

void TimeSteps::pause()
{
    m_next.stop();
    if (std::exchange(m_isPlaying, false))
        Q_EMIT playingChanged(false);
}

void TimeSteps::playOn()
{
    if (!hasPoint(1) && !hasPoint(-1))
        return pause();
    // A stroke or a drag is not cut short, and nobody's menu or dialog is taken away.
    if (m_opener.busy() || !m_workspace.session()->idle()
        || QGuiApplication::mouseButtons() != Qt::NoButton || QApplication::activePopupWidget()
        || QApplication::activeModalWidget())
        return m_next.start();
    openPoint(hasPoint(1) ? m_workspace.volume()->alternatives->time + 1 : 0);
}

void TimeSteps::finishOpening()
{
    // What has opened is awaited no more.
    if (std::exchange(m_awaited, {}).isEmpty())
        return;
    pause();
    m_views.releasePictures();
}

void TimeSteps::takeAlong()
{
    const core::Volume* volume = m_workspace.volume();
    if (m_awaited.isEmpty() || (volume && volume->seriesKey != m_awaited))
        pause();
    if (!volume || m_awaited.isEmpty() || volume->seriesKey != m_awaited)
        return;
    m_awaited.clear();
    m_rowsAtFirst = rows();
    if (m_isPlaying)
        m_next.start();
    QJsonObject look = std::exchange(m_look, {});
    const bool isNew = m_workspace.session()->display().kept().isEmpty();
    if (!isNew)
        look.remove(QStringLiteral("volume"));
    m_display.applyLook(look);
    if (!isNew)
        return;
    Workspace::GrowSettings growth = m_workspace.growSettings();
    growth.boxed = m_growth.boxed;
    growth.box = m_growth.box;
    m_workspace.setGrowSettings(growth);
}

} // namespace ui
