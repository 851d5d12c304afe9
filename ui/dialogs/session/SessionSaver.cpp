// SPDX-License-Identifier: Apache-2.0
#include "ui/dialogs/session/SessionSaver.h"

#include "core/base/OnMainThread.h"
#include "core/session/SessionStorage.h"
#include "core/sessionfile/SessionStudy.h"
#include "core/sessionfile/database/SessionUse.h"
#include "core/sessionfile/records/SessionImages.h"
#include "ui/base/ErrorText.h"
#include "ui/dialogs/session/SaveSessionDialog.h"
#include "ui/texts/ProgressTexts.h"
#include "ui/workspace/Workspace.h"

#include <QDir>
#include <QEventLoop>
#include <QFileInfo>
#include <QSettings>

#include <utility>

namespace ui {

namespace {

const QLatin1String folderKey("sessions/folder");

/// A name for people: the series, or the study's file or folder.
QString nameOfStudy(const core::Volume& volume)
{
    QString name = volume.identity.seriesDescription;
    if (name.isEmpty()) {
        name = QFileInfo(volume.sourcePath).completeBaseName();
        // Of "ball.nii.gz".
        if (const QLatin1String inner(".nii"); name.endsWith(inner, Qt::CaseInsensitive))
            name.chop(inner.size());
    }
    for (const QChar forbidden : QStringLiteral("/\\:*?\"<>|"))
        name.replace(forbidden, u'_');
    return (name.trimmed().isEmpty() ? QStringLiteral("session") : name.trimmed())
        + QStringLiteral(".burin");
}

/// The study is read once more: nobody keeps its voxels but the graphics card.
core::Result<std::shared_ptr<core::StagedFile>> stageFromStudy(
    const QString& target, const core::SessionSource& source, const core::Progress& progress)
{
    // Known before minutes are spent on the images.
    if (const core::Result<void> fits = core::checkOnlySessionAt(target); !fits)
        return tl::unexpected(fits.error());
    const auto study = core::loadSessionStudy(target, source, source.path, QString(), progress);
    if (!study && study.error().code == core::ErrorCode::Cancelled)
        return tl::unexpected(study.error());
    if (!study)
        return core::failure(core::ErrorCode::FileUnwritable, target,
            core::Clause::saying("the study's images cannot be read (%1); the session can be saved "
                                 "without them",
                errorText(study.error())));
    auto staged = core::stageImages(target, true, *study, progress);
    if (!staged)
        return tl::unexpected(staged.error());
    return std::make_shared<core::StagedFile>(*std::move(staged));
}

} // namespace

SessionSaver::SessionSaver(Workspace& workspace, QWidget& window)
    : QObject(&window)
    , m_workspace(workspace)
    , m_window(window)
{
    connect(&workspace, &Workspace::sessionClosing, this, &SessionSaver::cancel);
}

void SessionSaver::ask()
{
    if (const std::optional<Choice> choice = choose(true))
        save(*choice);
}

bool SessionSaver::askAndWait()
{
    const std::optional<Choice> choice = choose(false);
    if (!choice)
        return false;
    QEventLoop loop;
    std::optional<bool> result;
    save(*choice, [&loop, &result](bool saved) {
        result = saved;
        loop.quit();
    });
    if (!result)
        loop.exec(QEventLoop::ExcludeUserInputEvents);
    return result.value_or(false);
}

QString SessionSaver::suggestedName() const
{
    const QFileInfo file(m_workspace.session()->file());
    const bool named = !file.fileName().isEmpty()
        && (m_workingFolder.isEmpty() || file.absoluteDir() != QDir(m_workingFolder));
    return named ? file.fileName() : nameOfStudy(*m_workspace.volume());
}

std::optional<SessionSaver::Choice> SessionSaver::choose(bool offerImages)
{
    const core::Volume* volume = m_workspace.volume();
    if (!volume)
        return {};
    const bool holdsImages = m_workspace.session()->storage().holdsImages();
    const QString folder = QSettings().value(folderKey, QDir::homePath()).toString();
    SaveSessionDialog dialog(folder, suggestedName(), &m_window);
    if (offerImages)
        dialog.offerImages(holdsImages, volume->keptHeaders == nullptr);
    if (dialog.exec() != QDialog::Accepted || dialog.selectedFiles().isEmpty())
        return {};
    const QString target = dialog.selectedFiles().constFirst();
    QSettings().setValue(folderKey, QFileInfo(target).absolutePath());
    return Choice{.target = target, .images = offerImages ? dialog.wantsImages() : holdsImages};
}

void SessionSaver::save(const Choice& choice, std::function<void(bool)> done)
{
    core::EditSession* session = m_workspace.session();
    if (!session)
        return done ? done(false) : void();
    // What is staged for another place would move the session there later.
    cancel();
    if (choice.images && !session->storage().holdsImages())
        stage(choice, std::move(done));
    else
        goOnIn(choice, nullptr, std::move(done));
}

void SessionSaver::cancel()
{
    if (!m_staging.running())
        return;
    m_staging.cancel();
    // Behind it: nothing of it is left then.
    m_background.start(
        this, [] {},
        [done = std::exchange(m_done, {})](const core::Result<void>&) {
            if (done)
                done(false);
        });
    m_workspace.say(tr("Saving was cancelled; the session goes on where it was"));
    Q_EMIT imagesEnded(false);
}

void SessionSaver::stage(const Choice& choice, std::function<void(bool)> done)
{
    m_done = std::move(done);
    m_target = choice.target;
    Q_EMIT imagesBegun(choice.target);
    using Staged = core::Result<std::shared_ptr<core::StagedFile>>;
    m_staging = m_background.start(
        this,
        [target = choice.target, source = core::SessionSource::of(*m_workspace.volume())](
            const core::Progress& progress) { return stageFromStudy(target, source, progress); },
        [this, choice](const Staged& staged) {
            std::function<void(bool)> done = std::exchange(m_done, {});
            Q_EMIT imagesEnded(staged.has_value());
            if (staged)
                return goOnIn(choice, *staged, std::move(done));
            m_workspace.fail(staged.error());
            if (done)
                done(false);
        },
        [this](core::ProgressStep step, int piece, int pieces) {
            Q_EMIT imagesProgressed(progressText(step), piece, pieces);
        });
}

void SessionSaver::goOnIn(const Choice& choice, const std::shared_ptr<core::StagedFile>& staged,
    std::function<void(bool)> done)
{
    core::EditSession* session = m_workspace.session();
    const QString target = choice.target;
    // Without a file there is none to leave.
    const bool leavesFile = session->whyReadOnly().isEmpty() && !session->storage().whyNoFile();
    const QString before = leavesFile ? session->file() : QString();
    m_workspace.say(tr("Saving the session …"));
    // It may outlive whoever asked.
    const auto finished = [workspace = &m_workspace, before, target, done = std::move(done)](
                              const core::Result<void>& saved) {
        if (saved) {
            workspace->noteSaved(before, target);
            workspace->say(tr("The session is saved and goes on in %1").arg(target));
        } else {
            workspace->fail(saved.error());
            workspace->say(tr("The session was not saved there; it goes on where it was"));
        }
        if (done)
            done(saved.has_value());
    };
    session->storage().saveAs(target, true, core::onMainThread(&m_workspace, finished),
        {.kept = choice.images, .staged = staged});
}

} // namespace ui
