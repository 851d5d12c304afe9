// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gpu/scene/Scene.h"

#include <glm/glm.hpp>

namespace gpu {

struct ViewFrame;

/// A plane of the volume, and where its places are seen in a picture.
struct SeenPlane {
    glm::dvec3 centreLps{0.0};
    glm::dvec3 rightLps{1.0, 0.0, 0.0}; ///< unit
    glm::dvec3 downLps{0.0, 1.0, 0.0}; ///< unit
    /// (x · w, y · w, w) of (millimetres to the right and down of the centre, 1): frame pixels; w
    /// is the depth, and what is not before the eye has w ≤ 0.
    glm::dmat3 pixelFromMm{1.0};

    /// As a slice sees it. @param frameSize pixels
    [[nodiscard]] static SeenPlane of(const SliceScene& scene, const glm::ivec2& frameSize);
    /// As a 3D view sees it.
    [[nodiscard]] static SeenPlane of(const ScenePlane& plane, const ViewFrame& view);
};

} // namespace gpu
