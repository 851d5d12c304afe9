// SPDX-License-Identifier: Apache-2.0
#include "gpu/frame/FrameTargets.h"

namespace gpu {

void FrameTargets::resize(const glm::ivec2& newSize)
{
    if (size == newSize)
        return;
    size = newSize;
    sum = Texture2D({.label = "sum", .size = size, .format = GL_RGBA16F, .linear = true});
    sumFrame = Framebuffer({.label = "sum", .colours = {&sum}});
    picture = Texture2D({.label = "picture", .size = size, .format = GL_RGBA8});
    pictureFrame = Framebuffer({.label = "picture", .colours = {&picture}});
    home = Buffer({.label = "picture on its way",
        .bytes = std::size_t(size.x) * std::size_t(size.y) * 4,
        .use = BufferUse::MappedRead});
}

Resolve::Resolve(const ShaderLibrary& library)
    : m_whole(library,
        {.label = "resolve", .fragmentPath = "frame/resolve.frag", .defines = {{"ENLARGED", 0}}})
    , m_coarse(library,
          {.label = "resolve", .fragmentPath = "frame/resolve.frag", .defines = {{"ENLARGED", 1}}})
{
}

void Resolve::draw(const FrameTargets& targets, int pictures, const glm::ivec2& drawn,
    const VertexArray& noVertices)
{
    glDisable(GL_BLEND);
    glDisable(GL_SCISSOR_TEST);
    targets.pictureFrame.bind();
    targets.sum.bindUnit(0);
    Program& program = drawn == targets.size ? m_whole : m_coarse;
    program.set("scale", 1.0f / float(pictures));
    if (drawn != targets.size)
        program.set("drawnPerFrame", glm::vec2(drawn) / glm::vec2(targets.size))
            .set("drawn", glm::vec2(drawn));
    program.use();
    noVertices.drawFullScreenTriangle();
}

} // namespace gpu
