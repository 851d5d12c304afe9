// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"
#include "ui/tasks/BackgroundJob.h"

#include <QDialog>

#include <memory>

class QPushButton;
class QTemporaryDir;

namespace ui {

class DeidentifyBox;
class ExportRun;
class TargetRow;
class Workspace;

/// "Save de-identified session as …": saves a copy of the open session for others, without data
/// about the patient or the user (core/sessionfile/DeidentifySession.h). The open session stays
/// where it is. The copy is made on another thread.
class DeidentifySessionDialog : public QDialog {
    Q_OBJECT

public:
    explicit DeidentifySessionDialog(Workspace& workspace, QWidget* parent = nullptr);

    [[nodiscard]] bool running() const { return m_waits || m_job.running(); }

Q_SIGNALS:
    void saved(const QString& file);

private:
    void showState();
    void start();
    void write(const QString& target, bool replaces, const std::shared_ptr<QTemporaryDir>& folder);
    void showRunning();
    void showFailure(const core::Error& error);
    void reject() override;

    Workspace& m_workspace;
    DeidentifyBox* m_options;
    TargetRow* m_target;
    QPushButton* m_save;
    ExportRun* m_run;
    bool m_waits = false; ///< until the session's last steps are on the disk
    BackgroundJob m_job;
};

} // namespace ui
