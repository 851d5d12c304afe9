// SPDX-License-Identifier: Apache-2.0
#include "ui/tools/aim/CursorLabel.h"

#include "ui/base/Theme.h"

#include <QFontMetricsF>
#include <QPainter>

#include <algorithm>

namespace ui {

QColor toolColour()
{
    return theme::accent;
}

namespace {

/// Draws an outline that is visible on bone and on black alike: a dark rim under a bright line.
template <class Draw>
void drawOutline(QPainter& painter, const QColor& colour, bool dashed, Draw draw)
{
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(QColor(0, 0, 0, 150), 3.5));
    draw();
    QPen line(colour, 1.6);
    if (dashed)
        line.setDashPattern({4.0, 3.0});
    painter.setPen(line);
    draw();
}

} // namespace

void drawCursorRing(
    QPainter& painter, const QPointF& cursor, double radius, const QColor& colour, bool dashed)
{
    drawOutline(painter, colour, dashed, [&] { painter.drawEllipse(cursor, radius, radius); });
}

void drawCursorSquare(
    QPainter& painter, const QPointF& cursor, double radius, const QColor& colour, bool dashed)
{
    const QPointF corner(radius, radius);
    drawOutline(painter, colour, dashed,
        [&] { painter.drawRect(QRectF(cursor - corner, cursor + corner)); });
}

void drawCursorCross(QPainter& painter, const QPointF& cursor, const QColor& colour)
{
    constexpr double arm = 4.0;
    drawOutline(painter, colour, false, [&] {
        painter.drawLine(cursor - QPointF(arm, 0.0), cursor + QPointF(arm, 0.0));
        painter.drawLine(cursor - QPointF(0.0, arm), cursor + QPointF(0.0, arm));
    });
}

void drawCursorLabel(QPainter& painter, const QSizeF& view, const QPointF& cursor, double radius,
    const QStringList& lines)
{
    const QFontMetricsF metrics(theme::smallFont());
    const double height = metrics.height();
    double width = 0.0;
    for (const QString& line : lines)
        width = std::max(width, metrics.horizontalAdvance(line));
    const QSizeF box(width + 12.0, height * double(lines.size()) + 8.0);

    constexpr double gap = 14.0;
    constexpr double diagonal = 0.7071;
    const bool fitsRight = cursor.x() + radius + gap + box.width() < view.width() - 4.0;
    const bool fitsBelow =
        cursor.y() + radius * diagonal + gap + box.height() < view.height() - 4.0;
    const QPointF side(fitsRight ? diagonal : -diagonal, fitsBelow ? diagonal : -diagonal);
    const QPointF rim = cursor + side * radius;
    const QPointF knee = rim + side * gap;
    QPointF corner(fitsRight ? knee.x() : knee.x() - box.width(), knee.y() - box.height() / 2.0);
    corner.setX(std::clamp(corner.x(), 4.0, std::max(4.0, view.width() - box.width() - 4.0)));
    corner.setY(std::clamp(corner.y(), 4.0, std::max(4.0, view.height() - box.height() - 4.0)));

    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(toolColour(), 1.2));
    painter.drawLine(rim, knee);
    painter.setPen(Qt::NoPen);
    painter.setBrush(QColor(0, 0, 0, 170));
    painter.drawRoundedRect(QRectF(corner, box), theme::cornerRadius, theme::cornerRadius);
    painter.setFont(theme::smallFont());
    double baseline = corner.y() + 4.0 + metrics.ascent();
    for (qsizetype i = 0; i < lines.size(); ++i) {
        painter.setPen(i == 0 ? theme::accent : theme::text);
        painter.drawText(QPointF(corner.x() + 6.0, baseline), lines[i]);
        baseline += height;
    }
}

} // namespace ui
