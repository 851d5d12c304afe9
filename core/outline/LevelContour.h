// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/outline/SlicePixels.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <vector>

namespace core {

/// The closed contour of one value through a pixel, for a user who points at the border of a
/// structure. After the effect "Level tracing" of 3D Slicer's Segment Editor, whose contour also
/// passes through the pixel under the pointer (ITK, LevelTracingImageFilter).
///
/// 1. The level is the code of the pixel. Two regions are considered: the pixels connected with it
///    by their sides whose codes are at least the level, and those whose codes are at most the
///    level.
/// 2. Holes of a region are filled. A hole is a set of pixels from which no path over sides and
///    corners of pixels outside the region leads out of the picture.
/// 3. The inside is the region that does not reach the border of the picture. If both or neither
///    do, it is the one that is smaller with its holes filled, and if they are equal, the brighter
///    one. So a bright spot on a dark ground is traced, and a dark one on a bright ground.
/// 4. The contour runs along the sides of pixels and winds around exactly the inside with its
///    holes. It stays half a pixel away from the centre of every pixel.
struct LevelContour {
    int level = 0;
    /// True: inside are codes of at least the level; false: of at most the level.
    bool brighter = true;
    bool reachesBorder = false; ///< whether it runs along the border of the picture
    std::int64_t pixels = 0; ///< number of pixels inside, holes included
    /// The corners at which it turns, closed from the last to the first. Corner (x, y) lies half a
    /// pixel before the centre of pixel (x, y) in both directions.
    std::vector<glm::ivec2> corners{};
};

/// Cost ∝ the picture.
/// @pre the picture contains the pixel
[[nodiscard]] LevelContour levelContour(const SlicePixels& picture, const glm::ivec2& pixel);

} // namespace core
