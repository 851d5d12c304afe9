// SPDX-License-Identifier: Apache-2.0
#include "ui/window/MainWindow.h"

#include "ui/base/ErrorText.h"
#include "ui/base/Icons.h"
#include "ui/base/Theme.h"
#include "ui/dialogs/AboutDialog.h"
#include "ui/dialogs/session/SessionSaver.h"
#include "ui/dialogs/session/UnwrittenSteps.h"
#include "ui/dialogs/study/DroppedPaths.h"
#include "ui/dialogs/study/OpenDialogs.h"
#include "ui/frame/LoadingBar.h"
#include "ui/frame/MendingStrip.h"
#include "ui/frame/MessageBar.h"
#include "ui/frame/Panel.h"
#include "ui/frame/PanelColumn.h"
#include "ui/frame/PanelSection.h"
#include "ui/frame/SegmentWorkWatch.h"
#include "ui/frame/StartPage.h"
#include "ui/frame/ToolColumn.h"
#include "ui/frame/WindowHeader.h"
#include "ui/frame/WindowPlace.h"
#include "ui/input/Tool.h"
#include "ui/menus/SegmentEntries.h"
#include "ui/menus/SegmentMenus.h"
#include "ui/settings/RecentStudies.h"
#include "ui/tasks/MaskImporter.h"
#include "ui/views/ViewGrid.h"
#include "ui/widgets/fields/FieldManners.h"
#include "ui/window/BookmarkMenu.h"
#include "ui/window/OptionBar.h"
#include "ui/window/PlaneActions.h"
#include "ui/window/ShownStudy.h"
#include "ui/window/StageActions.h"
#include "ui/window/StatusLine.h"
#include "ui/window/WindowActions.h"

#include <QApplication>
#include <QDragEnterEvent>
#include <QFileInfo>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QMenu>
#include <QMimeData>
#include <QScreen>
#include <QScrollArea>
#include <QSettings>
#include <QSplitter>
#include <QStackedWidget>
#include <QStatusBar>
#include <QVBoxLayout>

