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

/// "Save session as …": asks for a place and lets the open session go on there. It is told by
/// Workspace::sessionSaved() or Workspace::failed(); the work goes on meanwhile.
class SessionSaver : public QObject {
    Q_OBJECT

public:
    /// Where to, and whether the study's images go with the session.
    struct Choice {
        QString target;
        bool images = false;
    };

    SessionSaver(Workspace& workspace, QWidget& window);

    /// Sessions in this folder were named by the program: that name is not suggested for another.
    void setWorkingFolder(const QString& folder) { m_workingFolder = folder; }

    /// Asks where, asks before a file is replaced, and saves.
    void ask();
    /// The same, and waits until it is done; steps are what matters then, so that images are not
    /// asked about. @return whether it is saved
    bool askAndWait();
    /// Replaces a file that is there. Images that the session's file does not hold are read from
    /// the study once more, beside the GUI thread.
    void save(const Choice& choice, std::function<void(bool saved)> done = {});
    /// Nothing is saved and nothing is left; too late once the images are written.
    void cancel();

Q_SIGNALS:
    void imagesBegun(const QString& target);
    void imagesProgressed(const QString& step, int done, int total);
    void imagesEnded(); ///< written, failed or cancelled

private:
    [[nodiscard]] QString suggestedName() const;
    [[nodiscard]] std::optional<Choice> choose(bool offerImages);
    void stage(const Choice& choice, std::function<void(bool saved)> done);
    void goOnIn(const Choice& choice, const std::shared_ptr<core::StagedFile>& staged,
        std::function<void(bool saved)> done);

    Workspace& m_workspace;
    QWidget& m_window;
    QString m_workingFolder;
    core::Background::Task m_staging; ///< of images
    std::function<void(bool saved)> m_done; ///< told when that has ended
    core::Background m_background; ///< last: it uses all of the above
};

} // namespace ui
