// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

namespace gpu {

/// A rectangle of a picture, in the picture's own pixels.
struct Tile {
    glm::ivec2 minimum{0};
    glm::ivec2 size{0};
};

/// Cuts a picture into rectangles made of blocks of 64 × 64 pixels, in reading order. The size of
/// each is chosen when it is taken. llvmpipe rasterises such blocks one per thread.
class TilePlan {
public:
    static constexpr int block = 64;

    explicit TilePlan(const glm::ivec2& size)
        : m_size(size)
    {
    }
    [[nodiscard]] bool finished() const { return m_next.y >= m_size.y; }
    /// The next rectangle: a run of blocks in a row, or whole rows; at least one block.
    [[nodiscard]] Tile take(double pixels);
    [[nodiscard]] glm::ivec2 size() const { return m_size; }

private:
    glm::ivec2 m_size;
    glm::ivec2 m_next{0};
};

} // namespace gpu
