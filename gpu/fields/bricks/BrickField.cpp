// SPDX-License-Identifier: Apache-2.0
#include "gpu/fields/bricks/BrickField.h"

#include <algorithm>

namespace gpu {

namespace {

// The layout of the atlas; pageTexel() in bricks.glsl.
constexpr glm::ivec3 pageSize(2048, 2, 1);
constexpr std::uint32_t pagesPerSlice = 1024;

constexpr std::uint32_t firstPages = 4096;

glm::ivec3 pageOrigin(std::uint32_t page)
{
    return glm::ivec3(0, page % pagesPerSlice, page / pagesPerSlice) * pageSize;
}

} // namespace

BrickField::BrickField(const BrickFieldOptions& options)
    : m_options(options)
    , m_pageTable({.label = options.label, .size = options.grid.bricks(), .format = GL_R32UI})
    , m_entries(std::size_t(options.grid.brickCount()), 0)
{
}

void BrickField::reserve()
{
    if (m_pageCount == 0)
        enlarge(std::min(std::uint32_t(m_entries.size()), firstPages));
}

void BrickField::enlarge(std::uint32_t pages)
{
    // One slice is as high as it must be; more than one are whole.
    const std::uint32_t slices = (pages + pagesPerSlice - 1) / pagesPerSlice;
    const std::uint32_t rows = slices > 1 ? pagesPerSlice : pages;
    Texture3D larger({.label = m_options.label,
        .size = pageSize * glm::ivec3(1, int(rows), int(slices)),
        .format = m_options.format});
    const std::uint32_t count = slices * rows;
    // Where memory is refused it is refused here, and everything is as it was.
    m_freePages.reserve(count);
    m_owners.reserve(count);
    m_ownerPositions.reserve(count);
    Buffer owners({.label = m_options.label, .bytes = count * sizeof(std::uint32_t)});
    if (m_atlas)
        m_atlas.copyTo(larger, glm::ivec3(0), glm::ivec3(0), m_atlas.size());
    m_atlas = std::move(larger);
    m_ownerBuffer = std::move(owners);
    for (std::uint32_t page = count; page > m_pageCount; --page)
        m_freePages.push_back(page - 1);
    m_pageCount = count;
    m_owners.resize(count, 0);
    m_ownerPositions.resize(count, 0);
    m_ownersStale = true;
}

void BrickField::ensure(std::span<const std::uint32_t> bricks, NewPages pages)
{
    // Memory first: where it is refused no brick has a page that nobody has cleared.
    const auto wanted = std::size_t(std::count_if(bricks.begin(), bricks.end(),
        [this](std::uint32_t brick) { return m_entries[brick] == 0; }));
    std::vector<std::uint32_t> fresh;
    fresh.reserve(wanted);
    if (wanted > 0)
        reserve();
    std::uint32_t enough = m_pageCount;
    while (m_freePages.size() + (enough - m_pageCount) < wanted && enough < m_entries.size())
        enough = std::min(std::uint32_t(m_entries.size()), 2 * enough);
    if (enough > m_pageCount)
        enlarge(enough);
    for (const std::uint32_t brick : bricks) {
        if (m_entries[brick] != 0)
            continue;
        const std::uint32_t page = m_freePages.back();
        m_freePages.pop_back();
        fresh.push_back(page);
        m_entries[brick] = page + 1;
        const glm::uvec3 owner(m_options.grid.brickPosition(int(brick)));
        m_owners[page] = brick;
        m_ownerPositions[page] = owner.x | owner.y << 10 | owner.z << 20;
        m_tableStale = true;
        m_ownersStale = true;
    }
    if (pages == NewPages::Empty)
        clear(std::move(fresh));
}

void BrickField::clear(std::vector<std::uint32_t> pages)
{
    std::sort(pages.begin(), pages.end());
    for (std::size_t first = 0; first < pages.size();) {
        // Pages that follow each other in one slice are one block of rows.
        std::size_t last = first + 1;
        while (last < pages.size() && pages[last] == pages[last - 1] + 1
            && pages[last] % pagesPerSlice != 0)
            ++last;
        m_atlas.clear(pageOrigin(pages[first]), pageSize * glm::ivec3(1, int(last - first), 1),
            &m_options.emptyVoxel);
        first = last;
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

void BrickField::read(std::uint32_t brick, std::span<std::byte> voxels) const
{
    m_atlas.read(pageOrigin(pageOf(brick)), pageSize, voxels);
}

void BrickField::write(std::uint32_t brick, std::span<const std::byte> voxels) const
{
    m_atlas.upload(pageOrigin(pageOf(brick)), pageSize, voxels);
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

const Buffer& BrickField::pageOwners()
{
    if (m_ownersStale)
        m_ownerBuffer.write(std::span<const std::uint32_t>(m_ownerPositions));
    m_ownersStale = false;
    return m_ownerBuffer;
}

std::size_t BrickField::bytes() const
{
    return m_atlas ? m_atlas.bytes() : 0;
}

} // namespace gpu
