// SPDX-License-Identifier: Apache-2.0
#include "ui/window/MainWindow.h"

#include "ui/base/ErrorText.h"
#include "ui/base/Icons.h"
#include "ui/base/StudyTexts.h"
#include "ui/base/Theme.h"
#include "ui/base/TimeText.h"
#include "ui/dialogs/AboutDialog.h"
#include "ui/dialogs/session/SessionSaver.h"
#include "ui/dialogs/session/UnwrittenSteps.h"
#include "ui/dialogs/study/OpenDialogs.h"
#include "ui/frame/LoadingBar.h"
#include "ui/frame/MessageBar.h"
#include "ui/frame/Panel.h"
#include "ui/frame/PanelColumn.h"
#include "ui/frame/PanelSection.h"
#include "ui/frame/ReadOnlyMark.h"
#include "ui/frame/StartPage.h"
#include "ui/frame/ToolColumn.h"
#include "ui/input/Tool.h"
#include "ui/overlays/CautionStrip.h"
#include "ui/settings/RecentStudies.h"
#include "ui/tasks/MaskImporter.h"
#include "ui/views/ViewGrid.h"
#include "ui/widgets/FieldManners.h"
#include "ui/widgets/FittingLabel.h"
#include "ui/window/BookmarkMenu.h"
#include "ui/window/OptionBar.h"
#include "ui/window/PlaneActions.h"
#include "ui/window/StageActions.h"
#include "ui/window/StatusLine.h"
#include "ui/window/WindowActions.h"

#include <QApplication>
#include <QDragEnterEvent>
#include <QFileInfo>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QMenuBar>
#include <QMimeData>
#include <QScrollArea>
#include <QSettings>
#include <QSplitter>
#include <QStackedWidget>
#include <QStatusBar>
#include <QVBoxLayout>

namespace ui {

namespace {

QString droppedPath(const QMimeData& data)
{
    for (const QUrl& url : data.urls()) {
        if (url.isLocalFile())
            return url.toLocalFile();
    }
    return {};
}

QString cautionSentence(const core::Volume& volume)
{
    return QStringLiteral("%1 Views and exports carry this caution until you accept it.")
        .arg(cautionText(volume));
}

} // namespace

MainWindow::MainWindow(Workspace& workspace, const QString& graphics)
    : m_workspace(workspace)
    , m_graphics(graphics)
    , m_actions(*this)
    , m_menuBar(new QMenuBar(this))
    , m_readOnly(new ReadOnlyMark(workspace, this))
    , m_identity(new FittingLabel(Qt::AlignRight, this))
    , m_tools(new ToolColumn(this))
    , m_loading(new LoadingBar(this))
    , m_messages(new MessageBar(this))
    , m_pages(new QStackedWidget(this))
    , m_startPage(new QScrollArea(this))
    , m_start(new StartPage)
    , m_views(new ViewGrid(workspace, this))
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
    buildMenus();
    buildCentre();
    connectOpener();

    const auto refresh = [this] { m_actions.refresh(); };
    connect(&workspace, &Workspace::documentChanged, this, refresh);
    connect(&workspace, &Workspace::activeSegmentChanged, this, refresh);
    connect(&workspace, &Workspace::activeLayerChanged, this, refresh);
    connect(&workspace, &Workspace::activeToolChanged, this, refresh);
    connect(&workspace, &Workspace::volumeDisplayChanged, this, refresh);
    connect(&workspace, &Workspace::viewOptionsChanged, this, refresh);
    connect(&workspace, &Workspace::windowLevelChanged, this, refresh);
    connect(&workspace, &Workspace::clipChanged, this, refresh);
    connect(m_views, &ViewGrid::layoutChanged, this, refresh);
    connect(m_panels, &PanelColumn::changed, this, refresh);
    connect(m_views, &ViewGrid::frameTimed, m_status, &StatusLine::showFrameTime);
    connect(&workspace, &Workspace::sessionChanged, this, &MainWindow::showSession);
    connect(&workspace, &Workspace::sessionSaved, this, [this] {
        m_messages->dismiss();
        showIdentity();
        m_actions.refresh();
    });
    connect(&workspace, &Workspace::offered, this, [this](const Workspace::Offer& made) {
        m_messages->show(MessageBar::Kind::Notice, made.sentence, made.button, made.run);
    });
    connect(&workspace, &Workspace::failed, this, [this](const core::Error& error) {
        m_messages->show(MessageBar::Kind::Error, errorText(error));
    });
    showSession();
}

