// SPDX-License-Identifier: Apache-2.0
#include "ui/widgets/FrontSizeCurve.h"

#include "ui/CountText.h"
#include "ui/Theme.h"

#include <QPainter>
#include <QPainterPath>

#include <algorithm>

namespace ui {

FrontSizeCurve::FrontSizeCurve(QWidget* parent)
    : QWidget(parent)
{
    setFixedHeight(36);
    setToolTip(tr("Voxels added in each generation"));
    setAccessibleName(tr("Size of the growing front"));
}

void FrontSizeCurve::setSizes(const std::vector<std::uint32_t>& sizes)
{
    if (sizes == m_sizes)
        return;
    m_sizes = sizes;
    update();
}

void FrontSizeCurve::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(theme::window);
    painter.drawRoundedRect(QRectF(rect()), theme::cornerRadius, theme::cornerRadius);
    if (m_sizes.empty())
        return;
    const QRectF area = QRectF(rect()).adjusted(6.0, 6.0, -6.0, -4.0);
    const double peak = std::max<double>(1.0, *std::max_element(m_sizes.begin(), m_sizes.end()));
    const double perStep = area.width() / std::max<double>(1.0, double(m_sizes.size()) - 1.0);
    QPainterPath path;
    for (std::size_t i = 0; i < m_sizes.size(); ++i) {
        const QPointF point(area.left() + perStep * double(i),
            area.bottom() - double(m_sizes[i]) / peak * area.height());
        if (i == 0)
            path.moveTo(point);
        else
            path.lineTo(point);
    }
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(theme::good, 1.6));
    painter.drawPath(path);
    const QPointF now = path.currentPosition();
    painter.setPen(QPen(theme::accent, 1.5));
    painter.drawLine(QPointF(now.x(), area.top() - 4.0), QPointF(now.x(), area.bottom() + 2.0));
    painter.setFont(theme::smallFont());
    painter.setPen(theme::secondary);
    painter.drawText(area.adjusted(0.0, 0.0, 0.0, 3.0), Qt::AlignHCenter | Qt::AlignBottom,
        tr("front at most %1 voxels").arg(countText(qlonglong(peak))));
}

} // namespace ui
