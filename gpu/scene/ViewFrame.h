// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gpu/scene/Scene.h"

#include <glm/glm.hpp>

namespace gpu {

/// The camera of a 3D view: unit axes in LPS, and where places are seen. All that draws or looks
/// for something in the view goes by it, so that one eye of two (VolumeScene::eyeShiftMm) is the
/// same for all.
///
/// An eye beside eyeLps looks straight ahead, and its picture is moved so that the target's plane
/// stays where it is: that is a shear of what a symmetric eye would see, by `across`.
struct ViewFrame {
    glm::dvec3 forward{0.0, 1.0, 0.0};
    glm::dvec3 right{1.0, 0.0, 0.0};
    glm::dvec3 down{0.0, 0.0, -1.0};
    double distanceMm = 1.0; ///< eye to target's plane
    double mmPerPixel = 1.0; ///< in the target's plane
    bool orthographic = true;
    glm::dvec3 targetLps{0.0};
    glm::dvec3 eyeLps{0.0, -1.0, 0.0}; ///< of this eye
    glm::dvec3 across{1.0, 0.0, 0.0}; ///< ways to the right are measured along it
    /// Unit, of orthographic rays; in perspective of the ray through the target.
    glm::dvec3 sight{0.0, 1.0, 0.0};
    glm::dvec2 middle{0.0}; ///< frame pixels: where the target is seen
    glm::dvec2 ahead{0.0}; ///< frame pixels: what lies straight ahead of the eye

    /// An eye on its target or an up along the view still yields a right-handed frame.
    [[nodiscard]] static ViewFrame of(const VolumeScene& scene, const glm::ivec2& frameSize);

    /// Millimetres to the right and down in the target's plane, times the depth.
    [[nodiscard]] glm::dvec2 placeOf(const glm::dvec3& fromTarget) const
    {
        return {glm::dot(fromTarget, across), glm::dot(fromTarget, down)};
    }
    /// Depth before the eye in distances of the target; 1 everywhere where it is orthographic.
    [[nodiscard]] double depthOf(const glm::dvec3& fromTarget) const
    {
        return orthographic ? 1.0 : 1.0 + glm::dot(fromTarget, forward) / distanceMm;
    }
};

} // namespace gpu
