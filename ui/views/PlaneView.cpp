// SPDX-License-Identifier: Apache-2.0
#include "ui/views/PlaneView.h"

#include "ui/base/Theme.h"
#include "ui/overlays/Annotations.h"
#include "ui/workspace/CuttingPlane.h"

#include <QPainter>

#include <cmath>

namespace ui {

namespace {

SliceAxes axesOf(const CuttingPlane::Pose& pose)
{
    return {pose.rightLps, pose.downLps, pose.normalLps()};
}

} // namespace

PlaneView::PlaneView(Workspace& workspace, gpu::ViewId view, QWidget* parent)
    : SliceView(workspace, view, axesOf(workspace.plane().pose()), QStringLiteral("PLANE"),
        theme::plane, parent)
{
    connect(&workspace.plane(), &CuttingPlane::changed, this, &PlaneView::follow);
    follow();
}

void PlaneView::follow()
{
    setAxes(axesOf(workspace().plane().pose()));
    requestMovingFrame();
}

gpu::Scene PlaneView::scene() const
{
    gpu::Scene scene = SliceView::scene();
    std::get<gpu::SliceScene>(scene).interpolation =
        workspace().viewOptions().interpolation.value_or(gpu::Interpolation::Cubic);
    return scene;
}

glm::dvec3 PlaneView::throughLps() const
{
    return workspace().plane().pose().centreLps;
}

void PlaneView::passThrough(const glm::dvec3& placeLps)
{
    CuttingPlane& plane = workspace().plane();
    plane.move(glm::dot(placeLps - plane.pose().centreLps, plane.pose().normalLps()));
}

void PlaneView::paintCross(QPainter& painter, const ViewContext& shown)
{
    const glm::dvec3 crosshair = workspace().crosshairLps();
    const double apart = glm::dot(crosshair - throughLps(), axes().normalLps);
    if (std::abs(apart) <= 0.5 * stack().stepMm)
        paintCrosshair(painter, rect(), shown.toPixel(crosshair), theme::plane, theme::plane);
}

} // namespace ui
