// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/delta/Ending.h"

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace ui {

class Workspace;

/// Changes the interval of the last growth while the user moves its bounds: the growth follows at
/// once, and it is one step of undo when the bounds are released. If bounds arrive faster than the
/// growth can follow, only the latest ones are used.
class LiveInterval : public QObject {
    Q_OBJECT

public:
    explicit LiveInterval(Workspace& workspace, QObject* parent = nullptr);

    /// Whether there is a growth that can follow.
    [[nodiscard]] bool possible() const;
    /// Whether it is following at present.
    [[nodiscard]] bool follows() const { return m_open; }

    /// @param segments whose growth follows (GrowCriteria::segments); what counts is the first move
    void move(double lower, double upper, const std::optional<std::vector<int>>& segments = {});
    /// To be called when the bounds are released.
    void settle();
    /// Restores the state before the bounds were moved.
    void cancel();

Q_SIGNALS:
    void progressed();

private:
    void send(bool atOnce);
    void poll();
    void close();
    void end(core::Ending ending);

    Workspace& m_workspace;
    /// Bounds that were not sent to the session yet.
    std::optional<std::pair<double, double>> m_wanted;
    std::optional<std::vector<int>> m_segments;
    bool m_open = false;
    QTimer m_watch; ///< decides only which bounds are skipped, never the result
    QElapsedTimer m_sinceSent;
};

} // namespace ui
