// SPDX-License-Identifier: Apache-2.0
#include "gpu/gl/GlId.h"

namespace gpu {

namespace glDelete {

void buffer(GLuint id)
{
    glDeleteBuffers(1, &id);
}
void texture(GLuint id)
{
    glDeleteTextures(1, &id);
}
void framebuffer(GLuint id)
{
    glDeleteFramebuffers(1, &id);
}
void vertexArray(GLuint id)
{
    glDeleteVertexArrays(1, &id);
}
void program(GLuint id)
{
    glDeleteProgram(id);
}
void shader(GLuint id)
{
    glDeleteShader(id);
}
void query(GLuint id)
{
    glDeleteQueries(1, &id);
}

} // namespace glDelete

void labelObject(GLenum type, GLuint id, const char* label)
{
    if (label != nullptr && *label != '\0')
        glObjectLabel(type, id, -1, label);
}

} // namespace gpu
