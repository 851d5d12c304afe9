// SPDX-License-Identifier: Apache-2.0
#include "gpu/gl/VertexArray.h"

namespace gpu {

VertexArray::VertexArray(const char* label)
{
    GLuint id = 0;
    glCreateVertexArrays(1, &id);
    m_id = GlId<glDelete::vertexArray>(id);
    labelObject(GL_VERTEX_ARRAY, id, label);
}

void VertexArray::drawFullScreenTriangle() const
{
    glBindVertexArray(m_id.get());
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

} // namespace gpu
