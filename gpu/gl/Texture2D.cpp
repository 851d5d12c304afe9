// SPDX-License-Identifier: Apache-2.0
#include "gpu/gl/Texture2D.h"

#include "gpu/gl/GlFailure.h"

#include <QtGlobal>

namespace gpu {

Texture2D::Texture2D(const Texture2DOptions& options)
    : m_size(options.size)
    , m_format(options.format)
{
    GLuint id = 0;
    glCreateTextures(GL_TEXTURE_2D, 1, &id);
    m_id = GlId<glDelete::texture>(id);
    labelObject(GL_TEXTURE, id, options.label);
    glTextureStorage2D(id, 1, m_format, m_size.x, m_size.y);
    requireStorage(options.label,
        std::size_t(m_size.x) * std::size_t(m_size.y) * texelLayout(m_format).bytes);
    const GLint filter = options.linear && !isIntegerFormat(m_format) ? GL_LINEAR : GL_NEAREST;
    glTextureParameteri(id, GL_TEXTURE_MIN_FILTER, filter);
    glTextureParameteri(id, GL_TEXTURE_MAG_FILTER, filter);
    glTextureParameteri(id, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTextureParameteri(id, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
}

void Texture2D::upload(glm::ivec2 offset, glm::ivec2 size, std::span<const std::byte> texels)
{
    const TexelLayout layout = texelLayout(m_format);
    Q_ASSERT(texels.size() >= std::size_t(size.x) * std::size_t(size.y) * layout.bytes);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTextureSubImage2D(
        id(), 0, offset.x, offset.y, size.x, size.y, layout.format, layout.type, texels.data());
}

void Texture2D::clear()
{
    const TexelLayout layout = texelLayout(m_format);
    glClearTexImage(id(), 0, layout.format, layout.type, nullptr);
}

void Texture2D::read(std::span<std::byte> texels) const
{
    const TexelLayout layout = texelLayout(m_format);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glGetTextureImage(id(), 0, layout.format, layout.type, GLsizei(texels.size()), texels.data());
}

void Texture2D::bindUnit(GLuint unit) const
{
    glBindTextureUnit(unit, id());
}

void Texture2D::bindImage(GLuint unit, GLenum access) const
{
    glBindImageTexture(unit, id(), 0, GL_FALSE, 0, access, m_format);
}

} // namespace gpu
