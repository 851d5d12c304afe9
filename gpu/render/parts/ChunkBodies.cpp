// SPDX-License-Identifier: Apache-2.0
#include "gpu/render/parts/ChunkBodies.h"

#include <algorithm>
#include <cstring>

namespace gpu {

namespace {

constexpr int side = ChunkBodies::side;
constexpr int reach = ChunkBodies::reach;
/// Of the voxels that a cell's smoothed colours and the next cell's first ones come from.
constexpr int wide = side + 2 * reach + 1;
constexpr int padded = side + 2 * reach;

using Colour = ChunkBodies::Colour;

/// Binomial weights 1 4 6 4 1, @p by numbers apart.
template <class To, class From> To smoothed(const From* from, std::ptrdiff_t by)
{
    return To(from[0] + 4 * from[by] + 6 * from[2 * by] + 4 * from[3 * by] + from[4 * by]);
}

class Cell {
public:
    /// Beyond the box its outermost voxels go on.
    void gather(const glm::ivec3& first, const glm::ivec3& size,
        std::span<const std::uint16_t> leaves, std::span<const Colour> colours)
    {
        std::array<std::size_t, wide> columns;
        for (int x = 0; x < wide; ++x)
            columns[std::size_t(x)] = std::size_t(std::clamp(first.x + x - reach, 0, size.x - 1));
        for (int z = 0; z < wide; ++z) {
            const auto slice = std::size_t(std::clamp(first.z + z - reach, 0, size.z - 1));
            for (int y = 0; y < wide; ++y) {
                const auto row = std::size_t(std::clamp(first.y + y - reach, 0, size.y - 1));
                const std::uint16_t* from =
                    &leaves[(slice * std::size_t(size.y) + row) * std::size_t(size.x)];
                Colour* to = &m_colours[std::size_t((z * wide + y) * wide)];
                for (int x = 0; x < wide; ++x)
                    to[x] = colours[from[columns[std::size_t(x)]]];
            }
        }
    }

    [[nodiscard]] bool isUniform() const
    {
        return std::all_of(m_colours.begin(), m_colours.end(),
            [this](const Colour& colour) { return colour == m_colours.front(); });
    }
    [[nodiscard]] const Colour& first() const { return m_colours.front(); }

    /// @return 8³ colours, x fastest
    const std::array<Colour, std::size_t(side* side* side)>& smooth()
    {
        // One axis after the other, four numbers a voxel.
        constexpr int row = 4 * side;
        for (int z = 0; z < padded; ++z) {
            for (int y = 0; y < padded; ++y) {
                const auto* from = m_colours[std::size_t((z * wide + y) * wide)].data();
                std::uint16_t* to = &m_alongX[std::size_t((z * padded + y) * row)];
                for (int i = 0; i < row; ++i)
                    to[i] = smoothed<std::uint16_t>(from + i, 4);
            }
        }
        for (int z = 0; z < padded; ++z) {
            const std::uint16_t* from = &m_alongX[std::size_t(z * padded * row)];
            std::uint16_t* to = &m_alongY[std::size_t(z * side * row)];
            for (int i = 0; i < side * row; ++i)
                to[i] = smoothed<std::uint16_t>(from + i, row);
        }
        auto* to = m_smooth.front().data();
        for (int i = 0; i < side * side * row; ++i)
            to[i] = std::uint8_t(
                (smoothed<std::uint32_t>(&m_alongY[std::size_t(i)], side * row) + 2048) >> 12);
        return m_smooth;
    }

private:
    std::array<Colour, std::size_t(wide* wide* wide)> m_colours;
    std::array<std::uint16_t, std::size_t(4 * side * padded * padded)> m_alongX;
    std::array<std::uint16_t, std::size_t(4 * side * side * padded)> m_alongY;
    std::array<Colour, std::size_t(side* side* side)> m_smooth;
};

} // namespace

void ChunkBodies::update(const glm::ivec3& size, std::span<const std::uint16_t> leaves,
    std::span<const Colour> colours, const core::VoxelBox& changed)
{
    const glm::ivec3 cells = (size + (side - 1)) / side;
    core::VoxelBox wanted = changed;
    if (!m_colours || m_colours.size() != size) {
        m_colours =
            Texture3D({.label = "chunk bodies", .size = size, .format = GL_RGBA8, .linear = true});
        m_cells = Texture3D({.label = "chunk cells", .size = cells, .format = GL_R8UI});
        wanted = {.minimum = glm::ivec3(0), .maximum = size};
    }
    if (wanted.empty())
        return;
    // Cells that look at a changed voxel.
    const glm::ivec3 low = glm::max(wanted.minimum - reach - 1, glm::ivec3(0)) / side;
    const glm::ivec3 high =
        glm::min((wanted.maximum + (reach + side - 1)) / side, cells); // one beyond
    const glm::ivec3 count = high - low;
    std::vector<std::uint8_t> mixed;
    mixed.reserve(std::size_t(count.x) * std::size_t(count.y) * std::size_t(count.z));
    const glm::ivec3 first = low * side;
    // A layer of cells at a time goes to the GPU.
    const glm::ivec3 end = glm::min(high * side, size);
    const glm::ivec3 layerSize(end.x - first.x, end.y - first.y, side);
    std::vector<Colour> layer(
        std::size_t(layerSize.x) * std::size_t(layerSize.y) * std::size_t(side));
    Cell cell;
    for (int k = low.z; k < high.z; ++k) {
        const int slices = std::min(side, size.z - k * side);
        for (int j = low.y; j < high.y; ++j) {
            for (int i = low.x; i < high.x; ++i) {
                const glm::ivec3 corner = glm::ivec3(i, j, k) * side;
                cell.gather(corner, size, leaves, colours);
                const bool isUniform = cell.isUniform();
                mixed.push_back(isUniform ? 0 : 1);
                const Colour* from = isUniform ? nullptr : cell.smooth().data();
                const glm::ivec3 part = glm::min(glm::ivec3(side), size - corner);
                for (int z = 0; z < part.z; ++z) {
                    for (int y = 0; y < part.y; ++y) {
                        Colour* to = &layer[(std::size_t(z) * std::size_t(layerSize.y)
                                                + std::size_t(corner.y - first.y + y))
                                * std::size_t(layerSize.x)
                            + std::size_t(corner.x - first.x)];
                        if (from)
                            std::copy_n(from + (z * side + y) * side, part.x, to);
                        else
                            std::fill_n(to, part.x, cell.first());
                    }
                }
            }
        }
        m_colours.upload({first.x, first.y, k * side}, {layerSize.x, layerSize.y, slices},
            std::as_bytes(std::span(layer))
                .first(std::size_t(layerSize.x) * std::size_t(layerSize.y) * std::size_t(slices)
                    * sizeof(Colour)));
    }
    m_cells.upload(low, count, std::as_bytes(std::span<const std::uint8_t>(mixed)));
}

void ChunkBodies::bind(GLuint colours, GLuint cells) const
{
    m_colours.bindUnit(colours);
    m_cells.bindUnit(cells);
}

} // namespace gpu
