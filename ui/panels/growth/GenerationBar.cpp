// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/growth/GenerationBar.h"

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
#include <numeric>
#include <utility>

namespace ui {

GenerationBar::GenerationBar(QWidget* parent)
    : QWidget(parent)
    , m_size([](std::int64_t voxels) { return countText(voxels); })
    , m_counted(m_size)
{
    setObjectName(QStringLiteral("generationBar"));
    setFixedHeight(40);
    setAccessibleName(tr("Generations of the growth"));
}

void GenerationBar::setSizeTexts(SizeText size, SizeText counted)
{
    m_size = std::move(size);
    m_counted = std::move(counted);
}

void GenerationBar::setSizes(const std::vector<std::uint32_t>& sizes)
{
    if (m_scrubbing)
        return;
    // A drag may have left the mark behind, though nothing has come of it.
    const int last = int(sizes.size());
    if (sizes == m_sizes && m_shown == last)
        return;
    m_sizes = sizes;
    m_shown = last;
    update();
}

void GenerationBar::abandon()
{
    m_scrubbing = false;
    m_shown = int(m_sizes.size());
    update();
}

void GenerationBar::setLeak(const std::optional<std::pair<int, int>>& generations)
{
    m_leak = generations;
    update();
}

void GenerationBar::setScrubbable(bool scrubbable)
{
    m_scrubbable = scrubbable;
    setCursor(scrubbable ? Qt::SizeHorCursor : Qt::ArrowCursor);
    setFocusPolicy(scrubbable ? Qt::ClickFocus : Qt::NoFocus);
}

QRectF GenerationBar::area() const
{
    return QRectF(rect()).adjusted(6.0, 6.0, -6.0, -6.0);
}

double GenerationBar::xOf(int generation) const
{
    const double steps = std::max<double>(1.0, double(m_sizes.size()) - 1.0);
    return area().left() + area().width() * (generation - 1) / steps;
}

int GenerationBar::generationAt(double x) const
{
    const double steps = std::max<double>(1.0, double(m_sizes.size()) - 1.0);
    const double place = 1.0 + (x - area().left()) / area().width() * steps;
    return std::clamp(int(std::lround(place)), 1, int(m_sizes.size()));
}

void GenerationBar::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    paintCurveGround(painter, size());
    if (m_sizes.empty())
        return;
    const QRectF room = area();
    const double peak = std::max<double>(1.0, *std::max_element(m_sizes.begin(), m_sizes.end()));
    QPolygonF curve;
    for (int i = 0; i < int(m_sizes.size()); ++i)
        curve << QPointF(
            xOf(i + 1), room.bottom() - double(m_sizes[std::size_t(i)]) / peak * room.height());
    if (m_leak)
        paintLeak(painter);
    // What is shown is filled, what the drag takes back only outlined.
    const double mark = xOf(m_shown);
    const MarkedCurve drawn{.curve = curve,
        .bottom = room.bottom(),
        .mark = mark,
        .moving = m_scrubbing,
        .knob = m_scrubbable};
    paintMarkedCurve(painter, size(), drawn);
    paintMark(painter, size(), drawn);
}

void GenerationBar::paintLeak(QPainter& painter) const
{
    const int last = int(m_sizes.size());
    const QRectF zone(QPointF(xOf(std::clamp(m_leak->first, 1, last)), 3.0),
        QPointF(xOf(std::clamp(m_leak->second, 1, last)), height() - 3.0));
    QColor fill = theme::bad;
    fill.setAlphaF(0.3);
    painter.fillRect(zone, fill);
    painter.setPen(theme::bad);
    painter.setFont(theme::smallFont());
    // Beside it: a narrow zone has no room for words.
    painter.drawText(
        QRectF(0.0, 2.0, zone.left() - 4.0, 16.0), Qt::AlignRight | Qt::AlignVCenter, tr("leak?"));
    painter.setPen(Qt::NoPen);
}

QString GenerationBar::textFor(int generation) const
{
    if (generation < 1 || generation > int(m_sizes.size()))
        return tr("Voxels that each generation of the growth added");
    const auto upTo = m_sizes.begin() + generation;
    const auto members = std::accumulate(m_sizes.begin(), upTo, std::int64_t(0));
    return tr("Generation %1 added %2 voxels; up to here %3")
        .arg(countText(generation), countText(m_sizes[std::size_t(generation - 1)]),
            m_counted(members));
}

QString GenerationBar::scrubText() const
{
    if (!m_scrubbing)
        return {};
    const auto members =
        std::accumulate(m_sizes.begin(), m_sizes.begin() + m_shown, std::int64_t(0));
    return tr("Generation %1 of %2 · %3")
        .arg(countText(m_shown), countText(qlonglong(m_sizes.size())), m_size(members));
}

void GenerationBar::scrubTo(int generation)
{
    if (generation == m_shown)
        return;
    m_shown = generation;
    update();
    Q_EMIT scrubbed(generation);
}

void GenerationBar::endScrub(bool kept)
{
    if (!m_scrubbing)
        return;
    m_scrubbing = false;
    if (!kept)
        m_shown = int(m_sizes.size());
    update();
    Q_EMIT scrubEnded(kept);
}

void GenerationBar::mousePressEvent(QMouseEvent* event)
{
    if (event->button() != Qt::LeftButton || !m_scrubbable || m_sizes.empty())
        return;
    m_scrubbing = true;
    QToolTip::hideText(); // it would lie over the pictures that are watched now
    Q_EMIT scrubBegan();
    if (!m_scrubbing)
        return; // it was abandoned
    scrubTo(generationAt(event->position().x()));
}

void GenerationBar::mouseMoveEvent(QMouseEvent* event)
{
    if (!m_scrubbing)
        return;
    scrubTo(generationAt(event->position().x()));
}

void GenerationBar::mouseReleaseEvent(QMouseEvent* event)
{
    if (event->button() == Qt::LeftButton)
        endScrub(true);
}

void GenerationBar::keyPressEvent(QKeyEvent* event)
{
    if (m_scrubbing && event->key() == Qt::Key_Escape)
        endScrub(false);
    else
        QWidget::keyPressEvent(event);
}

bool GenerationBar::event(QEvent* event)
{
    if (event->type() != QEvent::ToolTip)
        return QWidget::event(event);
    const auto* help = static_cast<QHelpEvent*>(event);
    QToolTip::showText(help->globalPos(),
        m_sizes.empty() ? textFor(0) : textFor(generationAt(help->pos().x())), this);
    return true;
}

} // namespace ui
