// SPDX-License-Identifier: Apache-2.0
#include "ui/views/ViewPointer.h"

#include "ui/input/RestingTool.h"
#include "ui/input/Tool.h"
#include "ui/workspace/Workspace.h"

#include <QKeyEvent>
#include <QWheelEvent>
#include <QWidget>

#include <algorithm>
#include <cmath>
#include <utility>

namespace ui {

namespace {

constexpr double clickSlackPixels = 4.0;

} // namespace

ViewPointer::ViewPointer(Workspace& workspace, PointedView& view, QWidget& widget)
    : m_workspace(workspace)
    , m_view(view)
    , m_widget(widget)
{
}

Tool* ViewPointer::toolIn(const ViewContext& context) const
{
    return m_tool && !m_navigateKey && m_tool->worksIn(context) ? m_tool.data() : nullptr;
}

void ViewPointer::leave()
{
    m_pointer.reset();
    m_workspace.setPointedLps(std::nullopt);
    takeToolAway();
}

void ViewPointer::forget()
{
    loseStroke();
    m_glue.forget();
}

void ViewPointer::handle(QEvent& event)
{
    const auto reading = m_glue.read(event);
    event.accept();
    if (!reading)
        return;
    if (!m_workspace.volume()) {
        // Pictures stay between two points in time, and so does a drag until its button goes up.
        if (reading->phase == PointerReading::Phase::Release && reading->button == m_gestureButton)
            loseStroke();
        return;
    }
    m_pointer = reading->sample.position;
    if (reading->pen)
        m_workspace.showPressure(reading->sample.pressure);
    switch (reading->phase) {
    case PointerReading::Phase::Press:
        pressed(*reading);
        break;
    case PointerReading::Phase::Move:
        moved(*reading);
        break;
    case PointerReading::Phase::Release:
        released(*reading);
        break;
    }
}

bool ViewPointer::toolWorksHere() const
{
    return m_tool && !m_navigateKey && m_tool->worksIn(m_view.context());
}

void ViewPointer::pressed(const PointerReading& reading)
{
    if (m_gesture != Gesture::None)
        return; // one drag at a time; a second button does not change what the first began
    m_widget.setFocus(Qt::MouseFocusReason);
    if (reading.doubleClick && reading.button == Qt::LeftButton && !toolWorksHere()) {
        // The first of the two clicks was meant for this, not for the crosshair.
        if (m_crosshairBeforePressLps)
            m_workspace.setCrosshairLps(*std::exchange(m_crosshairBeforePressLps, std::nullopt));
        m_view.doubleClicked();
        return;
    }
    m_crosshairBeforePressLps = m_workspace.crosshairLps();
    const bool tools = toolWorksHere() && m_tool->takes(reading.sample, m_view.context());
    m_gesture = m_view.gestureFor(reading.button, reading.sample, tools);
    if (m_navigateKey && reading.button == Qt::LeftButton && m_gesture == Gesture::Window)
        m_gesture = Gesture::Pan;
    m_gestureButton = reading.button;
    m_pressedAt = m_lastAt = reading.sample.position;
    m_dragging = false;
    if (m_gesture == Gesture::Tool) {
        m_everyEvent.emplace();
        m_toolIsHere = true;
        m_lastSample = reading.sample;
        m_workspace.showPressure(reading.sample.pressure);
        m_tool->press(reading.sample, m_view.context());
        m_view.refresh();
    }
}

void ViewPointer::moved(const PointerReading& reading)
{
    const QPointF at = reading.sample.position;
    if (m_gesture == Gesture::Tool) {
        m_lastSample = reading.sample;
        if (m_tool)
            m_tool->drag(reading.sample, m_view.context());
    } else if (m_gesture != Gesture::None) {
        const QPointF way = at - m_pressedAt;
        m_dragging = m_dragging || std::hypot(way.x(), way.y()) > clickSlackPixels;
        if (m_dragging) {
            m_view.dragged(m_gesture, m_lastAt, at);
            m_lastAt = at;
        }
    } else if (reading.hovering()) {
        if (toolWorksHere()) {
            m_toolIsHere = true;
            m_tool->hover(reading.sample, m_view.context());
        }
        m_view.hovered(reading.sample);
    }
    if (m_view.context().isSlice() && m_widget.rect().contains(at.toPoint()))
        m_workspace.setPointedLps(m_view.context().toLps(at));
}

void ViewPointer::released(const PointerReading& reading)
{
    if (m_gesture == Gesture::None || reading.button != m_gestureButton)
        return;
    const bool click = !m_dragging;
    const Gesture gesture = endGesture();
    if (gesture == Gesture::Tool) {
        if (m_tool)
            m_tool->release(reading.sample, m_view.context());
    } else if (!click) {
        m_view.dragEnded(gesture);
    } else if (reading.button == Qt::LeftButton) {
        const bool isDone = m_view.clicked(reading.sample.position);
        if (!isDone && m_tool && !m_navigateKey && !m_tool->worksIn(m_view.context()))
            m_workspace.say(whyToolRests(*m_tool, m_view.context()));
    } else if (reading.button == Qt::RightButton) {
        m_view.menuAsked(reading.sample.position);
    }
    m_view.refresh();
}

void ViewPointer::abandonBox()
{
    m_gesture = Gesture::None;
    m_gestureButton = Qt::NoButton;
    m_dragging = false;
    m_view.dragAbandoned();
}

void ViewPointer::loseStroke()
{
    if (m_gesture == Gesture::Box)
        return abandonBox();
    if (m_gesture == Gesture::None)
        return;
    const Gesture gesture = endGesture();
    m_glue.forget();
    if (gesture != Gesture::Tool)
        m_view.dragEnded(gesture);
    else if (m_tool)
        m_tool->cancel();
    m_view.refresh();
}

void ViewPointer::endStrokeWithoutPen()
{
    if (m_gesture == Gesture::None || !m_glue.penDown())
        return;
    // Lifted so fast that the tablet told of no release: what was drawn was meant.
    const Gesture gesture = endGesture();
    m_glue.forget();
    if (gesture != Gesture::Tool)
        m_view.dragEnded(gesture);
    else if (m_tool)
        m_tool->release(m_lastSample, m_view.context());
    m_view.refresh();
}

/// @return what was going on
ViewPointer::Gesture ViewPointer::endGesture()
{
    m_gestureButton = Qt::NoButton;
    m_dragging = false;
    m_everyEvent.reset();
    return std::exchange(m_gesture, Gesture::None);
}

void ViewPointer::followTool()
{
    // Who pans while taking another tool by its key goes on panning.
    if (m_gesture == Gesture::Tool || m_gesture == Gesture::Box)
        loseStroke();
    // It would go on showing itself here when it is taken again, wherever the pointer is by then.
    takeToolAway();
    if (m_tool)
        QObject::disconnect(m_tool, nullptr, &m_widget, nullptr);
    m_tool = m_workspace.activeTool();
    if (m_tool)
        QObject::connect(
            m_tool, &Tool::overlayChanged, &m_widget, [&widget = m_widget] { widget.update(); });
    m_widget.setCursor(toolWorksHere() ? Qt::CrossCursor : Qt::ArrowCursor);
    m_widget.update();
}

void ViewPointer::turnWheel(QWheelEvent& event)
{
    // Some systems turn a wheel sideways while a key is held.
    const QPoint angle = event.angleDelta();
    const double steps = (angle.y() != 0 ? angle.y() : angle.x()) / 120.0;
    event.accept();
    if (steps == 0.0 || !m_workspace.volume() || m_gesture == Gesture::Tool)
        return;
    const int whole = steps > 0.0 ? std::max(1, int(steps)) : std::min(-1, int(steps));
    // Alt means nothing: window managers keep it to themselves.
    const Qt::KeyboardModifiers keys =
        event.modifiers() & (Qt::ShiftModifier | Qt::ControlModifier);
    const bool deeper = keys == (Qt::ControlModifier | Qt::ShiftModifier);
    const bool turns = keys == Qt::ControlModifier && m_tool && m_tool->turns();
    if (m_view.ownsWheel(event.modifiers()))
        m_view.wheelTurned(steps, event.position(), event.modifiers());
    else if (toolWorksHere() && turns)
        m_tool->turn(whole);
    else if (toolWorksHere() && deeper)
        m_tool->changeDepth(whole);
    else if (toolWorksHere() && (keys & Qt::ShiftModifier))
        m_tool->changeRadius(whole);
    else
        m_view.wheelTurned(steps, event.position(), event.modifiers());
}

void ViewPointer::takeToolAway()
{
    // The mouse may leave here when a pen is over another view already.
    if (m_tool && m_gesture != Gesture::Tool && std::exchange(m_toolIsHere, false))
        m_tool->leave();
}

bool ViewPointer::pressKey(const QKeyEvent& event)
{
    if (event.key() == Qt::Key_Space) {
        // It repeats by itself in a view that one comes to while it is held.
        if (!std::exchange(m_navigateKey, true))
            m_widget.setCursor(Qt::OpenHandCursor);
    } else if (event.key() == Qt::Key_Escape && m_gesture == Gesture::Box) {
        abandonBox();
    } else if (event.key() == Qt::Key_Escape && m_gesture == Gesture::Tool) {
        loseStroke();
    } else if (event.key() == Qt::Key_Escape && m_tool) {
        // What stays open after the pen is lifted: a peel, an outline that is to be drawn.
        m_tool->cancel();
    } else {
        return m_tool && m_tool->pressKey(event.key());
    }
    return true;
}

bool ViewPointer::releaseKey(const QKeyEvent& event)
{
    if (event.key() != Qt::Key_Space || event.isAutoRepeat())
        return false;
    forgetKeys();
    return true;
}

void ViewPointer::forgetKeys()
{
    if (std::exchange(m_navigateKey, false))
        m_widget.setCursor(toolWorksHere() ? Qt::CrossCursor : Qt::ArrowCursor);
}

} // namespace ui