namespace ui {

namespace {

/// The class of the panel that a tool works with, by the tool's icon name; null: none.
const char* panelOf(const QString& tool)
{
    struct Pair {
        const char* tool;
        const char* panel;
    };
    constexpr Pair pairs[] = {{"clip", "ui::ClippingPanel"}, {"piece", "ui::PiecesPanel"},
        {"seed", "ui::GrowthPanel"}, {"shrink-here", "ui::GrowthPanel"},
        {"barrier", "ui::GrowthPanel"}, {"contour", "ui::ContourPanel"},
        {"ruler", "ui::MeasurementsPanel"}, {"refine", "ui::RefinePanel"},
        {"chunks", "ui::ChunksPanel"}, {"undo-here", "ui::HistoryPanel"}};
    for (const Pair& pair : pairs) {
        if (tool == QLatin1String(pair.tool))
            return pair.panel;
    }
    return nullptr;
}

} // namespace

MainWindow::MainWindow(Workspace& workspace, const QString& graphics)
    : m_workspace(workspace)
    , m_graphics(graphics)
    , m_actions(*this)
    , m_header(new WindowHeader(workspace, this))
    , m_tools(new ToolColumn(this))
    , m_loading(new LoadingBar(this))
    , m_messages(new MessageBar(this))
    , m_mending(new MendingStrip(this))
    , m_pages(new QStackedWidget(this))
    , m_startPage(new QScrollArea(this))
    , m_start(new StartPage)
    , m_views(new ViewGrid(workspace, this))
    , m_shown(new ShownStudy(workspace, *m_views, *m_messages, this))
    , m_status(new StatusLine(workspace, this))
    , m_panels(new PanelColumn(this))
    , m_splitter(new QSplitter(this))
    , m_saver(new SessionSaver(workspace, *this))
    , m_importer(new MaskImporter(workspace, this))
    , m_bookmarks(new BookmarkMenu(workspace, m_views->volume(), this))
{
    setWindowIcon(QIcon(tintedIcon(QStringLiteral("burin"), theme::text, 64, 1.0)));
    setAcceptDrops(true);
    qApp->installEventFilter(new FieldManners(this));
    addWindowActions(*this);
    const QStringList plane = addPlaneActions(*this);
    const QStringList stage = addStageActions(*this);
    m_header->fillMenus(m_actions, plane, stage);
    m_bookmarks->fill(m_header->bookmarksMenu());
    // Their entries are about the study in which they were opened.
    for (QMenu* menu : {&m_header->segmentsMenu(), &m_header->bookmarksMenu()})
        connect(&workspace, &Workspace::sessionClosing, menu, &QMenu::close);
    m_views->addToMenus([this](QMenu& menu) {
        QMenu* layouts = menu.addMenu(tr("Layout"));
        layouts->setObjectName(QStringLiteral("layoutOfViews"));
        m_actions.fill(*layouts, layoutIds());
    });
    const QList<QAction*> entries = m_header->segmentsMenu().actions();
    const qsizetype add = entries.indexOf(&m_actions[QStringLiteral("segments.add")]);
    addOverlaps(m_header->segmentsMenu(), entries.value(add + 1), workspace);
    // Before what is done to the segment alone.
    addCombinations(
        m_header->segmentsMenu(), &m_actions[QLatin1String(segmentActions().front().id)], workspace,
        [&workspace] { return workspace.activeSegment(); }, true);
    setMenuWidget(m_header);
    buildCentre();
    connectOpener();

    const auto refresh = [this] { m_actions.refresh(); };
    connect(&workspace, &Workspace::documentChanged, this, refresh);
    connect(&workspace, &Workspace::activeSegmentChanged, this, refresh);
    connect(&workspace, &Workspace::activeLayerChanged, this, refresh);
    connect(&workspace, &Workspace::activeToolChanged, this, [this] {
        if (const Tool* tool = m_workspace.activeTool()) {
            connect(tool, &Tool::stepsChanged, &m_actions, &Actions::refresh, Qt::UniqueConnection);
            connect(tool, &Tool::nameChanged, &m_actions, &Actions::refresh, Qt::UniqueConnection);
        }
        m_actions.refresh();
    });
    connect(&workspace, &Workspace::volumeDisplayChanged, this, refresh);
    connect(&workspace, &Workspace::viewOptionsChanged, this, refresh);
    connect(&workspace, &Workspace::windowLevelChanged, this, refresh);
    connect(&workspace, &Workspace::clipChanged, this, refresh);
    connect(m_views, &ViewGrid::layoutChanged, this, refresh);
    connect(m_views, &ViewGrid::awaitsBoxChanged, this, refresh);
    connect(m_panels, &PanelColumn::changed, this, refresh);
    connect(m_views, &ViewGrid::frameTimed, m_status, &StatusLine::showFrameTime);
    connect(&workspace, &Workspace::sessionChanged, this, &MainWindow::showSession);
    connect(m_shown, &ShownStudy::earlyChanged, this, &MainWindow::showPages);
    connect(m_views, &ViewGrid::picturesReleased, this, &MainWindow::showPages);
    connect(&workspace, &Workspace::sessionSaved, this, [this] {
        m_messages->dismiss();
        m_header->showIdentity(m_shown->volume());
        m_actions.refresh();
    });
    connect(&workspace, &Workspace::offered, this, [this](const Workspace::Offer& made) {
        m_messages->show(MessageBar::Kind::Notice, made.sentence, made.button, made.run);
    });
    connect(&workspace, &Workspace::failed, this, [this](const core::Error& error) {
        // Nothing failed; but what has another name now is worth a look.
        const bool moved = error.code == core::ErrorCode::SessionMoved;
        m_messages->show(
            moved ? MessageBar::Kind::Caution : MessageBar::Kind::Error, errorText(error));
    });
    showSession();
}

MainWindow::~MainWindow() = default;

QMenu& MainWindow::fileMenu() const
{
    return m_header->fileMenu();
}

QMenu& MainWindow::editMenu() const
{
    return m_header->editMenu();
}

QMenu& MainWindow::sculptMenu() const
{
    return m_header->sculptMenu();
}

QMenu& MainWindow::growMenu() const
{
    return m_header->growMenu();
}

QMenu& MainWindow::refineMenu() const
{
    return m_header->refineMenu();
}

QMenu& MainWindow::segmentsMenu() const
{
    return m_header->segmentsMenu();
}

void MainWindow::buildCentre()
{
    auto* centre = new QWidget(this);
    auto* row = new QHBoxLayout(centre);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(0);
    row->addWidget(m_tools);
    // Options go over the panels too: beside them there is not room for all in a small window.
    auto* working = new QVBoxLayout;
    working->setSpacing(0);
    auto* options = new OptionBar(m_workspace, m_actions[QStringLiteral("edit.undo")],
        m_actions[QStringLiteral("edit.redo")], this);
    // There is nothing to undo on the start page either.
    options->hide();
    connect(m_pages, &QStackedWidget::currentChanged, options,
        [this, options] { options->setVisible(m_pages->currentWidget() == m_views); });
    working->addWidget(options);
    working->addWidget(m_splitter, 1);
    row->addLayout(working, 1);
    auto* middle = new QWidget(m_splitter);
    m_middle = new QVBoxLayout(middle);
    m_middle->setContentsMargins(0, 0, 0, 0);
    m_middle->setSpacing(0);
    // A wider window widens the pictures.
    m_splitter->addWidget(middle);
    m_splitter->addWidget(m_panels);
    m_splitter->setStretchFactor(0, 1);
    m_splitter->setStretchFactor(1, 0);
    m_splitter->setChildrenCollapsible(false);
    m_splitter->setHandleWidth(1);
    m_mending->hide();
    m_middle->addWidget(m_mending);
    // Over the foot of the pictures, which would move when it comes and goes.
    m_pictures = new QGridLayout;
    m_pictures->addWidget(m_pages, 0, 0);
    m_pictures->addWidget(m_loading, 0, 0, Qt::AlignBottom);
    m_loading->raise();
    auto* work = new LoadingBar(this);
    work->setObjectName(QStringLiteral("segmentWork"));
    m_pictures->addWidget(work, 0, 0, Qt::AlignBottom);
    work->raise();
    new SegmentWorkWatch(m_workspace, *work);
    m_middle->addLayout(m_pictures, 1);
    connect(m_pages, &QStackedWidget::currentChanged, this, &MainWindow::placeMessages);
    // A low window scrolls the start page instead of growing to it.
    m_startPage->setWidget(m_start);
    m_startPage->setWidgetResizable(true);
    m_startPage->setFrameShape(QFrame::NoFrame);
    m_pages->addWidget(m_startPage);
    m_pages->addWidget(m_views);
    placeMessages();
    m_views->keepClearOf(*m_messages);
    setCentralWidget(centre);

    m_tools->addTool(m_actions[QStringLiteral("tool.navigate")], tr("Navigate"));

    statusBar()->setSizeGripEnabled(false);
    statusBar()->setContentsMargins(0, 0, 0, 0);
    statusBar()->layout()->setContentsMargins(0, 0, 0, 0);
    statusBar()->addWidget(m_status, 1);

    connect(
        m_start, &StartPage::openFolderRequested, this, [this] { askForFolder(m_opener, *this); });
    connect(m_start, &StartPage::openFileRequested, this, [this] { askForFile(m_opener, *this); });
    connect(m_start, &StartPage::demonstrationRequested, this, &MainWindow::demonstrationRequested);
    connect(m_start, &StartPage::recentRequested, this,
        [this](const QString& path) { m_opener.open(path, RecentStudies::seriesOf(path)); });
    connect(m_start, &StartPage::sessionRequested, this,
        [this](const QString& file) { m_opener.openSession(file); });
}

void MainWindow::connectOpener()
{
    m_loading->follow(m_opener);
    // A study that takes the place of another would answer what a dialog asks about that one.
    m_opener.holdWhile([] { return QApplication::activeModalWidget() != nullptr; });
    connect(&m_opener, &StudyOpener::started, m_messages, &MessageBar::dismiss);
    connect(&m_opener, &StudyOpener::started, &m_actions, &Actions::refresh);
    connect(&m_opener, &StudyOpener::finished, &m_actions, &Actions::refresh);
    connect(&m_opener, &StudyOpener::sliceReady, this,
        [this](const auto& early) { m_shown->setEarly(early); });
    connect(&m_opener, &StudyOpener::finished, this, [this] { m_shown->setEarly(nullptr); });
    connect(&m_opener, &StudyOpener::failed, &m_workspace, &Workspace::fail);
    answerQuestions(m_opener, *m_messages, *this);
    connect(m_importer, &MaskImporter::isImage, this,
        [this](const QString& path) { m_opener.open(path); });
    connect(m_saver, &SessionSaver::imagesBegun, this, [this](const QString& target) {
        m_loading->begin(tr("Saving %1").arg(QFileInfo(target).fileName()));
    });
    connect(m_saver, &SessionSaver::imagesProgressed, m_loading, &LoadingBar::progress);
    connect(m_saver, &SessionSaver::imagesEnded, m_loading, &LoadingBar::end);
    connect(m_loading, &LoadingBar::aborted, m_saver, &SessionSaver::cancel);
}

void MainWindow::addTool(Tool& tool, QMenu& menu, const QKeySequence& key)
{
    QAction& action = m_actions.add({.id = QStringLiteral("tool.") + tool.iconName(),
        .text = tool.longName(),
        .keys = {key},
        .icon = tool.iconName(),
        .run =
            [this, &tool] {
                const bool taken = tool.endMode() || m_workspace.activeTool() != &tool;
                m_workspace.setActiveTool(taken ? &tool : nullptr);
                if (taken)
                    bringUpPanelOf(tool);
            },
        .possible = [this] { return m_workspace.volume() != nullptr; },
        .checked = [this, &tool] { return m_workspace.activeTool() == &tool; }});
    m_tools->addTool(action, tool.name());
    menu.addAction(&action);
    m_actions.refresh();
}

/// A tool that comes back with a study leaves the panels as they were.
void MainWindow::bringUpPanelOf(const Tool& tool)
{
    const char* wanted = m_panelsWanted ? panelOf(tool.iconName()) : nullptr;
    for (const Panel* panel : findChildren<Panel*>()) {
        if (wanted && panel->metaObject()->className() == QLatin1String(wanted))
            m_panels->bringUp(*panel);
    }
}

void MainWindow::addToolGroup()
{
    m_tools->addGroupLine();
}

void MainWindow::addPanel(Panel* panel)
{
    PanelSection& section = m_panels->add(panel);
    QAction& action = m_actions.add({.id = QStringLiteral("panel.") + section.id(),
        .text = panel->title(),
        .run = [this, &section] { m_panels->setWanted(section, !m_panels->isWanted(section)); },
        .checked = [this, &section] { return m_panels->isWanted(section); }});
    m_header->panelsMenu().addAction(&action);
}

void MainWindow::bringUp(const Panel& panel)
{
    showPanels(true);
    m_panels->bringUp(panel);
}

bool MainWindow::panelsShown() const
{
    return m_panelsWanted;
}

void MainWindow::showPanels(bool shown)
{
    m_panelsWanted = shown;
    m_panels->setUsable(m_workspace.volume() != nullptr);
    m_panels->showAll(shown && hasPictures());
    m_actions.refresh();
}

void MainWindow::resetPanels()
{
    m_panels->reset();
    m_splitter->setSizes({width(), PanelColumn::leastWidth});
    showPanels(true);
}

void MainWindow::restoreLayout()
{
    m_keepsLayout = true;
    const QSettings settings;
    // Nothing is kept the first time; and Qt takes no place of a screen of quite another width.
    if (restoreGeometry(settings.value(QStringLiteral("window/geometry")).toByteArray()))
        bringOntoScreens(*this);
    else
        resize(size().boundedTo(screen()->availableSize() - QSize(0, titleBarPixels)));
    m_panels->restore(settings);
    m_splitter->restoreState(settings.value(QStringLiteral("panels/splitter")).toByteArray());
    m_panelsWanted = settings.value(QStringLiteral("panels/shown"), true).toBool();
    showPanels(m_panelsWanted);
}

void MainWindow::closeEvent(QCloseEvent* event)
{
    if (!mayLoseUnwrittenSteps(m_workspace, *this, *m_saver)) {
        event->ignore();
        return;
    }
    if (m_keepsLayout) {
        QSettings settings;
        settings.setValue(QStringLiteral("window/geometry"), saveGeometry());
        settings.setValue(QStringLiteral("panels/splitter"), m_splitter->saveState());
        settings.setValue(QStringLiteral("panels/shown"), m_panelsWanted);
        m_panels->save(settings);
    }
    QMainWindow::closeEvent(event);
}

void MainWindow::showSession()
{
    if (!m_workspace.volume()) {
        m_workspace.setActiveTool(nullptr);
        m_shown->showEarlyAgain();
        m_start->showRecent(RecentStudies::paths());
        m_start->showSessions(m_sessionFolder);
    }
    showPages();
    m_shown->showCaution();
    if (m_workspace.volume())
        m_views->current().setFocus();
    m_actions.refresh();
}

bool MainWindow::hasPictures() const
{
    return m_shown->volume() || m_views->holdsPictures();
}

void MainWindow::showPages()
{
    const bool open = hasPictures();
    m_pages->setCurrentWidget(open ? static_cast<QWidget*>(m_views) : m_startPage);
    m_tools->setVisible(open);
    showPanels(m_panelsWanted);
    // Pictures are held for another point in time of the same patient.
    if (!m_views->holdsPictures() || m_shown->volume())
        m_header->showIdentity(m_shown->volume());
}

/// Over the pictures, which would move when a message comes and goes; above the start page, whose
/// buttons it would hide.
void MainWindow::placeMessages()
{
    m_middle->removeWidget(m_messages);
    m_pictures->removeWidget(m_messages);
    if (m_pages->currentWidget() == m_views)
        m_pictures->addWidget(m_messages, 0, 0, Qt::AlignTop);
    else
        m_middle->insertWidget(0, m_messages);
    m_messages->raise();
}

void MainWindow::showAbout()
{
    AboutDialog(m_graphics, this).exec();
}

void MainWindow::saveSessionAs()
{
    m_saver->ask();
}

void MainWindow::offerSessionsIn(const QString& folder)
{
    m_sessionFolder = folder;
    m_saver->setWorkingFolder(folder);
    if (!m_workspace.volume())
        m_start->showSessions(folder);
}

void MainWindow::closeStudy()
{
    // What is on its way goes first; a study that stayed open meanwhile stays.
    if (m_opener.busy())
        return m_opener.cancel();
    const QString said = m_messages->sentence();
    if (!mayLoseUnwrittenSteps(m_workspace, *this, *m_saver))
        return;
    // Messages shown so far are about the study; those that closing it brings up are to be read.
    if (m_messages->sentence() == said)
        m_messages->dismiss();
    m_workspace.setSession(nullptr);
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event)
{
    if (!droppedPaths(*event->mimeData()).isEmpty())
        event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event)
{
    const QStringList paths = droppedPaths(*event->mimeData());
    if (paths.isEmpty())
        return;
    event->acceptProposedAction();
    takeDropped(paths, m_workspace.session() != nullptr, m_opener, *m_importer, *m_messages);
}

} // namespace ui
