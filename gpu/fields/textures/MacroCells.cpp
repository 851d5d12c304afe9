// SPDX-License-Identifier: Apache-2.0
#include "gpu/fields/textures/MacroCells.h"

#include "gpu/fields/textures/ChebyshevDistance.h"

#include <algorithm>
#include <array>

namespace gpu {

namespace {

constexpr std::uint8_t half = 128;

std::size_t product(const glm::ivec3& size)
{
    return std::size_t(size.x) * std::size_t(size.y) * std::size_t(size.z);
}

bool meets(const VisibleCodes& visible, int lowest, int highest)
{
    return std::any_of(visible.intervals.begin(), visible.intervals.end(),
        [&](const VisibleCodes::Interval& interval) {
            return interval.lowest <= highest && lowest <= interval.highest;
        });
}

} // namespace

glm::ivec3 MacroCells::cellsFor(const glm::ivec3& volumeSize)
{
    return (volumeSize + (side - 1)) / side;
}

std::size_t MacroCells::bytesFor(const glm::ivec3& volumeSize)
{
    constexpr std::size_t bytesPerCell = 4 + 2;
    return product(cellsFor(volumeSize)) * bytesPerCell;
}

MacroCells::MacroCells(const glm::ivec3& volumeSize, std::span<const std::uint16_t> codes)
    : m_cells(cellsFor(volumeSize))
    , m_codes(product(m_cells))
    , m_sculpt(product(m_cells))
    , m_ranges({.label = "macro-cell ranges", .size = m_cells, .format = GL_RG16})
    , m_skipMap({.label = "macro-cell skip map", .size = m_cells, .format = GL_RG8UI})
{
    const auto width = std::size_t(volumeSize.x);
    for (int z = 0; z < volumeSize.z; ++z) {
        for (int y = 0; y < volumeSize.y; ++y) {
            const std::size_t start = (std::size_t(z) * std::size_t(volumeSize.y) + std::size_t(y));
            accumulateRow(codes.subspan(start * width, width), y, z);
        }
    }
    for (const Range& range : m_codes)
        m_greatestCode = std::max(m_greatestCode, int(range.highest));
    m_ranges.upload<Range>(m_codes);
}

void MacroCells::accumulateRow(std::span<const std::uint16_t> row, int y, int z)
{
    const int width = int(row.size());
    for (int x = 0; x < m_cells.x; ++x) {
        const auto part =
            row.subspan(std::size_t(x * side), std::size_t(std::min(side + 1, width - x * side)));
        Range range;
        for (const std::uint16_t code : part) {
            range.lowest = std::min(range.lowest, code);
            range.highest = std::max(range.highest, code);
        }
        // A first row of a cell is the last that the cell before it reaches.
        const int rows = y % side == 0 && y > 0 ? 1 : 0;
        const int slices = z % side == 0 && z > 0 ? 1 : 0;
        for (int dz = 0; dz <= slices; ++dz)
            for (int dy = 0; dy <= rows; ++dy)
                widen(x, y / side - dy, z / side - dz, range);
    }
}

void MacroCells::widen(int x, int y, int z, const Range& range)
{
    Range& cell = m_codes[std::size_t((z * m_cells.y + y) * m_cells.x + x)];
    cell.lowest = std::min(cell.lowest, range.lowest);
    cell.highest = std::max(cell.highest, range.highest);
}

bool MacroCells::mayHold(const glm::ivec3& brick, int lowest, int highest) const
{
    constexpr int cellsOfBrick = core::BrickGrid::side / side;
    const glm::ivec3 first = brick * cellsOfBrick;
    const glm::ivec3 end = glm::min(first + cellsOfBrick, m_cells);
    for (int z = first.z; z < end.z; ++z) {
        for (int y = first.y; y < end.y; ++y) {
            for (int x = first.x; x < end.x; ++x) {
                const Range& cell = m_codes[std::size_t((z * m_cells.y + y) * m_cells.x + x)];
                if (lowest <= cell.highest && cell.lowest <= highest)
                    return true;
            }
        }
    }
    return false;
}

void MacroCells::update(Program& kernel, const Texture3D& radiation, const Texture3D& segmentation,
    const core::VoxelBox& dirty)
{
    if (dirty.empty())
        return;
    // A changed voxel at the beginning of a cell also counts for the cell before it.
    const glm::ivec3 first = glm::max((dirty.minimum - 1) / side, 0);
    const glm::ivec3 last = glm::min((dirty.maximum - 1) / side, m_cells - 1);
    const glm::ivec3 count = last - first + 1;
    std::vector<std::uint32_t> words(product(count));
    const Buffer result({.label = "macro-cells", .bytes = words.size() * sizeof(std::uint32_t)});
    radiation.bindUnit(0);
    segmentation.bindUnit(1);
    result.bindBase(GL_SHADER_STORAGE_BUFFER, 0);
    glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT);
    kernel.set("firstCell", first).set("cellCount", count);
    kernel.dispatch({unsigned(std::min((words.size() + 63) / 64, mostWorkGroups)), 1, 1});
    glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    result.read<std::uint32_t>(words);

    std::size_t from = 0;
    for (int z = first.z; z <= last.z; ++z) {
        for (int y = first.y; y <= last.y; ++y) {
            for (int x = first.x; x <= last.x; ++x) {
                const std::uint32_t word = words[from++];
                m_sculpt[std::size_t((z * m_cells.y + y) * m_cells.x + x)] = Sculpt{
                    .leastRadiation = std::uint8_t(word),
                    .greatestRadiation = std::uint8_t(word >> 8),
                    .greatestSegmentation = std::uint8_t(word >> 16),
                };
            }
        }
    }
    m_skipMapValid = false;
    m_carvedCells.clear();
    m_segmentCells.clear();
    std::size_t i = 0;
    for (int z = 0; z < m_cells.z; ++z) {
        for (int y = 0; y < m_cells.y; ++y) {
            for (int x = 0; x < m_cells.x; ++x, ++i) {
                const Sculpt& cell = m_sculpt[i];
                if (cell.greatestRadiation >= half)
                    m_carvedCells.emplace_back(x, y, z);
                if (cell.greatestSegmentation >= half)
                    m_segmentCells.emplace_back(x, y, z);
            }
        }
    }
}

const Texture3D& MacroCells::skipMap(const VisibleCodes& visible)
{
    if (m_skipMapValid && visible == m_visible)
        return m_skipMap;
    std::vector<std::uint8_t> flags(m_codes.size());
    std::vector<std::uint8_t> occupied(m_codes.size());
    for (std::size_t i = 0; i < flags.size(); ++i) {
        const Sculpt& sculpt = m_sculpt[i];
        std::uint8_t flag = 0;
        if (meets(visible, m_codes[i].lowest, m_codes[i].highest))
            flag |= sculpt.leastRadiation < half ? tissueFlag | shownFlag : shownFlag;
        if (sculpt.greatestRadiation >= half)
            flag |= carvedFlag;
        if (sculpt.greatestSegmentation >= half)
            flag |= segmentFlag;
        flags[i] = flag;
        occupied[i] = flag & (tissueFlag | segmentFlag);
    }
    const std::vector<std::uint8_t> distance = chebyshevDistance(m_cells, occupied);
    std::vector<std::uint8_t> texels(2 * flags.size());
    for (std::size_t i = 0; i < flags.size(); ++i) {
        texels[2 * i] = distance[i];
        texels[2 * i + 1] = flags[i];
    }
    m_skipMap.upload<std::uint8_t>(texels);
    m_visible = visible;
    m_skipMapValid = true;
    return m_skipMap;
}

} // namespace gpu
