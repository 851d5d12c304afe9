// SPDX-License-Identifier: Apache-2.0
#include "app/window/Application.h"

#include "app/steps/SessionFiles.h"
#include "app/window/DemonstrationStudy.h"
#include "app/window/LostContext.h"
#include "core/base/Guarded.h"
#include "core/repair/SeriesRepair.h"
#include "core/session/SessionStorage.h"
#include "core/sessionfile/SessionSalvage.h"
#include "core/sessionfile/records/SessionUse.h"
#include "gpu/engine/GpuEngine.h"
#include "ui/base/ErrorText.h"
#include "ui/base/Theme.h"
#include "ui/dialogs/export/CarvedExportDialog.h"
#include "ui/dialogs/export/DeidentifySessionDialog.h"
#include "ui/dialogs/export/ExportDialog.h"
#include "ui/dialogs/export/Screenshot.h"
#include "ui/dialogs/session/UnwrittenSteps.h"
#include "ui/frame/MessageBar.h"
#include "ui/panels/ClippingPanel.h"
#include "ui/panels/SeriesDoctorPanel.h"
#include "ui/panels/VolumePanel.h"
#include "ui/panels/growth/GrowthActions.h"
#include "ui/panels/growth/GrowthPanel.h"
#include "ui/panels/history/HistoryPanel.h"
#include "ui/panels/lists/LayersPanel.h"
#include "ui/panels/lists/PiecesPanel.h"
#include "ui/panels/lists/SegmentsPanel.h"
#include "ui/panels/refine/ChunksPanel.h"
#include "ui/panels/refine/ComparePanel.h"
#include "ui/panels/refine/RefineActions.h"
#include "ui/panels/refine/RefinePanel.h"
#include "ui/settings/RecentStudies.h"
#include "ui/tools/growth/BarrierTool.h"
#include "ui/tools/growth/PaintTool.h"
#include "ui/tools/growth/SeedTool.h"
#include "ui/tools/growth/ShrinkTool.h"
#include "ui/tools/refine/ChunkTool.h"
#include "ui/tools/refine/RefineTool.h"
#include "ui/tools/sculpt/CarveBrushTool.h"
#include "ui/tools/sculpt/DrillTool.h"
#include "ui/tools/sculpt/LaserTool.h"
#include "ui/tools/sculpt/PeelTool.h"
#include "ui/tools/sculpt/PieceTool.h"
#include "ui/tools/sculpt/ScissorsTool.h"
#include "ui/tools/view/ClipTool.h"
#include "ui/tools/view/CuttingPlaneTool.h"
#include "ui/tools/view/RulerTool.h"
#include "ui/tools/view/UndoHereTool.h"
#include "ui/views/ViewGrid.h"
#include "ui/views/VolumeView.h"
#include "ui/window/DisplayState.h"
#include "ui/window/KeyframeRecorder.h"
#include "ui/window/MainWindow.h"
#include "ui/window/PieceActions.h"

#include <QApplication>
#include <QDateTime>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QMenu>

#include <chrono>
#include <thread>
#include <utility>

