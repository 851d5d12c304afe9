// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/Application.h"
#include "core/session/EditSession.h"
#include "ui/MainWindow.h"
#include "ui/Workspace.h"

#include <QTemporaryDir>

#include <functional>
#include <memory>
#include <vector>

class QPixmap;

namespace test {

/// The real window for pictures of the manual: with settings and sessions of its own, drawn to the
/// end before anything is kept. Pictures go to the folder that BURIN_SCREENSHOTS names.
class ManualWindow {
protected:
    /// Skips the test where nobody wants pictures.
    void wantPictures();
    /// A new window of the usual size.
    void start();

    [[nodiscard]] ui::MainWindow& window() { return m_application->window(); }
    [[nodiscard]] ui::Workspace& workspace() { return m_application->workspace(); }
    [[nodiscard]] core::EditSession& session() { return *workspace().session(); }
    [[nodiscard]] static bool wait(const std::function<bool()>& condition);
    [[nodiscard]] bool waitUntilDrawn();
    void apply(const core::Edit& edit);
    template <class T> void take()
    {
        for (QObject* child : window().children()) {
            if (auto* tool = qobject_cast<T*>(child))
                workspace().setActiveTool(tool);
        }
    }
    void foldAllBut(const std::vector<QString>& titles);
    static void save(const QPixmap& picture, const char* name);

    /// A lesion in the demonstration study that a network found, but for a lobe, and with a leak;
    /// a surface around it, green where it is right.
    void openLesion();

    QTemporaryDir m_folder;
    std::unique_ptr<app::Application> m_application;
};

} // namespace test
