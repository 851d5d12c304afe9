// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/input/Tool.h"

#include <QPointF>

#include <optional>

namespace ui {

/// Base of tools that draw at the pointer. It keeps the pointer's position and view.
class CursorTool : public Tool {
    Q_OBJECT

public:
    using Tool::Tool;

    void hover(const PointerSample& sample, const ViewContext& view) override;
    void leave() override;

protected:
    /// Sets the pointer's position (logical pixels of its view) and has the overlays drawn again.
    void showCursor(const QPointF& at, gpu::ViewId view);
    /// The pointer's last position, in logical pixels of its view.
    [[nodiscard]] const QPointF& cursor() const { return m_cursor; }
    [[nodiscard]] bool isUnderPointer(const ViewContext& view) const;

private:
    QPointF m_cursor;
    std::optional<gpu::ViewId> m_cursorView; ///< none: the pointer is over no view
};

} // namespace ui
