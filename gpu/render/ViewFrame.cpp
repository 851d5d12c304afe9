// SPDX-License-Identifier: Apache-2.0
#include "gpu/render/ViewFrame.h"

#include <cmath>

namespace gpu {

ViewFrame ViewFrame::of(const VolumeScene& scene, const glm::ivec2& frameSize)
{
    ViewFrame frame;
    const glm::dvec3 sight = scene.targetLps - scene.eyeLps;
    frame.distanceMm = glm::length(sight);
    frame.forward = frame.distanceMm > 1e-9 ? sight / frame.distanceMm : glm::dvec3(0.0, 1.0, 0.0);
    glm::dvec3 right = glm::cross(frame.forward, scene.up);
    if (glm::length(right) < 1e-9) {
        const glm::dvec3 other =
            std::abs(frame.forward.x) < 0.9 ? glm::dvec3(1.0, 0.0, 0.0) : glm::dvec3(0.0, 1.0, 0.0);
        right = glm::cross(frame.forward, other);
    }
    frame.right = glm::normalize(right);
    frame.down = glm::cross(frame.forward, frame.right);
    frame.mmPerPixel = scene.heightMm / frameSize.y;
    return frame;
}

} // namespace gpu
