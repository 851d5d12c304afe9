// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QDockWidget>

class QScrollArea;
class QToolButton;

namespace ui {

class Panel;

/// A panel in the window's right column: a header with title, summary and the panel's actions; a
/// click on the title folds it; it can be dragged out.
class PanelDock : public QDockWidget {
    Q_OBJECT

public:
    explicit PanelDock(Panel& panel, QWidget* parent = nullptr);

    [[nodiscard]] Panel& panel() const { return m_panel; }
    void setFolded(bool folded);

private:
    Panel& m_panel;
    QScrollArea* m_body;
    QToolButton* m_fold;
    bool m_folded = false;
};

} // namespace ui
