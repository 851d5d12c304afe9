// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>

class QCheckBox;
class QDoubleSpinBox;
class QPushButton;
class QSlider;

namespace ui {

class PeelTool;

/// The options of the peel tool in the option bar: depth, what counts as a gap, and the button that
/// keeps an open peel.
class PeelOptions : public QWidget {
    Q_OBJECT

public:
    explicit PeelOptions(PeelTool& tool, QWidget* parent = nullptr);

private:
    void showSettings();
    void takeGaps();

    PeelTool& m_tool;
    QSlider* m_slider;
    QDoubleSpinBox* m_depth;
    QPushButton* m_keep;
    QCheckBox* m_through;
    QDoubleSpinBox* m_jump;
};

} // namespace ui
