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
    /// A number of the cut, where it has it.
    struct Field {
        QDoubleSpinBox* box;
        std::optional<double> core::ReviseStroke::*edit;
        double drawn; ///< as the stroke was drawn, in the edit's unit
        double now; ///< as it counts
        double perUnit; ///< of the box
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
