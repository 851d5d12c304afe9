// SPDX-License-Identifier: Apache-2.0
#include "app/window/Application.h"

#include "app/steps/SessionFiles.h"
#include "app/window/DemonstrationStudy.h"
#include "app/window/LostContext.h"
#include "app/window/WindowContents.h"
#include "core/base/Guarded.h"
#include "core/repair/SeriesRepair.h"
#include "core/session/SessionStorage.h"
#include "core/sessionfile/SessionPreview.h"
#include "core/sessionfile/SessionSalvage.h"
#include "core/sessionfile/database/SessionUse.h"
#include "gpu/engine/GpuEngine.h"
#include "ui/base/ErrorText.h"
#include "ui/base/Theme.h"
#include "ui/dialogs/session/UnwrittenSteps.h"
#include "ui/frame/MessageBar.h"
#include "ui/settings/RecentStudies.h"
#include "ui/texts/ClauseText.h"
#include "ui/window/MainWindow.h"

#include <QApplication>
#include <QDateTime>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QTimer>

#include <chrono>
#include <cstdint>
#include <thread>
#include <utility>

namespace app {

namespace {

QString stepsText(std::size_t steps)
{
    return steps == 1 ? QObject::tr("1 step") : QObject::tr("%1 steps").arg(steps);
}

} // namespace

core::Result<std::unique_ptr<Application>> Application::create()
{
    return core::guarded([]() -> core::Result<std::unique_ptr<Application>> {
        auto engine = gpu::GpuEngine::create();
        if (!engine)
            return tl::unexpected(engine.error());
        return std::unique_ptr<Application>(new Application(std::move(*engine)));
    });
}

Application::Application(std::unique_ptr<gpu::GpuEngine> engine)
    : m_engine(std::move(engine))
    , m_workspace(std::make_unique<ui::Workspace>(m_engine->frames()))
{
    ui::theme::apply(*qApp);
    m_window = std::make_unique<ui::MainWindow>(
        *m_workspace, m_engine->rendererName() + QStringLiteral(", ") + m_engine->versionText());
    addContents(*m_window);
    follow();
}

Application::~Application()
{
    m_workspace->setSession(nullptr);
}

void Application::follow()
{
    connect(
        m_workspace.get(), &ui::Workspace::sessionChanged, this, &Application::forgetUnusedSession);
    connect(m_workspace.get(), &ui::Workspace::documentChanged, this, [this] {
        if (m_rowsAtFirst && m_workspace->session()->history().rows().size() > *m_rowsAtFirst)
            m_rowsAtFirst.reset();
        // Who goes on has chosen.
        if (!m_goesOnSentence.isEmpty()
            && m_workspace->session()->history().rows().size() > m_rowsWhenOpened) {
            if (m_window->messages().sentence() == m_goesOnSentence)
                m_window->messages().dismiss();
            m_goesOnSentence.clear();
        }
    });
    connect(m_workspace.get(), &ui::Workspace::sessionSaved, this, &Application::followSaved);
    connect(m_window.get(), &ui::MainWindow::demonstrationRequested, this,
        &Application::openDemonstration);
    connect(&m_window->opener(), &ui::StudyOpener::loaded, this, &Application::openStudy);
    connect(&m_window->opener(), &ui::StudyOpener::sessionLoaded, this, &Application::openSession);
    // The session notices that another program has renamed or deleted its file when it writes.
    constexpr std::chrono::seconds betweenLooks{5};
    auto* look = new QTimer(this);
    connect(look, &QTimer::timeout, this, [this] {
        if (m_workspace->session())
            m_workspace->session()->storage().retryWriting();
    });
    look->start(betweenLooks);
    new LostContext(
        *m_window, [this] { return makeRoom(); }, this);
    m_window->offerSessionsIn(sessionFolder());
}

void Application::openDemonstration()
{
    m_window->opener().run(demonstrationFolder(),
        [](const core::Progress& progress, const core::EarlySliceListener& early) {
            return loadDemonstration(progress, early);
        });
}

void Application::openStudy(const std::shared_ptr<core::LoadedVolume>& loaded, const QString& path)
{
    // The study may be the open one: its session is closed before it is looked into.
    if (!makeRoom())
        return;
    const QString file = sessionFile(loaded->volume);
    const QString series = core::withRepair(loaded->volume.seriesKey, loaded->volume.repair);
    const auto repair = core::SeriesRepair::fromText(loaded->volume.repair);
    const bool givenSpacing = repair && repair->givenSpacingMm;
    make(loaded, {.file = file},
        [this, file, path, series, givenSpacing](const core::Result<void>& opened) {
            if (!opened)
                return showWhyNot(opened.error(), file, path, series);
            ui::RecentStudies::add(path, givenSpacing ? series : QString());
            if (m_goesOn)
                showThatItGoesOn(path, series);
        });
}

void Application::openSession(const std::shared_ptr<core::LoadedVolume>& loaded,
    const QString& file, const std::shared_ptr<const core::SessionContents>& contents)
{
    if (!makeRoom())
        return;
    make(loaded, {.file = file, .contents = contents}, [this](const core::Result<void>& opened) {
        if (!opened)
            return showError(opened.error());
        if (!isWorkingSession(m_sessionFile))
            ui::RecentStudies::add(m_sessionFile);
        if (m_goesOn)
            m_workspace->say(tr("The session goes on with %1")
                                 .arg(stepsText(m_workspace->session()->history().rows().size())));
    });
}

void Application::make(const std::shared_ptr<core::LoadedVolume>& loaded, SessionOpening::Wish wish,
    const std::function<void(const core::Result<void>&)>& then)
{
    wish.redo = !m_notRedone.contains(wish.file);
    wish.wakeUp = [this] { wake(); };
    m_window->opener().goOn(tr("Preparing the views"), [this, loaded, wish, then] {
        const auto opening = SessionOpening::make(*m_engine, std::move(*loaded), wish);
        return [this, opening, file = wish.file, then] { then(take(*opening, file)); };
    });
}

core::Result<void> Application::makeRoom()
{
    if (!ui::mayLoseUnwrittenSteps(*m_workspace, *m_window, m_window->saver()))
        return core::failure(core::ErrorCode::Cancelled);
    if (m_workspace->session())
        m_workspace->setSession(nullptr);
    return {};
}

core::Result<void> Application::take(SessionOpening& opening, const QString& file)
{
    if (!opening.session && opening.plan && !opening.plan->redo.empty()) {
        if (const core::Result<void> withdrawn = withdraw(*opening.plan, file); !withdrawn)
            return withdrawn;
        if (opening.session.error().code == core::ErrorCode::ContextLost)
            return tl::unexpected(opening.session.error());
        m_notRedone.insert(file);
        m_window->opener().openSession(file);
        return core::failure(core::ErrorCode::Cancelled);
    }
    if (!opening.session)
        return tl::unexpected(opening.session.error());
    const std::size_t steps = (*opening.session)->history().rows().size();
    const std::optional<core::Error> whyNoFile = (*opening.session)->storage().whyNoFile();
    const bool madeForIt = opening.plan ? opening.plan->isNew : !whyNoFile;
    m_sessionFile = opening.file;
    m_rowsAtFirst = madeForIt ? std::optional(steps) : std::nullopt;
    m_made = core::FollowedFile(m_sessionFile);
    m_workspace->setSession(std::move(*opening.session));
    m_goesOnSentence.clear();
    m_goesOn = opening.plan && !showSessionProblem(opening, file) && steps > 0;
    if (!opening.plan && whyNoFile)
        m_window->messages().show(ui::MessageBar::Kind::Caution,
            tr("Steps stay in memory only, until you save the session elsewhere: %1.")
                .arg(ui::noFileText(*whyNoFile)),
            tr("Save session as …"), [this] { m_window->saveSessionAs(); });
    return {};
}

bool Application::showSessionProblem(const SessionOpening& opening, const QString& file)
{
    const SessionPlan& plan = *opening.plan;
    const core::SessionContents& contents = *opening.contents;
    // The bar shows one message: what stands beside the file is told with what else is told.
    const QString beside = contents.leftBeside.isEmpty()
        ? QString()
        : tr("%1.").arg(ui::clauseText(contents.leftBeside));
    const auto andBeside = [&beside](const QString& sentence) {
        return beside.isEmpty() ? sentence : sentence + QLatin1Char(' ') + beside;
    };
    const bool nothingLost =
        plan.damage && !contents.damage && plan.redo.size() == contents.redo.size();
    if (nothingLost) {
        m_window->messages().show(ui::MessageBar::Kind::Caution, ui::errorText(*plan.damage));
    } else if (plan.damage) {
        m_workspace->fail(*plan.damage);
    } else if (!plan.whyReadOnly.isEmpty()) {
        m_window->messages().show(ui::MessageBar::Kind::Caution,
            andBeside(tr("%1 is %2. Here it can be looked at, not edited.")
                          .arg(QFileInfo(file).fileName(), plan.whyReadOnly)),
            tr("Save session as …"), [this] { m_window->saveSessionAs(); });
    } else if (!contents.leftOpen.isEmpty()) {
        m_window->messages().show(ui::MessageBar::Kind::Caution,
            tr("%1: %2. Its last steps may be missing.")
                .arg(QFileInfo(file).fileName(), ui::clauseText(contents.leftOpen)));
    } else if (opening.notFromStudy) {
        m_window->messages().show(
            beside.isEmpty() ? ui::MessageBar::Kind::Notice : ui::MessageBar::Kind::Caution,
            andBeside(whereImagesAre(*opening.notFromStudy, file)));
    } else if (!beside.isEmpty()) {
        m_window->messages().show(ui::MessageBar::Kind::Caution,
            andBeside(tr("%1 is whole.").arg(QFileInfo(file).fileName())));
    } else {
        return false;
    }
    return true;
}

void Application::showThatItGoesOn(const QString& path, const QString& series)
{
    m_rowsWhenOpened = m_workspace->session()->history().rows().size();
    m_goesOnSentence = tr("This study was worked on before; its session goes on with "
                          "%1. Begin anew to leave that session as it is.")
                           .arg(stepsText(m_rowsWhenOpened));
    m_window->messages().show(ui::MessageBar::Kind::Notice, m_goesOnSentence, tr("Begin anew"),
        [this, path, series] { beginAnew(path, series); });
}

void Application::beginAnew(const QString& path, const QString& series)
{
    const QString old = m_sessionFile;
    if (old.isEmpty() || !makeRoom())
        return;
    const QFileInfo file(old);
    const QString beside = file.dir().filePath(
        QStringLiteral("%1-%2.burin")
            .arg(file.completeBaseName(),
                QDateTime::currentDateTime().toString(QStringLiteral("yyyyMMdd-HHmmss"))));
    if (const core::Result<void> renamed = renameSession(old, beside); !renamed)
        m_workspace->fail(renamed.error());
    else if (path == demonstrationFolder())
        openDemonstration();
    else
        m_window->opener().open(path, series);
}

QString Application::whereImagesAre(const core::Error& whyNotFromStudy, const QString& file)
{
    const QString name = QFileInfo(file).fileName();
    const QString why = whyNotFromStudy.code == core::ErrorCode::StudyMissing
        ? tr("The study is no longer at %1").arg(whyNotFromStudy.arguments.value(1))
        : ui::errorText(whyNotFromStudy);
    return tr("%1. Its images are taken from %2 and agree with the session.").arg(why, name);
}

void Application::showError(const core::Error& error)
{
    // Who chose to stay knows.
    if (error.code != core::ErrorCode::Cancelled)
        m_workspace->fail(error);
}

void Application::showWhyNot(
    const core::Error& error, const QString& file, const QString& path, const QString& series)
{
    showError(error);
    using core::ErrorCode;
    const bool beyondUse = error.code == ErrorCode::SessionDamaged
        || error.code == ErrorCode::SessionMismatch || error.code == ErrorCode::FileTruncated
        || error.code == ErrorCode::UnsupportedFormat;
    if (!beyondUse || error.arguments.value(0) != file)
        return;
    // The study is not to be lost with its session; what is left of that stays beside the new one.
    m_window->messages().show(ui::MessageBar::Kind::Error, ui::errorText(error),
        tr("Put it aside and start a new session"), [this, file, path, series] {
            const QString time =
                QDateTime::currentDateTime().toString(QStringLiteral("yyyyMMdd-HHmmss"));
            const core::Result<void> renamed =
                renameSession(file, file + QStringLiteral(".aside-") + time);
            if (renamed)
                m_window->opener().open(path, series);
            else
                m_workspace->fail(renamed.error());
        });
}

void Application::forgetUnusedSession()
{
    if (m_workspace->session() || m_sessionFile.isEmpty())
        return;
    if (holdsNothingNew())
        QFile::remove(m_sessionFile);
    m_sessionFile.clear();
}

bool Application::holdsNothingNew() const
{
    // Another program may have put another file in its place.
    if (!m_rowsAtFirst || !m_made.isAt(m_sessionFile))
        return false;
    // A step that was under way when it was closed was carried out then, and nobody was told.
    const core::Result<core::SessionPreview> left = core::previewSession(m_sessionFile);
    return left && left->condition == core::SessionPreview::Condition::Closed
        && left->steps <= std::int64_t(*m_rowsAtFirst);
}

void Application::followSaved(const QString& before, const QString& now)
{
    // The copy stands: what a working session held lies in a file of the user's own.
    if (!before.isEmpty() && isWorkingSession(before) && !core::isSessionInUse(before))
        core::removeSession(before);
    // A working session that was written anew under its name is found by its study.
    if (!isWorkingSession(now) || now != m_sessionFile)
        ui::RecentStudies::add(now);
    if (!m_workspace->session() || m_workspace->session()->file() != now)
        return;
    m_sessionFile = now;
    m_rowsAtFirst.reset();
}

void Application::wake()
{
    // Any number of wake-ups before the GUI looks are one.
    if (m_pollQueued.exchange(true))
        return;
    constexpr std::chrono::milliseconds pause{5};
    const auto queue = [this] {
        QMetaObject::invokeMethod(
            this, [this] { poll(); }, Qt::QueuedConnection);
    };
    // One that is lost would leave the session waiting for ever.
    while (!core::guarded(queue))
        std::this_thread::sleep_for(pause);
}

void Application::poll()
{
    m_pollQueued = false;
    if (core::EditSession* session = m_workspace->session())
        session->poll();
}

} // namespace app