namespace app {

namespace {

QString stepsText(std::size_t steps)
{
    return steps == 1 ? QStringLiteral("1 step") : QStringLiteral("%1 steps").arg(steps);
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
    makeWindow();
}

Application::~Application()
{
    m_workspace->setSession(nullptr);
}

void Application::makeWindow()
{
    ui::MainWindow& window = *m_window;
    auto* drill = new ui::DrillTool(*m_workspace, &window);
    auto* laser = new ui::LaserTool(*m_workspace, &window);
    auto* peel = new ui::PeelTool(*m_workspace, &window);
    auto* scissors = new ui::ScissorsTool(*m_workspace, &window);
    auto* carve = new ui::CarveBrushTool(*m_workspace, &window);
    auto* clip = new ui::ClipTool(*m_workspace, &window);
    auto* piece = new ui::PieceTool(*m_workspace, &window);
    ui::addPieceActions(window);
    auto* seed = new ui::SeedTool(*m_workspace, &window);
    auto* shrink = new ui::ShrinkTool(*m_workspace, &window);
    auto* paint = new ui::PaintTool(*m_workspace, &window);
    auto* barrier = new ui::BarrierTool(*m_workspace, &window);
    auto* refine = new ui::RefineTool(*m_workspace, &window);
    auto* plane = new ui::CuttingPlaneTool(*m_workspace, &window);
    auto* chunks = new ui::ChunkTool(*m_workspace, &window);
    auto* ruler = new ui::RulerTool(*m_workspace, &window);
    auto* undoHere = new ui::UndoHereTool(*m_workspace, &window);
    window.addToolGroup();
    window.addTool(*drill, window.sculptMenu(), QKeySequence(QStringLiteral("T")));
    window.addTool(*laser, window.sculptMenu(), QKeySequence(QStringLiteral("A")));
    window.addTool(*peel, window.sculptMenu(), QKeySequence(QStringLiteral("O")));
    window.addTool(*scissors, window.sculptMenu(), QKeySequence(QStringLiteral("K")));
    window.addTool(*carve, window.sculptMenu(), QKeySequence(QStringLiteral("C")));
    window.addTool(*clip, window.sculptMenu(), QKeySequence(QStringLiteral("Shift+C")));
    window.addTool(*piece, window.sculptMenu(), QKeySequence(QStringLiteral("M")));
    window.actionTable().fill(window.sculptMenu(),
        {QString(), QStringLiteral("layers.add"), QStringLiteral("layers.mute"),
            QStringLiteral("layers.solo"), QString(), QStringLiteral("layers.toSegment"),
            QStringLiteral("segments.seen"), QString(), QStringLiteral("pieces.lift"),
            QStringLiteral("pieces.liftLayer"), QStringLiteral("pieces.lid"),
            QStringLiteral("pieces.home")});
    window.addToolGroup();
    window.addTool(*seed, window.growMenu(), QKeySequence(QStringLiteral("S")));
    window.addTool(*shrink, window.growMenu(), QKeySequence(QStringLiteral("X")));
    window.addTool(*paint, window.growMenu(), QKeySequence(QStringLiteral("B")));
    window.addTool(*barrier, window.growMenu(), QKeySequence(QStringLiteral("Shift+B")));
    window.addToolGroup();
    window.addTool(*refine, window.refineMenu(), QKeySequence(QStringLiteral("F")));
    window.addTool(*plane, window.refineMenu(), QKeySequence(QStringLiteral("P")));
    window.addTool(*chunks, window.refineMenu(), QKeySequence(QStringLiteral("Shift+F")));
    window.addToolGroup();
    window.addTool(*ruler, window.editMenu(), QKeySequence(QStringLiteral("L")));
    window.addToolGroup();
    window.addTool(*undoHere, window.editMenu(), QKeySequence(QStringLiteral("U")));

    addDoctor();
    window.addPanel(new ui::SegmentsPanel(*m_workspace));
    auto* growth = new ui::GrowthPanel(*m_workspace);
    window.addPanel(growth);
    window.growMenu().addSeparator();
    window.actionTable().fill(
        window.growMenu(), ui::addGrowthActions(window.actionTable(), *growth, *m_workspace));
    window.addPanel(new ui::RefinePanel(*m_workspace));
    window.refineMenu().addSeparator();
    window.actionTable().fill(
        window.refineMenu(), ui::addRefineActions(window.actionTable(), *m_workspace));
    window.addPanel(new ui::ComparePanel(*m_workspace));
    window.addPanel(new ui::ChunksPanel(*m_workspace));
    window.addPanel(new ui::HistoryPanel(*m_workspace));
    window.addPanel(new ui::LayersPanel(*m_workspace));
    window.addPanel(new ui::PiecesPanel(*m_workspace, window.views().volume()));
    window.addPanel(new ui::VolumePanel(*m_workspace));
    window.addPanel(new ui::ClippingPanel(*m_workspace, window.views().volume()));

    addExport();
    new ui::KeyframeRecorder(*m_workspace, window.views().volume());
    // The last to hear of a session: the others have set themselves up by then.
    const std::vector<ui::Tool*> tools{drill, laser, peel, scissors, carve, clip, piece, seed,
        shrink, paint, barrier, refine, plane, chunks, ruler, undoHere};
    new ui::DisplayState(*m_workspace, window.views(), tools, &window);

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
    connect(
        &window, &ui::MainWindow::demonstrationRequested, this, &Application::openDemonstration);
    connect(&window.opener(), &ui::StudyOpener::loaded, this, &Application::openStudy);
    connect(&window.opener(), &ui::StudyOpener::sessionLoaded, this, &Application::openSession);
    new LostContext(
        window, [this] { return makeRoom(); }, this);
    window.offerSessionsIn(sessionFolder());
}

void Application::addDoctor()
{
    auto* doctor = new ui::SeriesDoctorPanel(*m_workspace);
    m_window->addPanel(doctor);
    connect(doctor, &ui::SeriesDoctorPanel::reopenRequested, this,
        [this](
            const QString& path, const QString& series) { m_window->opener().open(path, series); });
    QAction& action = m_window->actionTable().add({.id = QStringLiteral("file.seriesDoctor"),
        .text = QStringLiteral("Series doctor …"),
        .run = [this, doctor] { m_window->bringUp(*doctor); },
        .possible = [doctor] { return doctor->hasSomething(); }});
    m_window->fileMenu().insertAction(
        &m_window->actionTable()[QStringLiteral("file.importMask")], &action);
}

void Application::addExport()
{
    QAction& action = m_window->actionTable().add({.id = QStringLiteral("file.export"),
        .text = QStringLiteral("Export segments …"),
        .keys = {QKeySequence(QStringLiteral("Ctrl+E"))},
        .icon = QStringLiteral("export"),
        .run =
            [this] {
                auto* dialog = new ui::ExportDialog(*m_workspace, m_window.get());
                dialog->setAttribute(Qt::WA_DeleteOnClose);
                dialog->open();
            },
        .possible =
            [this] {
                return m_workspace->session()
                    && !m_workspace->session()->document().segments.empty();
            }});
    QAction& carved = m_window->actionTable().add({.id = QStringLiteral("file.exportCarved"),
        .text = QStringLiteral("Export carved volume …"),
        .run =
            [this] {
                auto* dialog = new ui::CarvedExportDialog(*m_workspace, m_window.get());
                dialog->setAttribute(Qt::WA_DeleteOnClose);
                dialog->open();
            },
        .possible = [this] { return m_workspace->session() != nullptr; }});
    QAction& deidentified = m_window->actionTable().add({.id = QStringLiteral("file.deidentify"),
        .text = QStringLiteral("Save de-identified session as …"),
        .run =
            [this] {
                auto* dialog = new ui::DeidentifySessionDialog(*m_workspace, m_window.get());
                dialog->setAttribute(Qt::WA_DeleteOnClose);
                dialog->open();
            },
        .possible =
            [this] {
                core::EditSession* session = m_workspace->session();
                return session && !session->file().isEmpty() && !session->storage().whyNoFile();
            }});
    QAction& picture = m_window->actionTable().add({.id = QStringLiteral("file.savePicture"),
        .text = QStringLiteral("Save picture of the window …"),
        .run =
            [this] {
                const QString verdict = ui::askAndSavePicture(*m_workspace, *m_window);
                if (!verdict.isEmpty())
                    m_window->messages().show(ui::MessageBar::Kind::Notice, verdict);
            },
        .possible = [this] { return m_workspace->session() != nullptr; }});
    QMenu& menu = m_window->fileMenu();
    for (QAction* each : {&action, &carved, &picture})
        menu.insertAction(&m_window->actionTable()[QStringLiteral("file.close")], each);
    menu.insertAction(&action, &deidentified);
    m_window->actionTable().refresh();
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
            m_workspace->say(QStringLiteral("The session goes on with %1")
                                 .arg(stepsText(m_workspace->session()->history().rows().size())));
    });
}

