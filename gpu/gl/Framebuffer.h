// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gpu/gl/GlId.h"
#include "gpu/gl/Texture2D.h"

#include <initializer_list>

namespace gpu {

struct FramebufferOptions {
    const char* label = "";
    /// Draw buffer 0, 1, …; they must outlive the framebuffer.
    std::initializer_list<const Texture2D*> colours;
    /// Null if no depth test is needed; must outlive the framebuffer.
    const Texture2D* depth = nullptr;
};

/// A render target. It has a depth buffer only on request, since most passes draw one full-screen
/// triangle.
class Framebuffer {
public:
    Framebuffer() = default;
    explicit Framebuffer(const FramebufferOptions& options);

    [[nodiscard]] GLuint id() const { return m_id.get(); }
    /// Makes it the target of drawing, with a viewport of its full size.
    void bind() const;
    /// Sets all colours to 0 and the depth to the farthest value.
    void clear() const;
    /// Queues a copy of colour 0 into a buffer, tightly packed, rows bottom up; does not wait.
    void readInto(GLuint packBuffer, std::size_t offset = 0) const;

private:
    GlId<glDelete::framebuffer> m_id;
    glm::ivec2 m_size{0};
    TexelLayout m_layout;
    int m_colours = 0;
    bool m_hasDepth = false;
};

} // namespace gpu
