// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/dialogs/segment/SegmentDialog.h"

#include <QList>

#include <cstdint>

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QLabel;

namespace core {
struct ReshapeSegment;
enum class ShapeOperation : std::uint8_t;
} // namespace core

namespace ui {

class PreviewRow;
class SegmentWorkRow;

/// Grows, shrinks, hollows out, smooths or wraps a segment by a size in millimetres. It stays open
/// beside the window, and all views preview the result, so the user can look at it and try another
/// size. The last size of each operation is remembered. Growing and shrinking may have a different
/// margin on each of the patient's six sides; these start with the common margin and are not
/// remembered.
class ReshapeDialog : public SegmentDialog {
    Q_OBJECT

public:
    explicit ReshapeDialog(Workspace& workspace, QWidget* parent = nullptr);

    /// Opens the dialog for a segment.
    /// @param first the operation that is selected at first
    void ask(int label, core::ShapeOperation first);

private:
    [[nodiscard]] QWidget* sideFields();
    void chooseOperation();
    void showSides();
    void showState() override;
    void follow(); ///< updates the preview to what is chosen
    void carryOut();
    [[nodiscard]] core::ReshapeSegment chosen() const;

    QComboBox* m_operation;
    QDoubleSpinBox* m_mm;
    QCheckBox* m_bySides;
    QList<QDoubleSpinBox*> m_sides; ///< right, left, anterior, posterior, inferior, superior
    QLabel* m_hint;
    PreviewRow* m_preview;
    SegmentWorkRow* m_work;
};

} // namespace ui
