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

/// A contour that evolves before it is an edit: labels and values around it are read from the
/// engine, and another thread works out its generations, ahead of the one that is shown. So it runs
/// forwards and backwards like a growth that is played, and nothing of the session changes. When
/// labels change meanwhile it is worked out anew. GUI thread; never waits, and reads no voxels: a
/// state of what is shown is worked out beside it, too, one at a time.
class ContourRun : public QObject {
    Q_OBJECT

public:
    explicit ContourRun(Workspace& workspace, QObject* parent = nullptr);

    /// Begins at generation 0 and plays; a growth that stands open is committed first. While one is
    /// open it is worked out anew with this edit and comes to the generation that was shown, which
    /// stays in sight until then; only what has changed is read again.
    /// @param edit with the greatest number of generations. Segment 0: a new one, which nobody has
    /// made yet
    void begin(const core::EvolveContour& edit);
    /// Leaves nothing.
    void drop();
    [[nodiscard]] bool isOpen() const { return m_edit.has_value(); }
    /// Whether generations are being worked out, or what they need is read.
    [[nodiscard]] bool isWorking() const { return m_isWorking; }
    /// Whether nothing changes any more after the last generation that is known.
    [[nodiscard]] bool rests() const { return m_end == core::ContourEnd::Rests; }
    /// Whether it does not go on because that would take more memory than is allowed.
    [[nodiscard]] bool isOutOfMemory() const { return m_end == core::ContourEnd::OutOfMemory; }

    /// The generations, and which one is shown; null before the first is known.
    [[nodiscard]] const core::ContourTrack* track() const { return m_track.get(); }
    /// What is in sight; null without a track. While it moves, this is a moment behind the
    /// generation that is shown (isInSight()).
    [[nodiscard]] const std::shared_ptr<const core::ContourState>& state() const { return m_state; }
    [[nodiscard]] bool isInSight() const { return m_track && m_stateAt == m_track->shown(); }
    /// The edit that makes what is shown; none: there is nothing yet, it is at generation 0, or
    /// labels have changed since. Its segment is that of begin().
    [[nodiscard]] std::optional<core::EvolveContour> shownEdit() const;

    /// Goes there, as soon as it is known, and does not play on.
    void goTo(int generation);
    /// Plays from the generation that is shown; at the end, from the beginning.
    void setPlaying(bool playing);
    [[nodiscard]] bool isPlaying() const { return m_playing.isActive(); }
    /// Milliseconds of a generation that is played; 60 at first.
    void setPace(int milliseconds) { m_playing.setInterval(milliseconds); }
    /// Of what is watched (watchedContourBytes()); at first what the machine allows.
    void setMostBytes(double bytes) { m_mostBytes = bytes; }

Q_SIGNALS:
    void changed(); ///< what is open, shown or known
    void stateChanged(); ///< another one is in sight
    /// It evolves no further, since memory does not allow it; what is known stays.
    void ranOutOfMemory();
    /// There is nothing from which it could begin; it is dropped.
    void foundNothing();
    void failed(const core::Error& error); ///< it is dropped

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
    std::optional<core::EvolveContour> m_edit; ///< the latest that is wanted
    Locks m_locks; ///< under which it was read
    std::shared_ptr<Reading> m_reading;
    std::shared_ptr<const core::ContourGround> m_ground; ///< with codes; null: not read
    std::shared_ptr<core::ContourTrack> m_track;
    std::shared_ptr<const core::ContourState> m_state; ///< at one of its generations
    int m_stateAt = 0;
    core::EvolveContour m_trackEdit; ///< to which they belong
    bool m_trackStands = false; ///< it begins with the labels that there are
    int m_wanted = 0; ///< the generation that is to be shown
    bool m_isWorking = false;
    std::optional<core::ContourEnd> m_end; ///< of what is known; none: not yet
    double m_mostBytes;
    QTimer m_playing;
    QTimer m_again; ///< reads when the session is at rest
    LabelFetch m_fetch;
    core::Background m_background; ///< evolves; it uses all of the above
    core::Background m_showing; ///< works out states; likewise
};

} // namespace ui
