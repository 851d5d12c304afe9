// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/workspace/Workspace.h"

#include <QWidget>

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QToolButton;

namespace ui {

/// The options of drill or laser in the option bar; always in step with Workspace::drillSettings().
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

    /// The tool for which they are: drill and laser have separate depths.
    enum class Of { Drill, Laser };
    explicit DrillOptions(Workspace& workspace, Of tool, QWidget* parent = nullptr);

    /// How large the mask is: "radius 3.0 mm", or "width 6.0 mm" where it is no circle.
    [[nodiscard]] static QString sizeText(const Workspace::DrillSettings& settings);

    /// Shows whether the next drag draws the outline of a freehand mask.
    void showDrawing(bool drawing);

Q_SIGNALS:
    void outlineRequested(bool wanted); ///< the user wants to draw the outline

private:
    void showSettings();
    void takeSettings();
    void takeShape(int index);
    void showSize();

    [[nodiscard]] bool ofLaser() const { return m_tool == Of::Laser; }

    Workspace& m_workspace;
    Of m_tool;
    QComboBox* m_shape = nullptr;
    QToolButton* m_outline = nullptr; ///< for a freehand mask
    QDoubleSpinBox* m_radius = nullptr;
    QDoubleSpinBox* m_height = nullptr; ///< per cent of the width
    QDoubleSpinBox* m_turn = nullptr;
    QDoubleSpinBox* m_softness = nullptr;
    QComboBox* m_mode = nullptr;
    QDoubleSpinBox* m_depth = nullptr;
    QDoubleSpinBox* m_floor = nullptr; ///< for mode Rate
    QComboBox* m_sweep = nullptr; ///< for the drill
    QCheckBox* m_throughGaps = nullptr;
    QLabel* m_radiusLabel = nullptr;
    QLabel* m_start = nullptr;
};

} // namespace ui
