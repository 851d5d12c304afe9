// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/workspace/Workspace.h"

#include <QToolButton>

class QCheckBox;
class QDoubleSpinBox;

namespace ui {

/// "follows edges within ±40 HU": how *Paint* follows edges on slices; empty if it does not.
[[nodiscard]] QString edgesText(const Workspace& workspace);

/// Whether *Paint* follows edges on slices, and by how much values may differ: a button of the
/// option bar with a small window, pressed while it does; always in step with
/// Workspace::brushSettings().
class EdgeOptions : public QToolButton {
    Q_OBJECT

public:
    explicit EdgeOptions(Workspace& workspace, QWidget* parent = nullptr);

private:
    void showSettings();
    void takeSwitch();
    void takeTolerance();
    void takePressure();

    Workspace& m_workspace;
    QCheckBox* m_follows;
    QDoubleSpinBox* m_tolerance;
    QCheckBox* m_byPressure;
};

} // namespace ui
