// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/window/SessionOpening.h"
#include "core/base/Result.h"
#include "core/base/files/FollowedFile.h"

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

/// The workstation: creates engine, workspace and window and connects them: which study and session
/// are open, and what becomes of their files. WindowContents.h says what the window contains. One
/// per process, on the GUI thread.
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
    /// Connects to the signals of the window and its session.
    void follow();
    /// Opens a study with its own working session, which is continued or begun.
    void openStudy(const std::shared_ptr<core::LoadedVolume>& loaded, const QString& path);
    /// Opens a session file that the user named.
    void openSession(const std::shared_ptr<core::LoadedVolume>& loaded, const QString& file,
        const std::shared_ptr<const core::SessionContents>& contents);
    /// Makes the session on another thread; @p then is called with the result of take().
    void make(const std::shared_ptr<core::LoadedVolume>& loaded, SessionOpening::Wish wish,
        const std::function<void(const core::Result<void>&)>& then);
    /// Moves an opened session into the window.
    /// @param file that was requested
    /// Errors include Cancelled, also if the session is opened once more (SessionPlan::redo).
    core::Result<void> take(SessionOpening& opening, const QString& file);
    /// Tells the user what must be known about a session that was continued.
    /// @return whether there was anything
    bool showSessionProblem(const SessionOpening& opening, const QString& file);
    /// Tells the user that the opened study already had a session, with the choice to begin a new
    /// one.
    void showThatItGoesOn(const QString& path, const QString& series);
    /// Closes the open session, which is kept and listed on the start page, and opens its study
    /// with a new one.
    void beginAnew(const QString& path, const QString& series);
    /// Closes the old session, because the engine holds one volume at a time. Errors: Cancelled (it
    /// holds steps that are on no disk, and the user keeps it open).
    core::Result<void> makeRoom();
    void showError(const core::Error& error);
    /// Returns the sentence that the images were read from the session file.
    [[nodiscard]] static QString whereImagesAre(
        const core::Error& whyNotFromStudy, const QString& file);
    void showWhyNot(
        const core::Error& error, const QString& file, const QString& path, const QString& series);
    /// Removes the file of a session that was opened and closed without an edit.
    void forgetUnusedSession();
    /// Whether the file of the session that was just closed was made for it and holds only the rows
    /// it began with.
    [[nodiscard]] bool holdsNothingNew() const;
    void followSaved(const QString& before, const QString& now);
    void wake(); ///< any thread
    void poll();

    // Members are destroyed in reverse order, so the engine outlives everything that uses it.
    std::unique_ptr<gpu::GpuEngine> m_engine;
    std::atomic<bool> m_pollQueued = false;
    QString m_sessionFile;
    /// Files whose rows did not reach their hashes when carried out again.
    QSet<QString> m_notRedone;
    bool m_goesOn = false; ///< the open session had steps when it was opened, and no problem
    std::size_t m_rowsWhenOpened = 0; ///< number of rows of that session when it was opened
    QString m_goesOnSentence; ///< the message about it in the bar while it is shown; else empty
    /// For a file that was made for this session: the number of rows it began with. None: the file
    /// stays.
    std::optional<std::size_t> m_rowsAtFirst;
    core::FollowedFile m_made; ///< the file that was opened as m_sessionFile
    std::unique_ptr<ui::Workspace> m_workspace;
    std::unique_ptr<ui::MainWindow> m_window;
};

} // namespace app
