// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/kinds/segments/ReshapeSegment.h"

#include <QDialog>
#include <QTimer>

#include <optional>

class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QProgressBar;
class QPushButton;

namespace ui {

class FittingLabel;
class Workspace;

/// Asks how far a segment is grown, shrunk, hollowed out or smoothed, and has it done. It stays
/// open beside the window, so that one looks at the result, takes it back and tries another size.
/// Of each operation the last size is remembered.
class ReshapeDialog : public QDialog {
    Q_OBJECT

public:
    explicit ReshapeDialog(Workspace& workspace, QWidget* parent = nullptr);

    /// Shows it about a segment.
    /// @param first the operation that it begins with
    void ask(int label, core::ShapeOperation first);

private:
    void chooseOperation();
    void showState();
    void carryOut();
    void watch();
    [[nodiscard]] core::ReshapeSegment chosen() const;
    [[nodiscard]] std::optional<int> percentDone() const; ///< none: nothing is being worked out

    Workspace& m_workspace;
    int m_label = 0;
    FittingLabel* m_whose;
    QComboBox* m_operation;
    QDoubleSpinBox* m_mm;
    QLabel* m_hint;
    QProgressBar* m_progress;
    QPushButton* m_abort;
    QPushButton* m_apply;
    QTimer m_watching; ///< while it is being worked out
};

} // namespace ui
