// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Background.h"
#include "core/brick/VoxelRuns.h"
#include "core/export/common/SegmentStatistics.h"
#include "ui/tasks/LabelFetch.h"

#include <QObject>
#include <QTimer>

#include <cstdint>
#include <map>
#include <memory>
#include <vector>

namespace ui {

class Workspace;

/// Keeps the statistics of all segments up to date while they are shown. They are the same numbers
/// that an export writes (core/export/common/SegmentMeter.h). A short time after the last change,
/// and when no edit is under way, the engine reads the voxels and a background thread measures
/// them. Only segments whose voxels have changed are measured. GUI thread.
class LiveStatistics : public QObject {
    Q_OBJECT

public:
    explicit LiveStatistics(Workspace& workspace, QObject* parent = nullptr);

    /// Sets whether they are shown. Otherwise nothing is read; changes up to then are measured when
    /// they are shown again.
    void setWatched(bool watched);
    /// The latest statistics of a segment; null if it was not measured yet or has no voxels.
    [[nodiscard]] const core::SegmentStatistics* of(int label) const;
    /// Whether the segment has voxels and its statistics are missing or older than its last change.
    [[nodiscard]] bool isBehind(int label) const;
    /// Whether segments are being measured or are about to be.
    [[nodiscard]] bool isLooking() const { return m_timer.isActive() || m_job != nullptr; }
    /// How many segments were measured since construction, counting repetitions.
    [[nodiscard]] std::int64_t measuredSegments() const { return m_measuredSegments; }

Q_SIGNALS:
    void changed();
    void failed(const core::Error& error);

private:
    struct Known {
        std::shared_ptr<const core::VoxelRuns> voxels; ///< the voxels that were measured
        core::SegmentStatistics statistics;
        bool behind = false;
    };
    struct Job;

    void forget();
    void stop();
    void later();
    void follow(const core::DocumentChange& change);
    void noteCounts();
    void look();
    void takeLabels(const LabelFetch::Planes& planes);
    void beginNext();
    void askForCodes();
    void count(const core::VoxelBox& box, std::vector<std::uint16_t> codes);
    void measure();
    void fail(const core::Error& error);

    Workspace& m_workspace;
    bool m_watched = false;
    std::map<int, Known> m_known; ///< by label
    std::int64_t m_measuredSegments = 0;
    QTimer m_timer; ///< delay after the last change
    LabelFetch m_fetch;
    std::shared_ptr<Job> m_job; ///< null: nothing is being measured
    core::Background m_background; ///< last: it uses all of the above
};

} // namespace ui
