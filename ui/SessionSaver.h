// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <QString>

#include <functional>

class QWidget;

namespace ui {

class Workspace;

/// "Save session as …": asks for a place and lets the open session go on there. It is told by
/// Workspace::sessionSaved() or Workspace::failed(); the work goes on meanwhile.
class SessionSaver : public QObject {
    Q_OBJECT

public:
    SessionSaver(Workspace& workspace, QWidget& window);

    /// Asks where, asks before a file is replaced, and saves.
    void ask();
    /// The same, and waits until it is done. @return whether it is saved
    bool askAndWait();
    /// Replaces a file that is there.
    void save(const QString& target, std::function<void(bool saved)> done = {});

private:
    [[nodiscard]] QString chooseTarget();

    Workspace& m_workspace;
    QWidget& m_window;
};

} // namespace ui
