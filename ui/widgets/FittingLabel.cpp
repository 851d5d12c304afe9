// SPDX-License-Identifier: Apache-2.0
#include "ui/widgets/FittingLabel.h"

#include <QHelpEvent>
#include <QPainter>
#include <QToolTip>

#include <algorithm>

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
    painter.drawText(contentsRect(), int(alignment()), shownText());
}

QString FittingLabel::shownText() const
{
    const int room = contentsRect().width();
    if (m_separator.isEmpty()) {
        const QString shown = fontMetrics().elidedText(text(), Qt::ElideRight, room);
        // A letter or two tell nothing.
        return shown == text() || shown.size() > leastLetters ? shown : QString();
    }
    QString shown = text();
    while (!shown.isEmpty() && fontMetrics().horizontalAdvance(shown) > room)
        shown.truncate(std::max(0, int(shown.lastIndexOf(m_separator))));
    return shown;
}

} // namespace ui
