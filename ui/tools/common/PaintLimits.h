// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/workspace/Workspace.h"

#include <QToolButton>

class QCheckBox;
class QDoubleSpinBox;

namespace ui {

/// Returns the range of values to which painting is limited: "only 20 … 80 HU". Empty if there is
/// none.
[[nodiscard]] QString intervalText(const Workspace& workspace);

/// The same together with the editable range, which limits all tools.
[[nodiscard]] QString limitsText(const Workspace& workspace);

/// A button of the option bar whose menu sets which voxels painting and filling of outlines may
/// change. (The bar has no room for these controls themselves.) It always shows
/// Workspace::brushSettings().
class PaintLimits : public QToolButton {
    Q_OBJECT

public:
    explicit PaintLimits(Workspace& workspace, QWidget* parent = nullptr);

private:
    void showSettings();
    void takeSettings();
    void takeInterval();

    Workspace& m_workspace;
    QCheckBox* m_onlyBetween;
    QDoubleSpinBox* m_lower;
    QDoubleSpinBox* m_upper;
    QCheckBox* m_overwrite;
};

} // namespace ui
