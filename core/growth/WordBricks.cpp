// SPDX-License-Identifier: Apache-2.0
#include "core/growth/WordBricks.h"

#include <bit>
#include <cstring>

namespace core {

WordBricks::WordBricks(const BrickGrid& grid, std::size_t bricks)
    : m_grid(grid)
    , m_places(std::size_t(grid.brickCount()), none)
{
    m_bricks.reserve(bricks);
    m_words.reserve(bricks * BrickGrid::voxelsPerBrick);
}

void WordBricks::add(std::uint32_t brick, std::span<const std::uint8_t> bytes)
{
    m_places[brick] = std::uint32_t(m_bricks.size());
    m_bricks.push_back(brick);
    const std::size_t first = m_words.size();
    m_words.resize(first + BrickGrid::voxelsPerBrick);
    const std::uint8_t* byte = bytes.data();
    std::uint32_t* const words = m_words.data() + first;
    if constexpr (std::endian::native == std::endian::little) {
        std::memcpy(words, byte, BrickGrid::voxelsPerBrick * sizeof(std::uint32_t));
    } else {
        for (std::size_t i = 0; i < BrickGrid::voxelsPerBrick; ++i, byte += 4)
            words[i] = seedWord::wordAt(byte);
    }
}

void WordBricks::link()
{
    const glm::ivec3 bricks = m_grid.bricks();
    m_around.resize(m_bricks.size());
    for (std::size_t place = 0; place < m_bricks.size(); ++place) {
        const glm::ivec3 centre = m_grid.brickPosition(int(m_bricks[place]));
        std::size_t slot = 0;
        for (int z = centre.z - 1; z <= centre.z + 1; ++z) {
            for (int y = centre.y - 1; y <= centre.y + 1; ++y) {
                for (int x = centre.x - 1; x <= centre.x + 1; ++x, ++slot) {
                    const bool inside =
                        x >= 0 && y >= 0 && z >= 0 && x < bricks.x && y < bricks.y && z < bricks.z;
                    m_around[place][slot] =
                        inside ? m_places[std::size_t(x + bricks.x * (y + bricks.y * z))] : none;
                }
            }
        }
    }
}

WordBricks::Voxel WordBricks::find(const glm::ivec3& position) const
{
    const std::uint32_t place = m_places[std::size_t(m_grid.brickOf(position))];
    return place == none ? none : place << 12 | std::uint32_t(BrickGrid::offsetInBrick(position));
}

glm::ivec3 WordBricks::positionOf(Voxel voxel) const
{
    return m_grid.brickPosition(int(brickOf(voxel))) * BrickGrid::side
        + glm::ivec3(int(voxel & 15u), int(voxel >> 4 & 15u), int(voxel >> 8 & 15u));
}

} // namespace core
