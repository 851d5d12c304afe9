// SPDX-License-Identifier: Apache-2.0
#include "tests/benchmarks/pacing/PacedHand.h"

#include "core/session/EditSession.h"
#include "tests/benchmarks/pacing/PacingRecorder.h"
#include "ui/input/Tool.h"
#include "ui/views/ViewGrid.h"
#include "ui/window/MainWindow.h"

#include <QAbstractButton>
#include <QAction>
#include <QCoreApplication>
#include <QMouseEvent>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>

namespace bench {

namespace {

constexpr int tickMs = 16; ///< a mouse at 60 Hz
constexpr int repeatMs = 33; ///< a key that is held
constexpr int patienceMs = 2000;
constexpr double secondsOfStroke = 3.0;
constexpr int ticksOfSlice = 2; ///< 30 slices a second

/// As if the window system had sent it.
void post(ui::ImageView& view, QEvent::Type type, const QPointF& at)
{
    const bool move = type == QEvent::MouseMove;
    const bool up = type == QEvent::MouseButtonRelease;
    QCoreApplication::postEvent(&view,
        new QMouseEvent(type, at, view.mapToGlobal(at), move ? Qt::NoButton : Qt::LeftButton,
            up ? Qt::NoButton : Qt::LeftButton, Qt::NoModifier));
}

void post(QObject& object, const char* slot)
{
    QMetaObject::invokeMethod(&object, slot, Qt::QueuedConnection);
}

} // namespace

PacedHand::PacedHand(ui::MainWindow& window, PacingRecorder& recorder)
    : m_window(window)
    , m_recorder(recorder)
    , m_step(window.findChild<QAbstractButton*>(QStringLiteral("growStep")))
{
    if (!m_step)
        qFatal("the window has no button for a step of growth");
    m_tick.setTimerType(Qt::PreciseTimer);
    m_tick.setInterval(tickMs);
    m_tick.callOnTimeout([this] { tick(); });
}

void PacedHand::work(double secondsOfEach)
{
    m_seconds = secondsOfEach;
    m_rowsAtFirst = std::size_t(m_window.workspace().session()->history().position());
    begin(Phase::Orbit);
    m_tick.start();
    m_loop.exec();
}

void PacedHand::begin(Phase phase)
{
    m_phase = phase;
    m_ticks = 0;
    m_stroke = 0;
    m_undoes = true;
    m_seenThen = 0;
    m_sinceBegin.start();
    m_sinceAsked.start();
    ui::VolumeView& volume = m_window.views().volume();
    const auto take = [this](const QString& icon) {
        ui::Tool* taken = nullptr;
        for (ui::Tool* tool : m_window.findChildren<ui::Tool*>()) {
            if (tool->iconName() == icon)
                taken = tool;
        }
        m_window.workspace().setActiveTool(taken);
    };
    switch (phase) {
    case Phase::Orbit:
        take({});
        m_recorder.beginPhase(QStringLiteral("orbit"), volume);
        break;
    case Phase::Drill:
        take(QStringLiteral("drill"));
        m_recorder.beginPhase(QStringLiteral("drill"), volume);
        break;
    case Phase::Grow:
        take({});
        m_recorder.beginPhase(QStringLiteral("grow"), volume);
        break;
    case Phase::Scrub:
        m_recorder.beginPhase(QStringLiteral("scrub"), m_window.views().axial());
        break;
    case Phase::Undo:
        m_recorder.beginPhase(QStringLiteral("undo"), volume);
        break;
    }
}

void PacedHand::end()
{
    release();
    if (m_phase != Phase::Undo)
        return begin(Phase(int(m_phase) + 1));
    m_tick.stop();
    m_loop.quit();
}

void PacedHand::tick()
{
    const double seconds = 1e-9 * double(m_sinceBegin.nsecsElapsed());
    if (seconds >= m_seconds)
        return end();
    ++m_ticks;
    switch (m_phase) {
    case Phase::Orbit:
        return moveOn(seconds);
    case Phase::Drill:
        return drill(seconds);
    case Phase::Grow:
        return grow();
    case Phase::Scrub:
        return scrub();
    case Phase::Undo:
        return undoOrRedo(seconds);
    }
}

/// Round and round with the button down.
void PacedHand::moveOn(double seconds)
{
    ui::VolumeView& view = m_window.views().volume();
    const double reach = 0.2 * std::min(view.width(), view.height());
    m_at = QPointF(0.5 * view.width(), 0.5 * view.height())
        + reach * QPointF(std::cos(1.8 * seconds), std::sin(1.3 * seconds));
    if (!m_held)
        return press(view, m_at);
    post(view, QEvent::MouseMove, m_at);
}

/// The same in strokes, so that there are steps.
void PacedHand::drill(double seconds)
{
    if (m_held && int(seconds / secondsOfStroke) != m_stroke) {
        ++m_stroke;
        return release();
    }
    moveOn(seconds);
}

bool PacedHand::hasSeen()
{
    const int seen = m_recorder.picturesOf(m_window.views().volume());
    const qint64 waited = m_sinceAsked.elapsed();
    if (waited < repeatMs || (seen == m_seenThen && waited < patienceMs))
        return false;
    m_seenThen = seen;
    m_sinceAsked.start();
    return true;
}

void PacedHand::grow()
{
    if (hasSeen())
        post(*m_step, "click");
}

/// There and back, never as far as the end, where slices would not follow.
void PacedHand::scrub()
{
    ui::SliceView& view = m_window.views().axial();
    if (m_ticks == 1)
        view.goToSlice(view.sliceCount() / 2);
    if (m_ticks % ticksOfSlice != 0)
        return;
    const int reach = std::max(1, std::min(40, view.sliceCount() / 2 - 2));
    const bool there = (m_ticks / ticksOfSlice) / reach % 2 == 0;
    const QPointF at(0.5 * view.width(), 0.5 * view.height());
    QCoreApplication::postEvent(&view,
        new QWheelEvent(at, view.mapToGlobal(at), {}, {0, there ? -120 : 120}, Qt::NoButton,
            Qt::NoModifier, Qt::NoScrollPhase, false));
}

/// Back in the first half, forth in the second; at either end it turns sooner.
void PacedHand::undoOrRedo(double seconds)
{
    if (!hasSeen())
        return;
    const core::History& history = m_window.workspace().session()->history();
    const auto position = std::size_t(history.position());
    if (position <= m_rowsAtFirst)
        m_undoes = false;
    else if (position >= history.rows().size())
        m_undoes = true;
    else if (m_undoes && seconds > 0.5 * m_seconds)
        m_undoes = false;
    const QString action = m_undoes ? QStringLiteral("edit.undo") : QStringLiteral("edit.redo");
    post(m_window.actionTable()[action], "trigger");
}

void PacedHand::press(ui::ImageView& view, const QPointF& at)
{
    m_held = &view;
    post(view, QEvent::MouseButtonPress, at);
}

void PacedHand::release()
{
    if (m_held)
        post(*m_held, QEvent::MouseButtonRelease, m_at);
    m_held = nullptr;
}

} // namespace bench
