// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/document/Document.h"
#include "core/edits/sculpt/SculptEdits.h"
#include "core/history/History.h"

#include <QDialog>

#include <optional>
#include <vector>

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QFormLayout;

namespace core {
struct StandingStroke;
}

namespace ui {

/// Asks how an older cut is to be changed. It shows only the fields that the cut has, with their
/// present values.
class ReviseStrokeDialog : public QDialog {
    Q_OBJECT

public:
    /// @param title name of the cut's row in the history
    ReviseStrokeDialog(const core::StandingStroke& stroke, const core::SculptEdit& drawn,
        const QString& title, const core::Document& document, QWidget* parent = nullptr);

    /// The edit with the fields that differ from how the stroke was drawn.
    [[nodiscard]] core::ReviseStroke edit() const;

private:
    /// A numeric parameter of the cut.
    struct Field {
        QDoubleSpinBox* box;
        std::optional<double> core::ReviseStroke::*edit;
        double drawn; ///< value when the stroke was drawn, in the edit's unit
        double now; ///< value that counts now
        double perUnit; ///< factor from the box's unit to the edit's
    };
    struct Kind;
    void addField(QFormLayout& form, const Kind& kind, const core::StrokeParameters& now);

    core::RowId m_row;
    core::StrokeParameters m_drawn;
    std::vector<Field> m_fields;
    QComboBox* m_layer;
    QCheckBox* m_throughGaps;
};

} // namespace ui
