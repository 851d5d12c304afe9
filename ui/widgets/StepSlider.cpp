// SPDX-License-Identifier: Apache-2.0
#include "ui/widgets/StepSlider.h"

#include "ui/base/Theme.h"

#include <QMouseEvent>
#include <QPainter>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>

namespace ui {

namespace {

constexpr double knobRadius = 6.0;
constexpr double captionHeight = 20.0;
constexpr double tickHeight = 8.0;
constexpr double leastTickDistance = 4.0; ///< closer ones run into a bar
constexpr double grooveLeft = theme::padding + 4.0; ///< under the history's own line
constexpr double grooveRight = theme::padding + 4.0;

} // namespace

StepSlider::StepSlider(QWidget* parent)
    : QAbstractSlider(parent)
{
    setOrientation(Qt::Horizontal);
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    connect(this, &QAbstractSlider::valueChanged, this, qOverload<>(&QWidget::update));
    connect(this, &QAbstractSlider::rangeChanged, this, qOverload<>(&QWidget::update));
}

void StepSlider::setCaption(const QString& caption)
{
    m_caption = caption;
    update();
}

double StepSlider::xOf(int value) const
{
    const double span = double(width()) - grooveLeft - grooveRight;
    const int steps = std::max(1, maximum() - minimum());
    return grooveLeft + span * double(value - minimum()) / double(steps);
}

int StepSlider::valueAt(double x) const
{
    const double span = std::max(1.0, double(width()) - grooveLeft - grooveRight);
    const double part = std::clamp((x - grooveLeft) / span, 0.0, 1.0);
    return minimum() + int(std::lround(part * double(maximum() - minimum())));
}

void StepSlider::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.fillRect(0, 0, width(), 1, theme::line);
    painter.setRenderHint(QPainter::Antialiasing);
    const QRectF words(
        theme::padding, 4.0, double(width()) - 2.0 * theme::padding, captionHeight - 4.0);
    painter.setFont(theme::smallFont());
    painter.setPen(isSliderDown() ? theme::text : theme::secondary);
    painter.drawText(words, Qt::AlignLeft | Qt::AlignVCenter,
        QFontMetricsF(theme::smallFont()).elidedText(m_caption, Qt::ElideRight, words.width()));

    const double y = captionHeight + (double(height()) - captionHeight) / 2.0 - 1.0;
    const double now = xOf(sliderPosition());
    const int steps = maximum() - minimum();
    painter.setPen(QPen(theme::faint, 1.5));
    painter.drawLine(QPointF(now, y), QPointF(xOf(maximum()), y));
    painter.setPen(QPen(theme::accent, 1.5));
    painter.drawLine(QPointF(xOf(minimum()), y), QPointF(now, y));
    if (steps > 0 && (xOf(maximum()) - xOf(minimum())) / steps >= leastTickDistance) {
        painter.setRenderHint(QPainter::Antialiasing, false);
        for (int value = minimum(); value <= maximum(); ++value) {
            painter.setPen(QPen(value <= sliderPosition() ? theme::accent : theme::faint, 1.0));
            const double x = std::round(xOf(value));
            painter.drawLine(QPointF(x, y - tickHeight / 2.0), QPointF(x, y + tickHeight / 2.0));
        }
        painter.setRenderHint(QPainter::Antialiasing);
    }
    painter.setPen(hasFocus() ? QPen(theme::accent, 2.0) : QPen(theme::panel, 2.0));
    painter.setBrush(theme::text);
    painter.drawEllipse(QPointF(now, y), knobRadius, knobRadius);
}

void StepSlider::mousePressEvent(QMouseEvent* event)
{
    if (event->button() != Qt::LeftButton)
        return event->ignore();
    setSliderDown(true);
    setSliderPosition(valueAt(event->position().x()));
}

void StepSlider::mouseMoveEvent(QMouseEvent* event)
{
    const int value = valueAt(event->position().x());
    if (isSliderDown())
        setSliderPosition(value);
    Q_EMIT hovered(value);
}

void StepSlider::leaveEvent(QEvent* event)
{
    QAbstractSlider::leaveEvent(event);
    Q_EMIT left();
}

void StepSlider::mouseReleaseEvent(QMouseEvent* event)
{
    if (event->button() != Qt::LeftButton || !isSliderDown())
        return;
    setSliderPosition(valueAt(event->position().x()));
    setSliderDown(false);
    update();
}

void StepSlider::wheelEvent(QWheelEvent* event)
{
    event->ignore();
}

} // namespace ui
