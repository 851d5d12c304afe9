// SPDX-License-Identifier: Apache-2.0
#include "gpu/gl/VertexArray.h"

#include "gpu/gl/GpuTrace.h"

namespace gpu {

VertexArray::VertexArray(const char* label)
{
    GLuint id = 0;
    glCreateVertexArrays(1, &id);
    m_id = GlId<glDelete::vertexArray>(id);
    labelObject(GL_VERTEX_ARRAY, id, label);
}

void VertexArray::setVertices(const Buffer& buffer, std::size_t stride)
{
    glVertexArrayVertexBuffer(m_id.get(), 0, buffer.id(), 0, GLsizei(stride));
}

void VertexArray::setPerInstance()
{
    glVertexArrayBindingDivisor(m_id.get(), 0, 1);
}

void VertexArray::setAttribute(GLuint location, const AttributeOptions& options)
{
    glVertexArrayAttribFormat(m_id.get(), location, options.components, options.type,
        options.normalized ? GL_TRUE : GL_FALSE, GLuint(options.offset));
    glVertexArrayAttribBinding(m_id.get(), location, 0);
    glEnableVertexArrayAttrib(m_id.get(), location);
}

void VertexArray::setElements(const Buffer& buffer)
{
    glVertexArrayElementBuffer(m_id.get(), buffer.id());
}

void VertexArray::drawFullScreenTriangle() const
{
    glBindVertexArray(m_id.get());
    const GpuTrace::Span measured;
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

void VertexArray::drawTriangles(int elements) const
{
    glBindVertexArray(m_id.get());
    const GpuTrace::Span measured;
    glDrawElements(GL_TRIANGLES, elements, GL_UNSIGNED_INT, nullptr);
}

void VertexArray::drawQuads(int instances) const
{
    glBindVertexArray(m_id.get());
    const GpuTrace::Span measured;
    glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, instances);
}

} // namespace gpu
