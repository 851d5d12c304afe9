// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/workspace/Workspace.h"

#include <QWidget>

class QComboBox;
class QDoubleSpinBox;
class QToolButton;

namespace ui {

/// The options of paint or the carve brush in the option bar; always in step with
/// Workspace::brushSettings().
class BrushOptions : public QWidget {
    Q_OBJECT

public:
    BrushOptions(Workspace& workspace, Workspace::Brush brush, QWidget* parent = nullptr);

private:
    void showSettings();
    void takeSettings();

    Workspace& m_workspace;
    Workspace::Brush m_brush;
    QDoubleSpinBox* m_radius = nullptr;
    QComboBox* m_shape = nullptr;
    QToolButton* m_pressure = nullptr;
};

} // namespace ui
