// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

namespace gpu {

/// How the pixels that a pass draws lie in the frame that was asked for. Row 0 is the top row.
struct PassTarget {
    glm::ivec2 frameSize{0}; ///< frame pixels
    float pixelScale = 1.0f; ///< frame pixels per drawn pixel; > 1 for a coarse picture
    glm::vec2 pixelJitter{0.0f}; ///< frame pixels, within ±0.5: which point of the pixel is seen
    int sample = 0; ///< number of this picture among those accumulated
    /// Nothing moves: what the scene wants interpolated by cubics is.
    bool cubic = false;
};

} // namespace gpu
