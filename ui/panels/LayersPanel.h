// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/panels/Panel.h"

class QListView;
class QMenu;

namespace ui {

class LayerListModel;
class Workspace;

/// The sculpt layers: muted or not, name; a click makes one the layer that tools carve. Folded at
/// first, since one layer is what most sessions have.
class LayersPanel : public Panel {
    Q_OBJECT

public:
    explicit LayersPanel(Workspace& workspace, QWidget* parent = nullptr);

    [[nodiscard]] QString title() const override;
    [[nodiscard]] QString summary() const override;
    [[nodiscard]] bool foldedAtFirst() const override { return true; }

private:
    void add();
    void move(const QModelIndex& index, int by);
    void showMenu(const QPoint& position);
    void addPassages(QMenu& menu, int layer);
    void refresh();

    Workspace& m_workspace;
    LayerListModel* m_model = nullptr;
    QListView* m_view = nullptr;
    QAction* m_add = nullptr;
};

} // namespace ui
