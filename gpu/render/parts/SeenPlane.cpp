// SPDX-License-Identifier: Apache-2.0
#include "gpu/render/parts/SeenPlane.h"

#include "gpu/scene/ViewFrame.h"

namespace gpu {

SeenPlane SeenPlane::of(const SliceScene& scene, const glm::ivec2& frameSize)
{
    const double perMm = 1.0 / scene.mmPerPixel;
    return {.centreLps = scene.centreLps,
        .rightLps = scene.rightLps,
        .downLps = scene.downLps,
        .pixelFromMm = glm::dmat3(glm::dvec3(perMm, 0.0, 0.0), glm::dvec3(0.0, perMm, 0.0),
            glm::dvec3(glm::dvec2(frameSize) * 0.5, 1.0))};
}

SeenPlane SeenPlane::of(const ScenePlane& plane, const ViewFrame& view)
{
    // All of it is linear in the place.
    const auto columnOf = [&view](const glm::dvec3& from, double depth) {
        return glm::dvec3(view.middle * depth + view.placeOf(from) / view.mmPerPixel, depth);
    };
    const glm::dvec3 from = plane.centreLps - view.targetLps;
    const double depth = view.depthOf(from);
    return {.centreLps = plane.centreLps,
        .rightLps = plane.rightLps,
        .downLps = plane.downLps,
        .pixelFromMm =
            glm::dmat3(columnOf(plane.rightLps, view.depthOf(from + plane.rightLps) - depth),
                columnOf(plane.downLps, view.depthOf(from + plane.downLps) - depth),
                columnOf(from, depth))};
}

} // namespace gpu
