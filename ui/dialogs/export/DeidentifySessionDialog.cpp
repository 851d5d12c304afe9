// SPDX-License-Identifier: Apache-2.0
#include "ui/dialogs/export/DeidentifySessionDialog.h"

#include "core/base/OnMainThread.h"
#include "core/export/common/MaskSelection.h"
#include "core/session/EditSession.h"
#include "core/session/SessionStorage.h"
#include "core/sessionfile/DeidentifySession.h"
#include "ui/base/TabOrder.h"
#include "ui/base/Theme.h"
#include "ui/dialogs/export/DeidentifyBox.h"
#include "ui/dialogs/export/ExportRun.h"
#include "ui/dialogs/export/TargetRow.h"
#include "ui/texts/SessionTexts.h"
#include "ui/workspace/Workspace.h"

#include <QDir>
#include <QFileInfo>
#include <QLabel>
#include <QPushButton>
#include <QTemporaryDir>
#include <QVBoxLayout>

#include <functional>
#include <initializer_list>

namespace ui {

namespace {

/// Where the session is copied to; only its owner may look into the folder.
QString copyIn(const QTemporaryDir& folder)
{
    return folder.filePath(QStringLiteral("session.burin"));
}

} // namespace

DeidentifySessionDialog::DeidentifySessionDialog(Workspace& workspace, QWidget* parent)
    : QDialog(parent)
    , m_workspace(workspace)
    , m_options(new DeidentifyBox(this))
    , m_target(new TargetRow(tr("File"), QStringLiteral("deidentifiedFile"),
          QStringLiteral("sessions/folder"), QDir::homePath(), this))
    , m_save(new QPushButton(tr("Save and check"), this))
    , m_run(new ExportRun(QStringLiteral("deidentified"), m_save, this))
{
    setWindowTitle(tr("Save de-identified session"));
    resize(640, 280); // it grows with the verdict
    auto* what = new QLabel(
        tr("A copy of this session for others: the same steps, without the study's images, place, "
           "UIDs and description, without authors, pictures and how the window looked. Names that "
           "were given to segments, sculpt layers and bookmarks stay; one that holds a word of the "
           "patient's name or numbers keeps the copy from being written."),
        this);
    what->setWordWrap(true);
    m_options->askForSession();
    m_save->setObjectName(QStringLiteral("deidentifiedSave"));

    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(theme::padding, theme::padding, theme::padding, theme::padding);
    layout->setSpacing(theme::smallPadding);
    layout->addWidget(what);
    layout->addWidget(m_options);
    layout->addWidget(m_target);
    layout->addWidget(m_run);
    layout->addStretch(1);
    layout->addLayout(m_run->makeButtons());
    tabAsLaidOut(*this);

    m_target->askFor(tr("Save de-identified session as"), tr("Sessions of Burin (*.burin)"));
    m_target->setName(QStringLiteral("deidentified.burin"));
    connect(m_target, &TargetRow::changed, this, &DeidentifySessionDialog::showState);
    connect(m_options, &DeidentifyBox::changed, this, &DeidentifySessionDialog::showState);
    connect(m_run, &ExportRun::startRequested, this, &DeidentifySessionDialog::start);
    connect(m_run, &ExportRun::closeRequested, this, &DeidentifySessionDialog::reject);
    connect(&m_job, &BackgroundJob::ended, this, &DeidentifySessionDialog::showRunning);
    connect(&m_workspace, &Workspace::sessionChanged, this, [this] {
        m_waits = false;
        m_job.cancel();
        QDialog::reject();
    });
    showState();
}

void DeidentifySessionDialog::showState()
{
    if (running())
        return;
    m_run->expectStart();
    m_run->sayMissing(m_target->path().isEmpty() ? tr("Name the file.") : m_options->problem());
}

void DeidentifySessionDialog::start()
{
    if (!m_workspace.session() || running())
        return;
    const QString target = m_target->path();
    const bool replaces = QFileInfo::exists(target);
    if (QFileInfo(target) == QFileInfo(m_workspace.session()->file()))
        return m_run->say(tr("That is the open session itself: name another file."), "bad");
    if (replaces && !mayReplace(target, this))
        return;
    // The question above waits for its answer, and the session may have been closed meanwhile.
    core::EditSession* session = m_workspace.session();
    if (!session)
        return;
    m_target->remember();
    m_run->clearReport();
    m_run->showProgress(tr("Writing the last steps"), 0, 0);
    m_waits = true;
    showRunning();
    session->closeOpen();
    // The session's own file is open, and stays so.
    const auto folder = std::make_shared<QTemporaryDir>();
    session->storage().copyTo(copyIn(*folder),
        core::onMainThread(
            this, [this, target, replaces, folder](const core::Result<void>& copied) {
                if (!m_waits)
                    return;
                m_waits = false;
                if (copied)
                    write(target, replaces, folder);
                else
                    showFailure(copied.error());
            }));
}

void DeidentifySessionDialog::write(
    const QString& target, bool replaces, const std::shared_ptr<QTemporaryDir>& folder)
{
    m_run->showProgress(tr("Writing and checking the copy"), 0, 0);
    m_job.start(
        [this, target, replaces, folder,
            by = m_options->deidentifier(m_workspace.volume()->identity)](
            const core::Progress&) -> std::function<void()> {
            const core::Result<core::DeidentifiedSession> done =
                core::deidentifySession(copyIn(*folder), target, replaces, *by);
            const core::Result<QString> sum =
                done ? core::sha256OfFile(target) : core::Result<QString>(QString());
            return [this, target, folder, done, sum] {
                if (!done) {
                    core::Error error = done.error();
                    error.arguments.replace(copyIn(*folder), m_workspace.session()->file());
                    return showFailure(error);
                }
                m_run->showReport({.file = target,
                    .written = deidentifiedTexts(*done),
                    .checked = {},
                    .cautions = {},
                    .sha256 = sum.value_or(QString())});
                m_workspace.say(tr("The de-identified session is saved: %1").arg(target));
                Q_EMIT saved(target);
            };
        },
        [this](const core::Error& error) { showFailure(error); });
    showRunning();
}

void DeidentifySessionDialog::showRunning()
{
    for (QWidget* input : std::initializer_list<QWidget*>{m_options, m_target, m_save})
        input->setEnabled(!running());
    m_run->setBusy(running());
}

void DeidentifySessionDialog::showFailure(const core::Error& error)
{
    showRunning();
    m_run->showFailure(error);
}

/// A copy that is being written is done in a moment, whole or not at all.
void DeidentifySessionDialog::reject()
{
    if (!running())
        QDialog::reject();
}

} // namespace ui
