// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QDialog>

class QDoubleSpinBox;
class QPushButton;

namespace ui {

class FittingLabel;
class Workspace;

/// Asks from which size on the islands of a segment become segments of their own. It stays open
/// beside the window, for another size after undo, or where there were too many of them.
class SplitIslandsDialog : public QDialog {
    Q_OBJECT

public:
    explicit SplitIslandsDialog(Workspace& workspace, QWidget* parent = nullptr);

    /// Shows it about a segment.
    void ask(int label);

private:
    void showState();
    void carryOut();

    Workspace& m_workspace;
    int m_label = 0;
    FittingLabel* m_whose;
    QDoubleSpinBox* m_mm3;
    QPushButton* m_apply;
};

} // namespace ui
