// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QToolButton;

namespace ui {

class ContourTool;
class Workspace;

/// The options of the contour tool in the option bar: which segment evolves, and from which start.
/// ContourPanel has the settings of the evolution.
class ContourOptions : public QWidget {
    Q_OBJECT

public:
    ContourOptions(Workspace& workspace, ContourTool& tool, QWidget* parent = nullptr);

private:
    void showSettings();
    void takeSettings();

    Workspace& m_workspace;
    ContourTool& m_tool;
    QComboBox* m_start;
    QDoubleSpinBox* m_bubble;
    QToolButton* m_pressure;
    QCheckBox* m_overwrite;
};

} // namespace ui
