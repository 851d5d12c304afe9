// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/document/Piece.h"
#include "ui/frame/Panel.h"

#include <array>

class QAction;
class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QListView;
class QSlider;
class QToolButton;

namespace ui {

class ColorButton;
class PieceListModel;
class VolumeView;
class Workspace;

/// The panel of pieces: whether each is shown, its name, and its distance from its true place; for
/// the active one its pose in numbers, opacity, colour and colour map.
class PiecesPanel : public Panel {
    Q_OBJECT

public:
    /// @param view the 3D view to which "open like a lid" refers
    PiecesPanel(Workspace& workspace, VolumeView& view, QWidget* parent = nullptr);

    [[nodiscard]] QString title() const override;
    [[nodiscard]] QString summary() const override;
    [[nodiscard]] bool foldedAtFirst() const override { return true; }

private:
    void build();
    void connectParts();
    void refresh();
    void showPiece();
    void showMaps();
    void takePose();
    void takeLook();
    void showMenu(const QPoint& position);
    [[nodiscard]] const core::Piece* active() const;

    Workspace& m_workspace;
    VolumeView& m_view;
    PieceListModel* m_model = nullptr;
    QListView* m_list = nullptr;
    QLabel* m_empty = nullptr;
    QWidget* m_editor = nullptr;
    std::array<QDoubleSpinBox*, 3> m_offset{};
    std::array<QDoubleSpinBox*, 3> m_turn{};
    QDoubleSpinBox* m_zoom = nullptr;
    QSlider* m_opacity = nullptr;
    ColorButton* m_colour = nullptr;
    QToolButton* m_plain = nullptr;
    QComboBox* m_map = nullptr; ///< choices: the scene's, a segment's body, presets
    QToolButton* m_home = nullptr;
    QToolButton* m_lid = nullptr;
    QToolButton* m_allHome = nullptr;
};

} // namespace ui
