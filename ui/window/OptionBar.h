// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/workspace/Workspace.h"

#include <QFrame>

class QAction;
class QHBoxLayout;
class QLabel;
class QToolButton;

namespace ui {

class FittingLabel;

/// The bar above the views: undo and redo with the name of the step that they concern (if there is
/// room beside the options), the options of the active tool, and at the right what its modifier
/// keys do.
class OptionBar : public QFrame {
    Q_OBJECT

public:
    OptionBar(Workspace& workspace, QAction& undo, QAction& redo, QWidget* parent = nullptr);

protected:
    bool event(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    class StepButton;

    QToolButton* addAction(QAction& action);
    void showTool();
    void showKeys();
    void showNames();

    Workspace& m_workspace;
    QHBoxLayout* m_layout;
    QList<StepButton*> m_steps; ///< undo and redo
    QLabel* m_tool;
    QWidget* m_options = nullptr;
    FittingLabel* m_keys;
};

} // namespace ui