void Application::make(const std::shared_ptr<core::LoadedVolume>& loaded, SessionOpening::Wish wish,
    const std::function<void(const core::Result<void>&)>& then)
{
    wish.redo = !m_notRedone.contains(wish.file);
    wish.wakeUp = [this] { wake(); };
    m_window->opener().goOn(QStringLiteral("Preparing the views"), [this, loaded, wish, then] {
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
        withdraw(*opening.plan, file);
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
    m_workspace->setSession(std::move(*opening.session));
    m_goesOnSentence.clear();
    m_goesOn = opening.plan && !showSessionProblem(opening, file) && steps > 0;
    if (!opening.plan && whyNoFile)
        m_window->messages().show(ui::MessageBar::Kind::Caution,
            QStringLiteral("Steps stay in memory only, until you save the session elsewhere: %1.")
                .arg(ui::noFileText(*whyNoFile)),
            QStringLiteral("Save session as …"), [this] { m_window->saveSessionAs(); });
    return {};
}

bool Application::showSessionProblem(const SessionOpening& opening, const QString& file)
{
    const SessionPlan& plan = *opening.plan;
    const core::SessionContents& contents = *opening.contents;
    const bool nothingLost =
        plan.damage && !contents.damage && plan.redo.size() == contents.redo.size();
    if (nothingLost) {
        m_window->messages().show(ui::MessageBar::Kind::Caution, ui::errorText(*plan.damage));
    } else if (plan.damage) {
        m_workspace->fail(*plan.damage);
    } else if (!plan.whyReadOnly.isEmpty()) {
        m_window->messages().show(ui::MessageBar::Kind::Caution,
            QStringLiteral("%1 is %2. Here it can be looked at, not edited.")
                .arg(QFileInfo(file).fileName(), plan.whyReadOnly),
            QStringLiteral("Save session as …"), [this] { m_window->saveSessionAs(); });
    } else if (!contents.leftOpen.isEmpty()) {
        m_window->messages().show(ui::MessageBar::Kind::Caution,
            QStringLiteral("%1: %2. Its last steps may be missing.")
                .arg(QFileInfo(file).fileName(), contents.leftOpen));
    } else if (opening.notFromStudy) {
        showWhereImagesAre(*opening.notFromStudy, file);
    } else {
        return false;
    }
    return true;
}

void Application::showThatItGoesOn(const QString& path, const QString& series)
{
    m_rowsWhenOpened = m_workspace->session()->history().rows().size();
    m_goesOnSentence = QStringLiteral("This study was worked on before; its session goes on with "
                                      "%1. Begin anew to leave that session as it is.")
                           .arg(stepsText(m_rowsWhenOpened));
    m_window->messages().show(ui::MessageBar::Kind::Notice, m_goesOnSentence,
        QStringLiteral("Begin anew"), [this, path, series] { beginAnew(path, series); });
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
    if (!QFile::rename(old, beside))
        m_workspace->fail({core::ErrorCode::FileUnwritable, {old}});
    else if (path == demonstrationFolder())
        openDemonstration();
    else
        m_window->opener().open(path, series);
}

void Application::showWhereImagesAre(const core::Error& whyNotFromStudy, const QString& file)
{
    const QString name = QFileInfo(file).fileName();
    const QString why = whyNotFromStudy.code == core::ErrorCode::StudyMissing
        ? QStringLiteral("The study is no longer at %1").arg(whyNotFromStudy.arguments.value(1))
        : ui::errorText(whyNotFromStudy);
    m_window->messages().show(ui::MessageBar::Kind::Notice,
        QStringLiteral("%1. Its images are taken from %2 and agree with the session.")
            .arg(why, name));
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
        QStringLiteral("Put it aside and start a new session"), [this, file, path, series] {
            const QString time =
                QDateTime::currentDateTime().toString(QStringLiteral("yyyyMMdd-HHmmss"));
            if (QFile::rename(file, file + QStringLiteral(".aside-") + time))
                m_window->opener().open(path, series);
            else
                m_workspace->fail({core::ErrorCode::FileUnwritable, {file}});
        });
}

void Application::forgetUnusedSession()
{
    if (m_workspace->session() || m_sessionFile.isEmpty())
        return;
    if (m_rowsAtFirst)
        QFile::remove(m_sessionFile);
    m_sessionFile.clear();
}

void Application::followSaved(const QString& before, const QString& now)
{
    // The copy stands: what a working session held lies in a file of the user's own.
    if (!before.isEmpty() && isWorkingSession(before) && !core::isSessionInUse(before))
        core::removeSession(before);
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
