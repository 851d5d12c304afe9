// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Background.h"
#include "core/brick/VoxelRuns.h"
#include "core/doubts/DoubtfulPlace.h"
#include "ui/tasks/LabelFetch.h"

#include <QObject>
#include <QTimer>

#include <map>
#include <memory>
#include <vector>

namespace ui {

class Workspace;

/// Finds places of the active segment to look at first (core/doubts/PlacesToLookAt.h), on another
/// thread. What was found of each segment, and which places the user has seen, is kept until the
/// session closes; nothing of it is part of the session. GUI thread.
class SegmentDoubts : public QObject {
    Q_OBJECT

public:
    static constexpr std::size_t mostPlaces = 8;

    struct Entry {
        core::DoubtfulPlace place;
        bool seen = false; ///< the user has ticked it
    };
    /// What was found of a segment.
    struct Found {
        std::vector<Entry> entries;
        bool editedSince = false; ///< voxels of some segment were
        [[nodiscard]] bool allSeen() const;
    };
    using Mask = std::shared_ptr<const core::VoxelRuns>;

    explicit SegmentDoubts(Workspace& workspace, QObject* parent = nullptr);

    /// Starts the search. Of places that are found again, those seen stay seen.
    /// @param second a mask of the same organ with which the segment is compared; null: none
    void look(Mask second);
    void abort();
    [[nodiscard]] bool isLooking() const { return m_job != nullptr; }
    /// Whether the search begins only when the step that stands open is finished.
    [[nodiscard]] bool isWaiting() const { return m_waits; }
    /// What was found of the active segment; null: it has not been searched.
    [[nodiscard]] const Found* found() const;
    /// Ticks a place of the active segment, or takes the tick away.
    void setSeen(std::size_t entry, bool seen);

Q_SIGNALS:
    void changed();
    void failed(const core::Error& error);

private:
    struct Job;
    using Places = std::vector<core::DoubtfulPlace>;

    void forget();
    void fetch();
    void takeLabels(const LabelFetch::Planes& planes);
    void askForCodes();
    void workOut();
    void take(const Places& places);
    void follow(const core::DocumentChange& change);
    void fail(const core::Error& error);

    Workspace& m_workspace;
    LabelFetch m_fetch;
    QTimer m_again; ///< a step stands open, or the labels changed while they were fetched
    bool m_waits = false;
    std::shared_ptr<Job> m_job; ///< what is under way
    std::map<int, Found> m_found; ///< by label
    core::Background m_background; ///< last: it uses all of the above
};

} // namespace ui
