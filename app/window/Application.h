// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/window/SessionOpening.h"
#include "core/base/Result.h"

#include <QObject>
#include <QSet>

#include <atomic>
#include <functional>
#include <memory>
#include <optional>

namespace ui {
class MainWindow;
class Workspace;
} // namespace ui

namespace app {

/// The workstation: engine, workspace and window, wired. One per process, on the GUI thread.
class Application : public QObject {
    Q_OBJECT

public:
    /// Starts the engine and makes the window (not shown yet). Errors: GraphicsUnavailable.
    static core::Result<std::unique_ptr<Application>> create();
    ~Application() override;

    [[nodiscard]] ui::MainWindow& window() { return *m_window; }
    [[nodiscard]] ui::Workspace& workspace() { return *m_workspace; }

    /// The demonstration study, written once into the user's cache folder and opened from there.
    void openDemonstration();

private:
    explicit Application(std::unique_ptr<gpu::GpuEngine> engine);
    void makeWindow();
    void addDoctor();
    void addExport();
    /// The study's own working session: continued, or begun.
    void openStudy(const std::shared_ptr<core::LoadedVolume>& loaded, const QString& path);
    /// A session file that somebody named.
    void openSession(const std::shared_ptr<core::LoadedVolume>& loaded, const QString& file,
        const std::shared_ptr<const core::SessionContents>& contents);
    /// Beside the GUI thread; @p then hears how take() ended.
    void make(const std::shared_ptr<core::LoadedVolume>& loaded, SessionOpening::Wish wish,
        const std::function<void(const core::Result<void>&)>& then);
    /// Into the window. @p file that was asked for. Cancelled also where it is opened once more
    /// (SessionPlan::redo).
    core::Result<void> take(SessionOpening& opening, const QString& file);
    /// What is to be known of a session that was gone on with. @return whether anything had to be
    /// told
    bool tellOfSession(const SessionOpening& opening, const QString& file);
    /// A study was opened that has a session already: the user sees what came of it, and may begin
    /// anew.
    void tellThatItGoesOn(const QString& path, const QString& series);
    /// The open session is closed and put beside, to be found on the start page; its study opens
    /// with a new one.
    void beginAnew(const QString& path, const QString& series);
    /// The engine holds one volume at a time: the old session closes its file first. Errors:
    /// Cancelled (it holds steps that are on no disk, and the user stays with them).
    core::Result<void> makeRoom();
    void tell(const core::Error& error);
    /// That the images come out of the session file.
    void tellWhereImagesAre(const core::Error& whyNotFromStudy, const QString& file);
    void tellWhyNot(
        const core::Error& error, const QString& file, const QString& path, const QString& series);
    /// A session that was opened and closed without an edit leaves no file.
    void forgetUnusedSession();
    void followSaved(const QString& before, const QString& now);
    void wake(); ///< any thread
    void poll();

    // The engine outlives whoever borrows it: members go in reverse order.
    std::unique_ptr<gpu::GpuEngine> m_engine;
    std::atomic<bool> m_pollQueued = false;
    QString m_sessionFile;
    QSet<QString> m_notRedone; ///< files whose rows did not come to their hashes again
    bool m_goesOn = false; ///< the open session had steps when it was opened, and nothing was amiss
    std::size_t m_rowsWhenOpened = 0; ///< of that session
    QString m_goesOnSentence; ///< that the bar says of it, while it does; empty: nothing
    /// Of a file that was made for this session: how many rows it began with. None: it stays.
    std::optional<std::size_t> m_rowsAtFirst;
    std::unique_ptr<ui::Workspace> m_workspace;
    std::unique_ptr<ui::MainWindow> m_window;
};

} // namespace app
