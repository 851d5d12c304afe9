// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QLabel;

namespace ui {

class Workspace;

/// The drill's settings in the option bar; always in step with Workspace::drillSettings().
class DrillOptions : public QWidget {
    Q_OBJECT

public:
    static constexpr double minimumRadiusMm = 0.5;
    static constexpr double maximumRadiusMm = 60.0;
    static constexpr double minimumDepthMm = 0.5;
    static constexpr double maximumDepthMm = 120.0;
    static constexpr double minimumHeightRatio = 0.05;

    explicit DrillOptions(Workspace& workspace, QWidget* parent = nullptr);

private:
    void showSettings();
    void takeSettings();

    Workspace& m_workspace;
    QComboBox* m_shape = nullptr;
    QDoubleSpinBox* m_radius = nullptr;
    QDoubleSpinBox* m_height = nullptr; ///< per cent of the width
    QDoubleSpinBox* m_turn = nullptr;
    QComboBox* m_mode = nullptr;
    QDoubleSpinBox* m_depth = nullptr;
    QCheckBox* m_throughGaps = nullptr;
    QLabel* m_radiusLabel = nullptr;
    QLabel* m_start = nullptr;
};

} // namespace ui
