// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>

class QCheckBox;
class QSlider;
class QToolButton;

namespace ui {

class CuttingPlaneTool;
class Workspace;

/// The options of the cutting plane in the option bar; always in step with it.
class PlaneOptions : public QWidget {
    Q_OBJECT

public:
    PlaneOptions(Workspace& workspace, CuttingPlaneTool& tool, QWidget* parent = nullptr);

private:
    void showPlane();
    void showAim();
    void takeLook();

    Workspace& m_workspace;
    CuttingPlaneTool& m_tool;
    QToolButton* m_threePoints = nullptr;
    QToolButton* m_across = nullptr;
    QCheckBox* m_clips = nullptr;
    QSlider* m_opacity = nullptr;
};

} // namespace ui
