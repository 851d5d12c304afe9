// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/workspace/Workspace.h"

#include <QToolButton>

class QCheckBox;
class QDoubleSpinBox;

namespace ui {

/// Returns how the paint brush follows edges in slices: "follows edges within ±40 HU". Empty if it
/// does not.
[[nodiscard]] QString edgesText(const Workspace& workspace);

/// A button of the option bar whose menu sets whether the paint brush follows edges in slices, and
/// by how much values may differ. It is checked while the brush does, and always shows
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
