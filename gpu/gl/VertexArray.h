// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gpu/gl/Buffer.h"
#include "gpu/gl/GlId.h"

#include <cstddef>

namespace gpu {

/// One attribute in a vertex of the buffer.
struct AttributeOptions {
    int components = 1;
    GLenum type = GL_FLOAT;
    bool normalized = false; ///< integers to 0 … 1 or −1 … 1
    std::size_t offset = 0; ///< bytes
};

/// Where vertices come from; empty where the vertex shader makes its own, since the core profile
/// wants one even then. Lives with one context (not shared).
class VertexArray {
public:
    VertexArray() = default;
    explicit VertexArray(const char* label);

    /// Its one buffer. @param stride bytes from one vertex to the next
    void setVertices(const Buffer& buffer, std::size_t stride);
    /// One step in the buffer for each instance, not each vertex.
    void setPerInstance();
    void setAttribute(GLuint location, const AttributeOptions& options);
    /// Indices of 32 bits.
    void setElements(const Buffer& buffer);

    /// One triangle that covers the viewport, with the program in use (fullScreen.vert).
    void drawFullScreenTriangle() const;
    /// Triangles of the first so many elements, with the program in use.
    void drawTriangles(int elements) const;
    /// So many instances of a strip of four vertices that the vertex shader makes.
    void drawQuads(int instances) const;

private:
    GlId<glDelete::vertexArray> m_id;
};

} // namespace gpu
