// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/frame/Panel.h"

#include <QTimer>

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QProgressBar;
class QPushButton;
class QSlider;

namespace core {
struct Segment;
}

namespace ui {

class Workspace;

/// The panel that divides a segment and its surroundings into chunks (seed B §4.2): it sets how
/// many there are, and how they are shown.
class ChunksPanel : public Panel {
    Q_OBJECT

public:
    explicit ChunksPanel(Workspace& workspace, QWidget* parent = nullptr);

    [[nodiscard]] QString title() const override;
    [[nodiscard]] QString summary() const override;
    [[nodiscard]] bool foldedAtFirst() const override { return true; }

private:
    void buildDividing();
    void buildSource();
    void chooseMap();
    void suitMargin(const core::Segment& segment);
    void buildLook();
    void show();
    void showHint();
    void showStage();
    void takeLook();

    Workspace& m_workspace;
    QLabel* m_whose = nullptr;
    QDoubleSpinBox* m_margin = nullptr;
    bool m_marginByHand = false; ///< set for this session; else it suits the active segment
    QPushButton* m_divide = nullptr;
    QComboBox* m_source = nullptr; ///< its data: the file of a probability map
    int m_chosenSource = 0; ///< the choice that stays if no file is chosen
    QWidget* m_waiting = nullptr; ///< shown while chunks are being computed
    QProgressBar* m_progress = nullptr;
    QLabel* m_step = nullptr;
    QTimer m_asking; ///< polls the progress
    QWidget* m_looks = nullptr; ///< shown while there is a division
    QCheckBox* m_shown = nullptr;
    QLabel* m_state = nullptr;
    QSlider* m_count = nullptr; ///< 100 · logarithm of the number
    QLabel* m_countText = nullptr;
    QSlider* m_opacity = nullptr;
    QLabel* m_opacityText = nullptr;
    QComboBox* m_bodies = nullptr;
    QLabel* m_hint = nullptr;
};

} // namespace ui
