// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Background.h"
#include "core/sessionfile/AuditReport.h"
#include "ui/tasks/LabelFetch.h"

#include <QObject>

class QWidget;

namespace ui {

class Workspace;

/// Writes audit reports of the open session while the user goes on working: the session's file is
/// read on its own thread; the segments are measured and the report is laid out on another. One
/// report at a time.
class AuditSaver : public QObject {
    Q_OBJECT

public:
    AuditSaver(Workspace& workspace, QWidget* window);

    /// Asks for a file and saves.
    void ask();
    /// @param path is replaced if it exists; the user has agreed to that
    void save(const QString& path);

Q_SIGNALS:
    void saved(const QString& path);
    void failed(const core::Error& error);

private:
    struct Measured;

    void audit(const LabelFetch::Planes& planes);
    void write(const core::AuditReport& report, Measured measured);
    void fail(const core::Error& error);

    Workspace& m_workspace;
    QWidget* m_window;
    QString m_path;
    bool m_busy = false;
    LabelFetch m_fetch; ///< of the segments
    core::Background m_background; ///< last: it uses all of the above
};

} // namespace ui
