// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QLabel>

namespace ui {

/// One line of plain text, as much of it as fits; where something is cut, all of it is the tool
/// tip. Takes what room its layout leaves and asks for none.
class FittingLabel : public QLabel {
    Q_OBJECT

public:
    explicit FittingLabel(Qt::Alignment alignment, QWidget* parent = nullptr);
    /// Cut between such parts only, without a mark: as many of the first ones as fit.
    void setParts(const QString& separator) { m_separator = separator; }
    /// What of the text is to be seen.
    [[nodiscard]] QString shownText() const;

protected:
    bool event(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

private:
    QString m_separator; ///< empty: cut anywhere
};

} // namespace ui
