// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/frame/Panel.h"

class QLabel;
class QListView;
class QMenu;
class QSlider;

namespace ui {

class LayerListModel;
class Workspace;

/// The panel of sculpt layers: whether each is muted, and its name; a click makes one the layer
/// that tools carve. Below the list, the user sets how much of what the active layer carves is
/// hidden. Folded at first, since most sessions have a single layer.
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
    void buildLook();
    void showLook();
    void takeLook();

    Workspace& m_workspace;
    LayerListModel* m_model = nullptr;
    QListView* m_view = nullptr;
    QAction* m_add = nullptr;
    QWidget* m_look = nullptr; ///< how the active layer hides
    QSlider* m_hides = nullptr;
    QLabel* m_hidesText = nullptr;
    QSlider* m_softness = nullptr;
    QLabel* m_softnessText = nullptr;
};

} // namespace ui
