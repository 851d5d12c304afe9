// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QToolButton>

namespace ui {

class PressureCurve;
class Workspace;

/// How a pen's pressure sets the depth of drill and laser: opens the curve.
class PressureMenu : public QToolButton {
    Q_OBJECT

public:
    explicit PressureMenu(Workspace& workspace, QWidget* parent = nullptr);

private:
    void showSettings();

    Workspace& m_workspace;
    PressureCurve* m_curve = nullptr;
};

} // namespace ui
