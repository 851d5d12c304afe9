// SPDX-License-Identifier: Apache-2.0
#include "gpu/textures/ChebyshevDistance.h"

#include <algorithm>
#include <array>

namespace gpu {

namespace {

constexpr std::uint8_t far = 255;

/// The distances with a border of one far cell, so that the sweeps need no bounds checks.
struct Padded {
    glm::ivec3 size;
    std::vector<std::uint8_t> values;

    explicit Padded(const glm::ivec3& cells)
        : size(cells + 2)
        , values(std::size_t(size.x) * std::size_t(size.y) * std::size_t(size.z), far)
    {
    }
    [[nodiscard]] std::ptrdiff_t index(int x, int y, int z) const
    {
        return (std::ptrdiff_t(z + 1) * size.y + y + 1) * size.x + x + 1;
    }
};

} // namespace

std::vector<std::uint8_t> chebyshevDistance(
    const glm::ivec3& cells, std::span<const std::uint8_t> occupied)
{
    Padded distance(cells);
    std::size_t from = 0;
    for (int z = 0; z < cells.z; ++z)
        for (int y = 0; y < cells.y; ++y)
            for (int x = 0; x < cells.x; ++x)
                if (occupied[from++] != 0)
                    distance.values[std::size_t(distance.index(x, y, z))] = 0;

    // The 13 neighbours that come before a cell in memory; those after it are their negatives.
    std::array<std::ptrdiff_t, 13> before{};
    const std::ptrdiff_t row = distance.size.x;
    const std::ptrdiff_t slice = row * distance.size.y;
    std::size_t count = 0;
    for (int dy = -1; dy <= 1; ++dy)
        for (int dx = -1; dx <= 1; ++dx)
            before[count++] = -slice + dy * row + dx;
    for (int dx = -1; dx <= 1; ++dx)
        before[count++] = -row + dx;
    before[count] = -1;

    const auto relax = [&](std::ptrdiff_t at, int sign) {
        std::uint8_t& value = distance.values[std::size_t(at)];
        if (value == 0)
            return;
        std::uint8_t least = value;
        for (const std::ptrdiff_t offset : before)
            least = std::min(least, distance.values[std::size_t(at + sign * offset)]);
        if (least < value)
            value = std::uint8_t(least + 1);
    };
    for (int z = 0; z < cells.z; ++z)
        for (int y = 0; y < cells.y; ++y)
            for (int x = 0; x < cells.x; ++x)
                relax(distance.index(x, y, z), 1);
    for (int z = cells.z - 1; z >= 0; --z)
        for (int y = cells.y - 1; y >= 0; --y)
            for (int x = cells.x - 1; x >= 0; --x)
                relax(distance.index(x, y, z), -1);

    std::vector<std::uint8_t> result(occupied.size());
    std::size_t to = 0;
    for (int z = 0; z < cells.z; ++z)
        for (int y = 0; y < cells.y; ++y)
            for (int x = 0; x < cells.x; ++x)
                result[to++] = distance.values[std::size_t(distance.index(x, y, z))];
    return result;
}

} // namespace gpu
