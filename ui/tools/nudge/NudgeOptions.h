// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>

class QCheckBox;
class QDoubleSpinBox;
class QToolButton;

namespace ui {

class NudgeTool;
class Workspace;

/// The options of the nudge tool in the option bar. They always show the tool's settings.
class NudgeOptions : public QWidget {
    Q_OBJECT

public:
    NudgeOptions(Workspace& workspace, NudgeTool& tool, QWidget* parent = nullptr);

private:
    void showSettings();
    void takeSettings();

    NudgeTool& m_tool;
    QDoubleSpinBox* m_radius;
    QCheckBox* m_fits;
    QToolButton* m_pressure;
};

} // namespace ui
