// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QToolButton>

class QCheckBox;

namespace ui {

class PressureCurve;
class Workspace;

/// What a pen does to drill and laser: opens the curve by which its pressure sets the depth, and
/// whether the mask turns and leans with it.
class PenMenu : public QToolButton {
    Q_OBJECT

public:
    explicit PenMenu(Workspace& workspace, QWidget* parent = nullptr);

private:
    void showSettings();

    Workspace& m_workspace;
    PressureCurve* m_curve = nullptr;
    QCheckBox* m_turns = nullptr;
    QCheckBox* m_foreshortened = nullptr;
};

} // namespace ui