MainWindow::~MainWindow() = default;

void MainWindow::buildMenus()
{
    const auto ids = [](std::initializer_list<const char*> names) {
        QStringList list;
        for (const char* name : names)
            list += QLatin1String(name);
        return list;
    };
    const QStringList plane = addPlaneActions(*this);
    const QStringList stage = addStageActions(*this);
    m_fileMenu = m_menuBar->addMenu(QStringLiteral("&File"));
    m_actions.fill(*m_fileMenu,
        ids({"file.openFolder", "file.openFile", "file.openSession", "file.fromPacs",
            "file.demonstration", "", "file.importMask", "file.toPacs", "file.saveAs",
            "file.auditReport", "file.close", "file.quit"}));
    m_editMenu = m_menuBar->addMenu(QStringLiteral("&Edit"));
    m_actions.fill(
        *m_editMenu, ids({"edit.undo", "edit.redo", "", "edit.author", "edit.historyMemory"}));

    QMenu* view = m_menuBar->addMenu(QStringLiteral("&View"));
    m_actions.fill(*view,
        ids({"view.four", "view.penAndStage", "view.volume", "view.axial", "view.sagittal",
            "view.coronal", "view.plane", "view.penApart", "", "view.reset", "view.resetAll", "",
            "view.bookmark"}));
    m_bookmarks->fill(*view->addMenu(QStringLiteral("Bookmarks")));
    view->addSeparator();
    QMenu* grey = view->addMenu(QStringLiteral("Grey scale"));
    for (int number = 1; number <= 9; ++number)
        grey->addAction(&m_actions[QStringLiteral("window.preset%1").arg(number)]);
    grey->addSeparator();
    grey->addAction(&m_actions[QStringLiteral("view.inverted")]);
    QMenu* volume = view->addMenu(QStringLiteral("3D"));
    m_actions.fill(*volume,
        ids({"view.surface", "view.dvr", "view.mip", "view.xray", "", "view.fromFront",
            "view.fromBack", "view.fromLeft", "view.fromRight", "view.fromAbove",
            "view.fromBelow"}));
    m_actions.fill(*view->addMenu(QStringLiteral("Stage")), stage);
    m_actions.fill(*view->addMenu(QStringLiteral("Cutting plane")), plane);
    view->addSeparator();
    m_actions.fill(*view,
        ids({"view.crosshair", "view.patient", "view.segments", "view.carved", "view.hole",
            "view.barriers", ""}));
    m_panelsMenu = view->addMenu(QStringLiteral("Panels"));
    m_actions.fill(*m_panelsMenu, ids({"view.panels", "view.resetPanels", ""}));
    m_actions.fill(*view, ids({"view.fullScreen"}));

    m_sculptMenu = m_menuBar->addMenu(QStringLiteral("S&culpt"));
    m_growMenu = m_menuBar->addMenu(QStringLiteral("&Grow"));
    m_refineMenu = m_menuBar->addMenu(QStringLiteral("&Refine"));
    m_segmentsMenu = m_menuBar->addMenu(QStringLiteral("&Segments"));
    m_actions.fill(*m_segmentsMenu, ids({"segments.add", "segments.remove"}));
    QMenu* help = m_menuBar->addMenu(QStringLiteral("&Help"));
    m_actions.fill(*help, ids({"help.keys", "help.pen", "help.about"}));

    m_identity->setFont(theme::smallFont());
    m_identity->setProperty("role", QStringLiteral("secondary"));
    m_identity->setContentsMargins(0, 0, theme::padding, 0);

    auto* header = new QFrame(this);
    header->setProperty("role", QStringLiteral("panel"));
    auto* row = new QHBoxLayout(header);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(theme::padding);
    m_menuBar->setSizePolicy(QSizePolicy::Maximum, QSizePolicy::Preferred);
    row->addWidget(m_menuBar);
    row->addWidget(m_readOnly);
    row->addWidget(m_identity, 1);
    setMenuWidget(header);
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
    auto* column = new QVBoxLayout(middle);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    // A wider window widens the pictures.
    m_splitter->addWidget(middle);
    m_splitter->addWidget(m_panels);
    m_splitter->setStretchFactor(0, 1);
    m_splitter->setStretchFactor(1, 0);
    m_splitter->setChildrenCollapsible(false);
    m_splitter->setHandleWidth(1);
    column->addWidget(m_messages);
    // Over the foot of the pictures, which would move when it comes and goes.
    auto* pictures = new QGridLayout;
    pictures->addWidget(m_pages, 0, 0);
    pictures->addWidget(m_loading, 0, 0, Qt::AlignBottom);
    m_loading->raise();
    column->addLayout(pictures, 1);
    // A low window scrolls the start page instead of growing to it.
    m_startPage->setWidget(m_start);
    m_startPage->setWidgetResizable(true);
    m_startPage->setFrameShape(QFrame::NoFrame);
    m_pages->addWidget(m_startPage);
    m_pages->addWidget(m_views);
    setCentralWidget(centre);

    m_tools->addTool(m_actions[QStringLiteral("tool.navigate")], QStringLiteral("Navigate"));

    statusBar()->setSizeGripEnabled(false);
    statusBar()->setContentsMargins(0, 0, 0, 0);
    statusBar()->layout()->setContentsMargins(0, 0, 0, 0);
    statusBar()->addWidget(m_status, 1);

    connect(m_start, &StartPage::openFolderAsked, this, [this] { askForFolder(m_opener, *this); });
    connect(m_start, &StartPage::openFileAsked, this, [this] { askForFile(m_opener, *this); });
    connect(m_start, &StartPage::demonstrationAsked, this, &MainWindow::demonstrationAsked);
    connect(m_start, &StartPage::recentAsked, this,
        [this](const QString& path) { m_opener.open(path, RecentStudies::seriesOf(path)); });
    connect(m_start, &StartPage::sessionAsked, this,
        [this](const QString& file) { m_opener.openSession(file); });
}

