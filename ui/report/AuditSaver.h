// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Background.h"
#include "core/sessionfile/AuditReport.h"

#include <QObject>

class QWidget;

namespace ui {

class Workspace;

/// Writes audit reports of the open session beside the window's work: the session's file is read on
/// its own thread, the report is laid out on another. One at a time.
class AuditSaver : public QObject {
    Q_OBJECT

public:
    AuditSaver(Workspace& workspace, QWidget* window);

    /// Asks where to.
    void ask();
    /// @param path replaced if it is there: whoever chose it was asked
    void save(const QString& path);

Q_SIGNALS:
    void saved(const QString& path);
    void failed(const core::Error& error);

private:
    void write(const core::AuditReport& report, const QString& path);

    Workspace& m_workspace;
    QWidget* m_window;
    bool m_busy = false;
    core::Background m_background; ///< last: it uses all of the above
};

} // namespace ui
