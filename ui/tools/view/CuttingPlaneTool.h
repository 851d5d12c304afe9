// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/input/Tool.h"
#include "ui/tools/view/PlaneHandles.h"
#include "ui/workspace/CuttingPlane.h"

#include <optional>
#include <vector>

namespace ui {

class Workspace;

/// Places the cutting plane (seed B §4.1): by handles in slices and in the 3D view, by dragging in
/// the pen view, through three points, or perpendicular to a structure at a point. Elsewhere the
/// view navigates. This is no step of undo.
class CuttingPlaneTool : public Tool {
    Q_OBJECT

public:
    /// What a press means.
    enum class Aim { Handles, ThreePoints, Across };

    explicit CuttingPlaneTool(Workspace& workspace, QObject* parent = nullptr);

    [[nodiscard]] Aim aim() const { return m_aim; }
    /// Sets the aim. The other two return to Handles when they are done.
    void setAim(Aim aim);

    [[nodiscard]] QString name() const override;
    [[nodiscard]] QString iconName() const override;
    [[nodiscard]] QString hint() const override;
    [[nodiscard]] QString target() const override;
    [[nodiscard]] QString keys() const override;
    [[nodiscard]] QWidget* createOptions(QWidget* parent) override;
    [[nodiscard]] bool worksIn(const ViewContext& view) const override;
    [[nodiscard]] bool takes(const PointerSample& sample, const ViewContext& view) const override;

    void press(const PointerSample& sample, const ViewContext& view) override;
    void drag(const PointerSample& sample, const ViewContext& view) override;
    void release(const PointerSample& sample, const ViewContext& view) override;
    void cancel() override;
    void hover(const PointerSample& sample, const ViewContext& view) override;
    void leave() override;
    void paintOverlay(QPainter& painter, const ViewContext& view) const override;

Q_SIGNALS:
    void aimChanged();

private:
    struct Drag {
        std::optional<PlaneHandle> handle; ///< none if the plane is turned in the pen view
        gpu::ViewId view = 0;
        QPointF last;
        CuttingPlane::Pose before;
    };
    [[nodiscard]] std::optional<PlaneHandle> handleAt(
        const QPointF& pixel, const ViewContext& view) const;
    void turnInPenView(const PointerSample& sample, const ViewContext& view);
    /// Finds the place under a press: on a slice at once, in the 3D view when the engine has
    /// answered.
    void point(const QPointF& pixel, const ViewContext& view);
    void take(const glm::dvec3& placeLps);

    Workspace& m_workspace;
    Aim m_aim = Aim::Handles;
    std::vector<glm::dvec3> m_points; ///< the points of Aim::ThreePoints so far
    std::optional<Drag> m_drag;
    std::optional<int> m_hovered; ///< PlaneHandle::id
    gpu::ViewId m_hoveredView = 0;
};

} // namespace ui
