// SPDX-License-Identifier: Apache-2.0
// The lens over a slice, while its key is held.
#include "ui/views/SliceView.h"

#include <QEvent>

namespace ui {

void SliceView::holdLens(bool held)
{
    m_lensHeld = held;
    moveLens();
}

void SliceView::moveLens()
{
    if (!m_lensHeld && !m_lens.isShown())
        return;
    const auto& at = pointedPixel();
    if (m_lensHeld && at && workspace().volume() && rect().contains(at->toPoint()))
        m_lens.lookAt(*at, context(), segmentDisplay(), devicePixelRatioF());
    else
        m_lens.putAway();
    update();
}

bool SliceView::takes(gpu::ViewId view) const
{
    return ImageView::takes(view) || view == m_lens.viewId();
}

void SliceView::takeFrame(const gpu::Frame& frame)
{
    if (frame.view != m_lens.viewId())
        return ImageView::takeFrame(frame);
    m_lens.take(frame, imageOf(frame));
    update();
}

void SliceView::requested(const gpu::FrameRequest&)
{
    moveLens();
}

void SliceView::paintOnTop(QPainter& painter)
{
    m_lens.paint(painter, picture(), QSizeF(size()));
}

bool SliceView::event(QEvent* event)
{
    const bool done = ImageView::event(event);
    switch (event->type()) {
    case QEvent::TabletMove:
    case QEvent::MouseMove:
        moveLens();
        break;
    // Its key may be let go elsewhere.
    case QEvent::Leave:
    case QEvent::FocusOut:
    case QEvent::Hide:
    case QEvent::WindowDeactivate:
        holdLens(false);
        break;
    default:
        break;
    }
    return done;
}

} // namespace ui
