// SPDX-License-Identifier: Apache-2.0
#include "ui/SessionSaver.h"

#include "ui/SessionOffers.h"
#include "ui/Workspace.h"

#include <QDir>
#include <QEventLoop>
#include <QFileDialog>
#include <QFileInfo>
#include <QPointer>
#include <QSettings>

#include <optional>
#include <utility>

namespace ui {

namespace {

const QLatin1String folderKey("sessions/folder");

/// A name for people: the series, or the study's file or folder.
QString suggestedName(const core::Volume& volume)
{
    QString name = volume.identity.seriesDescription;
    if (name.isEmpty())
        name = QFileInfo(volume.sourcePath).completeBaseName();
    for (const QChar forbidden : QStringLiteral("/\\:*?\"<>|"))
        name.replace(forbidden, u'_');
    return (name.trimmed().isEmpty() ? QStringLiteral("session") : name.trimmed())
        + QStringLiteral(".burin");
}

} // namespace

SessionSaver::SessionSaver(Workspace& workspace, QWidget& window)
    : QObject(&window)
    , m_workspace(workspace)
    , m_window(window)
{
}

void SessionSaver::ask()
{
    const QString target = chooseTarget();
    if (!target.isEmpty())
        save(target);
}

bool SessionSaver::askAndWait()
{
    const QString target = chooseTarget();
    if (target.isEmpty())
        return false;
    QEventLoop loop;
    std::optional<bool> result;
    save(target, [&loop, &result](bool saved) {
        result = saved;
        loop.quit();
    });
    if (!result)
        loop.exec(QEventLoop::ExcludeUserInputEvents);
    return result.value_or(false);
}

QString SessionSaver::chooseTarget()
{
    const core::Volume* volume = m_workspace.volume();
    if (!volume)
        return {};
    const QString folder = QSettings().value(folderKey, QDir::homePath()).toString();
    QFileDialog dialog(
        &m_window, tr("Save session as"), folder, tr("Sessions of Burin (*.burin);;All files (*)"));
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    dialog.setDefaultSuffix(QStringLiteral("burin"));
    dialog.selectFile(suggestedName(*volume));
    if (dialog.exec() != QDialog::Accepted || dialog.selectedFiles().isEmpty())
        return {};
    const QString target = dialog.selectedFiles().constFirst();
    QSettings().setValue(folderKey, QFileInfo(target).absolutePath());
    return target;
}

void SessionSaver::save(const QString& target, std::function<void(bool)> done)
{
    core::EditSession* session = m_workspace.session();
    if (!session)
        return;
    const QString before = session->file();
    const bool wasReadOnly = !session->whyReadOnly().isEmpty();
    m_workspace.say(tr("Saving the session …"));
    // It may outlive whoever asked.
    const QPointer<Workspace> workspace(&m_workspace);
    const auto tell = [workspace, before, wasReadOnly, target, done = std::move(done)](
                          const core::Result<void>& saved) {
        if (workspace && saved) {
            workspace->tellSaved(wasReadOnly ? QString() : before, target);
            workspace->say(tr("The session is saved and goes on in %1").arg(target));
        } else if (workspace) {
            workspace->fail(saved.error());
        }
        if (done)
            done(saved.has_value());
    };
    QObject* receiver = &m_workspace;
    session->saveAs(target, true, [receiver, tell](const core::Result<void>& saved) {
        QMetaObject::invokeMethod(
            receiver, [tell, saved] { tell(saved); }, Qt::QueuedConnection);
    });
}

} // namespace ui
