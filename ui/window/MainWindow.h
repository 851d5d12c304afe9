// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/brick/ThreadWithoutVoxels.h"
#include "ui/base/Actions.h"
#include "ui/settings/StudyOpener.h"
#include "ui/workspace/Workspace.h"

#include <QMainWindow>

class QGridLayout;
class QScrollArea;
class QSplitter;
class QStackedWidget;
class QVBoxLayout;

namespace ui {

class BookmarkMenu;
class LoadingBar;
class MessageBar;
class OptionBar;
class Panel;
class PanelColumn;
class MaskImporter;
class MendingStrip;
class SessionSaver;
class ShownStudy;
class StartPage;
class StatusLine;
class ToolColumn;
class ViewGrid;
class WindowHeader;

/// The main window: it lays out the views, tools and panels and shows whose study is open. What the
/// user can do is in Actions, and the work is done by views, tools and panels.
class MainWindow : public QMainWindow {
    Q_OBJECT

public:
    /// @param graphics the renderer's name and version, for About
    MainWindow(Workspace& workspace, const QString& graphics);
    ~MainWindow() override;

    /// Adds a tool to the column at the left and to @p menu. Pressing @p key activates the tool;
    /// pressing it again deactivates it.
    void addTool(Tool& tool, QMenu& menu, const QKeySequence& key);
    void addToolGroup();
    /// Adds a panel at the bottom of the right column and to the View menu. The window owns it.
    void addPanel(Panel* panel);
    /// Shows the panels, with this one unfolded.
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
    [[nodiscard]] LoadingBar& loading() const { return *m_loading; }
    [[nodiscard]] MendingStrip& mendingStrip() const { return *m_mending; }
    [[nodiscard]] StudyOpener& opener() { return m_opener; }
    [[nodiscard]] SessionSaver& saver() const { return *m_saver; }
    [[nodiscard]] Actions& actionTable() { return m_actions; }
    [[nodiscard]] bool panelsShown() const;
    void showPanels(bool shown);
    /// Restores the panels of the first start: all in the column.
    void resetPanels();

    /// Makes the start page list the sessions in a folder, which were not named by the user.
    void offerSessionsIn(const QString& folder);

    /// Restores size and panels from when a window was last closed. From now on closing stores
    /// them.
    void restoreLayout();

    void showAbout();
    void saveSessionAs();
    [[nodiscard]] MaskImporter& importer() { return *m_importer; }
    /// Closes the study, unless the user wants to keep steps that are not on disk yet.
    void closeStudy();

Q_SIGNALS:
    void demonstrationRequested();

protected:
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;
    void closeEvent(QCloseEvent* event) override;

private:
    void buildCentre();
    void connectOpener();
    void showSession();
    [[nodiscard]] bool hasPictures() const; ///< else the start page is shown
    void showPages();
    void placeMessages();
    void bringUpPanelOf(const Tool& tool);

    /// Forbids work on voxels in this thread: changes are only passed on.
    core::ThreadWithoutVoxels m_here;
    Workspace& m_workspace;
    QString m_graphics;
    Actions m_actions;
    StudyOpener m_opener;
    WindowHeader* m_header;
    ToolColumn* m_tools;
    LoadingBar* m_loading;
    MessageBar* m_messages;
    MendingStrip* m_mending; ///< hidden at first
    QVBoxLayout* m_middle = nullptr; ///< the pictures and what stands above them
    QGridLayout* m_pictures = nullptr; ///< the pictures and what lies over them
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
