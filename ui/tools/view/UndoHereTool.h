// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/brick/BrickGrid.h"
#include "ui/tools/common/CursorTool.h"

#include <optional>

namespace ui {

class Workspace;

/// Takes back the last step that changed something at a place, and keeps all others. A click means
/// a box around what is seen there, its side twice the radius; a drag on a slice means the box
/// under the rectangle, extending by the radius to both sides of the slice.
class UndoHereTool : public CursorTool {
    Q_OBJECT

public:
    explicit UndoHereTool(Workspace& workspace, QObject* parent = nullptr);

    [[nodiscard]] QString name() const override;
    [[nodiscard]] QString iconName() const override;
    [[nodiscard]] QString hint() const override;
    [[nodiscard]] QString target() const override;
    [[nodiscard]] QString keys() const override;
    [[nodiscard]] bool worksIn(const ViewContext& view) const override;

    void press(const PointerSample& sample, const ViewContext& view) override;
    void drag(const PointerSample& sample, const ViewContext& view) override;
    void release(const PointerSample& sample, const ViewContext& view) override;
    void cancel() override;
    void changeRadius(int steps) override;

    void paintOverlay(QPainter& painter, const ViewContext& view) const override;

private:
    [[nodiscard]] bool isRectangle() const;
    void undoOnSlice();
    void undoWhatIsSeen();
    /// The smallest box of voxels around points, @p reachMm wider on all sides.
    [[nodiscard]] core::VoxelBox boxAround(
        const std::vector<glm::dvec3>& pointsLps, double reachMm) const;

    Workspace& m_workspace;
    double m_radiusMm = 5.0;
    std::optional<ViewContext> m_pressedView;
    QPointF m_pressed;
};

} // namespace ui
