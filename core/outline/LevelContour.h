// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/outline/SlicePixels.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <vector>

namespace core {

/// The closed contour of one value through a pixel, for a hand that points at the border of
/// something. After the tool "Level tracing" of 3D Slicer's segment editor, whose contour passes
/// through the pixel under the pointer, too (ITK, LevelTracingImageFilter).
///
/// 1. The level is the code of the pixel. There are two parts of that level: the pixels with at
///    least that code that hang together with it by their sides, and those with at most that code.
/// 2. Holes are filled: pixels from which no way over sides and corners leads around the part to
///    the outside of the picture.
/// 3. Inside is the part that does not reach the border of the picture; if that does not tell, the
///    one that is smaller with its holes; if they are equal, the brighter one. So a bright spot on
///    a dark ground is traced, and a dark one on a bright ground.
/// 4. The contour runs along the sides of pixels. It encloses exactly the inside with its holes, by
///    winding, and stays half a pixel away from the centre of any pixel.
struct LevelContour {
    int level = 0;
    bool brighter = true; ///< inside are codes from the level on; else up to it
    bool reachesBorder = false; ///< the border of the picture closes it
    std::int64_t pixels = 0; ///< inside, with holes
    /// A corner (x, y) lies half a pixel before the centre of pixel (x, y) in both directions;
    /// closed from the last to the first. Only where it turns.
    std::vector<glm::ivec2> corners{};
};

/// The cost is that of the picture. @pre the picture contains the pixel
[[nodiscard]] LevelContour levelContour(const SlicePixels& picture, const glm::ivec2& pixel);

} // namespace core
