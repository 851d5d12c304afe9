// SPDX-License-Identifier: Apache-2.0
#include "gpu/fields/textures/ShownLabels.h"

#include "core/document/Document.h"
#include "gpu/gl/Buffer.h"
#include "gpu/gl/Program.h"

#include <algorithm>

namespace gpu {

ShownLabels::ShownLabels(const core::BrickGrid& grid, const Texture3D& firstPlane)
    : m_grid(grid)
    , m_texture({.label = "shown labels", .size = grid.volumeSize, .format = GL_R8UI})
{
    firstPlane.copyTo(m_texture, {}, {}, grid.volumeSize);
}

void ShownLabels::update(Program& compose, std::span<const Texture3D* const> planes,
    const Looks& looks, std::span<const std::uint32_t> bricks)
{
    if (bricks.empty())
        return;
    Buffer list({.label = "bricks to compose", .bytes = bricks.size_bytes()});
    list.write(bricks);
    list.bindBase(GL_SHADER_STORAGE_BUFFER, 0);
    for (std::size_t unit = 0; unit < std::size_t(core::mostLabelPlanes); ++unit)
        planes[std::min(unit, planes.size() - 1)]->bindUnit(GLuint(unit));
    m_texture.bindImage(0, GL_WRITE_ONLY);
    compose.set("volumeSize", m_grid.volumeSize)
        .set("volumeBricks", m_grid.bricks())
        .set("brickCount", unsigned(bricks.size()))
        .set("planeCount", unsigned(planes.size()))
        .set("shown", looks.shown)
        .set("opaque", looks.shown & ~looks.translucent);
    glMemoryBarrier(GL_ALL_BARRIER_BITS);
    compose.dispatch({unsigned(std::min(bricks.size(), mostWorkGroups)), 1, 1});
    glMemoryBarrier(GL_ALL_BARRIER_BITS);
}

} // namespace gpu
