// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QToolButton>

namespace ui {

/// The head of a part of a panel that folds away: a small line of text with an arrow. What the user
/// unfolds is scrolled into view.
class FoldButton : public QToolButton {
    Q_OBJECT

public:
    /// Folded at first. @param body is shown and hidden; outlives the button
    explicit FoldButton(QWidget& body, QWidget* parent = nullptr);

    void setFolded(bool folded);
    [[nodiscard]] bool folded() const;

private:
    void bringIntoView();

    QWidget& m_body;
};

} // namespace ui
