// SPDX-License-Identifier: Apache-2.0
#include "tests/support/faults/WorkOfGl.h"

#include <epoxy/gl.h>

#include <array>
#include <atomic>

namespace test {

namespace {

std::atomic<int> dispatches = 0;
std::atomic<std::int64_t> groups = 0;
std::atomic<std::int64_t> bytesUp = 0;
std::atomic<std::int64_t> bytesDown = 0;
std::atomic<std::int64_t> bytesWithin = 0;
std::atomic<std::int64_t> bytesMade = 0;
std::atomic<int> drawCalls = 0;
std::atomic<std::int64_t> pixelsDrawn = 0;

/// Of one texel as the program has it.
std::int64_t texelBytes(GLenum format, GLenum type)
{
    std::int64_t channels = 1;
    if (format == GL_RG || format == GL_RG_INTEGER)
        channels = 2;
    else if (format == GL_RGB || format == GL_RGB_INTEGER)
        channels = 3;
    else if (format == GL_RGBA || format == GL_RGBA_INTEGER)
        channels = 4;
    if (type == GL_UNSIGNED_BYTE || type == GL_BYTE)
        return channels;
    return channels * (type == GL_UNSIGNED_SHORT || type == GL_HALF_FLOAT ? 2 : 4);
}

void countingDispatch(GLuint x, GLuint y, GLuint z)
{
    static const auto own = driversOwn<PFNGLDISPATCHCOMPUTEPROC>("glDispatchCompute");
    ++dispatches;
    groups += std::int64_t(x) * y * z;
    own(x, y, z);
}

void countingIndirect(GLintptr offset)
{
    static const auto own =
        driversOwn<PFNGLDISPATCHCOMPUTEINDIRECTPROC>("glDispatchComputeIndirect");
    ++dispatches;
    own(offset);
}

void countingStorage(GLuint buffer, GLsizeiptr size, const void* data, GLbitfield flags)
{
    static const auto own = driversOwn<PFNGLNAMEDBUFFERSTORAGEPROC>("glNamedBufferStorage");
    bytesMade += size;
    bytesUp += data ? size : 0;
    own(buffer, size, data, flags);
}

void countingWrite(GLuint buffer, GLintptr offset, GLsizeiptr size, const void* data)
{
    static const auto own = driversOwn<PFNGLNAMEDBUFFERSUBDATAPROC>("glNamedBufferSubData");
    bytesUp += size;
    own(buffer, offset, size, data);
}

void countingRead(GLuint buffer, GLintptr offset, GLsizeiptr size, void* data)
{
    static const auto own = driversOwn<PFNGLGETNAMEDBUFFERSUBDATAPROC>("glGetNamedBufferSubData");
    bytesDown += size;
    own(buffer, offset, size, data);
}

void countingFill(GLuint buffer, GLenum internal, GLintptr offset, GLsizeiptr size, GLenum format,
    GLenum type, const void* data)
{
    static const auto own =
        driversOwn<PFNGLCLEARNAMEDBUFFERSUBDATAPROC>("glClearNamedBufferSubData");
    bytesWithin += size;
    own(buffer, internal, offset, size, format, type, data);
}

void countingCopy(GLuint from, GLuint to, GLintptr fromOffset, GLintptr toOffset, GLsizeiptr size)
{
    static const auto own = driversOwn<PFNGLCOPYNAMEDBUFFERSUBDATAPROC>("glCopyNamedBufferSubData");
    bytesWithin += size;
    own(from, to, fromOffset, toOffset, size);
}

void countingTexels(GLuint texture, GLint level, GLint x, GLint y, GLint z, GLsizei width,
    GLsizei height, GLsizei depth, GLenum format, GLenum type, const void* texels)
{
    static const auto own = driversOwn<PFNGLTEXTURESUBIMAGE3DPROC>("glTextureSubImage3D");
    bytesUp += std::int64_t(width) * height * depth * texelBytes(format, type);
    own(texture, level, x, y, z, width, height, depth, format, type, texels);
}

void countingFlatTexels(GLuint texture, GLint level, GLint x, GLint y, GLsizei width,
    GLsizei height, GLenum format, GLenum type, const void* texels)
{
    static const auto own = driversOwn<PFNGLTEXTURESUBIMAGE2DPROC>("glTextureSubImage2D");
    bytesUp += std::int64_t(width) * height * texelBytes(format, type);
    own(texture, level, x, y, width, height, format, type, texels);
}

void countingPixelsRead(
    GLint x, GLint y, GLsizei width, GLsizei height, GLenum format, GLenum type, void* into)
{
    static const auto own = driversOwn<PFNGLREADPIXELSPROC>("glReadPixels");
    bytesDown += std::int64_t(width) * height * texelBytes(format, type);
    own(x, y, width, height, format, type, into);
}

void countingTexelsRead(GLuint texture, GLint level, GLint x, GLint y, GLint z, GLsizei width,
    GLsizei height, GLsizei depth, GLenum format, GLenum type, GLsizei size, void* texels)
{
    static const auto own = driversOwn<PFNGLGETTEXTURESUBIMAGEPROC>("glGetTextureSubImage");
    bytesDown += std::int64_t(width) * height * depth * texelBytes(format, type);
    own(texture, level, x, y, z, width, height, depth, format, type, size, texels);
}

void countingClear(GLuint texture, GLint level, GLint x, GLint y, GLint z, GLsizei width,
    GLsizei height, GLsizei depth, GLenum format, GLenum type, const void* texel)
{
    static const auto own = driversOwn<PFNGLCLEARTEXSUBIMAGEPROC>("glClearTexSubImage");
    bytesWithin += std::int64_t(width) * height * depth;
    own(texture, level, x, y, z, width, height, depth, format, type, texel);
}

/// Its size is not among the arguments; level 0 is all there is.
void countingClearWhole(GLuint texture, GLint level, GLenum format, GLenum type, const void* texel)
{
    static const auto own = driversOwn<PFNGLCLEARTEXIMAGEPROC>("glClearTexImage");
    GLint width = 1;
    GLint height = 1;
    GLint depth = 1;
    glGetTextureLevelParameteriv(texture, level, GL_TEXTURE_WIDTH, &width);
    glGetTextureLevelParameteriv(texture, level, GL_TEXTURE_HEIGHT, &height);
    glGetTextureLevelParameteriv(texture, level, GL_TEXTURE_DEPTH, &depth);
    bytesWithin += std::int64_t(width) * height * depth;
    own(texture, level, format, type, texel);
}

void countingCopyTexels(GLuint from, GLenum fromTarget, GLint fromLevel, GLint fromX, GLint fromY,
    GLint fromZ, GLuint to, GLenum toTarget, GLint toLevel, GLint toX, GLint toY, GLint toZ,
    GLsizei width, GLsizei height, GLsizei depth)
{
    static const auto own = driversOwn<PFNGLCOPYIMAGESUBDATAPROC>("glCopyImageSubData");
    bytesWithin += std::int64_t(width) * height * depth;
    own(from, fromTarget, fromLevel, fromX, fromY, fromZ, to, toTarget, toLevel, toX, toY, toZ,
        width, height, depth);
}

/// A pass draws one triangle over the whole target and cuts out its tile by scissors.
void countingArrays(GLenum mode, GLint first, GLsizei count)
{
    static const auto own = driversOwn<PFNGLDRAWARRAYSPROC>("glDrawArrays");
    std::array<GLint, 4> place{};
    glGetIntegerv(
        glIsEnabled(GL_SCISSOR_TEST) == GL_TRUE ? GL_SCISSOR_BOX : GL_VIEWPORT, place.data());
    ++drawCalls;
    pixelsDrawn += std::int64_t(place[2]) * place[3];
    own(mode, first, count);
}

void countingElements(GLenum mode, GLsizei count, GLenum type, const void* indices)
{
    static const auto own = driversOwn<PFNGLDRAWELEMENTSPROC>("glDrawElements");
    ++drawCalls;
    own(mode, count, type, indices);
}

void countingInstances(GLenum mode, GLint first, GLsizei count, GLsizei instances)
{
    static const auto own = driversOwn<PFNGLDRAWARRAYSINSTANCEDPROC>("glDrawArraysInstanced");
    ++drawCalls;
    own(mode, first, count, instances);
}

} // namespace

WorkOfGl::WorkOfGl()
{
    static_cast<void>(take());
    m_gl.lead(epoxy_glDispatchCompute, &countingDispatch);
    m_gl.lead(epoxy_glDispatchComputeIndirect, &countingIndirect);
    m_gl.lead(epoxy_glNamedBufferStorage, &countingStorage);
    m_gl.lead(epoxy_glNamedBufferSubData, &countingWrite);
    m_gl.lead(epoxy_glGetNamedBufferSubData, &countingRead);
    m_gl.lead(epoxy_glClearNamedBufferSubData, &countingFill);
    m_gl.lead(epoxy_glCopyNamedBufferSubData, &countingCopy);
    m_gl.lead(epoxy_glTextureSubImage3D, &countingTexels);
    m_gl.lead(epoxy_glGetTextureSubImage, &countingTexelsRead);
    m_gl.lead(epoxy_glClearTexSubImage, &countingClear);
    m_gl.lead(epoxy_glClearTexImage, &countingClearWhole);
    m_gl.lead(epoxy_glCopyImageSubData, &countingCopyTexels);
    m_gl.lead(epoxy_glTextureSubImage2D, &countingFlatTexels);
    m_gl.lead(epoxy_glReadPixels, &countingPixelsRead);
    m_gl.lead(epoxy_glDrawArrays, &countingArrays);
    m_gl.lead(epoxy_glDrawElements, &countingElements);
    m_gl.lead(epoxy_glDrawArraysInstanced, &countingInstances);
}

GlWork WorkOfGl::take()
{
    return {.dispatches = dispatches.exchange(0),
        .groups = groups.exchange(0),
        .bytesUp = bytesUp.exchange(0),
        .bytesDown = bytesDown.exchange(0),
        .bytesWithin = bytesWithin.exchange(0),
        .bytesMade = bytesMade.exchange(0),
        .draws = drawCalls.exchange(0),
        .pixels = pixelsDrawn.exchange(0)};
}

} // namespace test
