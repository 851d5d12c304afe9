// SPDX-License-Identifier: Apache-2.0
#include "ui/widgets/ColorButton.h"

#include "ui/base/Theme.h"

#include <QColorDialog>
#include <QPainter>

#include <algorithm>

namespace ui {

ColorButton::ColorButton(QWidget* parent)
    : QAbstractButton(parent)
{
    setToolTip(tr("Choose a colour"));
    setFocusPolicy(Qt::StrongFocus);
    connect(this, &QAbstractButton::clicked, this, [this] {
        const QColor picked = QColorDialog::getColor(m_colour, window(), tr("Colour"));
        if (!picked.isValid() || picked == m_colour)
            return;
        setColour(picked);
        Q_EMIT colourPicked(picked);
    });
}

void ColorButton::setColour(const QColor& colour)
{
    m_colour = colour;
    setAccessibleName(tr("Colour %1").arg(colour.name()));
    update();
}

void ColorButton::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(hasFocus() || underMouse() ? theme::accent : theme::line, 1.0));
    painter.setBrush(m_colour);
    const double side = std::min(width(), height()) - 6.0;
    QRectF swatch(0.0, 0.0, side, side);
    swatch.moveCenter(QRectF(rect()).center());
    painter.drawRoundedRect(swatch, 3.0, 3.0);
}

} // namespace ui
