// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/workspace/Workspace.h"

#include <QWidget>

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QHBoxLayout;
class QToolButton;

namespace ui {

/// "only 20 … 80 HU": the range of values to which painting is limited; empty if it is not.
[[nodiscard]] QString intervalText(const Workspace& workspace);

/// The options of paint or the carve brush in the option bar; always in step with
/// Workspace::brushSettings().
class BrushOptions : public QWidget {
    Q_OBJECT

public:
    BrushOptions(Workspace& workspace, Workspace::Brush brush, QWidget* parent = nullptr);

private:
    void addPaintOptions(QHBoxLayout& layout);
    void showSettings();
    void takeSettings();
    void takeInterval();

    Workspace& m_workspace;
    Workspace::Brush m_brush;
    QDoubleSpinBox* m_radius = nullptr;
    QComboBox* m_shape = nullptr;
    QToolButton* m_pressure = nullptr;
    // The following are for paint only.
    QToolButton* m_limits = nullptr;
    QCheckBox* m_onlyBetween = nullptr;
    QDoubleSpinBox* m_lower = nullptr;
    QDoubleSpinBox* m_upper = nullptr;
    QCheckBox* m_overwrite = nullptr;
};

} // namespace ui
