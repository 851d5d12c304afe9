// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gpu/gl/GlId.h"
#include "gpu/gl/TextureFormat.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <span>

namespace gpu {

struct Texture2DOptions {
    const char* label = "";
    glm::ivec2 size{1};
    GLenum format = GL_RGBA8; ///< one that texelLayout() knows
    bool linear = false; ///< filter; integer formats are always nearest
};

/// Immutable 2D texture (DSA), one level, clamped to its edge. Contents start undefined.
class Texture2D {
public:
    Texture2D() = default;
    explicit Texture2D(const Texture2DOptions& options); ///< throws GlFailure where it is refused

    [[nodiscard]] GLuint id() const { return m_id.get(); }
    [[nodiscard]] glm::ivec2 size() const { return m_size; }
    [[nodiscard]] GLenum format() const { return m_format; }
    explicit operator bool() const { return bool(m_id); }

    /// Rows are bottom up, as GL stores them, and tightly packed.
    void upload(glm::ivec2 offset, glm::ivec2 size, std::span<const std::byte> texels);
    template <class T> void upload(std::span<const T> texels)
    {
        upload(glm::ivec2(0), m_size, std::as_bytes(texels));
    }
    void clear(); ///< all bits zero
    void read(std::span<std::byte> texels) const; ///< reads all texels; waits for the GPU

    void bindUnit(GLuint unit) const;
    void bindImage(GLuint unit, GLenum access) const;

private:
    GlId<glDelete::texture> m_id;
    glm::ivec2 m_size{0};
    GLenum m_format = GL_RGBA8;
};

} // namespace gpu
