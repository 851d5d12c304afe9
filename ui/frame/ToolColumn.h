// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QFrame>

#include <vector>

class QAction;
class QToolButton;
class QVBoxLayout;

namespace ui {

/// The column at the left with one button per tool, an icon over a short name, in groups. If the
/// window is too low it shows only the icons; their tool tips name them.
class ToolColumn : public QFrame {
    Q_OBJECT

public:
    explicit ToolColumn(QWidget* parent = nullptr);

    /// @param label short name under the icon; the action's own text is the tip
    void addTool(QAction& action, const QString& label);
    void addGroupLine();

    [[nodiscard]] QSize minimumSizeHint() const override;

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    /// Height of the whole column with buttons of this height.
    [[nodiscard]] int heightWith(int buttonHeight, int spacing) const;

    QVBoxLayout* m_layout;
    std::vector<QToolButton*> m_buttons;
};

} // namespace ui
