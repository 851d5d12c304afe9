// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/outline/SlicePixels.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <vector>

namespace core {

/// What it costs to draw along the sides of pixels, so that the cheapest way between two corners
/// follows what the eye takes for an edge.
///
/// From Mortensen and Barrett, "Intelligent scissors for image composition", SIGGRAPH 1995: an
/// edge is cheap, and ways are the cheapest ones from an anchor. Their ways lead from pixel to
/// pixel, so that it stays open on which side of the outline those pixels are. Here they lead along
/// the sides of pixels, as in Falcão et al., "User-steered image segmentation paradigms: live wire
/// and live lane", Graphical Models and Image Processing 60 (1998), and an outline encloses whole
/// pixels.
///
/// 1. A pixel's brightness is its code within the window of values, 0 … 255: b = (code − low) · 255
///    / (high − low), rounded down and clamped, where high is at least low + 1. What is not seen is
///    not followed.
/// 2. The contrast c of a side is |(d₋₁ + 2·d₀ + d₁)|, 0 … 1020, with the differences d of the
///    brightness across it (d₀), and across its neighbours in the same line. A neighbour beyond the
///    picture counts as the side itself, and a side at the border of the picture has no contrast.
///    So noise counts for less, and a bump of a single pixel may be cut off.
/// 3. The cost is 1 + 254 · 64 / (64 + c), rounded down: 255 where there is no contrast, half of
///    that at a sixteenth of the window, and 15 at all of it. So a faint edge is much cheaper than
///    none, however strong others are.
struct SideCosts {
    static constexpr int greatest = 255;
    static constexpr int greatestContrast = 4 * 255;

    glm::ivec2 pixels{0}; ///< columns, rows; there is one corner more along each
    std::vector<std::uint8_t> along{}; ///< by corner: the side that leads on to column + 1
    std::vector<std::uint8_t> down{}; ///< by corner: the side that leads on to row + 1

    [[nodiscard]] static int ofContrast(int contrast) { return 1 + 254 * 64 / (64 + contrast); }
    [[nodiscard]] glm::ivec2 corners() const { return pixels + 1; }
    [[nodiscard]] std::size_t at(const glm::ivec2& corner) const
    {
        return std::size_t(corner.y) * std::size_t(pixels.x + 1) + std::size_t(corner.x);
    }
};

/// @param lowCode, highCode the window of values
[[nodiscard]] SideCosts sideCosts(const SlicePixels& picture, int lowCode, int highCode);

} // namespace core
