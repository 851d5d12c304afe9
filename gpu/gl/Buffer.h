// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gpu/gl/GlId.h"

#include <algorithm>
#include <cstddef>
#include <span>
#include <type_traits>

namespace gpu {

/// How the processor accesses a buffer after its creation.
enum class BufferUse {
    Dynamic, ///< write() and read() by copy
    MappedRead, ///< readback: stays mapped, read mapped() after a Fence has passed
    MappedWrite, ///< streaming: stays mapped, written through mapped()
};

struct BufferOptions {
    const char* label = "";
    std::size_t bytes = 0;
    BufferUse use = BufferUse::Dynamic;
};

/// Immutable GPU memory (DSA). Contents are undefined until written or cleared.
class Buffer {
public:
    Buffer() = default; ///< none
    explicit Buffer(const BufferOptions& options); ///< throws GlFailure where it is refused

    [[nodiscard]] GLuint id() const { return m_id.get(); }
    [[nodiscard]] std::size_t bytes() const { return m_bytes; }
    explicit operator bool() const { return bool(m_id); }

    void writeBytes(std::size_t offset, std::span<const std::byte> data);
    /// Waits if the GPU is still writing the buffer.
    void readBytes(std::size_t offset, std::span<std::byte> data) const;

    template <class T> void write(std::span<const T> values, std::size_t offset = 0)
    {
        static_assert(std::is_trivially_copyable_v<T>);
        writeBytes(offset, std::as_bytes(values));
    }
    template <class T> void read(std::span<T> values, std::size_t offset = 0) const
    {
        static_assert(std::is_trivially_copyable_v<T>);
        readBytes(offset, std::as_writable_bytes(values));
    }
    /// Fills with one 32-bit word. Offset and bytes are multiples of four; bytes 0 means to the
    /// end.
    void fill(GLuint word, std::size_t offset = 0, std::size_t bytes = 0);
    void copyTo(Buffer& target, std::size_t bytes, std::size_t from = 0, std::size_t to = 0) const;

    /// @param target GL_SHADER_STORAGE_BUFFER, GL_UNIFORM_BUFFER or GL_ATOMIC_COUNTER_BUFFER
    void bindBase(GLenum target, GLuint binding) const;
    void bindRange(GLenum target, GLuint binding, std::size_t offset, std::size_t bytes) const;

    /// Coherent memory of a buffer for MappedRead or MappedWrite; null for others.
    [[nodiscard]] std::byte* mapped() const { return m_mapped; }

private:
    GlId<glDelete::buffer> m_id;
    std::size_t m_bytes = 0;
    std::byte* m_mapped = nullptr;
};

/// A buffer that holds these values. One of none has room for a few bytes, since GL refuses less.
template <class List> [[nodiscard]] Buffer bufferOf(const char* label, const List& list)
{
    const std::span values(list);
    Buffer buffer({.label = label, .bytes = std::max<std::size_t>(values.size_bytes(), 16)});
    buffer.write(values);
    return buffer;
}

} // namespace gpu
