// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QAbstractButton>
#include <QColor>

namespace ui {

/// A button that shows a colour and opens a colour dialog.
class ColorButton : public QAbstractButton {
    Q_OBJECT

public:
    explicit ColorButton(QWidget* parent = nullptr);

    [[nodiscard]] QColor colour() const { return m_colour; }
    void setColour(const QColor& colour);

    [[nodiscard]] QSize sizeHint() const override { return {24, 24}; }

Q_SIGNALS:
    void colourPicked(const QColor& colour); ///< by the user

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    QColor m_colour;
};

} // namespace ui
