// SPDX-License-Identifier: Apache-2.0
#include "gpu/kernels/cut/CutColumns.h"

#include <algorithm>
#include <limits>

namespace gpu {

namespace {

constexpr std::size_t columnsPerTile = CutColumns::tileSide * CutColumns::tileSide;

std::pair<int, int> tileOf(const glm::ivec2& element)
{
    return {element.x >> 4, element.y >> 4};
}

} // namespace

CutColumns::CutColumns(const core::CutFrame& frame, const core::BrickGrid& grid)
    : m_pitch(frame.pitch)
    , m_rampHalfWidth(frame.rampHalfWidth)
{
    // A brick of margin covers the rounding.
    glm::ivec2 low(std::numeric_limits<int>::max());
    glm::ivec2 high(std::numeric_limits<int>::lowest());
    for (int corner = 0; corner < 8; ++corner) {
        const glm::ivec3 voxel = glm::ivec3(corner & 1, corner >> 1 & 1, corner >> 2 & 1)
            * grid.bricks() * core::BrickGrid::side;
        const glm::ivec2 plane(core::planeBase(frame, voxel));
        low = glm::min(low, plane);
        high = glm::max(high, plane);
    }
    using core::fixedPoint::floorDivide;
    const int tileMm16 = frame.pitch * tileSide;
    m_firstTile = {floorDivide(low.x, tileMm16) - 1, floorDivide(low.y, tileMm16) - 1};
    m_tileCount =
        glm::ivec2(floorDivide(high.x, tileMm16), floorDivide(high.y, tileMm16)) + 2 - m_firstTile;
    m_room = {m_firstTile * tileSide, (m_firstTile + m_tileCount) * tileSide - 1};
    m_tileSlots = Buffer({.label = "mask tile slots",
        .bytes = std::size_t(m_tileCount.x) * std::size_t(m_tileCount.y) * sizeof(std::uint32_t)});
    m_tileSlots.fill(0);
}

void CutColumns::set(const glm::ivec2& element, const core::CutColumn& column)
{
    const TileKey key = tileOf(element);
    Tile& tile = m_tiles[key];
    if (tile.columns.empty()) {
        tile.columns.resize(columnsPerTile);
        tile.slot = std::uint32_t(m_tiles.size()) - 1;
    }
    tile.columns[std::size_t((element.x & 15) + tileSide * (element.y & 15))] = column;
    m_stale.insert(key);
    if (column.weight == 0)
        return;
    const PlaneBox box{{element.x * m_pitch, element.y * m_pitch, column.zFrom - m_rampHalfWidth},
        {(element.x + 1) * m_pitch, (element.y + 1) * m_pitch, column.zTo + m_rampHalfWidth}};
    const auto [entry, isNew] = m_changed.try_emplace(key, box);
    if (!isNew) {
        entry->second.minimum = glm::min(entry->second.minimum, box.minimum);
        entry->second.maximum = glm::max(entry->second.maximum, box.maximum);
    }
}

void CutColumns::clear()
{
    for (auto& [key, tile] : m_tiles) {
        std::fill(tile.columns.begin(), tile.columns.end(), core::CutColumn{});
        m_stale.insert(key);
    }
    m_changed.clear();
}

std::vector<PlaneBox> CutColumns::takeChanged()
{
    std::vector<PlaneBox> boxes;
    for (const auto& entry : m_changed)
        boxes.push_back(entry.second);
    m_changed.clear();
    return boxes;
}

void CutColumns::bind(unsigned slotsBinding, unsigned columnsBinding)
{
    mirror();
    m_tileSlots.bindBase(GL_SHADER_STORAGE_BUFFER, slotsBinding);
    m_columns.bindBase(GL_SHADER_STORAGE_BUFFER, columnsBinding);
}

void CutColumns::mirror()
{
    constexpr std::size_t tileBytes = columnsPerTile * sizeof(core::CutColumn);
    const auto needed = std::uint32_t(m_tiles.size());
    if (needed > m_slots || !m_columns) {
        const std::uint32_t slots = std::max(needed * 2, 64u);
        Buffer larger({.label = "mask columns", .bytes = slots * tileBytes});
        if (m_columns)
            m_columns.copyTo(larger, m_columns.bytes());
        m_columns = std::move(larger);
        m_slots = slots;
    }
    for (const TileKey& key : m_stale) {
        const Tile& tile = m_tiles.at(key);
        m_columns.write(std::span<const core::CutColumn>(tile.columns), tile.slot * tileBytes);
        const std::uint32_t entry = tile.slot + 1;
        const auto position =
            std::size_t(key.first - m_firstTile.x + m_tileCount.x * (key.second - m_firstTile.y));
        m_tileSlots.write(std::span<const std::uint32_t>(&entry, 1), position * sizeof(entry));
    }
    m_stale.clear();
}

} // namespace gpu
