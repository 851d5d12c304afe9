// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/Application.h"
#include "core/edits/Edits.h"
#include "core/session/EditSession.h"
#include "ui/MainWindow.h"

#include <QPixmap>
#include <QTemporaryDir>
#include <QTimer>

#include <functional>
#include <memory>

namespace test {

/// The workstation as `burin open` makes it, with folders and settings of its own, and the small
/// study as a CT series in case/ct.
class ApplicationFixture {
public:
    static constexpr int patience = 120000; ///< ms; only a hang takes that long

    ApplicationFixture();
    /// Once more, as after a restart.
    void start();
    void close() { m_application.reset(); }

    [[nodiscard]] QString path(const char* name) const
    {
        return m_folder.filePath(QLatin1String(name));
    }
    [[nodiscard]] QString folder() const { return m_folder.path(); }
    [[nodiscard]] ui::MainWindow& window() const { return m_application->window(); }
    [[nodiscard]] ui::Workspace& workspace() const { return m_application->workspace(); }
    [[nodiscard]] core::EditSession& session() const { return *workspace().session(); }
    [[nodiscard]] QString bar() const; ///< what the message bar says

    /// A study or a session; waits.
    void open(const QString& what) const;
    void edit(const core::Edit& edit) const;

private:
    QTemporaryDir m_folder;
    std::unique_ptr<app::Application> m_application;
};

/// Calls @p answer with every modal dialog that shows while it lives.
class Dialogs {
public:
    explicit Dialogs(std::function<void(QWidget&)> answer);

private:
    QTimer m_timer;
};

/// The button of that text.
void press(QWidget& dialog, const QString& text);

/// A session with the steps of manyEdits(), closed. @return how many
std::size_t writeSession(const QString& file, const QString& study);

/// Waits for all that was asked of the session so far, and until every view shows a picture of it
/// that is drawn to the end. @return whether that came, without an error of the session
[[nodiscard]] bool waitUntilDrawn(ui::MainWindow& window, ui::Workspace& workspace,
    int patienceMs = ApplicationFixture::patience);

/// For people who want to look: the folder is named by BURIN_SCREENSHOTS.
void look(const QPixmap& picture, const char* name);

} // namespace test
