// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace core {

/// The values of a slice as a picture, for outlines that follow its edges.
struct SlicePixels {
    glm::ivec2 size{0}; ///< columns, rows
    std::vector<std::uint16_t> codes{}; ///< columns fastest

    [[nodiscard]] bool contains(const glm::ivec2& pixel) const
    {
        return pixel.x >= 0 && pixel.y >= 0 && pixel.x < size.x && pixel.y < size.y;
    }
    /// @pre it contains the pixel
    [[nodiscard]] int code(const glm::ivec2& pixel) const
    {
        return codes[std::size_t(pixel.y) * std::size_t(size.x) + std::size_t(pixel.x)];
    }
};

} // namespace core
