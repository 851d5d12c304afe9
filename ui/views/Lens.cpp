// SPDX-License-Identifier: Apache-2.0
#include "ui/views/Lens.h"

#include "ui/base/Theme.h"
#include "ui/overlays/Annotations.h"

#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <cmath>
#include <utility>

namespace ui {

namespace {

constexpr gpu::ViewId lensNames = 2000; // beyond the views' and their second eyes'

QRectF around(const QPointF& at, double side)
{
    return {at.x() - 0.5 * side, at.y() - 0.5 * side, side, side};
}

} // namespace

Lens::Lens(gpu::FrameSource& frames, gpu::ViewId view)
    : m_frames(frames)
    , m_overView(view)
{
}

Lens::~Lens()
{
    putAway();
}

gpu::ViewId Lens::nameOver(gpu::ViewId view)
{
    return view + lensNames;
}

void Lens::lookAt(const QPointF& at, const ViewContext& view, const gpu::SegmentDisplay& segments,
    double pixelRatio)
{
    auto scene = std::get<gpu::SliceScene>(view.scene);
    scene.centreLps = view.toLps(at);
    scene.mmPerPixel /= magnification * pixelRatio;
    gpu::FrameRequest request;
    request.view = viewId();
    request.sizePixels = glm::ivec2(int(std::lround(diameterPixels * pixelRatio)));
    request.scene = scene;
    request.segments = segments;
    const bool same = m_at && request.sizePixels == m_request.sizePixels
        && request.scene == m_request.scene && request.segments == m_request.segments;
    m_at = at;
    if (same)
        return;
    m_request = request;
    m_frames.request(std::move(request));
}

void Lens::putAway()
{
    if (!m_at)
        return;
    m_at.reset();
    m_picture = {};
    m_frames.forget(viewId());
}

void Lens::take(const gpu::Frame& frame, const QImage& picture)
{
    if (!m_at || picture.isNull())
        return; // it was on its way when the lens was put away
    m_picture = picture;
    m_pictureScene = frame.scene;
}

bool Lens::isDrawn() const
{
    return !m_picture.isNull() && m_pictureScene == m_request.scene;
}

void Lens::paint(QPainter& painter, const QImage& whole, const QSizeF& view) const
{
    if (!m_at)
        return;
    const QRectF place = around(*m_at, diameterPixels);
    painter.save();
    painter.setRenderHints(QPainter::Antialiasing | QPainter::SmoothPixmapTransform);
    QPainterPath outline;
    outline.addEllipse(place);
    painter.setClipPath(outline);
    painter.fillRect(place, theme::picture);
    if (isDrawn()) {
        painter.drawImage(place, m_picture);
    } else if (!whole.isNull()) {
        const double scale = whole.width() / std::max(view.width(), 1.0);
        painter.drawImage(
            place, whole, around(*m_at * scale, diameterPixels * scale / magnification));
    }
    painter.setClipping(false);
    painter.setBrush(Qt::NoBrush);
    for (const QPen& pen : {QPen(QColor(0, 0, 0, 170), 4.0), QPen(theme::text, 1.4)}) {
        painter.setPen(pen);
        painter.drawEllipse(place);
        // Where the pointer is, open in the middle.
        for (const QPointF& arm : {QPointF(1, 0), QPointF(-1, 0), QPointF(0, 1), QPointF(0, -1)})
            painter.drawLine(*m_at + arm * 5.0, *m_at + arm * 11.0);
    }
    painter.setFont(theme::smallFont());
    paintText(painter, QRectF(place.left(), place.bottom() - 26.0, place.width(), 16.0),
        Qt::AlignHCenter | Qt::AlignVCenter, QStringLiteral("%1 ×").arg(magnification),
        theme::text);
    painter.restore();
}

} // namespace ui
