// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QToolButton>

namespace ui {

/// The header of a foldable part of a panel: a small line of text with an arrow. A part that the
/// user unfolds is scrolled into view.
class FoldButton : public QToolButton {
    Q_OBJECT

public:
    /// The part is folded at first.
    /// @param body shown and hidden by the button; outlives the button
    explicit FoldButton(QWidget& body, QWidget* parent = nullptr);

    void setFolded(bool folded);
    [[nodiscard]] bool folded() const;

private:
    QWidget& m_body;
};

} // namespace ui
