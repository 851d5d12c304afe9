// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gpu/gl/Buffer.h"
#include "gpu/gl/GlId.h"

#include <cstddef>

namespace gpu {

/// One attribute of a vertex in the buffer.
struct AttributeOptions {
    int components = 1;
    GLenum type = GL_FLOAT;
    bool normalized = false; ///< maps integers to 0 … 1 or −1 … 1
    std::size_t offset = 0; ///< bytes
};

/// Describes where vertices come from. It stays empty if the vertex shader computes its own
/// positions: the core profile requires a vertex array even then. It belongs to one context and is
/// not shared.
class VertexArray {
public:
    VertexArray() = default;
    explicit VertexArray(const char* label);

    /// Sets its one buffer.
    /// @param stride bytes from one vertex to the next
    void setVertices(const Buffer& buffer, std::size_t stride);
    /// Advances in the buffer once per instance instead of once per vertex.
    void setPerInstance();
    void setAttribute(GLuint location, const AttributeOptions& options);
    /// Sets the buffer of 32-bit indices.
    void setElements(const Buffer& buffer);

    /// Draws one triangle that covers the viewport, with the program in use (fullScreen.vert).
    void drawFullScreenTriangle() const;
    /// Draws the triangles of the first @p elements indices, with the program in use.
    void drawTriangles(int elements) const;
    /// Draws instances of a strip of four vertices that the vertex shader computes.
    void drawQuads(int instances) const;

private:
    GlId<glDelete::vertexArray> m_id;
};

} // namespace gpu
