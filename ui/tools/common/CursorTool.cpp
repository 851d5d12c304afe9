// SPDX-License-Identifier: Apache-2.0
#include "ui/tools/common/CursorTool.h"

namespace ui {

void CursorTool::hover(const PointerSample& sample, const ViewContext& view)
{
    showCursor(sample.position, view.view);
}

void CursorTool::leave()
{
    m_cursorView.reset();
    Q_EMIT overlayChanged();
}

void CursorTool::showCursor(const QPointF& at, gpu::ViewId view)
{
    m_cursor = at;
    m_cursorView = view;
    Q_EMIT overlayChanged();
}

bool CursorTool::isUnderPointer(const ViewContext& view) const
{
    return m_cursorView == view.view;
}

} // namespace ui
