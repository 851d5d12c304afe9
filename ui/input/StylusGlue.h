// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/input/Tool.h"

#include <optional>

class QEvent;

namespace ui {

/// What a mouse or pen event says, in one form for both.
struct PointerReading {
    enum class Phase { Press, Move, Release };

    Phase phase = Phase::Move;
    Qt::MouseButton button = Qt::NoButton; ///< that went down or up; the pen's tip is the left one
    Qt::MouseButtons buttons = Qt::NoButton; ///< held after the event; none: hovering
    bool doubleClick = false; ///< a press shortly after another (mouse only)
    bool pen = false;
    PointerSample sample;

    [[nodiscard]] bool hovering() const { return phase == Phase::Move && buttons == Qt::NoButton; }
};

/// The one place where QMouseEvent and QTabletEvent become PointerSample. One per view.
///
/// Whoever uses a reading accepts the event. Mouse events that the system or Qt makes out of a
/// pen's are swallowed (see isEcho), so nothing is done twice. Time is the event's own, never the
/// clock's.
class StylusGlue {
public:
    /// None for events that are neither mouse nor pen, and for echoes; an echo is accepted here.
    [[nodiscard]] std::optional<PointerReading> read(QEvent& event);

    [[nodiscard]] bool penDown() const { return m_penDown; }
    /// The view lost the pen (hidden, grab taken away).
    void forget() { m_penDown = false; }

private:
    bool m_penDown = false;
};

} // namespace ui
