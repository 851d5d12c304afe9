// SPDX-License-Identifier: Apache-2.0
#include "app/Application.h"

#include "app/DemonstrationStudy.h"
#include "app/SessionFiles.h"
#include "gpu/GpuEngine.h"
#include "ui/DisplayState.h"
#include "ui/ErrorText.h"
#include "ui/KeyframeRecorder.h"
#include "ui/MainWindow.h"
#include "ui/MessageBar.h"
#include "ui/RecentStudies.h"
#include "ui/Theme.h"
#include "ui/dialogs/ExportDialog.h"
#include "ui/panels/GrowthPanel.h"
#include "ui/panels/HistoryPanel.h"
#include "ui/panels/SegmentsPanel.h"
#include "ui/panels/VolumePanel.h"
#include "ui/tools/DrillTool.h"
#include "ui/tools/SeedTool.h"
#include "ui/views/ViewGrid.h"
#include "ui/views/VolumeView.h"

#include <QApplication>
#include <QDateTime>
#include <QFile>
#include <QFileInfo>
#include <QMenu>

#include <utility>

namespace app {

core::Result<std::unique_ptr<Application>> Application::create()
{
    auto engine = gpu::GpuEngine::create();
    if (!engine)
        return tl::unexpected(engine.error());
    return std::unique_ptr<Application>(new Application(std::move(*engine)));
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
    auto* seed = new ui::SeedTool(*m_workspace, &window);
    window.addToolGroup();
    window.addTool(*drill, window.sculptMenu(), QKeySequence(QStringLiteral("T")));
    window.addToolGroup();
    window.addTool(*seed, window.growMenu(), QKeySequence(QStringLiteral("S")));

    window.addPanel(new ui::SegmentsPanel(*m_workspace));
    window.addPanel(new ui::GrowthPanel(*m_workspace));
    window.addPanel(new ui::HistoryPanel(*m_workspace));
    window.addPanel(new ui::VolumePanel(*m_workspace));

    addExport();
    new ui::KeyframeRecorder(*m_workspace, window.views().volume());
    // The last to hear of a session: the others have set themselves up by then.
    new ui::DisplayState(*m_workspace, window.views(), {drill, seed}, &window);

    connect(
        m_workspace.get(), &ui::Workspace::sessionChanged, this, &Application::forgetUnusedSession);
    connect(m_workspace.get(), &ui::Workspace::documentChanged, this, [this] {
        m_sessionUsed = m_sessionUsed || !m_workspace->session()->history().rows().empty();
    });
    connect(&window, &ui::MainWindow::demonstrationAsked, this, &Application::openDemonstration);
    connect(&window.opener(), &ui::StudyOpener::loaded, this, &Application::openStudy);
    connect(&window.opener(), &ui::StudyOpener::sessionLoaded, this, &Application::openSession);
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
    QMenu& menu = m_window->fileMenu();
    menu.insertAction(&m_window->actionTable()[QStringLiteral("file.close")], &action);
    m_window->actionTable().refresh();
}

void Application::openDemonstration()
{
    m_window->opener().run(demonstrationFolder(),
        [](const core::Progress& progress) { return loadDemonstration(progress); });
}

void Application::openStudy(const std::shared_ptr<core::LoadedVolume>& loaded, const QString& path)
{
    const QString file = sessionFile(loaded->volume);
    const QString series = loaded->volume.identity.seriesUid;
    const auto begun = begin(std::move(*loaded), file, QFileInfo::exists(file));
    if (begun)
        ui::RecentStudies::add(path);
    else
        tellWhyNot(begun.error(), file, path, series);
}

void Application::openSession(
    const std::shared_ptr<core::LoadedVolume>& loaded, const QString& file)
{
    const auto begun = begin(std::move(*loaded), file, true);
    if (begun)
        ui::RecentStudies::add(file);
    else
        m_workspace->fail(begun.error());
}

core::Result<void> Application::begin(
    core::LoadedVolume loaded, const QString& file, bool continues)
{
    // One volume at a time on the engine: the old session closes its file first.
    m_workspace->setSession(nullptr);
    const auto wakeUp = [this] { wake(); };
    m_engine->setVolumeGeometry(loaded.volume.geometry, loaded.volume.encoding);
    auto session = continues
        ? core::EditSession::open(m_engine->edits(), std::move(loaded), file, wakeUp)
        : core::EditSession::create(
            m_engine->edits(), std::move(loaded), {.file = file, .wakeUp = wakeUp});
    if (!session)
        return tl::unexpected(session.error());
    m_sessionFile = file;
    m_sessionUsed = continues;
    m_workspace->setSession(std::move(*session));
    const std::size_t steps = m_workspace->session()->history().rows().size();
    if (steps > 0) {
        m_workspace->say(
            QStringLiteral("The session of this study was continued: %1 steps").arg(steps));
    }
    return {};
}

void Application::tellWhyNot(
    const core::Error& error, const QString& file, const QString& path, const QString& series)
{
    m_workspace->fail(error);
    const bool beyondUse = error.code == core::ErrorCode::SessionDamaged
        || error.code == core::ErrorCode::SessionMismatch;
    if (!beyondUse)
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
    if (!m_sessionUsed)
        QFile::remove(m_sessionFile);
    m_sessionFile.clear();
}

void Application::wake()
{
    // Any number of wake-ups before the GUI looks are one.
    if (!m_pollQueued.exchange(true))
        QMetaObject::invokeMethod(
            this, [this] { poll(); }, Qt::QueuedConnection);
}

void Application::poll()
{
    m_pollQueued = false;
    if (core::EditSession* session = m_workspace->session())
        session->poll();
}

} // namespace app
