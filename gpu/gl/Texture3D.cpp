// SPDX-License-Identifier: Apache-2.0
#include "gpu/gl/Texture3D.h"

#include "gpu/gl/GlFailure.h"

#include <QtGlobal>

namespace gpu {

Texture3D::Texture3D(const Texture3DOptions& options)
    : m_size(options.size)
    , m_format(options.format)
{
    GLuint id = 0;
    glCreateTextures(GL_TEXTURE_3D, 1, &id);
    m_id = GlId<glDelete::texture>(id);
    labelObject(GL_TEXTURE, id, options.label);
    glTextureStorage3D(id, 1, m_format, m_size.x, m_size.y, m_size.z);
    requireStorage(options.label, bytes());
    setSampling(options.linear);
}

Texture3D Texture3D::view(GLenum format, const char* label) const
{
    Q_ASSERT(texelLayout(format).bytes == texelLayout(m_format).bytes);
    // glTextureView wants a name without a target: glCreateTextures would give it one.
    GLuint id = 0;
    glGenTextures(1, &id);
    Texture3D result;
    result.m_id = GlId<glDelete::texture>(id);
    result.m_size = m_size;
    result.m_format = format;
    glTextureView(id, GL_TEXTURE_3D, m_id.get(), format, 0, 1, 0, 1);
    requireStorage(label, 0);
    labelObject(GL_TEXTURE, id, label);
    result.setSampling(false);
    return result;
}

void Texture3D::setSampling(bool linear)
{
    const GLint filter = linear && !isIntegerFormat(m_format) ? GL_LINEAR : GL_NEAREST;
    glTextureParameteri(id(), GL_TEXTURE_MIN_FILTER, filter);
    glTextureParameteri(id(), GL_TEXTURE_MAG_FILTER, filter);
    for (const GLenum axis : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R})
        glTextureParameteri(id(), axis, GL_CLAMP_TO_EDGE);
}

std::size_t Texture3D::bytes() const
{
    return std::size_t(m_size.x) * std::size_t(m_size.y) * std::size_t(m_size.z)
        * texelLayout(m_format).bytes;
}

void Texture3D::upload(
    const glm::ivec3& offset, const glm::ivec3& size, std::span<const std::byte> texels) const
{
    const TexelLayout layout = texelLayout(m_format);
    Q_ASSERT(texels.size()
        >= std::size_t(size.x) * std::size_t(size.y) * std::size_t(size.z) * layout.bytes);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTextureSubImage3D(id(), 0, offset.x, offset.y, offset.z, size.x, size.y, size.z,
        layout.format, layout.type, texels.data());
}

void Texture3D::clear(const void* texel)
{
    const TexelLayout layout = texelLayout(m_format);
    glClearTexImage(id(), 0, layout.format, layout.type, texel);
}

void Texture3D::clear(const glm::ivec3& offset, const glm::ivec3& size, const void* texel)
{
    const TexelLayout layout = texelLayout(m_format);
    glClearTexSubImage(id(), 0, offset.x, offset.y, offset.z, size.x, size.y, size.z, layout.format,
        layout.type, texel);
}

void Texture3D::read(
    const glm::ivec3& offset, const glm::ivec3& size, std::span<std::byte> texels) const
{
    const TexelLayout layout = texelLayout(m_format);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glGetTextureSubImage(id(), 0, offset.x, offset.y, offset.z, size.x, size.y, size.z,
        layout.format, layout.type, GLsizei(texels.size()), texels.data());
}

void Texture3D::copyTo(
    Texture3D& target, const glm::ivec3& from, const glm::ivec3& to, const glm::ivec3& size) const
{
    glCopyImageSubData(id(), GL_TEXTURE_3D, 0, from.x, from.y, from.z, target.id(), GL_TEXTURE_3D,
        0, to.x, to.y, to.z, size.x, size.y, size.z);
}

void Texture3D::bindUnit(GLuint unit) const
{
    glBindTextureUnit(unit, id());
}

void Texture3D::bindImage(GLuint unit, GLenum access) const
{
    glBindImageTexture(unit, id(), 0, GL_TRUE, 0, access, m_format);
}

} // namespace gpu
