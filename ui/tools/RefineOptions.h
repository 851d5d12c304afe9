// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/Workspace.h"

#include <QWidget>

class QButtonGroup;
class QComboBox;
class QDoubleSpinBox;

namespace ui {

/// The settings of the refine tool in the option bar; always in step with Refinement::settings().
class RefineOptions : public QWidget {
    Q_OBJECT

public:
    explicit RefineOptions(Workspace& workspace, QWidget* parent = nullptr);

private:
    void showSettings();
    void takeSettings();

    Workspace& m_workspace;
    QButtonGroup* m_modes = nullptr;
    QComboBox* m_mark = nullptr;
    QDoubleSpinBox* m_radius = nullptr;
};

} // namespace ui
