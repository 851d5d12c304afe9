// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QFrame>

class QMenu;
class QMenuBar;
class QToolButton;

namespace core {
struct Volume;
}

namespace ui {

class Actions;
class FittingLabel;
class Workspace;

/// The actions for the layouts of the views, in the order of menus: of View, of the button, and of
/// right clicks.
[[nodiscard]] QStringList layoutIds();

/// The header of the window: its menus, whose study is shown, and the layouts of the views.
class WindowHeader : public QFrame {
    Q_OBJECT

public:
    WindowHeader(Workspace& workspace, QWidget* parent);

    /// @param plane, stage ids of the actions for these two submenus of View
    void fillMenus(Actions& actions, const QStringList& plane, const QStringList& stage);
    /// Shows whose study it is, here and in the title of the window. Null: no study.
    void showIdentity(const core::Volume* volume);

    [[nodiscard]] QMenu& fileMenu() const { return *m_fileMenu; }
    [[nodiscard]] QMenu& editMenu() const { return *m_editMenu; }
    [[nodiscard]] QMenu& sculptMenu() const { return *m_sculptMenu; }
    [[nodiscard]] QMenu& growMenu() const { return *m_growMenu; }
    [[nodiscard]] QMenu& refineMenu() const { return *m_refineMenu; }
    [[nodiscard]] QMenu& segmentsMenu() const { return *m_segmentsMenu; }
    [[nodiscard]] QMenu& bookmarksMenu() const { return *m_bookmarksMenu; }
    [[nodiscard]] QMenu& panelsMenu() const { return *m_panelsMenu; }

private:
    void fillViewMenu(Actions& actions, const QStringList& plane, const QStringList& stage);

    Workspace& m_workspace;
    QMenuBar* m_menuBar;
    FittingLabel* m_identity;
    QToolButton* m_layouts; ///< hidden while there are no views
    QMenu* m_fileMenu = nullptr;
    QMenu* m_editMenu = nullptr;
    QMenu* m_sculptMenu = nullptr;
    QMenu* m_growMenu = nullptr;
    QMenu* m_refineMenu = nullptr;
    QMenu* m_segmentsMenu = nullptr;
    QMenu* m_bookmarksMenu = nullptr;
    QMenu* m_panelsMenu = nullptr;
};

} // namespace ui
