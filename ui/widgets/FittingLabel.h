// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QLabel>

namespace ui {

/// A label with one line of plain text, cut to the available width; if it is cut, the tool tip
/// shows all of it. It takes the room that its layout leaves and demands none.
class FittingLabel : public QLabel {
    Q_OBJECT

public:
    explicit FittingLabel(Qt::Alignment alignment, QWidget* parent = nullptr);
    /// Makes it cut the text only at this separator, without an ellipsis: it shows as many of the
    /// first parts as fit.
    void setParts(const QString& separator) { m_separator = separator; }
    /// The part of the text that is visible.
    [[nodiscard]] QString shownText() const;

protected:
    bool event(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

private:
    QString m_separator; ///< empty: cut anywhere
};

} // namespace ui
