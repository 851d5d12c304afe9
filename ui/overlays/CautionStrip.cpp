// SPDX-License-Identifier: Apache-2.0
#include "ui/overlays/CautionStrip.h"

#include "ui/base/Icons.h"
#include "ui/base/Theme.h"
#include "ui/texts/ProblemTexts.h"

#include <QFontMetrics>
#include <QPainter>
#include <QStringList>

namespace ui {

QString cautionText(const core::Volume& volume)
{
    QStringList sentences;
    for (const core::VolumeProblem& problem : volume.problems) {
        if (problem.caution)
            sentences += problemText(problem.said);
    }
    return sentences.join(QLatin1Char(' '));
}

void paintCautionStrip(QPainter& painter, const QRect& view, const core::Volume& volume)
{
    painter.save();
    painter.setFont(theme::smallFont());
    constexpr int iconRoom = 26;
    const QRect room = view.adjusted(theme::padding + iconRoom, 0, -theme::padding, 0);
    const QFontMetrics metrics = painter.fontMetrics();
    const QString text = metrics.elidedText(cautionText(volume), Qt::ElideRight, room.width());
    const int height = metrics.height() + 10;
    const QRect strip(view.left(), view.top() + 82, view.width(), height);
    painter.fillRect(strip, QColor(0x3a, 0x2c, 0x12, 0xe6));
    painter.fillRect(QRect(strip.left(), strip.top(), 3, height), theme::caution);
    painter.drawPixmap(QPointF(strip.left() + theme::padding, strip.top() + (height - 16) / 2.0),
        tintedIcon(
            QStringLiteral("caution"), theme::caution, 16, painter.device()->devicePixelRatioF()));
    painter.setPen(theme::caution);
    painter.drawText(QRect(room.left(), strip.top(), room.width(), height),
        Qt::AlignLeft | Qt::AlignVCenter, text);
    painter.restore();
}

} // namespace ui
