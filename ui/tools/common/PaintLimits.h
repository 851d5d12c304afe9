// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/workspace/Workspace.h"

#include <QToolButton>

class QCheckBox;
class QDoubleSpinBox;

namespace ui {

/// "only 20 … 80 HU": the range of values to which painting is limited; empty if it is not.
[[nodiscard]] QString intervalText(const Workspace& workspace);

/// The same with the editable range, which limits all tools.
[[nodiscard]] QString limitsText(const Workspace& workspace);

/// Which voxels may change when a segment is painted or an outline is filled: a button of the
/// option bar, which has no room for more, with a small window; always in step with
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
