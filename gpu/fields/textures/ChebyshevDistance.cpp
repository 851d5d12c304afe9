// SPDX-License-Identifier: Apache-2.0
#include "gpu/fields/textures/ChebyshevDistance.h"

#include <algorithm>

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
    /// The cells of a row with their border.
    [[nodiscard]] std::uint8_t* row(int y, int z)
    {
        return &values[(std::size_t(z + 1) * std::size_t(size.y) + std::size_t(y + 1))
            * std::size_t(size.x)];
    }
};

std::uint8_t oneMore(std::uint8_t distance)
{
    return distance == far ? far : std::uint8_t(distance + 1);
}

} // namespace

std::vector<std::uint8_t> chebyshevDistance(
    const glm::ivec3& cells, std::span<const std::uint8_t> occupied)
{
    Padded distance(cells);
    std::size_t from = 0;
    for (int z = 0; z < cells.z; ++z)
        for (int y = 0; y < cells.y; ++y)
            for (int x = 0; x < cells.x; ++x, ++from)
                distance.row(y, z)[x + 1] = occupied[from] != 0 ? 0 : far;

    // Of the 13 neighbours that come before a cell, 12 lie in rows that are finished: compilers
    // take their least in vectors.
    std::vector<std::uint8_t> column(std::size_t(cells.x) + 2);
    std::vector<std::uint8_t> least(std::size_t(cells.x));
    const auto lookBack = [&](int y, int z, int sign) {
        const std::uint8_t* a = distance.row(y - 1, z - sign);
        const std::uint8_t* b = distance.row(y, z - sign);
        const std::uint8_t* c = distance.row(y + 1, z - sign);
        const std::uint8_t* d = distance.row(y - sign, z);
        for (std::size_t x = 0; x < column.size(); ++x)
            column[x] = std::min(std::min(a[x], b[x]), std::min(c[x], d[x]));
        for (std::size_t x = 0; x < least.size(); ++x)
            least[x] = std::min(std::min(column[x], column[x + 1]), column[x + 2]);
    };
    for (int z = 0; z < cells.z; ++z) {
        for (int y = 0; y < cells.y; ++y) {
            lookBack(y, z, 1);
            std::uint8_t* row = distance.row(y, z) + 1;
            for (int x = 0; x < cells.x; ++x)
                row[x] = std::min(row[x], oneMore(std::min(least[std::size_t(x)], row[x - 1])));
        }
    }
    for (int z = cells.z - 1; z >= 0; --z) {
        for (int y = cells.y - 1; y >= 0; --y) {
            lookBack(y, z, -1);
            std::uint8_t* row = distance.row(y, z) + 1;
            for (int x = cells.x - 1; x >= 0; --x)
                row[x] = std::min(row[x], oneMore(std::min(least[std::size_t(x)], row[x + 1])));
        }
    }

    std::vector<std::uint8_t> result;
    result.reserve(occupied.size());
    for (int z = 0; z < cells.z; ++z)
        for (int y = 0; y < cells.y; ++y) {
            const std::uint8_t* row = distance.row(y, z) + 1;
            result.insert(result.end(), row, row + cells.x);
        }
    return result;
}

} // namespace gpu
