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

/// What the pointer does to a view where no tool takes it.
class PointedView {
public:
    /// What a drag does.
    enum class Gesture { None, Tool, Window, Pan, Zoom, Rotate };

    [[nodiscard]] virtual ViewContext context() const = 0;
    [[nodiscard]] virtual Gesture gestureFor(Qt::MouseButton button, bool toolWorksHere) const = 0;
    virtual void dragged(Gesture gesture, const QPointF& from, const QPointF& to) = 0;
    /// A left click without a drag and without a tool.
    virtual void clicked(const QPointF&) { }
    virtual void doubleClicked() = 0;
    /// Moved with no button down.
    virtual void hovered(const PointerSample&) { }
    virtual void wheelTurned(double steps, const QPointF& at, Qt::KeyboardModifiers modifiers) = 0;
    /// What it shows may have changed.
    virtual void refresh() = 0;

protected:
    ~PointedView() = default;
};

/// The pointer over a view: the left button and the pen belong to the active tool where it works;
/// otherwise, and for the other buttons, the view navigates (UX §4.3).
class ViewPointer {
public:
    /// @param view, widget the same
    ViewPointer(Workspace& workspace, PointedView& view, QWidget& widget);

    void handle(QEvent& event);
    void turnWheel(QWheelEvent& event);
    /// @return whether the key is the pointer's
    bool pressKey(const QKeyEvent& event);
    bool releaseKey(const QKeyEvent& event);
    void leave();

    void followTool();
    /// The pointer was taken away while a tool was at work.
    void loseStroke();
    void takeToolAway();
    void endStrokeWithoutPen();
    /// The view is hidden.
    void forget();

    /// Over this view.
    [[nodiscard]] const std::optional<QPointF>& position() const { return m_pointer; }
    [[nodiscard]] bool isAtWork() const { return m_dragging || m_gesture == Gesture::Tool; }
    /// That works in such a view; null: none does.
    [[nodiscard]] Tool* toolIn(const ViewContext& context) const;

private:
    using Gesture = PointedView::Gesture;
    void pressed(const PointerReading& reading);
    void moved(const PointerReading& reading);
    void released(const PointerReading& reading);
    [[nodiscard]] bool toolWorksHere() const;

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
    bool m_dragging = false; ///< moved farther than a click does
    bool m_navigateKey = false; ///< Space: the left button navigates with a tool in hand
    bool m_toolIsHere = false; ///< it was told of the pointer here, and not that it left
    std::optional<QPointF> m_pointer; ///< over this view
    QPointer<Tool> m_tool; ///< the window may outlive it
};

} // namespace ui
