// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QToolButton>

class QCheckBox;

namespace ui {

class PressureCurve;
class Workspace;

/// The menu in the option bar for the effects of a pen on drill and laser: the curve by which
/// pressure sets the depth, and whether the mask rotates and tilts with the pen.
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
