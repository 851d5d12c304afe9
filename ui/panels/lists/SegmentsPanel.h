// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/frame/Panel.h"

class QAction;
class QListView;
class QMenu;
class QLabel;

namespace ui {

class SegmentListModel;
class Workspace;

/// The panel of segments: whether each is shown, its colour, name, code and volume; a click makes
/// one the active segment.
class SegmentsPanel : public Panel {
    Q_OBJECT

public:
    explicit SegmentsPanel(Workspace& workspace, QWidget* parent = nullptr);

    [[nodiscard]] QString title() const override;
    [[nodiscard]] QString summary() const override;

private:
    void chooseColour(const QModelIndex& index);
    void chooseCode(const QModelIndex& index);
    void move(const QModelIndex& index, int by);
    void showMenu(const QPoint& position);
    void addPassages(QMenu& menu, const QModelIndex& index);
    void remove(const QModelIndex& index);
    void refresh();

    Workspace& m_workspace;
    SegmentListModel* m_model = nullptr;
    QListView* m_view = nullptr;
    QLabel* m_empty = nullptr;
    QAction* m_add = nullptr;
    QAction* m_remove = nullptr;
};

} // namespace ui
