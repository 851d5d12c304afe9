// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Background.h"
#include "core/study/StudyLoader.h"
#include "core/volume/Volume.h"
#include "core/volume/encoding/EarlySlice.h"

#include <QObject>
#include <QTimer>

#include <functional>
#include <memory>
#include <optional>
#include <utility>

namespace core {
struct SessionContents;
}

namespace ui {

/// Finds and loads volumes on another thread, one job at a time. It never guesses: it asks if a
/// path holds several volumes or points in time, and if the study of a session is not found.
class StudyOpener : public QObject {
    Q_OBJECT

public:
    explicit StudyOpener(QObject* parent = nullptr);

    /// Holds every outcome back, whatever it is, while @p isBusy is true, and looks again soon: a
    /// dialog may be waiting for an answer about the session that the outcome would close. Without
    /// this function nothing is held back.
    void holdWhile(std::function<bool()> isBusy) { m_holdsWhile = std::move(isBusy); }

    /// Opens a path. A session file leads to sessionLoaded() or to the other signals of
    /// openSession(), anything else to a volume.
    ///
    /// @param series a key of StudyListing or a SeriesInstanceUID. If it is empty and there is a
    /// single series, that one is opened; else choiceNeeded() is emitted with the study as it was
    /// read. spacingNeeded() is emitted for pictures without spacing.
    void open(const QString& path, const QString& series = QString());
    /// Opens one volume of a study that was already read for choiceNeeded().
    void open(const std::shared_ptr<const core::Study>& study, const QString& series);
    /// Checks the session without changing its file, and loads the study on which it was made: from
    /// @p place, or from where it is found (core/sessionfile/SessionStudy.h).
    void openSession(const QString& sessionFile, const QString& place = QString());
    /// Runs any other job that results in a volume (the demonstration study), with the same
    /// progress.
    using Job = std::function<core::Result<core::LoadedVolume>(
        const core::Progress&, const core::EarlySliceListener&)>;
    void run(const QString& path, Job job);
    /// A function that reports an outcome; called on this object's thread.
    using Completion = std::function<void()>;
    /// Continues the opening with more work on the other thread. Call it only while loaded() or
    /// sessionLoaded() is emitted, from a receiver. It still counts as the same opening: busy()
    /// stays true, its first slice stays, and finished() is emitted after what @p work returns was
    /// called. If the opening is cancelled, that is not called.
    void goOn(const QString& step, std::function<Completion()> work);
    void cancel();
    /// Cancels and waits, as the destructor does, and reports nothing, now or later: the program
    /// ends.
    void abandon();
    [[nodiscard]] bool busy() const { return m_task.running() || m_held; }

Q_SIGNALS:
    void started(const QString& path);
    void progressed(const QString& step, int done, int total);
    /// The first slice of a volume that is ready; whether the volume will open is not known yet.
    /// Not emitted for sessions, whose views are restored to where they were.
    void sliceReady(const std::shared_ptr<const core::EarlySlice>& early);
    void choiceNeeded(const std::shared_ptr<const core::Study>& study);
    /// The spacing of pictures is not known: open() takes @p series with the spacing appended
    /// (core::withRepair()).
    void spacingNeeded(const std::shared_ptr<const core::Study>& study, const QString& series);
    void loaded(const std::shared_ptr<core::LoadedVolume>& volume, const QString& path);
    /// @p contents is the sound part of the session; the volume is the one on which it was made.
    void sessionLoaded(const std::shared_ptr<core::LoadedVolume>& volume,
        const QString& sessionFile, const std::shared_ptr<const core::SessionContents>& contents);
    /// The session can be opened, but its study was not found: the user has to say where it is.
    void sessionStudyNeeded(
        const QString& sessionFile, const QString& format, const core::Error& why);
    void failed(const core::Error& error); ///< not emitted after cancelling
    /// After any of the above and the work of goOn(), or after cancelling.
    void finished();

private:
    void start(const QString& path,
        std::function<Completion(const core::Progress&, const core::EarlySliceListener&)> work);
    /// Reports an outcome, or holds it back.
    void take(const core::Result<Completion>& outcome);

    std::function<bool()> m_holdsWhile;
    std::optional<core::Result<Completion>> m_held; ///< an outcome that was not reported yet
    QTimer m_later; ///< looks whether it may be reported now
    core::Background::Task m_task; ///< the running task
    core::Background m_background; ///< last: it uses all of the above
};

} // namespace ui
