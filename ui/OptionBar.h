// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/Workspace.h"

#include <QFrame>

class QAction;
class QHBoxLayout;
class QLabel;
class QToolButton;

namespace ui {

/// Above the views: undo and redo with the name of what they concern, the active tool's few
/// options, and at the right what its modifier keys do.
class OptionBar : public QFrame {
    Q_OBJECT

public:
    OptionBar(Workspace& workspace, QAction& undo, QAction& redo, QWidget* parent = nullptr);

private:
    QToolButton* addAction(QAction& action);
    void showTool();

    Workspace& m_workspace;
    QHBoxLayout* m_layout;
    QLabel* m_tool;
    QWidget* m_options = nullptr;
    QLabel* m_keys;
};

} // namespace ui
