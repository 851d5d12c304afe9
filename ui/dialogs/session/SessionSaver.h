// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Background.h"

#include <QObject>
#include <QString>

#include <functional>
#include <memory>
#include <optional>

class QWidget;

namespace core {
class StagedFile;
}

namespace ui {

class Workspace;

/// "Save session as …": asks for a file and moves the open session there. The outcome is reported
/// by Workspace::sessionSaved() or Workspace::failed(); the user can go on working meanwhile.
class SessionSaver : public QObject {
    Q_OBJECT

public:
    /// The target file, and whether the study's images are saved in the session.
    struct Choice {
        QString target;
        bool images = false;
    };

    SessionSaver(Workspace& workspace, QWidget& window);

    /// The folder of working sessions: their names were made by the program and are not suggested
    /// for another file.
    void setWorkingFolder(const QString& folder) { m_workingFolder = folder; }

    /// Asks for the file, asks before replacing one, and saves.
    void ask();
    /// The same, and waits for the outcome. It does not offer to save images, because what matters
    /// then are the steps.
    /// @return whether the session was saved
    bool askAndWait();
    /// Saves without asking and replaces an existing session, but no other file. Images that the
    /// session's file does not hold are read from the study again, on another thread; if that is
    /// still going on for an earlier call, it is cancelled.
    void save(const Choice& choice, std::function<void(bool saved)> done = {});
    /// Whether images are being written, which cancel() or closing the session would call off.
    [[nodiscard]] bool saving() const { return m_staging.running(); }
    /// The file that the images are written for while saving().
    [[nodiscard]] const QString& target() const { return m_target; }
    /// Cancels saving and leaves no file behind. Has no effect once the images are written.
    void cancel();

Q_SIGNALS:
    void imagesBegun(const QString& target);
    void imagesProgressed(const QString& step, int done, int total);
    /// The images are written, so that the session goes on with them; or that failed or was
    /// cancelled.
    void imagesEnded(bool written);

private:
    [[nodiscard]] QString suggestedName() const;
    [[nodiscard]] std::optional<Choice> choose(bool offerImages);
    void stage(const Choice& choice, std::function<void(bool saved)> done);
    void goOnIn(const Choice& choice, const std::shared_ptr<core::StagedFile>& staged,
        std::function<void(bool saved)> done);

    Workspace& m_workspace;
    QWidget& m_window;
    QString m_workingFolder;
    core::Background::Task m_staging; ///< the task that writes images
    QString m_target; ///< of that task
    std::function<void(bool saved)> m_done; ///< called when that task has ended
    core::Background m_background; ///< last: it uses all of the above
};

} // namespace ui
