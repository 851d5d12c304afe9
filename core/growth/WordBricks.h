// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/brick/BrickGrid.h"
#include "core/growth/SeedWord.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace core {

/// The seed words of one plane in memory, brick by brick. Where no brick was added, all words are
/// unvisited. A voxel is identified by i << 12 | its offset in the brick, where the brick was the
/// i-th to be added.
class WordBricks {
public:
    using Voxel = std::uint32_t;
    static constexpr Voxel none = 0xFFFFFFFFu;

    /// @param bricks how many bricks will be added
    WordBricks(const BrickGrid& grid, std::size_t bricks);

    /// @param bytes of the brick: 4096 words, little-endian
    void add(std::uint32_t brick, std::span<const std::uint8_t> bytes);
    /// To be called once, after the last add() and before forNeighbours().
    void link();

    [[nodiscard]] const BrickGrid& grid() const { return m_grid; }
    [[nodiscard]] std::size_t count() const { return m_words.size(); }
    [[nodiscard]] std::uint32_t brickOf(Voxel voxel) const { return m_bricks[voxel >> 12]; }
    [[nodiscard]] Voxel find(const glm::ivec3& position) const;
    [[nodiscard]] glm::ivec3 positionOf(Voxel voxel) const;
    [[nodiscard]] std::uint32_t operator[](Voxel voxel) const { return m_words[voxel]; }
    void put(Voxel voxel, std::uint32_t word) { m_words[voxel] = word; }

    /// Calls @p visit(neighbour, word, direction) for the neighbours in directions @p first …
    /// @p last − 1 of seedWord::offsets that lie in a brick that was added.
    template <class Visit>
    void forNeighbours(
        Voxel voxel, std::uint32_t first, std::uint32_t last, const Visit& visit) const
    {
        const int x = int(voxel & 15u);
        const int y = int(voxel >> 4 & 15u);
        const int z = int(voxel >> 8 & 15u);
        if (std::uint32_t(x - 1) < 14 && std::uint32_t(y - 1) < 14 && std::uint32_t(z - 1) < 14) {
            for (std::uint32_t direction = first; direction < last; ++direction) {
                const Voxel neighbour = voxel + std::uint32_t(strides[direction]);
                visit(neighbour, m_words[neighbour], direction);
            }
            return;
        }
        const std::array<std::uint32_t, 27>& around = m_around[voxel >> 12];
        for (std::uint32_t direction = first; direction < last; ++direction) {
            const std::array<int, 3>& offset = seedWord::offsets[direction];
            const int a = x + offset[0] + 16;
            const int b = y + offset[1] + 16;
            const int c = z + offset[2] + 16;
            const std::uint32_t place = around[std::size_t((a >> 4) + 3 * (b >> 4) + 9 * (c >> 4))];
            if (place == none)
                continue;
            const Voxel neighbour =
                place << 12 | std::uint32_t((a & 15) | (b & 15) << 4 | (c & 15) << 8);
            visit(neighbour, m_words[neighbour], direction);
        }
    }

    /// The lowest direction below @p last (an even number) that leads to the voxel from a neighbour
    /// whose brick was added and for whose word @p holds is true; seedWord::directions if there is
    /// none. It stops at the first one.
    template <class Holds>
    [[nodiscard]] std::uint32_t lowestDirectionTo(
        Voxel voxel, std::uint32_t last, const Holds& holds) const
    {
        const int x = int(voxel & 15u);
        const int y = int(voxel >> 4 & 15u);
        const int z = int(voxel >> 8 & 15u);
        if (std::uint32_t(x - 1) < 14 && std::uint32_t(y - 1) < 14 && std::uint32_t(z - 1) < 14) {
            for (std::uint32_t direction = 0; direction < last; ++direction) {
                if (holds(m_words[voxel + std::uint32_t(strides[direction ^ 1u])]))
                    return direction;
            }
            return seedWord::directions;
        }
        const std::array<std::uint32_t, 27>& around = m_around[voxel >> 12];
        for (std::uint32_t direction = 0; direction < last; ++direction) {
            const std::array<int, 3>& offset = seedWord::offsets[direction ^ 1u];
            const int a = x + offset[0] + 16;
            const int b = y + offset[1] + 16;
            const int c = z + offset[2] + 16;
            const std::uint32_t place = around[std::size_t((a >> 4) + 3 * (b >> 4) + 9 * (c >> 4))];
            if (place == none)
                continue;
            const Voxel neighbour =
                place << 12 | std::uint32_t((a & 15) | (b & 15) << 4 | (c & 15) << 8);
            if (holds(m_words[neighbour]))
                return direction;
        }
        return seedWord::directions;
    }

private:
    /// From a voxel to its neighbour in the same brick.
    static constexpr std::array<int, seedWord::directions> strides = [] {
        std::array<int, seedWord::directions> steps{};
        for (std::size_t i = 0; i < steps.size(); ++i)
            steps[i] = seedWord::offsets[i][0] + 16 * seedWord::offsets[i][1]
                + 256 * seedWord::offsets[i][2];
        return steps;
    }();

    BrickGrid m_grid;
    std::vector<std::uint32_t> m_bricks; ///< brick number by place, that is by order of adding
    std::vector<std::uint32_t> m_places; ///< place by brick number, or none
    std::vector<std::uint32_t> m_words;
    /// by place: the places of the 27 bricks around it
    std::vector<std::array<std::uint32_t, 27>> m_around;
};

} // namespace core
