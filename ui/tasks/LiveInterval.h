// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/delta/Ending.h"

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

#include <cstddef>
#include <optional>
#include <utility>

namespace ui {

class Workspace;

/// Gives the growth that was made last another interval while the user moves its bounds: it follows
/// at once, and is one step of undo when the bounds are let go. Bounds that come while the growth
/// is still following are left out but for the last.
class LiveInterval : public QObject {
    Q_OBJECT

public:
    explicit LiveInterval(Workspace& workspace, QObject* parent = nullptr);

    /// Whether something has grown that can follow.
    [[nodiscard]] bool possible() const;
    /// It follows at present.
    [[nodiscard]] bool follows() const { return m_open; }

    void move(double lower, double upper);
    /// The bounds were let go.
    void settle();
    /// As if they had never been moved.
    void cancel();

Q_SIGNALS:
    void progressed();
    /// Undo, redo or a walk through the history brought back a growth with other bounds.
    void returned(double lower, double upper);

private:
    void send(bool atOnce);
    void poll();
    void close();
    void end(core::Ending ending);
    void followHistory();

    Workspace& m_workspace;
    std::optional<std::pair<double, double>> m_wanted; ///< not told to the session yet
    std::optional<std::pair<double, double>> m_stands; ///< of the growth at the history's position
    std::size_t m_rows = 0; ///< of the history, when it was looked at last
    bool m_open = false;
    QTimer m_watch; ///< decides what is left out, never what comes of it
    QElapsedTimer m_sinceSent;
};

} // namespace ui
