// SPDX-License-Identifier: Apache-2.0
#include "ui/widgets/FittingLabel.h"

#include <QHelpEvent>
#include <QPainter>
#include <QToolTip>

namespace ui {

namespace {

constexpr int leastLetters = 5;

} // namespace

FittingLabel::FittingLabel(Qt::Alignment alignment, QWidget* parent)
    : QLabel(parent)
{
    setTextFormat(Qt::PlainText);
    setAlignment(alignment | Qt::AlignVCenter);
    // Long texts are cut rather than widening the window.
    setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
}

bool FittingLabel::event(QEvent* event)
{
    if (event->type() == QEvent::ToolTip && toolTip().isEmpty()
        && fontMetrics().horizontalAdvance(text()) > contentsRect().width()) {
        QToolTip::showText(static_cast<QHelpEvent*>(event)->globalPos(), text(), this);
        return true;
    }
    return QLabel::event(event);
}

void FittingLabel::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setPen(palette().color(foregroundRole()));
    const QRect room = contentsRect();
    const QString shown = fontMetrics().elidedText(text(), Qt::ElideRight, room.width());
    // A letter or two tell nothing.
    if (shown == text() || shown.size() > leastLetters)
        painter.drawText(room, int(alignment()), shown);
}

} // namespace ui
