// SPDX-License-Identifier: Apache-2.0
#include "ui/geometry/ViewContext.h"

namespace ui {

namespace {

struct PlaneAxes {
    glm::dvec3 centreLps;
    glm::dvec3 rightLps;
    glm::dvec3 downLps;
};

PlaneAxes planeAxes(const gpu::Scene& scene)
{
    if (const auto* slice = std::get_if<gpu::SliceScene>(&scene))
        return {slice->centreLps, slice->rightLps, slice->downLps};
    const auto& volume = std::get<gpu::VolumeScene>(scene);
    const glm::dvec3 forward = glm::normalize(volume.targetLps - volume.eyeLps);
    const glm::dvec3 right = glm::normalize(glm::cross(forward, volume.up));
    return {volume.targetLps, right, glm::cross(forward, right)};
}

} // namespace

double ViewContext::mmPerPixel() const
{
    if (const auto* slice = std::get_if<gpu::SliceScene>(&scene))
        return slice->mmPerPixel;
    return std::get<gpu::VolumeScene>(scene).heightMm / sizePixels.height();
}

glm::dvec2 ViewContext::toViewPlaneMm(const QPointF& pixel) const
{
    return {(pixel.x() - sizePixels.width() / 2) * mmPerPixel(),
        (sizePixels.height() / 2 - pixel.y()) * mmPerPixel()};
}

glm::dvec3 ViewContext::toLps(const QPointF& pixel) const
{
    const PlaneAxes axes = planeAxes(scene);
    const glm::dvec2 mm = toViewPlaneMm(pixel);
    return axes.centreLps + axes.rightLps * mm.x - axes.downLps * mm.y;
}

QPointF ViewContext::toPixel(const glm::dvec3& lps) const
{
    const PlaneAxes axes = planeAxes(scene);
    const glm::dvec3 offset = lps - axes.centreLps;
    return {sizePixels.width() / 2 + glm::dot(offset, axes.rightLps) / mmPerPixel(),
        sizePixels.height() / 2 + glm::dot(offset, axes.downLps) / mmPerPixel()};
}

} // namespace ui