void MainWindow::connectOpener()
{
    m_loading->follow(m_opener);
    connect(&m_opener, &StudyOpener::started, m_messages, &MessageBar::dismiss);
    connect(&m_opener, &StudyOpener::started, &m_actions, &Actions::refresh);
    connect(&m_opener, &StudyOpener::finished, &m_actions, &Actions::refresh);
    connect(&m_opener, &StudyOpener::sliceReady, this, [this](const auto& early) {
        m_early = early;
        showEarlySlice(early);
    });
    connect(&m_opener, &StudyOpener::finished, this, [this] {
        m_early.reset();
        showEarlySlice(nullptr);
    });
    connect(&m_opener, &StudyOpener::failed, &m_workspace, &Workspace::fail);
    connect(
        &m_opener, &StudyOpener::choiceNeeded, this,
        [this](const auto& study) { chooseVolume(study, m_opener, *this); }, Qt::QueuedConnection);
    connect(
        &m_opener, &StudyOpener::spacingNeeded, this,
        [this](const auto& study, const QString& series) {
            askForSpacing(study, series, m_opener, *this);
        },
        Qt::QueuedConnection);
    connect(&m_opener, &StudyOpener::sessionStudyNeeded, this,
        [this](const QString& file, const QString& format, const core::Error& why) {
            offerToFindStudy({file, format, why}, *m_messages, m_opener, *this);
        });
    connect(m_saver, &SessionSaver::imagesBegun, this, [this](const QString& target) {
        m_loading->begin(QStringLiteral("Saving %1").arg(QFileInfo(target).fileName()));
    });
    connect(m_saver, &SessionSaver::imagesProgressed, m_loading, &LoadingBar::progress);
    connect(m_saver, &SessionSaver::imagesEnded, m_loading, &LoadingBar::end);
    connect(m_loading, &LoadingBar::aborted, m_saver, &SessionSaver::cancel);
}

