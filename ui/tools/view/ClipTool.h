// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/ClipRegion.h"
#include "ui/input/Tool.h"
#include "ui/tools/view/ClipHandles.h"

#include <optional>

namespace ui {

class Workspace;

/// Drags the faces of the clip box and the clip planes by handles, in the 3D view and in slices;
/// beside the handles the view navigates. This makes no step of the history, but undo takes it back
/// (ViewSteps).
class ClipTool : public Tool {
    Q_OBJECT

public:
    explicit ClipTool(Workspace& workspace, QObject* parent = nullptr);

    [[nodiscard]] QString name() const override;
    [[nodiscard]] QString iconName() const override;
    [[nodiscard]] QString hint() const override;
    [[nodiscard]] QString keys() const override;
    [[nodiscard]] bool worksIn(const ViewContext& view) const override;
    [[nodiscard]] bool takes(const PointerSample& sample, const ViewContext& view) const override;

    void press(const PointerSample& sample, const ViewContext& view) override;
    void drag(const PointerSample& sample, const ViewContext& view) override;
    void release(const PointerSample& sample, const ViewContext& view) override;
    void cancel() override;
    void hover(const PointerSample& sample, const ViewContext& view) override;
    void leave() override;
    void paintOverlay(QPainter& painter, const ViewContext& view) const override;

private:
    struct Drag {
        ClipHandle handle;
        gpu::ViewId view = 0;
        QPointF from;
        core::ClipRegion before;
    };
    [[nodiscard]] std::optional<ClipHandle> handleAt(
        const QPointF& pixel, const ViewContext& view) const;
    [[nodiscard]] QString textOf(int face) const;

    Workspace& m_workspace;
    std::optional<Drag> m_drag;
    std::optional<int> m_hovered; ///< face
    gpu::ViewId m_hoveredView = 0;
    QPointF m_cursor;
};

} // namespace ui
