// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"
#include "core/delta/Ending.h"
#include "core/growth/GrowthCommands.h"

#include <QElapsedTimer>
#include <QObject>
#include <QString>
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
///
/// Meanwhile every view marks what the bounds suspend and what they reach
/// (VoxelQuestions::compareGrowth()). The engine finds that out; this class asks it, one question
/// at a time, and puts the answer into words. What is suspended stays marked after the release if
/// the 3D view shows it (ViewOptions::suspendedBodies).
class LiveInterval : public QObject {
    Q_OBJECT

public:
    explicit LiveInterval(Workspace& workspace, QObject* parent = nullptr);

    /// Whether there is a growth that can follow.
    [[nodiscard]] bool possible() const;
    /// Whether it is following at present.
    [[nodiscard]] bool follows() const { return m_open; }
    /// What the bounds have changed since they were moved: "− 12.3 mL suspended, + 0.4 mL". It ends
    /// with "…" while that is not all. Empty while nothing follows or nothing is known yet.
    [[nodiscard]] QString words() const;
    /// The latest answer; none if there was none yet.
    [[nodiscard]] const std::optional<core::GrowthComparison>& comparison() const
    {
        return m_comparison;
    }

    /// @param segments whose growth follows (GrowCriteria::segments); only the first move of a drag
    ///     sets them
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
    void compare();
    /// @param asked the bounds that it was asked about, by number
    /// @param arrived whether the growth had come to rest in them
    void take(const core::Result<std::optional<core::GrowthComparison>>& comparison, int asked,
        bool arrived);
    void close();
    void end(core::Ending ending);

    Workspace& m_workspace;
    /// Bounds that were not sent to the session yet.
    std::optional<std::pair<double, double>> m_wanted;
    std::optional<std::vector<int>> m_segments;
    bool m_open = false;
    QTimer m_watch; ///< decides only which bounds are skipped, never the result
    QElapsedTimer m_sinceSent;

    std::optional<core::GrowthComparison> m_comparison;
    int m_drag = 0; ///< number of the present drag
    bool m_asking = false;
    int m_sent = 0; ///< how many bounds were sent to the session
    int m_answered = 0; ///< the bounds of the latest answer, by number
    bool m_isWhole = false; ///< whether that answer is final for these bounds
    QElapsedTimer m_sinceAsked;
};

} // namespace ui
