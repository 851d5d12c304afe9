// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gpu/scene/Scene.h"

#include <glm/glm.hpp>

namespace gpu {

struct ViewFrame;

/// A plane through the volume, and where its points are seen in a picture.
struct SeenPlane {
    glm::dvec3 centreLps{0.0};
    glm::dvec3 rightLps{1.0, 0.0, 0.0}; ///< unit
    glm::dvec3 downLps{0.0, 1.0, 0.0}; ///< unit
    /// Maps (millimetres to the right of the centre, millimetres down, 1) to (x · w, y · w, w),
    /// where (x, y) are frame pixels and w is the depth; points that are not in front of the eye
    /// have w ≤ 0.
    glm::dmat3 pixelFromMm{1.0};

    /// The plane of a slice.
    /// @param frameSize in pixels
    [[nodiscard]] static SeenPlane of(const SliceScene& scene, const glm::ivec2& frameSize);
    /// The cutting plane of a 3D view.
    [[nodiscard]] static SeenPlane of(const ScenePlane& plane, const ViewFrame& view);
};

} // namespace gpu
