// SPDX-License-Identifier: Apache-2.0
#include "ui/widgets/MarkedCurve.h"

#include "ui/base/Theme.h"

#include <QPainter>
#include <QPainterPath>

#include <algorithm>

namespace ui {

void paintCurveGround(QPainter& painter, const QSizeF& size)
{
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(theme::window);
    painter.drawRoundedRect(QRectF(QPointF(), size), theme::cornerRadius, theme::cornerRadius);
}

void paintMarkedCurve(QPainter& painter, const QSizeF& size, const MarkedCurve& marked)
{
    QPainterPath area(QPointF(marked.curve.front().x(), marked.bottom));
    for (const QPointF& point : marked.curve)
        area.lineTo(point);
    area.lineTo(marked.curve.back().x(), marked.bottom);
    QColor fill = theme::good;
    fill.setAlphaF(0.25);
    painter.setClipRect(QRectF(0.0, 0.0, marked.mark, size.height()));
    painter.setPen(Qt::NoPen);
    painter.setBrush(fill);
    painter.drawPath(area);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(theme::good, 1.6));
    painter.drawPolyline(marked.curve);
    painter.setClipRect(QRectF(marked.mark, 0.0, size.width() - marked.mark, size.height()));
    painter.setPen(QPen(theme::secondary, 1.2));
    painter.drawPolyline(marked.curve);
    painter.setClipping(false);
}

void paintMark(QPainter& painter, const QSizeF& size, const MarkedCurve& marked)
{
    painter.setPen(QPen(theme::accent, marked.moving ? 2.5 : 1.5));
    painter.drawLine(QPointF(marked.mark, 3.0), QPointF(marked.mark, size.height() - 3.0));
    if (!marked.knob)
        return;
    painter.setPen(Qt::NoPen);
    painter.setBrush(theme::accent);
    painter.drawEllipse(QPointF(std::clamp(marked.mark, 5.0, size.width() - 5.0), 5.0), 3.5, 3.5);
}

} // namespace ui
