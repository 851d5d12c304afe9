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

/// Keeps the statistics of the segments up to date while somebody watches: the same as an export
/// writes (core/export/common/SegmentMeter.h). The engine reads the voxels, another thread measures
/// them, when nothing has changed for a moment and no edit is under way. Only segments whose voxels
/// have changed are measured. GUI thread.
class LiveStatistics : public QObject {
    Q_OBJECT

public:
    explicit LiveStatistics(Workspace& workspace, QObject* parent = nullptr);

    /// While nobody watches nothing is asked; what has changed by then is measured afterwards.
    void setWatched(bool watched);
    /// The newest of a segment; null: it was not measured yet, or has no voxels.
    [[nodiscard]] const core::SegmentStatistics* of(int label) const;
    /// Whether a segment has voxels that are not measured, so that of() is none or older.
    [[nodiscard]] bool isBehind(int label) const;
    /// Whether something is being measured, or will be by itself.
    [[nodiscard]] bool isLooking() const { return m_timer.isActive() || m_job != nullptr; }
    /// How many times a segment was measured.
    [[nodiscard]] std::int64_t measuredSegments() const { return m_measuredSegments; }

Q_SIGNALS:
    void changed();
    void failed(const core::Error& error);

private:
    struct Known {
        std::shared_ptr<const core::VoxelRuns> voxels; ///< that were measured
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
    std::shared_ptr<Job> m_job; ///< what is under way; null: nothing
    core::Background m_background; ///< last: it uses all of the above
};

} // namespace ui
