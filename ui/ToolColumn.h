// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QFrame>

class QAction;
class QActionGroup;
class QVBoxLayout;

namespace ui {

/// The column at the left: one button per tool, icon over a short name, in groups.
class ToolColumn : public QFrame {
    Q_OBJECT

public:
    explicit ToolColumn(QWidget* parent = nullptr);

    /// @param label short name under the icon; the action's own text is the tip
    void addTool(QAction& action, const QString& label);
    void addGroupLine();

private:
    QVBoxLayout* m_layout;
};

} // namespace ui
