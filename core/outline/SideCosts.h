// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/outline/SlicePixels.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <vector>

namespace core {

/// The cost of drawing along each side of a pixel, so that the cheapest path between two corners
/// follows what the eye takes for an edge.
///
/// From Mortensen and Barrett, "Intelligent scissors for image composition", SIGGRAPH 1995: edges
/// are cheap, and paths are the cheapest ones from an anchor. Their paths lead from pixel to pixel,
/// which leaves open on which side of the outline those pixels are. Here paths lead along the sides
/// of pixels, as in Falcão et al., "User-steered image segmentation paradigms: live wire and live
/// lane", Graphical Models and Image Processing 60 (1998), so an outline encloses whole pixels.
///
/// 1. The brightness of a pixel is its code within the window of values, 0 … 255: b = (code − low)
///    · 255 / (high − low), rounded down and clamped, where high is at least low + 1. So an edge
///    that is not visible is not followed.
/// 2. The contrast c of a side is |(d₋₁ + 2·d₀ + d₁)|, 0 … 1020, where d₀ is the difference in
///    brightness across it, and d₋₁ and d₁ those across its neighbours in the same line. A
///    neighbour outside the picture is replaced by the side itself; a side at the border of the
///    picture has no contrast. The average makes noise count for less, and a bump of a single pixel
///    may be cut off.
/// 3. The cost is 1 + 254 · 64 / (64 + c), rounded down: 255 without contrast, half of that at a
///    sixteenth of the window, and 15 at the whole window. So a faint edge is much cheaper than
///    none, however strong others are.
struct SideCosts {
    static constexpr int greatest = 255;
    static constexpr int greatestContrast = 4 * 255;

    /// Columns and rows; there is one more corner than that in each direction.
    glm::ivec2 pixels{0};
    /// For each corner, the cost of the side that leads to the corner at column + 1.
    std::vector<std::uint8_t> along{};
    /// For each corner, the cost of the side that leads to the corner at row + 1.
    std::vector<std::uint8_t> down{};

    [[nodiscard]] static int ofContrast(int contrast) { return 1 + 254 * 64 / (64 + contrast); }
    [[nodiscard]] glm::ivec2 corners() const { return pixels + 1; }
    [[nodiscard]] std::size_t at(const glm::ivec2& corner) const
    {
        return std::size_t(corner.y) * std::size_t(pixels.x + 1) + std::size_t(corner.x);
    }
};

/// Computes the costs of a picture.
/// @param lowCode, highCode the window of values
[[nodiscard]] SideCosts sideCosts(const SlicePixels& picture, int lowCode, int highCode);

} // namespace core
