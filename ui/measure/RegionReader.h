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

/// Reads the values in a region, one region at a time. The engine reads the voxels in portions; a
/// background thread chooses those that lie in the region and counts their values. GUI thread.
class RegionReader : public QObject {
    Q_OBJECT

public:
    struct Found {
        core::MeasuredSize size;
        core::RegionTally tally; ///< of all voxels that lie in the region
        std::optional<core::Error> error; ///< none: the region was read completely
    };

    explicit RegionReader(Workspace& workspace, QObject* parent = nullptr);

    /// Starts to read a region or probe; one that is still being read is dropped.
    /// @param done is called later on this thread, when busy() is false again
    void read(const core::Measurement& measurement, std::function<void(const Found&)> done);
    /// Drops the region that is being read; @p done is not called. Call it before the session
    /// closes.
    void drop();
    [[nodiscard]] bool busy() const { return m_job != nullptr; }

private:
    struct Job;
    void readOn(const std::shared_ptr<Job>& job);
    void count(const std::shared_ptr<Job>& job, std::function<void()> does);
    void finish(std::optional<core::Error> error);

    Workspace& m_workspace;
    std::shared_ptr<Job> m_job; ///< null: nothing is being read
    core::Background m_background; ///< last: it uses all of the above
};

} // namespace ui
