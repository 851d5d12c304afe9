// SPDX-License-Identifier: Apache-2.0
#include "gpu/fields/bricks/BarrierBricks.h"

#include "gpu/fields/bricks/BrickField.h"
#include "gpu/fields/bricks/FieldPrograms.h"
#include "gpu/gl/Program.h"

#include <algorithm>
#include <vector>

namespace gpu {

namespace {

} // namespace

BarrierBricks::BarrierBricks(FieldPrograms& programs, const core::BrickGrid& grid)
    : m_programs(programs)
    , m_grid(grid)
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
    if (!looked.empty()) {
        const std::size_t bytes = looked.size() * sizeof(std::uint32_t);
        Buffer list({.label = "bricks that may hold barriers", .bytes = bytes});
        Buffer found({.label = "bricks that hold barriers", .bytes = bytes});
        list.write(std::span<const std::uint32_t>(looked));
        found.fill(0);
        list.bindBase(GL_SHADER_STORAGE_BUFFER, 0);
        found.bindBase(GL_SHADER_STORAGE_BUFFER, 1);
        words.atlas().bindUnit(0);
        words.pageTable().bindUnit(1);
        Program& kernel = m_programs.findBarriers();
        kernel.set("volumeBricks", m_grid.bricks()).set("brickCount", unsigned(looked.size()));
        glMemoryBarrier(GL_ALL_BARRIER_BITS);
        kernel.dispatch({unsigned(std::min(looked.size(), mostWorkGroups)), 1, 1});
        glMemoryBarrier(GL_ALL_BARRIER_BITS);
        std::vector<std::uint32_t> flags(looked.size());
        found.read(std::span<std::uint32_t>(flags));
        for (std::size_t i = 0; i < looked.size(); ++i) {
            if (flags[i] == 0)
                continue;
            m_held.insert(looked[i]);
            changed = changed.united(m_grid.boxOf(int(looked[i])));
        }
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