void MainWindow::addTool(Tool& tool, QMenu& menu, const QKeySequence& key)
{
    QAction& action = m_actions.add({.id = QStringLiteral("tool.") + tool.iconName(),
        .text = tool.name(),
        .keys = {key},
        .icon = tool.iconName(),
        .run =
            [this, &tool] {
                m_workspace.setActiveTool(m_workspace.activeTool() == &tool ? nullptr : &tool);
            },
        .possible = [this] { return m_workspace.volume() != nullptr; },
        .checked = [this, &tool] { return m_workspace.activeTool() == &tool; }});
    m_tools->addTool(action, tool.name());
    menu.addAction(&action);
    m_actions.refresh();
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
    m_panelsMenu->addAction(&action);
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
    m_panels->showAll(shown && shownVolume());
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
    restoreGeometry(settings.value(QStringLiteral("window/geometry")).toByteArray());
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

const core::Volume* MainWindow::shownVolume() const
{
    const core::EarlySlice* early = m_views->earlySlice();
    return early && !m_workspace.volume() ? &early->volume : m_workspace.volume();
}

void MainWindow::showSession()
{
    if (!m_workspace.volume()) {
        m_workspace.setActiveTool(nullptr);
        // What takes the closed study's place is on its way already.
        if (m_early)
            showEarlySlice(m_early);
        m_start->showRecent(RecentStudies::paths());
        m_start->showSessions(m_sessionFolder);
    }
    showPages();
    showCaution();
    if (m_workspace.volume())
        m_views->current().setFocus();
    m_actions.refresh();
}

void MainWindow::showEarlySlice(const std::shared_ptr<const core::EarlySlice>& early)
{
    const core::EarlySlice* before = m_views->earlySlice();
    const QString said = before ? cautionSentence(before->volume) : QString();
    // An open study stays, and can be worked on, until the next one is there.
    if (!m_views->showEarlySlice(m_workspace.session() ? nullptr : early) && !before)
        return;
    showPages();
    // The bar takes its room now, lest the picture move when it comes.
    if (early && early->volume.needsCaution())
        m_messages->show(MessageBar::Kind::Caution, cautionSentence(early->volume));
    else if (!m_workspace.volume() && m_messages->sentence() == said)
        m_messages->dismiss();
}

void MainWindow::showPages()
{
    const bool open = shownVolume() != nullptr;
    m_pages->setCurrentWidget(open ? static_cast<QWidget*>(m_views) : m_startPage);
    m_tools->setVisible(open);
    showPanels(m_panelsWanted);
    showIdentity();
}

void MainWindow::showIdentity()
{
    const core::Volume* volume = shownVolume();
    if (!volume) {
        setWindowTitle(QStringLiteral("Burin"));
        m_identity->clear();
        m_identity->setToolTip(QString());
        return;
    }
    QStringList parts{patientText(volume->identity), studyText(volume->identity),
        seriesText(volume->identity), timeText(*volume)};
    parts.removeAll(QString());
    const QString text = parts.join(QStringLiteral(" · "));
    const bool readOnly = m_workspace.session() && !m_workspace.session()->whyReadOnly().isEmpty();
    setWindowTitle(text + (readOnly ? QStringLiteral(" (read-only)") : QString())
        + QStringLiteral(" — Burin"));
    m_identity->setToolTip(text);
    m_identity->setText(text);
}

void MainWindow::showCaution()
{
    const core::Volume* volume = m_workspace.volume();
    m_messages->dismiss();
    if (!volume || !volume->needsCaution() || m_workspace.cautionAccepted())
        return;
    m_messages->show(MessageBar::Kind::Caution, cautionSentence(*volume), QStringLiteral("Accept"),
        [this] { m_workspace.acceptCaution(); });
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
    if (!mayLoseUnwrittenSteps(m_workspace, *this, *m_saver))
        return;
    m_workspace.setSession(nullptr);
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event)
{
    if (!droppedPath(*event->mimeData()).isEmpty())
        event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event)
{
    const QString path = droppedPath(*event->mimeData());
    if (path.isEmpty())
        return;
    event->acceptProposedAction();
    if (m_workspace.session() && MaskImporter::looksLikeMask(path))
        return m_importer->import(path);
    m_opener.open(path);
}

} // namespace ui
