// SPDX-License-Identifier: Apache-2.0
#include "gpu/gl/Buffer.h"

#include "gpu/gl/GlFailure.h"

namespace gpu {

namespace {

GLbitfield storageFlags(BufferUse use)
{
    switch (use) {
    case BufferUse::Dynamic:
        return GL_DYNAMIC_STORAGE_BIT;
    case BufferUse::MappedRead:
        return GL_MAP_READ_BIT | GL_MAP_PERSISTENT_BIT | GL_MAP_COHERENT_BIT;
    case BufferUse::MappedWrite:
        return GL_MAP_WRITE_BIT | GL_MAP_PERSISTENT_BIT | GL_MAP_COHERENT_BIT;
    }
    return 0;
}

} // namespace

Buffer::Buffer(const BufferOptions& options)
    : m_bytes(options.bytes)
{
    GLuint id = 0;
    glCreateBuffers(1, &id);
    m_id = GlId<glDelete::buffer>(id);
    labelObject(GL_BUFFER, id, options.label);
    const GLbitfield flags = storageFlags(options.use);
    glNamedBufferStorage(id, GLsizeiptr(m_bytes), nullptr, flags);
    if (options.use != BufferUse::Dynamic) {
        m_mapped =
            static_cast<std::byte*>(glMapNamedBufferRange(id, 0, GLsizeiptr(m_bytes), flags));
    }
    requireStorage(options.label, m_bytes);
}

void Buffer::writeBytes(std::size_t offset, std::span<const std::byte> data)
{
    if (!data.empty())
        glNamedBufferSubData(id(), GLintptr(offset), GLsizeiptr(data.size()), data.data());
}

void Buffer::readBytes(std::size_t offset, std::span<std::byte> data) const
{
    if (!data.empty())
        glGetNamedBufferSubData(id(), GLintptr(offset), GLsizeiptr(data.size()), data.data());
}

void Buffer::fill(GLuint word, std::size_t offset, std::size_t bytes)
{
    glClearNamedBufferSubData(id(), GL_R32UI, GLintptr(offset),
        GLsizeiptr(bytes == 0 ? m_bytes - offset : bytes), GL_RED_INTEGER, GL_UNSIGNED_INT, &word);
}

void Buffer::copyTo(Buffer& target, std::size_t bytes, std::size_t from, std::size_t to) const
{
    if (bytes > 0)
        glCopyNamedBufferSubData(
            id(), target.id(), GLintptr(from), GLintptr(to), GLsizeiptr(bytes));
}

void Buffer::bindBase(GLenum target, GLuint binding) const
{
    glBindBufferBase(target, binding, id());
}

void Buffer::bindRange(GLenum target, GLuint binding, std::size_t offset, std::size_t bytes) const
{
    glBindBufferRange(target, binding, id(), GLintptr(offset), GLsizeiptr(bytes));
}

} // namespace gpu
