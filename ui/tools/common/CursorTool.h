// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/input/Tool.h"

#include <QPointF>

#include <optional>

namespace ui {

/// A tool that draws at the cursor, in the view under the pointer.
class CursorTool : public Tool {
    Q_OBJECT

public:
    using Tool::Tool;

    void hover(const PointerSample& sample, const ViewContext& view) override;
    void leave() override;

protected:
    /// From now on it is drawn there.
    void showCursor(const QPointF& at, gpu::ViewId view);
    /// In pixels of its view.
    [[nodiscard]] const QPointF& cursor() const { return m_cursor; }
    [[nodiscard]] bool isUnderPointer(const ViewContext& view) const;

private:
    QPointF m_cursor;
    std::optional<gpu::ViewId> m_cursorView; ///< none: the pointer is over no view
};

} // namespace ui
