// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/frame/Panel.h"

class QButtonGroup;
class QComboBox;
class QDoubleSpinBox;
class QSlider;
class QWidget;

namespace ui {

class TransferFunctionEditor;
class Workspace;

/// Sets how the volume is shown: the render mode with its threshold or transfer function, and
/// window presets. Nothing here is a step of undo.
class VolumePanel : public Panel {
    Q_OBJECT

public:
    explicit VolumePanel(Workspace& workspace, QWidget* parent = nullptr);

    [[nodiscard]] QString title() const override;
    [[nodiscard]] QString summary() const override;

private:
    void build();
    void showVolume();
    void showDisplay();
    void takeMode(int mode);
    void takeThreshold(double threshold);
    void takePreset(int row);
    void takeWindow(int row);

    Workspace& m_workspace;
    QButtonGroup* m_modes = nullptr;
    QWidget* m_surfaceRow = nullptr;
    QSlider* m_slider = nullptr;
    QDoubleSpinBox* m_threshold = nullptr;
    TransferFunctionEditor* m_function = nullptr;
    QComboBox* m_preset = nullptr;
    QComboBox* m_window = nullptr;
};

} // namespace ui
