// SPDX-License-Identifier: Apache-2.0
#include "gpu/edit/BrickField.h"

#include <algorithm>

namespace gpu {

namespace {

constexpr int pagesAcross = 32;
constexpr std::uint32_t pagesPerSlab = pagesAcross * pagesAcross;

glm::ivec3 pageOrigin(std::uint32_t page)
{
    return glm::ivec3(page % pagesAcross, page / pagesAcross % pagesAcross, page / pagesPerSlab)
        * core::BrickGrid::side;
}

} // namespace

BrickField::BrickField(const BrickFieldOptions& options)
    : m_options(options)
    , m_pageTable({.label = options.label, .size = options.grid.bricks(), .format = GL_R32UI})
    , m_entries(std::size_t(options.grid.brickCount()), 0)
{
}

void BrickField::enlarge()
{
    const int slabs = std::max(1, int(m_pageCount / pagesPerSlab) * 2);
    const int side = core::BrickGrid::side;
    Texture3D larger({.label = m_options.label,
        .size = {pagesAcross * side, pagesAcross * side, slabs * side},
        .format = m_options.format});
    if (m_atlas)
        m_atlas.copyTo(larger, glm::ivec3(0), glm::ivec3(0), m_atlas.size());
    m_atlas = std::move(larger);
    const std::uint32_t count = std::uint32_t(slabs) * pagesPerSlab;
    for (std::uint32_t page = count; page > m_pageCount; --page)
        m_freePages.push_back(page - 1);
    m_pageCount = count;
}

void BrickField::ensure(std::span<const std::uint32_t> bricks)
{
    for (const std::uint32_t brick : bricks) {
        if (m_entries[brick] != 0)
            continue;
        if (m_freePages.empty())
            enlarge();
        const std::uint32_t page = m_freePages.back();
        m_freePages.pop_back();
        m_atlas.clear(pageOrigin(page), glm::ivec3(core::BrickGrid::side), &m_options.emptyVoxel);
        m_entries[brick] = page + 1;
        m_tableStale = true;
    }
}

void BrickField::release(std::span<const std::uint32_t> bricks)
{
    for (const std::uint32_t brick : bricks) {
        if (m_entries[brick] == 0)
            continue;
        m_freePages.push_back(m_entries[brick] - 1);
        m_entries[brick] = 0;
        m_tableStale = true;
    }
}

std::vector<std::uint32_t> BrickField::heldBricks() const
{
    std::vector<std::uint32_t> held;
    for (std::uint32_t brick = 0; brick < m_entries.size(); ++brick) {
        if (m_entries[brick] != 0)
            held.push_back(brick);
    }
    return held;
}

const Texture3D& BrickField::pageTable()
{
    if (m_tableStale)
        m_pageTable.upload(std::span<const std::uint32_t>(m_entries));
    m_tableStale = false;
    return m_pageTable;
}

std::size_t BrickField::bytes() const
{
    return m_atlas ? m_atlas.bytes() : 0;
}

} // namespace gpu
