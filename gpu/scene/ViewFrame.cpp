// SPDX-License-Identifier: Apache-2.0
#include "gpu/scene/ViewFrame.h"

#include <algorithm>
#include <cmath>

namespace gpu {

ViewFrame ViewFrame::of(const VolumeScene& scene, const glm::ivec2& frameSize)
{
    ViewFrame frame;
    const glm::dvec3 sight = scene.targetLps - scene.eyeLps;
    const double distance = glm::length(sight);
    frame.forward = distance > 1e-9 ? sight / distance : glm::dvec3(0.0, 1.0, 0.0);
    glm::dvec3 right = glm::cross(frame.forward, scene.up);
    if (glm::length(right) < 1e-9) {
        const glm::dvec3 other =
            std::abs(frame.forward.x) < 0.9 ? glm::dvec3(1.0, 0.0, 0.0) : glm::dvec3(0.0, 1.0, 0.0);
        right = glm::cross(frame.forward, other);
    }
    frame.right = glm::normalize(right);
    frame.down = glm::cross(frame.forward, frame.right);
    frame.distanceMm = std::max(distance, 1e-6);
    frame.mmPerPixel = scene.heightMm / frameSize.y;
    frame.orthographic = scene.orthographic;
    frame.targetLps = scene.targetLps;
    frame.eyeLps = scene.eyeLps;
    frame.across = frame.right;
    frame.sight = frame.forward;
    frame.middle = glm::dvec2(frameSize) * 0.5;
    frame.ahead = frame.middle;
    if (scene.eyeShiftMm != 0.0 && distance > 1e-9) {
        const double slant = scene.eyeShiftMm / frame.distanceMm;
        frame.eyeLps += frame.right * scene.eyeShiftMm;
        frame.across += frame.forward * slant;
        frame.sight = glm::normalize(frame.forward - frame.right * slant);
        frame.ahead.x += scene.eyeShiftMm / frame.mmPerPixel;
    }
    return frame;
}

} // namespace gpu
