// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/geometry/ViewContext.h"
#include "ui/input/EveryPointerEvent.h"
#include "ui/input/StylusGlue.h"

#include <QPointer>

#include <optional>

class QKeyEvent;
class QWheelEvent;
class QWidget;

namespace ui {

class Workspace;

/// What a view does with the pointer when no tool takes it; implemented by views, called by
/// ViewPointer.
class PointedView {
public:
    /// What a drag does.
    enum class Gesture { None, Tool, Window, Pan, Zoom, Rotate, Box, Turn, TurnOne };

    [[nodiscard]] virtual ViewContext context() const = 0;
    [[nodiscard]] virtual Gesture gestureFor(
        Qt::MouseButton button, const PointerSample& sample, bool toolWorksHere) const = 0;
    virtual void dragged(Gesture gesture, const QPointF& from, const QPointF& to) = 0;
    /// The button was released after a drag.
    virtual void dragEnded(Gesture) { }
    /// A drag that does something only at its end was given up.
    virtual void dragAbandoned() { }
    /// A left click without a drag and without a tool.
    /// @return whether it has done something
    virtual bool clicked(const QPointF&) { return false; }
    /// A right click without a drag.
    virtual void menuAsked(const QPointF&) { }
    virtual void doubleClicked() = 0;
    /// The pointer has moved with no button down.
    virtual void hovered(const PointerSample&) { }
    virtual void wheelTurned(double steps, const QPointF& at, Qt::KeyboardModifiers modifiers) = 0;
    /// Whether the wheel is the view's with these keys, whatever the tool makes of them.
    [[nodiscard]] virtual bool ownsWheel(Qt::KeyboardModifiers) const { return false; }
    /// What the view shows may have changed.
    virtual void refresh() = 0;

protected:
    ~PointedView() = default;
};

/// Handles the pointer over a view: the left button and the pen belong to the active tool where it
/// works; otherwise, and for the other buttons, the view navigates (UX §4.3).
class ViewPointer {
public:
    /// @param view, widget the same object
    ViewPointer(Workspace& workspace, PointedView& view, QWidget& widget);

    void handle(QEvent& event);
    void turnWheel(QWheelEvent& event);
    /// @return whether the pointer uses the key
    bool pressKey(const QKeyEvent& event);
    bool releaseKey(const QKeyEvent& event);
    /// To be called when keys may be let go elsewhere.
    void forgetKeys();
    void leave();

    void followTool();
    /// The pointer was taken away while a tool was at work, or a drag went on.
    void loseStroke();
    void takeToolAway();
    /// The pen has left without a report that it was lifted.
    void endStrokeWithoutPen();
    /// To be called when the view is hidden.
    void forget();

    /// Where the pointer is over this view; none if it is elsewhere.
    [[nodiscard]] const std::optional<QPointF>& position() const { return m_pointer; }
    [[nodiscard]] bool isAtWork() const { return m_dragging || m_gesture == Gesture::Tool; }
    /// Whether Esc takes back what the pointer draws.
    [[nodiscard]] bool takesEscape() const
    {
        return m_gesture == Gesture::Tool || m_gesture == Gesture::Box;
    }
    /// The active tool if it works in such a view; else null.
    [[nodiscard]] Tool* toolIn(const ViewContext& context) const;

private:
    using Gesture = PointedView::Gesture;
    void pressed(const PointerReading& reading);
    void moved(const PointerReading& reading);
    void released(const PointerReading& reading);
    [[nodiscard]] bool toolWorksHere() const;
    void abandonBox();
    Gesture endGesture();

    Workspace& m_workspace;
    PointedView& m_view;
    QWidget& m_widget;
    StylusGlue m_glue;
    std::optional<EveryPointerEvent> m_everyEvent; ///< while a tool is at work
    PointerSample m_lastSample; ///< of the stroke
    Gesture m_gesture = Gesture::None;
    Qt::MouseButton m_gestureButton = Qt::NoButton;
    QPointF m_pressedAt;
    QPointF m_lastAt;
    std::optional<glm::dvec3> m_crosshairBeforePressLps;
    bool m_dragging = false; ///< the pointer has moved farther than in a click
    bool m_navigateKey = false; ///< Space: the left button navigates with a tool in hand
    bool m_toolIsHere = false; ///< the tool was told of the pointer here, and not yet that it left
    std::optional<QPointF> m_pointer; ///< position over this view
    QPointer<Tool> m_tool; ///< the window may outlive it
};

} // namespace ui
