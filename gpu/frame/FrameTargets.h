// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gpu/gl/Buffer.h"
#include "gpu/gl/Framebuffer.h"
#include "gpu/gl/Program.h"
#include "gpu/gl/Texture2D.h"
#include "gpu/gl/VertexArray.h"

namespace gpu {

/// The textures and buffers that one view draws into: the sum of several pictures, the picture to
/// hand out, and the buffer through which it is read back.
struct FrameTargets {
    glm::ivec2 size{0};
    Texture2D sum; ///< RGBA16F; a coarse picture uses its upper left corner
    Framebuffer sumFrame;
    Texture2D picture; ///< RGBA8
    Framebuffer pictureFrame;
    Buffer home; ///< size.x · size.y · 4 bytes, mapped

    /// Allocates everything again if the size differs.
    void resize(const glm::ivec2& newSize);
};

/// Converts the sum of pictures to bytes: divides it by their number, or enlarges a coarse picture.
class Resolve {
public:
    explicit Resolve(const ShaderLibrary& library);

    /// @param pictures how many pictures were added up
    /// @param drawn size of the corner that was drawn; if it is smaller than the frame it is
    /// enlarged smoothly
    void draw(const FrameTargets& targets, int pictures, const glm::ivec2& drawn,
        const VertexArray& noVertices);

private:
    Program m_whole; ///< of pictures in which each pixel was drawn
    Program m_coarse;
};

} // namespace gpu
