// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/brick/ThreadWithoutVoxels.h"
#include "ui/base/Actions.h"
#include "ui/settings/StudyOpener.h"
#include "ui/workspace/Workspace.h"

#include <QMainWindow>

class QScrollArea;
class QSplitter;
class QStackedWidget;

namespace ui {

class BookmarkMenu;
class LoadingBar;
class MessageBar;
class OptionBar;
class Panel;
class PanelColumn;
class MaskImporter;
class SessionSaver;
class ShownStudy;
class StartPage;
class StatusLine;
class ToolColumn;
class ViewGrid;
class WindowHeader;

/// Lays the window out and shows whose study is open. What can be done is in Actions, what happens
/// in the views, tools and panels.
class MainWindow : public QMainWindow {
    Q_OBJECT

public:
    /// @param graphics the renderer's name and version, for About
    MainWindow(Workspace& workspace, const QString& graphics);
    ~MainWindow() override;

    /// The tool appears in the column at the left and in @p menu; @p key takes it up, and once more
    /// lays it down.
    void addTool(Tool& tool, QMenu& menu, const QKeySequence& key);
    void addToolGroup();
    /// The panel appears in the right column, below those before it, and in the View menu. The
    /// window owns it.
    void addPanel(Panel* panel);
    /// Shows the panels, and this one of them unfolded.
    void bringUp(const Panel& panel);
    [[nodiscard]] QMenu& fileMenu() const;
    [[nodiscard]] QMenu& editMenu() const;
    [[nodiscard]] QMenu& sculptMenu() const;
    [[nodiscard]] QMenu& growMenu() const;
    [[nodiscard]] QMenu& refineMenu() const;
    [[nodiscard]] QMenu& segmentsMenu() const;

    [[nodiscard]] Workspace& workspace() const { return m_workspace; }
    [[nodiscard]] ViewGrid& views() const { return *m_views; }
    [[nodiscard]] BookmarkMenu& bookmarks() const { return *m_bookmarks; }
    [[nodiscard]] MessageBar& messages() const { return *m_messages; }
    [[nodiscard]] StudyOpener& opener() { return m_opener; }
    [[nodiscard]] SessionSaver& saver() const { return *m_saver; }
    [[nodiscard]] Actions& actionTable() { return m_actions; }
    [[nodiscard]] bool panelsShown() const;
    void showPanels(bool shown);
    /// The panels as at the first start: all in the column.
    void resetPanels();

    /// The start page offers the sessions in a folder; they have no names of the user's own.
    void offerSessionsIn(const QString& folder);

    /// Size and panels as they were when a window was closed last; from now on closing keeps them.
    void restoreLayout();

    void showAbout();
    void saveSessionAs();
    [[nodiscard]] MaskImporter& importer() { return *m_importer; }
    /// Unless the user would rather keep steps that are not on disk yet.
    void closeStudy();

Q_SIGNALS:
    void demonstrationAsked();

protected:
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;
    void closeEvent(QCloseEvent* event) override;

private:
    void buildCentre();
    void connectOpener();
    void showSession();
    void showPages();

    core::ThreadWithoutVoxels m_here; ///< what changes is handed on here, and not looked at
    Workspace& m_workspace;
    QString m_graphics;
    Actions m_actions;
    StudyOpener m_opener;
    WindowHeader* m_header;
    ToolColumn* m_tools;
    LoadingBar* m_loading;
    MessageBar* m_messages;
    QStackedWidget* m_pages;
    QScrollArea* m_startPage; ///< holds m_start
    StartPage* m_start;
    ViewGrid* m_views;
    ShownStudy* m_shown;
    StatusLine* m_status;
    PanelColumn* m_panels;
    QSplitter* m_splitter;
    SessionSaver* m_saver;
    MaskImporter* m_importer;
    QString m_sessionFolder;
    BookmarkMenu* m_bookmarks;
    bool m_panelsWanted = true;
    bool m_keepsLayout = false;
};

} // namespace ui
