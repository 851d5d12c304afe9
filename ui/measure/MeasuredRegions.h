// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Background.h"
#include "core/measure/region/RegionStatistics.h"

#include <QObject>

#include <functional>
#include <memory>

namespace ui {

class Workspace;

/// Works out what measurements come to, with the values in regions and under probes, one after the
/// other: the engine reads the voxels, another thread chooses and counts them. What is found is
/// handed to the workspace (measured()), where views and panels read it. Since the study never
/// changes, it is kept until the session closes, also while undo has taken a measurement back.
class MeasuredRegions : public QObject {
    Q_OBJECT

public:
    explicit MeasuredRegions(Workspace& workspace, QObject* parent = nullptr);

    /// Whether some are still to be worked out.
    [[nodiscard]] bool busy() const { return m_job != nullptr; }

private:
    struct Job;
    void drop();
    /// Begins with the first that is not known, unless one is under way.
    void lookOn();
    void readOn(const std::shared_ptr<Job>& job);
    void count(const std::shared_ptr<Job>& job, std::function<void()> does);
    void fail(const core::Error& error);

    Workspace& m_workspace;
    std::shared_ptr<Job> m_job; ///< what is under way; null: nothing
    core::Background m_background; ///< last: it uses all of the above
};

} // namespace ui
