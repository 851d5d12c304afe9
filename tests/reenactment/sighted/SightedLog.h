// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/brick/VoxelRuns.h"
#include "tests/reenactment/RefinementBench.h"
#include "tests/reenactment/sighted/Inspection.h"

#include <QStringList>

namespace reenact {

/// What a sighted robot did. How good that was it does not know: who holds the reference may look
/// at what was seen after each action.
struct SightedRun {
    struct Step {
        QString what;
        core::VoxelRuns seen; ///< afterwards
    };
    std::vector<Step> steps; ///< one for each action
    core::VoxelRuns mask; ///< the segment in the end
    int looks = 0; ///< planes that were opened
    double seconds = 0.0; ///< of processors that the edits took

    [[nodiscard]] int actions() const { return int(steps.size()); }
};

/// Counts what a robot does, and looks at what came of it as a user would.
class SightedLog {
public:
    SightedLog(RefinementBench& bench, const Inspection& inspection);

    /// An edit that is an action by itself. Where the contour is farther from what was read than
    /// before, it is taken back, which is another action. @return whether it did any good
    bool act(const core::Edit& edit, const QString& what);
    /// An edit that is not judged by what it changes.
    bool prepare(const core::Edit& edit, const QString& what);
    /// What the user does that is no edit yet: a contour that is drawn.
    void countOne(const QString& what);

    [[nodiscard]] int actions() const { return m_run.actions(); }
    [[nodiscard]] const Mask& seen() const { return m_seen; }
    [[nodiscard]] SightedRun finished(int looks);

private:
    QString timed(const core::Edit& edit);

    RefinementBench& m_bench;
    const Inspection& m_inspection;
    SightedRun m_run;
    Mask m_seen;
};

} // namespace reenact
