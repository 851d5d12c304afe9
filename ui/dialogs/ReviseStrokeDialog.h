// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/history/StandingStrokes.h"

#include <QDialog>

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;

namespace core {
struct Document;
}

namespace ui {

/// Asks how an older cut is to be. Its fields show the cut as it counts now, those that it has.
class ReviseStrokeDialog : public QDialog {
    Q_OBJECT

public:
    /// @param title the row's name
    ReviseStrokeDialog(const core::StandingStroke& stroke, const core::SculptEdit& drawn,
        const QString& title, const core::Document& document, QWidget* parent = nullptr);

    /// What was chosen, as it differs from how the stroke was drawn.
    [[nodiscard]] core::ReviseStroke edit() const;

private:
    core::RowId m_row;
    core::StrokeParameters m_drawn;
    QDoubleSpinBox* m_radius;
    QDoubleSpinBox* m_depth;
    QDoubleSpinBox* m_softness;
    QComboBox* m_layer;
    QCheckBox* m_throughGaps;
};

} // namespace ui
