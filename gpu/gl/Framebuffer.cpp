// SPDX-License-Identifier: Apache-2.0
#include "gpu/gl/Framebuffer.h"

#include <array>
#include <vector>

namespace gpu {

Framebuffer::Framebuffer(const FramebufferOptions& options)
{
    GLuint id = 0;
    glCreateFramebuffers(1, &id);
    m_id = GlId<glDelete::framebuffer>(id);
    labelObject(GL_FRAMEBUFFER, id, options.label);
    std::vector<GLenum> drawBuffers;
    for (const Texture2D* texture : options.colours) {
        const GLenum attachment = GL_COLOR_ATTACHMENT0 + GLenum(drawBuffers.size());
        if (drawBuffers.empty()) {
            m_size = texture->size();
            m_layout = texelLayout(texture->format());
        }
        glNamedFramebufferTexture(id, attachment, texture->id(), 0);
        drawBuffers.push_back(attachment);
    }
    m_colours = int(drawBuffers.size());
    m_hasDepth = options.depth != nullptr;
    if (m_hasDepth)
        glNamedFramebufferTexture(id, GL_DEPTH_ATTACHMENT, options.depth->id(), 0);
    glNamedFramebufferDrawBuffers(id, GLsizei(drawBuffers.size()), drawBuffers.data());
    glNamedFramebufferReadBuffer(id, GL_COLOR_ATTACHMENT0);
}

void Framebuffer::bind() const
{
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, id());
    glViewport(0, 0, m_size.x, m_size.y);
}

void Framebuffer::clear() const
{
    constexpr std::array<float, 4> none{};
    for (int i = 0; i < m_colours; ++i)
        glClearNamedFramebufferfv(id(), GL_COLOR, i, none.data());
    constexpr float farthest = 1.0f;
    if (m_hasDepth)
        glClearNamedFramebufferfv(id(), GL_DEPTH, 0, &farthest);
}

void Framebuffer::readInto(GLuint packBuffer, std::size_t offset) const
{
    glBindFramebuffer(GL_READ_FRAMEBUFFER, id());
    glBindBuffer(GL_PIXEL_PACK_BUFFER, packBuffer);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, m_size.x, m_size.y, m_layout.format, m_layout.type,
        reinterpret_cast<void*>(offset)); // NOLINT: GL's way to say an offset
    glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
}

} // namespace gpu
