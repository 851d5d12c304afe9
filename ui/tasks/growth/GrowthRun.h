// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/kinds/Edit.h"
#include "core/growth/GrowthCommands.h"
#include "ui/tasks/growth/GrowthTurns.h"

#include <QObject>
#include <QTimer>

#include <cstdint>
#include <vector>

namespace ui {

class Workspace;

/// Runs a growth that the user watches. A burst lasts from its start to a pause, a leak alarm or
/// closure, and is one step of undo. If segments grow in different intervals there is one burst for
/// each turn (GrowthTurns.h); the next begins when the one before has become a row of the history.
/// GUI thread.
class GrowthRun : public QObject {
    Q_OBJECT

public:
    explicit GrowthRun(Workspace& workspace, QObject* parent = nullptr);

    /// Whether a growth is running or the next turn is about to begin.
    [[nodiscard]] bool running() const { return m_running; }

    /// Begins the first turn; the others follow by themselves.
    /// @param generationsPerSecond pace; 0: as fast as possible
    void begin(std::vector<GrowthTurn> turns, double generationsPerSecond);
    /// Continues the last growth with the same criteria, as a single burst.
    void resume();
    /// Continues after a leak alarm. If the active segment was not in the turn that raised it, that
    /// turn and those after it go on; otherwise the turns are planned anew. A growth that was
    /// resumed is resumed again.
    /// @param plane the label plane of the growth; another one than the active segment's goes on by
    ///     the criteria of its last growth
    void goOn(std::uint8_t plane);
    /// To be called when an alarm was rejected, or when there is one that no burst has raised:
    /// goOn() plans anew then. Has no effect while a growth runs.
    void forgetAlarm();
    /// Ends the burst at its present generation and drops the turns that have not begun.
    void pause();
    /// To be called when another session is opened.
    void forget();

Q_SIGNALS:
    void begun(); ///< a burst has begun
    void changed(); ///< a burst has begun, made progress or ended
    /// A leak alarm has ended the burst, which is no row yet.
    /// @param burst the segments that grew in it, and where
    void alarmed(const core::LeakAlarm& alarm, const GrowthTurn& burst);
    /// All turns have reached closure: nothing is left to grow within the intervals.
    /// @param last the last turn; after resume() it names no segments
    void completed(const GrowthTurn& last);

private:
    void dropTurns();
    bool resumeIn(std::uint8_t plane);
    [[nodiscard]] core::Edit resumed(std::uint8_t plane) const;
    bool beginBurst(const core::Edit& growth, double generationsPerSecond);
    void poll();
    void goToNextTurn();
    void finish();
    [[nodiscard]] bool isOpen() const;
    [[nodiscard]] GrowthTurn openBurst() const;

    Workspace& m_workspace;
    QTimer m_watch; ///< reads the progress; has no influence on voxels
    bool m_running = false;
    /// The turn that grows or raised an alarm, then those after it.
    std::vector<GrowthTurn> m_turns;
    bool m_resumed = false; ///< the last burst was a resumed growth, which has no turns
    bool m_nextTurn = false; ///< m_turns.front() begins as soon as the session is idle
    /// Rows that the history may have then; more mean that the user did something else.
    std::size_t m_mostRows = 0;
    double m_pace = 0.0; ///< generations per second; 0: as fast as it goes
};

} // namespace ui
