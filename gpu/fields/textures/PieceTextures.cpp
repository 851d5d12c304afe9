// SPDX-License-Identifier: Apache-2.0
#include "gpu/fields/textures/PieceTextures.h"

#include "gpu/fields/textures/MacroCells.h"

#include <algorithm>
#include <vector>

namespace gpu {

namespace {

constexpr int side = MacroCells::side;

glm::ivec3 cellsOf(const glm::ivec3& voxels)
{
    return (voxels + (side - 1)) / side;
}

} // namespace

void PieceTextures::arrange(const std::map<PieceSource, core::VoxelBox>& boxes)
{
    // Both at once may not fit; and where the new ones do not, there are none.
    m_entries.clear();
    m_footprints = {};
    m_bytes = {};
    m_cells = {};
    std::map<PieceSource, Entry> entries;
    // One on top of the other as high as textures may be, then beside that, then behind it.
    GLint longest = 0;
    glGetIntegerv(GL_MAX_3D_TEXTURE_SIZE, &longest);
    glm::ivec3 size(0);
    glm::ivec3 corner(0);
    int besideY = 0;
    for (const auto& [source, box] : boxes) {
        if (box.empty())
            continue;
        const glm::ivec3 room = cellsOf(box.maximum - box.minimum) * side;
        if (corner.z + room.z > longest)
            corner = {corner.x, besideY, 0};
        if (corner.y + room.y > longest) {
            corner = {size.x, 0, 0};
            besideY = 0;
        }
        entries[source] = Entry{.box = box, .place = corner, .filled = {}};
        size = glm::max(size, corner + room);
        besideY = std::max(besideY, corner.y + room.y);
        corner.z += room.z;
    }
    if (entries.empty())
        return;
    m_footprints =
        Texture3D({.label = "footprints of pieces", .size = size, .format = GL_R8, .linear = true});
    m_bytes = m_footprints.view(GL_R8UI, "footprints, integer");
    m_cells = Texture3D({.label = "cells of pieces", .size = size / side, .format = GL_R8UI});
    m_footprints.clear();
    m_cells.clear();
    m_entries = std::move(entries);
}

void PieceTextures::updateCells(Program& kernel, const PieceSource& source)
{
    const auto found = m_entries.find(source);
    if (found == m_entries.end())
        return;
    Entry& entry = found->second;
    const glm::ivec3 size = entry.box.maximum - entry.box.minimum;
    const glm::ivec3 count = cellsOf(size);
    const std::size_t cells = std::size_t(count.x) * std::size_t(count.y) * std::size_t(count.z);
    m_bytes.bindUnit(0);
    m_cells.bindImage(0, GL_WRITE_ONLY);
    kernel.set("firstTexel", entry.place).set("texelCount", size).set("cellCount", count);
    glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT);
    kernel.dispatch({unsigned(std::min((cells + 63) / 64, mostWorkGroups)), 1, 1});
    glMemoryBarrier(GL_ALL_BARRIER_BITS);
    std::vector<std::uint8_t> greatest(cells);
    m_cells.read(entry.place / side, count, std::as_writable_bytes(std::span(greatest)));
    entry.filled = {};
    entry.cells.clear();
    std::size_t from = 0;
    for (int z = 0; z < count.z; ++z) {
        for (int y = 0; y < count.y; ++y) {
            for (int x = 0; x < count.x; ++x) {
                if (greatest[from++] < 128)
                    continue;
                const glm::ivec3 low = entry.box.minimum + glm::ivec3(x, y, z) * side;
                entry.cells.push_back(low / side);
                entry.filled = entry.filled.united({low, glm::min(low + side, entry.box.maximum)});
            }
        }
    }
}

const PieceTextures::Entry* PieceTextures::entry(const PieceSource& source) const
{
    const auto found = m_entries.find(source);
    return found == m_entries.end() ? nullptr : &found->second;
}

std::size_t PieceTextures::bytes() const
{
    return m_footprints ? m_footprints.bytes() + m_cells.bytes() : 0;
}

} // namespace gpu
