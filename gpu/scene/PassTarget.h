// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

namespace gpu {

/// How the pixels that a pass draws lie in the requested frame. Row 0 is the top row.
struct PassTarget {
    glm::ivec2 frameSize{0}; ///< frame pixels
    float pixelScale = 1.0f; ///< frame pixels per drawn pixel; > 1 for a coarse picture
    /// In frame pixels, within ±0.5: the point of the pixel that is sampled.
    glm::vec2 pixelJitter{0.0f};
    int sample = 0; ///< index of this picture among those that are summed
    /// Nothing moves, so cubic interpolation is used where the scene wants it.
    bool cubic = false;
};

} // namespace gpu
