// SPDX-License-Identifier: Apache-2.0
#include "gpu/gl/DebugOutput.h"

#include "core/base/Log.h"
#include "gpu/gl/Gl.h"

#include <atomic>
#include <new>

namespace gpu {

namespace {

std::atomic<int> errors = 0;

void logMessage(GLenum type, GLuint id, GLenum severity, const QByteArray& text)
{
    if (type == GL_DEBUG_TYPE_ERROR) {
        qCCritical(core::log, "GL error %u: %s", id, text.constData());
    } else if (severity == GL_DEBUG_SEVERITY_HIGH) {
        qCWarning(core::log, "GL %u: %s", id, text.constData());
    } else if (severity != GL_DEBUG_SEVERITY_NOTIFICATION) {
        qCDebug(core::log, "GL %u: %s", id, text.constData());
    }
}

/// The driver is under way, perhaps with locks held: nothing may be thrown through it.
void onMessage(GLenum, GLenum type, GLuint id, GLenum severity, GLsizei length,
    const GLchar* message, const void*) noexcept
{
    if (type == GL_DEBUG_TYPE_ERROR)
        ++errors;
    try {
        logMessage(type, id, severity, QByteArray(message, length));
    } catch (const std::bad_alloc&) {
        // There is not even memory to say so. Who made the call asks for the error.
    }
}

} // namespace

void DebugOutput::install()
{
    glEnable(GL_DEBUG_OUTPUT);
    // A message then comes from inside the call that caused it, so that a debugger shows which.
    GLint flags = 0;
    glGetIntegerv(GL_CONTEXT_FLAGS, &flags);
    if ((flags & GL_CONTEXT_FLAG_DEBUG_BIT) != 0)
        glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
    glDebugMessageCallback(onMessage, nullptr);
}

int DebugOutput::errorCount()
{
    return errors;
}

} // namespace gpu
