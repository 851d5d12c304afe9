// SPDX-License-Identifier: Apache-2.0
#include "tests/benchmarks/pacing/PacingPlot.h"

#include <QPainter>

#include <algorithm>
#include <cmath>

namespace bench {

namespace {

const QSize size(1200, 520);
const QRectF field(70.0, 40.0, 1070.0, 400.0);
constexpr double leastMs = 5.0;
constexpr double goalMs = 1000.0 / 15.0;
constexpr double stallMs = 50.0;
const QColor ink(0x22, 0x22, 0x22);
const QColor faint(0xD5, 0xD5, 0xD5);
const QColor dots(0x1F, 0x5F, 0xA8);
const QColor gaps(0xC0, 0x39, 0x2B);
const QColor goal(0x2E, 0x7D, 0x32);

/// Where a record lies in the field. Waits of a few and of hundreds of milliseconds are both to be
/// told apart, so each height is ten times as long as the one as far below it.
struct Axes {
    double lastMs = 1.0; ///< of the minute
    double mostMs = 1000.0; ///< of a wait

    [[nodiscard]] double x(double at) const { return field.left() + field.width() * at / lastMs; }
    [[nodiscard]] double y(double milliseconds) const
    {
        const double part =
            std::log(std::max(milliseconds, leastMs) / leastMs) / std::log(mostMs / leastMs);
        return field.bottom() - field.height() * part;
    }
};

Axes axesOf(const PacingRecord& record)
{
    Axes axes;
    double longest = record.longestGap().lasted;
    for (const PacingRecord::Phase& phase : record.phases) {
        axes.lastMs = std::max(axes.lastMs, phase.end);
        for (const PacingRecord::Wait& wait : record.waits(phase))
            longest = std::max(longest, wait.lasted);
    }
    axes.mostMs = std::max(500.0, 1.1 * longest);
    return axes;
}

void drawAxes(QPainter& painter, const Axes& axes)
{
    for (const double tick : {5.0, 10.0, 20.0, 50.0, 100.0, 200.0, 500.0, 1000.0, 2000.0, 5000.0}) {
        if (tick > axes.mostMs)
            break;
        const double y = axes.y(tick);
        painter.setPen(faint);
        painter.drawLine(QPointF(field.left(), y), QPointF(field.right(), y));
        painter.setPen(ink);
        painter.drawText(QRectF(0.0, y - 10.0, field.left() - 8.0, 20.0),
            Qt::AlignRight | Qt::AlignVCenter, QString::number(tick));
    }
    for (double seconds = 0.0; 1000.0 * seconds <= axes.lastMs + 1.0; seconds += 5.0) {
        const double x = axes.x(1000.0 * seconds);
        painter.drawLine(QPointF(x, field.bottom()), QPointF(x, field.bottom() + 4.0));
        painter.drawText(QRectF(x - 30.0, field.bottom() + 4.0, 60.0, 18.0), Qt::AlignCenter,
            QStringLiteral("%1 s").arg(seconds));
    }
    painter.drawRect(field);
}

void drawPhases(QPainter& painter, const PacingRecord& record, const Axes& axes)
{
    bool shaded = true;
    for (const PacingRecord::Phase& phase : record.phases) {
        const QRectF part(
            QPointF(axes.x(phase.begin), field.top()), QPointF(axes.x(phase.end), field.bottom()));
        painter.fillRect(part, QColor(shaded ? 0xEE : 0xF8, shaded ? 0xF1 : 0xF9, 0xF6));
        shaded = !shaded;
        painter.setPen(ink);
        painter.drawText(QRectF(part.left(), 14.0, part.width(), 22.0), Qt::AlignCenter,
            QStringLiteral("%1 (%2)").arg(phase.id, phase.view));
    }
}

/// The longest one is named, beside its bar.
void drawGaps(QPainter& painter, const PacingRecord& record, const Axes& axes)
{
    painter.setPen(QPen(gaps, 1.5));
    for (const PacingRecord::Gap& gap : record.gaps) {
        const double x = axes.x(gap.begin);
        painter.drawLine(QPointF(x, field.bottom()), QPointF(x, axes.y(gap.lasted)));
    }
    const PacingRecord::Gap longest = record.longestGap();
    painter.setPen(gaps);
    const double x = axes.x(longest.begin);
    painter.setBrush(Qt::NoBrush);
    painter.drawEllipse(QPointF(x, axes.y(longest.lasted)), 5.0, 5.0);
    const QString name = longest.name.isEmpty()
        ? QString()
        : QStringLiteral(" (%1: %2 ms)").arg(longest.name).arg(longest.ofThat, 0, 'f', 0);
    painter.drawText(QRectF(field.left(), field.bottom() + 46.0, field.width(), 20.0),
        Qt::AlignLeft | Qt::AlignVCenter,
        QStringLiteral("red: the event loop did not come round; longest %1 ms at %2 s%3")
            .arg(longest.lasted, 0, 'f', 0)
            .arg(longest.begin / 1000.0, 0, 'f', 1)
            .arg(name));
}

void drawLine(QPainter& painter, const Axes& axes, double milliseconds, const QColor& colour)
{
    painter.setPen(QPen(colour, 1.5, Qt::DashLine));
    const double y = axes.y(milliseconds);
    painter.drawLine(QPointF(field.left(), y), QPointF(field.right(), y));
    painter.drawText(QRectF(field.right() + 6.0, y - 9.0, 54.0, 18.0),
        Qt::AlignLeft | Qt::AlignVCenter, QStringLiteral("%1 ms").arg(milliseconds, 0, 'f', 0));
}

} // namespace

QImage pacingPlot(const PacingRecord& record)
{
    QImage image(size, QImage::Format_RGB32);
    image.fill(Qt::white);
    QPainter painter(&image);
    painter.setRenderHints(QPainter::Antialiasing | QPainter::TextAntialiasing);
    QFont font = painter.font();
    font.setPixelSize(13);
    painter.setFont(font);
    const Axes axes = axesOf(record);
    drawPhases(painter, record, axes);
    drawAxes(painter, axes);
    drawGaps(painter, record, axes);
    drawLine(painter, axes, goalMs, goal);
    drawLine(painter, axes, stallMs, gaps);
    painter.setPen(Qt::NoPen);
    painter.setBrush(dots);
    for (const PacingRecord::Phase& phase : record.phases) {
        for (const PacingRecord::Wait& wait : record.waits(phase))
            painter.drawEllipse(QPointF(axes.x(wait.at), axes.y(wait.lasted)), 2.0, 2.0);
    }
    painter.setPen(dots);
    painter.drawText(QRectF(field.left(), field.bottom() + 26.0, field.width(), 20.0),
        Qt::AlignLeft | Qt::AlignVCenter,
        QStringLiteral("blue: milliseconds since the picture before, in the view of each phase"));
    return image;
}

} // namespace bench
