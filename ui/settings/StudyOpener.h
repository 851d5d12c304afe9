// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Background.h"
#include "core/study/StudyLoader.h"
#include "core/volume/Volume.h"
#include "core/volume/encoding/EarlySlice.h"

#include <QObject>

#include <functional>
#include <memory>

namespace core {
struct SessionContents;
}

namespace ui {

/// Finds and loads volumes beside the GUI thread, one job at a time. Opens nothing by guess: where
/// a path holds several volumes or points in time it asks, and where a session's study is gone.
class StudyOpener : public QObject {
    Q_OBJECT

public:
    using QObject::QObject;

    /// A session file ends in sessionLoaded() or what openSession() says, anything else in a
    /// volume.
    ///
    /// @param series a key of StudyListing or a SeriesInstanceUID; empty: the only one there is,
    /// else choiceNeeded() with the study as it was read; spacingNeeded() for pictures without one
    void open(const QString& path, const QString& series = QString());
    /// Opens one volume of a study that was read for a choice.
    void open(const std::shared_ptr<const core::Study>& study, const QString& series);
    /// Checks the session, file untouched, and loads the study that it was made on: from
    /// @p place, or from where it is found (core/sessionfile/SessionStudy.h).
    void openSession(const QString& sessionFile, const QString& place = QString());
    /// Runs any other job that ends in a volume (the demonstration study), with the same progress.
    using Job = std::function<core::Result<core::LoadedVolume>(
        const core::Progress&, const core::EarlySliceListener&)>;
    void run(const QString& path, Job job);
    /// What tells of an outcome, on this thread.
    using Tell = std::function<void()>;
    /// What more an opening takes beside the GUI thread; only while loaded() or sessionLoaded() is
    /// told, by who is told. It is the same opening still: busy(), its first slice stays, and
    /// finished() follows what @p work returns. When called off, that is dropped.
    void goOn(const QString& step, std::function<Tell()> work);
    void cancel();
    /// Cancels and waits, as the destructor does; tells nobody, now or later: the program ends.
    void abandon();
    [[nodiscard]] bool busy() const { return m_task.running(); }

Q_SIGNALS:
    void started(const QString& path);
    void progressed(const QString& step, int done, int total);
    /// The first that there is to see of a volume; whether it will open is not known yet. Not told
    /// of sessions, whose views are to stand where they were left.
    void sliceReady(const std::shared_ptr<const core::EarlySlice>& early);
    void choiceNeeded(const std::shared_ptr<const core::Study>& study);
    /// Pictures that do not say how far apart their voxels are: open() takes @p series with the
    /// spacing behind it (core::withRepair()).
    void spacingNeeded(const std::shared_ptr<const core::Study>& study, const QString& series);
    void loaded(const std::shared_ptr<core::LoadedVolume>& volume, const QString& path);
    /// @p contents is what is sound of the session, and the volume is the one it was made on.
    void sessionLoaded(const std::shared_ptr<core::LoadedVolume>& volume,
        const QString& sessionFile, const std::shared_ptr<const core::SessionContents>& contents);
    /// The session can be opened, but its study is not where it was looked for: somebody must know.
    void sessionStudyNeeded(
        const QString& sessionFile, const QString& format, const core::Error& why);
    void failed(const core::Error& error); ///< not told when cancelled
    /// After any of the above and what goOn() adds, or cancelled.
    void finished();

private:
    void start(const QString& path,
        std::function<Tell(const core::Progress&, const core::EarlySliceListener&)> work);
    void take(const core::Result<Tell>& outcome);

    core::Background::Task m_task; ///< what is under way
    core::Background m_background; ///< last: it uses all of the above
};

} // namespace ui
