// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Background.h"
#include "core/measure/MeasuredSize.h"
#include "core/measure/region/RegionStatistics.h"

#include <QObject>

#include <functional>
#include <memory>
#include <optional>

namespace ui {

class Workspace;

/// Reads the values in one region after the other: the engine reads the voxels, another thread
/// chooses and counts them.
class RegionReader : public QObject {
    Q_OBJECT

public:
    struct Found {
        core::MeasuredSize size;
        core::RegionTally tally; ///< of all voxels that lie in the region
        std::optional<core::Error> error; ///< why it was not read to its end
    };

    explicit RegionReader(Workspace& workspace, QObject* parent = nullptr);

    /// Begins with a region or a probe, and drops the one before.
    /// @param done called later, on this thread, when busy() is false again
    void read(const core::Measurement& measurement, std::function<void(const Found&)> done);
    /// To be called before the session closes. Nothing is reported then.
    void drop();
    [[nodiscard]] bool busy() const { return m_job != nullptr; }

private:
    struct Job;
    void readOn(const std::shared_ptr<Job>& job);
    void count(const std::shared_ptr<Job>& job, std::function<void()> does);
    void finish(std::optional<core::Error> error);

    Workspace& m_workspace;
    std::shared_ptr<Job> m_job; ///< what is under way; null: nothing
    core::Background m_background; ///< last: it uses all of the above
};

} // namespace ui
