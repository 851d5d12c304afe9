// SPDX-License-Identifier: Apache-2.0
#include "gpu/fields/textures/MaximumCells.h"

#include "core/base/ParallelFor.h"
#include "gpu/fields/textures/ChebyshevDistance.h"

#include <algorithm>
#include <array>
#include <vector>

namespace gpu {

namespace {

std::size_t cellCount(const glm::ivec3& size)
{
    return std::size_t(size.x) * std::size_t(size.y) * std::size_t(size.z);
}

/// Greatest code of every cell, its last border included: samples between two cells reach it.
std::vector<std::uint16_t> greatestOf(
    const glm::ivec3& size, const glm::ivec3& cells, std::span<const std::uint16_t> codes)
{
    constexpr int side = MaximumCells::side;
    std::vector<std::uint16_t> greatest(cellCount(cells));
    core::parallelFor(cells.z, [&](int cz) {
        std::vector<std::uint16_t> row(std::size_t(cells.x));
        for (int z = cz * side; z <= std::min(cz * side + side, size.z - 1); ++z) {
            for (int y = 0; y < size.y; ++y) {
                const std::uint16_t* from =
                    &codes[(std::size_t(z) * std::size_t(size.y) + std::size_t(y))
                        * std::size_t(size.x)];
                for (int x = 0; x < cells.x; ++x) {
                    const int last = std::min(x * side + side, size.x - 1);
                    row[std::size_t(x)] = *std::max_element(from + x * side, from + last + 1);
                }
                // The first row of a cell is the last that the cell before it reaches.
                const int rows = y % side == 0 && y > 0 ? 1 : 0;
                for (int cy = y / side - rows; cy <= y / side; ++cy) {
                    std::uint16_t* to =
                        &greatest[(std::size_t(cz) * std::size_t(cells.y) + std::size_t(cy))
                            * std::size_t(cells.x)];
                    for (std::size_t x = 0; x < row.size(); ++x)
                        to[x] = std::max(to[x], row[x]);
                }
            }
        }
    });
    return greatest;
}

} // namespace

glm::ivec3 MaximumCells::cellsFor(const glm::ivec3& volumeSize)
{
    return (volumeSize + (side - 1)) / side;
}

std::size_t MaximumCells::bytesFor(const glm::ivec3& volumeSize)
{
    constexpr std::size_t bytesPerCell = 8;
    return cellCount(cellsFor(volumeSize)) * bytesPerCell;
}

MaximumCells::MaximumCells(const glm::ivec3& volumeSize, std::span<const std::uint16_t> codes)
    : m_texture({.label = "maximum cells", .size = cellsFor(volumeSize), .format = GL_RGBA16UI})
{
    const glm::ivec3 cells = cellsFor(volumeSize);
    const std::vector<std::uint16_t> greatest = greatestOf(volumeSize, cells, codes);
    // Evenly spaced, but for the few cells at either end: air, tissue and bone, or fat, grey matter
    // and vessels, are apart by value, not by their number of voxels.
    std::vector<std::uint16_t> sorted = greatest;
    const auto quantile = [&sorted](std::size_t part, std::size_t whole) {
        const auto at = sorted.begin() + std::ptrdiff_t((sorted.size() - 1) * part / whole);
        std::nth_element(sorted.begin(), at, sorted.end());
        return int(*at);
    };
    const int low = quantile(1, 50);
    const int high = quantile(49, 50);
    for (std::size_t k = 0; k < m_levels.size(); ++k)
        m_levels[k] = low + (high - low) * int(k + 1) / (levelCount + 1);
    std::vector<std::uint16_t> texels(4 * greatest.size());
    for (std::size_t i = 0; i < greatest.size(); ++i)
        texels[4 * i] = greatest[i];
    std::array<std::vector<std::uint8_t>, levelCount> distances;
    core::parallelFor(levelCount, [&](int level) {
        std::vector<std::uint8_t> above(greatest.size());
        std::transform(greatest.begin(), greatest.end(), above.begin(),
            [least = m_levels[std::size_t(level)]](
                std::uint16_t code) { return std::uint8_t(code > least); });
        distances[std::size_t(level)] = chebyshevDistance(cells, above);
    });
    for (std::size_t k = 0; k < distances.size(); ++k) {
        for (std::size_t i = 0; i < greatest.size(); ++i) {
            std::uint16_t& word = texels[4 * i + 1 + k / 2];
            word = std::uint16_t(word | distances[k][i] << 8 * (k % 2));
        }
    }
    m_texture.upload<std::uint16_t>(texels);
}

} // namespace gpu
