// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QToolButton;

namespace ui {

class Workspace;

/// The settings of drill or laser in the option bar; always in step with
/// Workspace::drillSettings().
class DrillOptions : public QWidget {
    Q_OBJECT

public:
    static constexpr double minimumRadiusMm = 0.5;
    static constexpr double maximumRadiusMm = 60.0;
    static constexpr double minimumDepthMm = 0.5;
    static constexpr double maximumDepthMm = 120.0;
    static constexpr double minimumHeightRatio = 0.05;
    static constexpr double minimumFloorMm = 1.0;
    static constexpr double maximumFloorMm = 200.0;
    static constexpr double maximumSoftnessMm = 30.0;

    /// Which tool they are of: drill and laser differ in their depth.
    enum class Of { Drill, Laser };
    explicit DrillOptions(Workspace& workspace, Of tool, QWidget* parent = nullptr);

    /// Whether the next drag draws a freehand mask's outline.
    void showDrawing(bool drawing);

Q_SIGNALS:
    void outlineAsked(bool wanted); ///< to be drawn

private:
    void showSettings();
    void takeSettings();
    void takeShape(int index);
    void showSize();

    [[nodiscard]] bool ofLaser() const { return m_tool == Of::Laser; }

    Workspace& m_workspace;
    Of m_tool;
    QComboBox* m_shape = nullptr;
    QToolButton* m_outline = nullptr; ///< freehand
    QDoubleSpinBox* m_radius = nullptr;
    QDoubleSpinBox* m_height = nullptr; ///< per cent of the width
    QDoubleSpinBox* m_turn = nullptr;
    QDoubleSpinBox* m_softness = nullptr;
    QComboBox* m_mode = nullptr;
    QDoubleSpinBox* m_depth = nullptr;
    QDoubleSpinBox* m_floor = nullptr; ///< mode Rate
    QComboBox* m_sweep = nullptr; ///< the drill's
    QCheckBox* m_throughGaps = nullptr;
    QLabel* m_radiusLabel = nullptr;
    QLabel* m_start = nullptr;
};

} // namespace ui
