// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/workspace/Workspace.h"

#include <QWidget>

class QButtonGroup;
class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QToolButton;

namespace ui {

/// The options of the refine tool in the option bar; always in step with Refinement::settings().
class RefineOptions : public QWidget {
    Q_OBJECT

public:
    explicit RefineOptions(Workspace& workspace, QWidget* parent = nullptr);

private:
    void showSettings();
    void takeSettings();
    void showContours();
    QWidget* buildTemplate();

    Workspace& m_workspace;
    QButtonGroup* m_modes = nullptr;
    QComboBox* m_mark = nullptr;
    QLabel* m_radiusLabel = nullptr;
    QDoubleSpinBox* m_radius = nullptr;
    QToolButton* m_pressure = nullptr;
    QWidget* m_template = nullptr; ///< for Mode::Template
    QLabel* m_contours = nullptr;
    QToolButton* m_preview = nullptr;
    QToolButton* m_take = nullptr;
    QToolButton* m_remove = nullptr;
};

} // namespace ui
