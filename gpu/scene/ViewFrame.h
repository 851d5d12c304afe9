// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gpu/scene/Scene.h"

#include <glm/glm.hpp>

namespace gpu {

/// The camera of a 3D view: its unit axes in LPS, and where points are seen in the picture.
/// Everything that draws or searches in the view uses this struct, so that stereo
/// (VolumeScene::eyeShiftMm) is the same for all.
///
/// An eye beside eyeLps looks straight ahead, and its picture is shifted so that the target's plane
/// stays in place: what a symmetric eye would see is sheared along `across`.
struct ViewFrame {
    glm::dvec3 forward{0.0, 1.0, 0.0};
    glm::dvec3 right{1.0, 0.0, 0.0};
    glm::dvec3 down{0.0, 0.0, -1.0};
    double distanceMm = 1.0; ///< from the eye to the target's plane
    double mmPerPixel = 1.0; ///< in the target's plane
    bool orthographic = true;
    glm::dvec3 targetLps{0.0};
    glm::dvec3 eyeLps{0.0, -1.0, 0.0}; ///< position of this eye
    glm::dvec3 across{1.0, 0.0, 0.0}; ///< direction along which distances to the right are measured
    /// Unit direction of orthographic rays; in perspective, of the ray through the target.
    glm::dvec3 sight{0.0, 1.0, 0.0};
    glm::dvec2 middle{0.0}; ///< frame pixels: where the target is seen
    glm::dvec2 ahead{0.0}; ///< frame pixels: the point straight ahead of the eye

    /// The frame is right-handed even if the eye is at the target or `up` is parallel to the view
    /// direction.
    [[nodiscard]] static ViewFrame of(const VolumeScene& scene, const glm::ivec2& frameSize);

    /// Millimetres to the right and down in the target's plane, multiplied by depthOf().
    [[nodiscard]] glm::dvec2 placeOf(const glm::dvec3& fromTarget) const
    {
        return {glm::dot(fromTarget, across), glm::dot(fromTarget, down)};
    }
    /// Depth in front of the eye, in units of the target's distance; 1 everywhere in an
    /// orthographic view.
    [[nodiscard]] double depthOf(const glm::dvec3& fromTarget) const
    {
        return orthographic ? 1.0 : 1.0 + glm::dot(fromTarget, forward) / distanceMm;
    }
};

} // namespace gpu
