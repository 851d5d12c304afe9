// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tests/reenactment/BrushRobot.h"

namespace reenact {

/// Counts what a robot does, and looks at what came of it.
class RobotLog {
public:
    static constexpr double commonError = 2.7; ///< per cent

    RobotLog(RefinementBench& bench, const Truth& truth);

    /// An edit that is an action by itself; where it made things worse it is taken back, which is
    /// another one. @return whether it did any good
    bool act(const core::Edit& edit, const QString& what);
    /// An edit that changes nothing that is seen, and so is never taken back.
    bool prepare(const core::Edit& edit, const QString& what);
    /// Something the user does that is no edit yet: a contour that is drawn.
    void countOne(const QString& what);

    [[nodiscard]] double error() const { return m_error; } ///< of what is seen, per cent
    [[nodiscard]] int actions() const { return m_run.actions; }
    [[nodiscard]] const Mask& seen() const { return m_seen; }
    [[nodiscard]] RobotRun finished();

private:
    QString timed(const core::Edit& edit);
    void note(const QString& what);

    RefinementBench& m_bench;
    const Truth& m_truth;
    RobotRun m_run;
    Mask m_seen;
    double m_error = 0.0;
    double m_plainError = 0.0;
};

} // namespace reenact
