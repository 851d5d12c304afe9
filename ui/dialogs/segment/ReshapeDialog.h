// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/kinds/segments/ReshapeSegment.h"
#include "ui/dialogs/segment/SegmentDialog.h"

#include <QList>

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QLabel;

namespace ui {

class SegmentWorkRow;

/// Asks how far a segment is grown, shrunk, hollowed out or smoothed, and has it done. It stays
/// open beside the window, so that one looks at the result, takes it back and tries another size.
/// Of each operation the last size is remembered. Margins may be others on each of the patient's
/// sides; these begin with the one margin and are not remembered.
class ReshapeDialog : public SegmentDialog {
    Q_OBJECT

public:
    explicit ReshapeDialog(Workspace& workspace, QWidget* parent = nullptr);

    /// Shows it about a segment.
    /// @param first the operation that it begins with
    void ask(int label, core::ShapeOperation first);

private:
    [[nodiscard]] QWidget* sideFields();
    void chooseOperation();
    void showSides();
    void showState() override;
    void carryOut();
    [[nodiscard]] core::ReshapeSegment chosen() const;

    QComboBox* m_operation;
    QDoubleSpinBox* m_mm;
    QCheckBox* m_bySides;
    QList<QDoubleSpinBox*> m_sides; ///< right, left, anterior, posterior, inferior, superior
    QLabel* m_hint;
    SegmentWorkRow* m_work;
};

} // namespace ui
