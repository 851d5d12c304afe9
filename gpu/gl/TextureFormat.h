// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gpu/gl/Gl.h"

#include <cstddef>

namespace gpu {

/// How texels are laid out in the processor's memory: one layout per internal format, so that
/// uploads and readbacks need not name a format.
struct TexelLayout {
    GLenum format = GL_RED;
    GLenum type = GL_UNSIGNED_BYTE;
    std::size_t bytes = 1; ///< per texel
};

/// Supports R8, R8UI, R16, R16UI, R32UI, R32F, RG8, RG8UI, RG16, RG16UI, RG32F, RGBA8, RGBA16F,
/// RGBA32F and DEPTH_COMPONENT32F.
[[nodiscard]] TexelLayout texelLayout(GLenum internalFormat);
[[nodiscard]] bool isIntegerFormat(GLenum internalFormat);

} // namespace gpu
