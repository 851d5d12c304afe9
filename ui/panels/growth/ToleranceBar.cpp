// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/growth/ToleranceBar.h"

#include "ui/base/NumberText.h"
#include "ui/base/Theme.h"
#include "ui/widgets/MarkedCurve.h"

#include <QHelpEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>

#include <algorithm>
#include <cmath>

namespace ui {

namespace {

constexpr int barHeight = 52;

} // namespace

ToleranceBar::ToleranceBar(QWidget* parent)
    : QWidget(parent)
{
    setObjectName(QStringLiteral("toleranceBar"));
    setFixedHeight(barHeight);
    setAccessibleName(tr("Size of the segment at each tolerance"));
    setCursor(Qt::SizeHorCursor);
    setFocusPolicy(Qt::StrongFocus);
}

void ToleranceBar::setCurve(std::vector<std::int64_t> members, std::vector<int> jumps)
{
    m_members = std::move(members);
    m_jumps = std::move(jumps);
    if (m_tolerance > greatest())
        m_tolerance = greatest();
    update();
}

void ToleranceBar::setTolerance(int tolerance)
{
    if (m_moving)
        return;
    m_tolerance = std::min(tolerance, greatest());
    update();
}

QRectF ToleranceBar::area() const
{
    return QRectF(rect()).adjusted(6.0, 9.0, -6.0, -4.0);
}

// Cube roots: what one looks for lies near the seeds' value, far below the greatest tolerance.
double ToleranceBar::xOf(int tolerance) const
{
    const double part = std::cbrt(std::max(tolerance, 0) / std::max<double>(1.0, greatest()));
    return area().left() + area().width() * part;
}

int ToleranceBar::toleranceAt(double x) const
{
    const double part = std::clamp((x - area().left()) / area().width(), 0.0, 1.0);
    return std::clamp(
        int(std::lround(part * part * part * greatest())), 0, std::max(greatest(), 0));
}

double ToleranceBar::heightOf(std::int64_t voxels) const
{
    const double most = std::log1p(double(m_members.back()));
    return most > 0.0 ? std::log1p(double(voxels)) / most * area().height() : 0.0;
}

void ToleranceBar::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    paintCurveGround(painter, size());
    if (m_members.empty())
        return;
    const QRectF room = area();
    QPolygonF curve;
    for (double x = room.left(); x <= room.right(); x += 1.0)
        curve << QPointF(x, room.bottom() - heightOf(m_members[std::size_t(toleranceAt(x))]));
    for (const int jump : m_jumps) {
        const double x = xOf(jump);
        painter.setPen(QPen(theme::caution, 1.0));
        painter.drawLine(QPointF(x, room.top()), QPointF(x, room.bottom()));
        painter.setPen(Qt::NoPen);
        painter.setBrush(theme::caution);
        painter.drawPolygon(QPolygonF{{x - 3.0, 2.0}, {x + 3.0, 2.0}, {x, room.top() - 2.0}});
    }

    const bool marked = m_tolerance >= 0;
    const double mark = marked ? xOf(m_tolerance) : room.left() - 1.0;
    const MarkedCurve drawn{
        .curve = curve, .bottom = room.bottom(), .mark = mark, .moving = m_moving, .knob = true};
    paintMarkedCurve(painter, size(), drawn);
    if (marked)
        paintMark(painter, size(), drawn);
}

QString ToleranceBar::textFor(int tolerance) const
{
    if (tolerance < 0 || tolerance > greatest() || !m_text || !m_size)
        return {};
    return m_text(tolerance) + QStringLiteral(" · ") + m_size(m_members[std::size_t(tolerance)]);
}

void ToleranceBar::begin()
{
    if (m_moving)
        return;
    m_moving = true;
    m_before = m_tolerance;
}

void ToleranceBar::moveTo(int tolerance)
{
    if (tolerance == m_tolerance)
        return;
    m_tolerance = tolerance;
    update();
    Q_EMIT moved(tolerance);
}

void ToleranceBar::settle(bool kept)
{
    if (!m_moving)
        return;
    m_moving = false;
    if (!kept)
        m_tolerance = m_before;
    update();
    Q_EMIT settled(kept);
}

void ToleranceBar::mousePressEvent(QMouseEvent* event)
{
    if (event->button() != Qt::LeftButton || m_members.empty())
        return;
    begin();
    moveTo(toleranceAt(event->position().x()));
}

void ToleranceBar::mouseMoveEvent(QMouseEvent* event)
{
    if (m_moving && event->buttons().testFlag(Qt::LeftButton))
        moveTo(toleranceAt(event->position().x()));
}

void ToleranceBar::mouseReleaseEvent(QMouseEvent* event)
{
    if (event->button() == Qt::LeftButton)
        settle(true);
}

void ToleranceBar::keyPressEvent(QKeyEvent* event)
{
    const int step = event->modifiers().testFlag(Qt::ShiftModifier) ? 10 : 1;
    switch (event->key()) {
    case Qt::Key_Left:
    case Qt::Key_Right:
        if (m_members.empty())
            return;
        begin();
        moveTo(std::clamp(
            m_tolerance + (event->key() == Qt::Key_Right ? step : -step), 0, greatest()));
        return;
    case Qt::Key_Return:
    case Qt::Key_Enter:
        return settle(true);
    case Qt::Key_Escape:
        if (m_moving)
            return settle(false);
        break;
    default:
        break;
    }
    QWidget::keyPressEvent(event);
}

void ToleranceBar::focusOutEvent(QFocusEvent* event)
{
    settle(false);
    QWidget::focusOutEvent(event);
}

bool ToleranceBar::event(QEvent* event)
{
    if (event->type() != QEvent::ToolTip)
        return QWidget::event(event);
    const auto* help = static_cast<QHelpEvent*>(event);
    const int tolerance = toleranceAt(help->pos().x());
    QString text = tr("How large the segment is at each tolerance; where it jumps it may leak");
    if (!m_members.empty()) {
        text = textFor(tolerance);
        // Within two pixels it is the jump that is meant.
        const auto jump = std::find_if(m_jumps.begin(), m_jumps.end(),
            [&](int each) { return std::abs(xOf(each) - help->pos().x()) <= 2.0; });
        if (jump != m_jumps.end() && *jump > 0) {
            const double before =
                double(std::max<std::int64_t>(m_members[std::size_t(*jump - 1)], 1));
            text = tr("%1: %2 times as large as just before")
                       .arg(textFor(*jump),
                           numberText(double(m_members[std::size_t(*jump)]) / before, 1));
        }
    }
    QToolTip::showText(help->globalPos(), text, this);
    return true;
}

} // namespace ui
