// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/frame/Panel.h"

class QCheckBox;
class QDoubleSpinBox;
class QFormLayout;
class QPushButton;
class QSlider;
class QSpinBox;

namespace ui {

class ContourTool;
class StepSlider;
class Workspace;

/// The settings by which the contour of the contour tool evolves, and a slider over its generations
/// with buttons like those of a media player. Shown only while the contour tool is active.
class ContourPanel : public Panel {
    Q_OBJECT

public:
    ContourPanel(Workspace& workspace, ContourTool& tool, QWidget* parent = nullptr);

    [[nodiscard]] QString title() const override;
    [[nodiscard]] QString summary() const override;
    [[nodiscard]] bool hasSomething() const override;

private:
    void buildRule(QFormLayout& form);
    void buildRun();
    [[nodiscard]] QSlider* share(
        QFormLayout& form, const char* name, const QString& label, const QString& tip);
    void showSettings();
    void takeInterval(double lower, double upper);
    void takeSettings();
    void showRun();
    void playOrPause();

    Workspace& m_workspace;
    ContourTool& m_tool;
    QDoubleSpinBox* m_lower = nullptr;
    QDoubleSpinBox* m_upper = nullptr;
    QCheckBox* m_ofBubble = nullptr;
    QSlider* m_softness = nullptr;
    QSlider* m_smoothness = nullptr;
    QSlider* m_edge = nullptr;
    QDoubleSpinBox* m_gradient = nullptr;
    QSpinBox* m_generations = nullptr;
    StepSlider* m_bar = nullptr;
    QPushButton* m_play = nullptr;
    QPushButton* m_accept = nullptr;
    QPushButton* m_abort = nullptr;
    bool m_showing = false; ///< the sliders are being set by showSettings(), not by the user
    bool m_hadSomething = false;
};

} // namespace ui
