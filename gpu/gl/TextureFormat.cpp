// SPDX-License-Identifier: Apache-2.0
#include "gpu/gl/TextureFormat.h"

#include <QtGlobal>

namespace gpu {

TexelLayout texelLayout(GLenum internalFormat)
{
    switch (internalFormat) {
    case GL_R8:
        return {GL_RED, GL_UNSIGNED_BYTE, 1};
    case GL_R8UI:
        return {GL_RED_INTEGER, GL_UNSIGNED_BYTE, 1};
    case GL_R16:
        return {GL_RED, GL_UNSIGNED_SHORT, 2};
    case GL_R16UI:
        return {GL_RED_INTEGER, GL_UNSIGNED_SHORT, 2};
    case GL_R32UI:
        return {GL_RED_INTEGER, GL_UNSIGNED_INT, 4};
    case GL_R32F:
        return {GL_RED, GL_FLOAT, 4};
    case GL_RG8:
        return {GL_RG, GL_UNSIGNED_BYTE, 2};
    case GL_RG8UI:
        return {GL_RG_INTEGER, GL_UNSIGNED_BYTE, 2};
    case GL_RG16:
        return {GL_RG, GL_UNSIGNED_SHORT, 4};
    case GL_RG16UI:
        return {GL_RG_INTEGER, GL_UNSIGNED_SHORT, 4};
    case GL_RG32F:
        return {GL_RG, GL_FLOAT, 8};
    case GL_RGBA8:
        return {GL_RGBA, GL_UNSIGNED_BYTE, 4};
    case GL_RGBA16UI:
        return {GL_RGBA_INTEGER, GL_UNSIGNED_SHORT, 8};
    case GL_RGBA16F:
        return {GL_RGBA, GL_HALF_FLOAT, 8};
    case GL_RGBA32F:
        return {GL_RGBA, GL_FLOAT, 16};
    case GL_DEPTH_COMPONENT32F:
        return {GL_DEPTH_COMPONENT, GL_FLOAT, 4};
    default:
        break;
    }
    qFatal("no texel layout for format 0x%x", internalFormat);
    return {};
}

bool isIntegerFormat(GLenum internalFormat)
{
    const GLenum format = texelLayout(internalFormat).format;
    return format == GL_RED_INTEGER || format == GL_RG_INTEGER || format == GL_RGBA_INTEGER;
}

} // namespace gpu
