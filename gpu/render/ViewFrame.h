// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gpu/frame/Scene.h"

#include <glm/glm.hpp>

namespace gpu {

/// The camera of a 3D view as unit axes in LPS.
struct ViewFrame {
    glm::dvec3 forward{0.0, 1.0, 0.0};
    glm::dvec3 right{1.0, 0.0, 0.0};
    glm::dvec3 down{0.0, 0.0, -1.0};
    double distanceMm = 1.0; ///< eye to target
    double mmPerPixel = 1.0; ///< in the target's plane

    /// An eye on its target or an up along the view still yields a right-handed frame.
    [[nodiscard]] static ViewFrame of(const VolumeScene& scene, const glm::ivec2& frameSize);
};

} // namespace gpu
