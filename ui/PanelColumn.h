// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QScrollArea>
#include <QWidget>

class QToolButton;
class QVBoxLayout;

namespace ui {

class Panel;

/// A panel with its header: title, summary and the panel's actions; a click on the title folds it.
class PanelSection : public QWidget {
    Q_OBJECT

public:
    explicit PanelSection(Panel& panel, QWidget* parent = nullptr);

    void setFolded(bool folded);

    // The column asks for one height: as much as the panel needs in the column's width, or for a
    // list the least that is of use. (A height that depends on the width would end shrinking.)
    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override { return sizeHint(); }
    [[nodiscard]] bool hasHeightForWidth() const override { return false; }

Q_SIGNALS:
    void folded(bool folded);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    Panel& m_panel;
    QWidget* m_header;
    QToolButton* m_fold;
    bool m_folded = false;
};

/// The window's right column. Lists share the height that the other panels leave; where a window is
/// too low for all, the column scrolls.
class PanelColumn : public QScrollArea {
    Q_OBJECT

public:
    explicit PanelColumn(QWidget* parent = nullptr);

    void add(ui::Panel* panel); ///< takes it over

private:
    QVBoxLayout* m_layout;
};

} // namespace ui
