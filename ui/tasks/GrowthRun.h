// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/kinds/Edit.h"
#include "core/growth/GrowthCommands.h"
#include "ui/tasks/GrowthTurns.h"

#include <QObject>
#include <QTimer>

#include <vector>

namespace ui {

class Workspace;

/// The growth that the user has let run and watches. A burst lasts from its beginning to a pause,
/// an alarm or closure, and is one step of undo. Where segments grow in different intervals it is
/// one burst for each turn (GrowthTurns.h): the next one begins when the one before is a row.
class GrowthRun : public QObject {
    Q_OBJECT

public:
    explicit GrowthRun(Workspace& workspace, QObject* parent = nullptr);

    /// Also between two turns.
    [[nodiscard]] bool running() const { return m_running; }

    /// Begins with the first of the turns.
    /// @param generationsPerSecond 0: as fast as it goes
    void begin(std::vector<GrowthTurn> turns, double generationsPerSecond);
    /// Goes on with the criteria of the growth before, as a single burst.
    void resume();
    /// Goes on after an alarm: with the segments that raised it, which need not be the active one,
    /// and the turns after them.
    void goOn();
    /// Ends the burst where it is, and drops the turns that have not begun.
    void pause();
    /// Forgets everything, because another study was opened.
    void forget();

Q_SIGNALS:
    void begun(); ///< a burst
    void changed(); ///< it has begun, gone on or ended
    void alarmed(const core::LeakAlarm& alarm); ///< which has ended it
    /// Nothing is left within the interval, of the last turn either.
    /// @param last that turn; after resume() it names no segments
    void completed(const GrowthTurn& last);

private:
    bool beginBurst(const core::Edit& growth, double generationsPerSecond);
    void poll();
    void goToNextTurn();
    void finish();

    Workspace& m_workspace;
    QTimer m_watch; ///< only updates what is shown; has no influence on voxels
    bool m_running = false;
    std::vector<GrowthTurn> m_turns; ///< the one that grows, or raised an alarm, and those after it
    bool m_nextTurn = false; ///< the first of them begins as soon as the session is idle
    std::size_t m_mostRows = 0; ///< that there may be when the next turn begins
    double m_pace = 0.0; ///< generations per second; 0: as fast as it goes
};

} // namespace ui
