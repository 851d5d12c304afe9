// SPDX-License-Identifier: Apache-2.0
#include "gpu/fields/bricks/BarrierBricks.h"

#include "core/growth/SeedWord.h"
#include "gpu/fields/bricks/BrickField.h"
#include "gpu/fields/bricks/FieldPrograms.h"
#include "gpu/gl/Program.h"

#include <algorithm>
#include <iterator>
#include <vector>

namespace gpu {

BarrierBricks::BarrierBricks(FieldPrograms& programs, const core::BrickGrid& grid, WorkBy by)
    : m_programs(programs)
    , m_grid(grid)
    , m_byProcessor(isByProcessor(by))
{
}

void BarrierBricks::note(std::span<const std::uint32_t> bricks)
{
    m_stale.insert(bricks.begin(), bricks.end());
}

void BarrierBricks::noteAll(std::span<const std::uint32_t> bricks)
{
    note(bricks);
    m_stale.insert(m_held.begin(), m_held.end());
    if (m_texture) // what it says may be gone from what is held
        for (int brick = 0; brick < m_grid.brickCount(); ++brick)
            m_stale.insert(std::uint32_t(brick));
}

std::vector<std::uint32_t> BarrierBricks::found(
    BrickField& words, std::span<const std::uint32_t> bricks)
{
    if (bricks.empty())
        return {};
    if (!m_byProcessor)
        return foundByKernel(words, bricks);
    std::vector<std::uint32_t> held;
    std::vector<std::uint32_t> image(core::BrickGrid::voxelsPerBrick);
    for (const std::uint32_t brick : bricks) {
        words.read(brick, std::as_writable_bytes(std::span(image)));
        if (std::find(image.begin(), image.end(), core::seedWord::barrier) != image.end())
            held.push_back(brick);
    }
    return held;
}

std::vector<std::uint32_t> BarrierBricks::foundByKernel(
    BrickField& words, std::span<const std::uint32_t> bricks)
{
    const Buffer list = bufferOf("bricks that may hold barriers", bricks);
    Buffer flags({.label = "bricks that hold barriers", .bytes = bricks.size_bytes()});
    flags.fill(0);
    list.bindBase(GL_SHADER_STORAGE_BUFFER, 0);
    flags.bindBase(GL_SHADER_STORAGE_BUFFER, 1);
    words.atlas().bindUnit(0);
    words.pageTable().bindUnit(1);
    Program& kernel = m_programs.findBarriers();
    kernel.set("volumeBricks", m_grid.bricks()).set("brickCount", unsigned(bricks.size()));
    glMemoryBarrier(GL_ALL_BARRIER_BITS);
    kernel.dispatch({unsigned(std::min(bricks.size(), mostWorkGroups)), 1, 1});
    glMemoryBarrier(GL_ALL_BARRIER_BITS);
    std::vector<std::uint32_t> isHeld(bricks.size());
    flags.read(std::span<std::uint32_t>(isHeld));
    std::vector<std::uint32_t> held;
    for (std::size_t i = 0; i < bricks.size(); ++i) {
        if (isHeld[i] != 0)
            held.push_back(bricks[i]);
    }
    return held;
}

std::vector<std::uint32_t> BarrierBricks::bricks(BrickField& words)
{
    std::vector<std::uint32_t> looked;
    for (const std::uint32_t brick : m_stale) {
        if (words.holds(brick))
            looked.push_back(brick);
    }
    std::vector<std::uint32_t> all = found(words, looked);
    std::set_difference(
        m_held.begin(), m_held.end(), m_stale.begin(), m_stale.end(), std::back_inserter(all));
    std::sort(all.begin(), all.end());
    return all;
}

core::VoxelBox BarrierBricks::update(BrickField& words)
{
    std::vector<std::uint32_t> looked;
    core::VoxelBox changed;
    for (const std::uint32_t brick : m_stale) {
        if (words.holds(brick))
            looked.push_back(brick);
        if (m_held.erase(brick) > 0)
            changed = changed.united(m_grid.boxOf(int(brick)));
    }
    m_stale.clear();
    for (const std::uint32_t brick : found(words, looked)) {
        m_held.insert(brick);
        changed = changed.united(m_grid.boxOf(int(brick)));
    }
    if (changed.empty())
        return changed;
    m_box = {};
    std::vector<std::uint8_t> texels(std::size_t(m_grid.brickCount()), 0);
    for (const std::uint32_t brick : m_held) {
        m_box = m_box.united(m_grid.boxOf(int(brick)));
        texels[brick] = 1;
    }
    if (!m_texture)
        m_texture = Texture3D(
            {.label = "bricks with barriers", .size = m_grid.bricks(), .format = GL_R8UI});
    m_texture.upload(std::span<const std::uint8_t>(texels));
    return changed;
}

} // namespace gpu
