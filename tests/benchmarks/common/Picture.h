// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include <cstdint>
#include <string>
#include <vector>

namespace bench {

/// A grey picture, top row first.
struct Picture {
    glm::ivec2 size{0};
    std::vector<std::uint8_t> luminance;

    /// From RGBA bytes, top row first (Rec. 709 weights).
    static Picture fromRgba(const glm::ivec2& size, const std::uint8_t* rgba);
    void save(const std::string& file) const; ///< as PGM, for eyes
};

/// How far two pictures of one thing agree.
struct Agreement {
    double silhouetteOverlap = 0.0; ///< intersection over union of what is not background, 0 … 1
    double meanDifference = 1.0; ///< of luminance, share of full scale
};
/// @param background luminance up to which a pixel is background
Agreement compare(const Picture& a, const Picture& b, int background);

} // namespace bench
