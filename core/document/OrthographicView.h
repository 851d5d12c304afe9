// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

namespace core {

/// An orthographic camera, in LPS mm. A perspective camera is converted to one at the picked depth.
struct OrthographicView {
    glm::dvec3 eyeLps{0.0};
    glm::dvec3 targetLps{0.0};
    glm::dvec3 up{0.0, 0.0, 1.0};
    double heightMm = 300.0; ///< visible height; decides no voxel
};

} // namespace core
