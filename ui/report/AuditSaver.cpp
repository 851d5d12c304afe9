// SPDX-License-Identifier: Apache-2.0
#include "ui/report/AuditSaver.h"

#include "core/base/OnMainThread.h"
#include "core/session/SessionStorage.h"
#include "ui/report/WriteAudit.h"
#include "ui/workspace/Workspace.h"

#include <QFileDialog>
#include <QStandardPaths>

namespace ui {

AuditSaver::AuditSaver(Workspace& workspace, QWidget* window)
    : QObject(window)
    , m_workspace(workspace)
    , m_window(window)
{
}

void AuditSaver::ask()
{
    const QString folder = QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
    QFileDialog dialog(m_window, tr("Audit report"), folder,
        tr("Report to print (*.pdf);;Page for a browser (*.html)"));
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    dialog.setDefaultSuffix(QStringLiteral("pdf"));
    dialog.selectFile(QStringLiteral("audit.pdf"));
    QObject::connect(
        &dialog, &QFileDialog::filterSelected, &dialog, [&dialog](const QString& filter) {
            dialog.setDefaultSuffix(filter.contains(QLatin1String("html")) ? QStringLiteral("html")
                                                                           : QStringLiteral("pdf"));
        });
    if (dialog.exec() == QDialog::Accepted && !dialog.selectedFiles().isEmpty())
        save(dialog.selectedFiles().first());
}

void AuditSaver::save(const QString& path)
{
    core::EditSession* session = m_workspace.session();
    if (!session || m_busy)
        return;
    if (const QString problem = auditNameProblem(path); !problem.isEmpty()) {
        Q_EMIT failed({core::ErrorCode::FileUnwritable, {path, problem}});
        return;
    }
    m_busy = true;
    session->closeGrowth();
    session->storage().audit(
        core::onMainThread(this, [this, path](const core::Result<core::AuditReport>& report) {
            if (report)
                return write(*report, path);
            m_busy = false;
            Q_EMIT failed(report.error());
        }));
}

void AuditSaver::write(const core::AuditReport& report, const QString& path)
{
    m_background.start(
        this, [report, path] { return writeAudit(report, path, true); },
        [this, path](const core::Result<void>& written) {
            m_busy = false;
            if (written)
                Q_EMIT saved(path);
            else
                Q_EMIT failed(written.error());
        });
}

} // namespace ui
