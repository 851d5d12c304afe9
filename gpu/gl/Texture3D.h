// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gpu/gl/GlId.h"
#include "gpu/gl/TextureFormat.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <span>

namespace gpu {

struct Texture3DOptions {
    const char* label = "";
    glm::ivec3 size{1};
    GLenum format = GL_R8; ///< one that texelLayout() knows
    /// Filter; integer formats are always nearest, else they would be incomplete.
    bool linear = false;
};

/// Immutable 3D texture (DSA), one level, clamped to its edge. Contents start undefined.
class Texture3D {
public:
    Texture3D() = default;
    explicit Texture3D(const Texture3DOptions& options); ///< throws GlFailure where it is refused

    /// The same storage read as another format of the same texel size (R16 ↔ R16UI).
    [[nodiscard]] Texture3D view(GLenum format, const char* label) const;

    [[nodiscard]] GLuint id() const { return m_id.get(); }
    [[nodiscard]] glm::ivec3 size() const { return m_size; }
    [[nodiscard]] GLenum format() const { return m_format; }
    [[nodiscard]] std::size_t bytes() const;
    explicit operator bool() const { return bool(m_id); }

    /// Texels are ordered x fastest, then y, then z, and tightly packed. What the texture holds
    /// belongs to the GPU, as with bindImage().
    void upload(
        const glm::ivec3& offset, const glm::ivec3& size, std::span<const std::byte> texels) const;
    template <class T> void upload(std::span<const T> texels) const
    {
        upload(glm::ivec3(0), m_size, std::as_bytes(texels));
    }
    /// Fills with one texel in the layout of texelLayout(); null sets all bits to zero.
    void clear(const void* texel = nullptr);
    void clear(const glm::ivec3& offset, const glm::ivec3& size, const void* texel = nullptr);
    /// Waits for the GPU.
    void read(const glm::ivec3& offset, const glm::ivec3& size, std::span<std::byte> texels) const;
    void copyTo(Texture3D& target, const glm::ivec3& from, const glm::ivec3& to,
        const glm::ivec3& size) const;

    void bindUnit(GLuint unit) const;
    /// Binds all layers, in the texture's own format.
    void bindImage(GLuint unit, GLenum access) const;

private:
    void setSampling(bool linear);

    GlId<glDelete::texture> m_id;
    glm::ivec3 m_size{0};
    GLenum m_format = GL_R8;
};

} // namespace gpu
