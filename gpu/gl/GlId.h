// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gpu/gl/Gl.h"

#include <utility>

namespace gpu {

/// The name of one GL object, deleted with its owner. Move-only; 0 means none.
///
/// Destroy it on the engine thread, with the context current.
template <void (*deleteObject)(GLuint)> class GlId {
public:
    GlId() = default;
    explicit GlId(GLuint id)
        : m_id(id)
    {
    }
    GlId(GlId&& other) noexcept
        : m_id(std::exchange(other.m_id, 0))
    {
    }
    GlId& operator=(GlId&& other) noexcept
    {
        std::swap(m_id, other.m_id);
        return *this;
    }
    GlId(const GlId&) = delete;
    GlId& operator=(const GlId&) = delete;
    ~GlId()
    {
        if (m_id != 0)
            deleteObject(m_id);
    }

    [[nodiscard]] GLuint get() const { return m_id; }
    explicit operator bool() const { return m_id != 0; }

private:
    GLuint m_id = 0;
};

namespace glDelete {
void buffer(GLuint id);
void texture(GLuint id);
void framebuffer(GLuint id);
void vertexArray(GLuint id);
void program(GLuint id);
void shader(GLuint id);
void query(GLuint id);
} // namespace glDelete

/// Names an object for debug output and GL debuggers (KHR_debug). Null or empty: no name.
void labelObject(GLenum type, GLuint id, const char* label);

} // namespace gpu
