// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gpu/gl/Buffer.h"
#include "gpu/gl/Framebuffer.h"
#include "gpu/gl/Program.h"
#include "gpu/gl/Texture2D.h"
#include "gpu/gl/VertexArray.h"

namespace gpu {

/// What one view draws into: a sum of pictures, the picture to hand out, and its way home.
struct FrameTargets {
    glm::ivec2 size{0};
    Texture2D sum; ///< RGBA16F; a coarse picture uses its upper left corner
    Framebuffer sumFrame;
    Texture2D picture; ///< RGBA8
    Framebuffer pictureFrame;
    Buffer home; ///< size.x · size.y · 4 bytes, mapped

    /// Makes everything anew when the size differs.
    void resize(const glm::ivec2& newSize);
};

/// Brings the sum of pictures to bytes: divides by their number, or enlarges a coarse one.
class Resolve {
public:
    explicit Resolve(const ShaderLibrary& library);

    /// @param pictures how many lie on top of each other in the sum
    /// @param drawn size of the corner that was drawn; smaller than the frame: enlarged smoothly
    void draw(const FrameTargets& targets, int pictures, const glm::ivec2& drawn,
        const VertexArray& noVertices);

private:
    Program m_program;
};

} // namespace gpu
