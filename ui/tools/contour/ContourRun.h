// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Background.h"
#include "core/contour/ContourWatch.h"
#include "core/edits/kinds/filling/EvolveContour.h"
#include "ui/tasks/LabelFetch.h"

#include <QObject>
#include <QTimer>

#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace ui {

class Workspace;

/// Evolves a contour for viewing, before it becomes an edit. The engine reads the labels and values
/// around it, and a background thread computes its generations ahead of the one that is shown. So
/// it can be played forwards and backwards while nothing in the session changes. If labels or locks
/// of segments change meanwhile, it is read and computed anew. The state of the shown generation is
/// computed in the background, too, one at a time. GUI thread; no call waits or reads voxels.
class ContourRun : public QObject {
    Q_OBJECT

public:
    explicit ContourRun(Workspace& workspace, QObject* parent = nullptr);

    /// Starts at generation 0 and plays; an open growth is committed first. If a contour is open
    /// already, it is computed anew for @p edit and goes to the generation that was shown; the old
    /// one stays visible until then. Voxels are read again only if the edits differ in more than
    /// their rule.
    /// @param edit with the greatest number of generations; segment 0: a new segment, which is not
    /// added before the contour is accepted
    void begin(const core::EvolveContour& edit);
    /// Ends the contour; nothing of it is left.
    void drop();
    [[nodiscard]] bool isOpen() const { return m_edit.has_value(); }
    /// Whether voxels are being read or generations computed.
    [[nodiscard]] bool isWorking() const { return m_isWorking; }
    /// Whether the evolution has ended because nothing changes after the last known generation.
    [[nodiscard]] bool rests() const { return m_end == core::ContourEnd::Rests; }
    /// Whether the evolution has ended because it would take more memory than is allowed.
    [[nodiscard]] bool isOutOfMemory() const { return m_end == core::ContourEnd::OutOfMemory; }

    /// The known generations and which one is shown; null before the first is known.
    [[nodiscard]] const core::ContourTrack* track() const { return m_track.get(); }
    /// The state that views draw; null without a track. While the contour moves it lags a moment
    /// behind the generation that is shown (isInSight()).
    [[nodiscard]] const std::shared_ptr<const core::ContourState>& state() const { return m_state; }
    /// Whether state() is that of the shown generation.
    [[nodiscard]] bool isInSight() const { return m_track && m_stateAt == m_track->shown(); }
    /// The edit that leads to the shown generation, with the segment of begin(). None at generation
    /// 0, unless it is a bubble that rests as it is; before anything is known; or if labels have
    /// changed since.
    [[nodiscard]] std::optional<core::EvolveContour> shownEdit() const;

    /// Stops playing and shows a generation, as soon as it is known.
    void goTo(int generation);
    /// Plays from the shown generation; from the beginning if the end is shown.
    void setPlaying(bool playing);
    [[nodiscard]] bool isPlaying() const { return m_playing.isActive(); }
    /// Sets how long each generation is shown while playing; 60 ms at first.
    void setPace(int milliseconds) { m_playing.setInterval(milliseconds); }
    /// Sets the memory limit of the evolution (watchedContourBytes()); at first what the machine
    /// allows.
    void setMostBytes(double bytes) { m_mostBytes = bytes; }

Q_SIGNALS:
    void changed(); ///< a contour was opened or ended, or more is known, or another is shown
    void stateChanged(); ///< state() is another one
    /// The evolution has ended at the memory limit; the known generations stay.
    void ranOutOfMemory();
    /// The contour was ended because there are no voxels to start from.
    void foundNothing();
    void failed(const core::Error& error); ///< the contour was ended

private:
    struct Reading;
    using Locks = std::vector<std::pair<int, bool>>; ///< segments by label: whether locked

    void stop();
    void read();
    void fetch();
    void takeLabels(const LabelFetch::Planes& planes);
    void askForCodes();
    void join();
    void evolve();
    void takeTrack(const std::shared_ptr<core::ContourTrack>& track,
        const std::shared_ptr<const core::ContourState>& state, const core::EvolveContour& edit);
    void takeGenerations(std::vector<core::ContourGeneration> generations);
    void end(core::ContourEnd how);
    void playOn();
    void show(int generation);
    void bringIntoSight();
    void follow(const core::DocumentChange& change);
    void fail(const core::Error& error);

    Workspace& m_workspace;
    std::optional<core::EvolveContour> m_edit; ///< the latest one requested
    Locks m_locks; ///< at the time of reading
    std::shared_ptr<Reading> m_reading;
    std::shared_ptr<const core::ContourGround> m_ground; ///< what was read; null: nothing
    std::shared_ptr<core::ContourTrack> m_track;
    std::shared_ptr<const core::ContourState> m_state; ///< the state of generation m_stateAt
    int m_stateAt = 0;
    core::EvolveContour m_trackEdit; ///< the edit of m_track
    bool m_trackStands = false; ///< m_track starts from the present labels
    int m_wanted = 0; ///< the generation to be shown
    bool m_isWorking = false;
    std::optional<core::ContourEnd> m_end; ///< how the evolution ended; none: it has not
    double m_mostBytes;
    QTimer m_playing;
    QTimer m_again; ///< tries to read until the session is idle
    LabelFetch m_fetch;
    core::Background m_background; ///< evolves; declared late, since it uses all of the above
    core::Background m_showing; ///< computes states; likewise
};

} // namespace ui
