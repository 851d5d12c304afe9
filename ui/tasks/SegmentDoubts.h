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

/// Searches the active segment in the background for places to look at first
/// (core/doubts/PlacesToLookAt.h). What was found of each segment, and which places the user has
/// seen, is kept until the session closes; it is not saved with the session. GUI thread.
class SegmentDoubts : public QObject {
    Q_OBJECT

public:
    static constexpr std::size_t mostPlaces = 8;

    struct Entry {
        core::DoubtfulPlace place;
        bool seen = false; ///< the user has ticked it
    };
    /// The result of a search of one segment.
    struct Found {
        std::vector<Entry> entries;
        bool editedSince = false; ///< labels were changed after the search
        [[nodiscard]] bool allSeen() const;
    };
    using Mask = std::shared_ptr<const core::VoxelRuns>;

    explicit SegmentDoubts(Workspace& workspace, QObject* parent = nullptr);

    /// Starts a search. A place that was ticked before stays ticked if it is found again.
    /// @param second another mask of the same organ, with which the segment is compared; null: none
    void look(Mask second);
    void abort();
    [[nodiscard]] bool isLooking() const { return m_job != nullptr; }
    /// Whether the search waits for the end of an open edit.
    [[nodiscard]] bool isWaiting() const { return m_waits; }
    /// The result for the active segment; null if it was not searched.
    [[nodiscard]] const Found* found() const;
    /// Sets whether a place of the active segment counts as seen.
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
    /// Tries to read again, after an open edit or a change of labels while they were read.
    QTimer m_again;
    bool m_waits = false;
    std::shared_ptr<Job> m_job; ///< null: no search is running
    std::map<int, Found> m_found; ///< by label
    core::Background m_background; ///< last: it uses all of the above
};

} // namespace ui
