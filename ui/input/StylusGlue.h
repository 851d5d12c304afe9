// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/input/Tool.h"

#include <optional>

class QEvent;

namespace ui {

/// A mouse or pen event, in one form for both.
struct PointerReading {
    enum class Phase { Press, Move, Release };

    Phase phase = Phase::Move;
    /// The button that went down or up; the pen's tip is the left one.
    Qt::MouseButton button = Qt::NoButton;
    Qt::MouseButtons buttons = Qt::NoButton; ///< buttons held after the event; none while hovering
    bool doubleClick = false; ///< a press shortly after another (mouse only)
    bool pen = false;
    PointerSample sample;

    [[nodiscard]] bool hovering() const { return phase == Phase::Move && buttons == Qt::NoButton; }
};

/// Converts QMouseEvent and QTabletEvent to PointerSample; the only place that does. One object per
/// view.
///
/// The caller accepts the event if it uses the reading. Mouse events that the system or Qt
/// synthesises from a pen's events are swallowed (see isEcho), so that nothing happens twice. Times
/// are those of the events, never read from a clock.
class StylusGlue {
public:
    /// None for events that are neither mouse nor pen, and for synthesised ones, which are accepted
    /// here.
    [[nodiscard]] std::optional<PointerReading> read(QEvent& event);

    [[nodiscard]] bool penDown() const { return m_penDown; }
    /// To be called when the view loses the pen (it is hidden, or the grab is taken away).
    void forget() { m_penDown = false; }

private:
    bool m_penDown = false;
};

} // namespace ui
