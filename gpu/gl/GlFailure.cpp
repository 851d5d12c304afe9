// SPDX-License-Identifier: Apache-2.0
#include "gpu/gl/GlFailure.h"

#include "core/base/Guarded.h"
#include "gpu/gl/Gl.h"
#include "gpu/shaders/ShaderLibrary.h"

#include <optional>

namespace gpu {

namespace {

/// A lost context reports itself for ever.
constexpr int mostErrors = 64;

/// The reset that has taken away this thread's context; empty: it is there. A driver may tell of it
/// only once, and a thread keeps its context from start to end.
thread_local std::optional<GLenum> lostBy;

core::Clause reasonOf(GLenum resetStatus)
{
    switch (resetStatus) {
    case GL_GUILTY_CONTEXT_RESET:
        return core::Clause::saying("the graphics processor was reset in the middle of it");
    case GL_INNOCENT_CONTEXT_RESET:
        return core::Clause::saying("the graphics processor was reset because of another program");
    case GL_UNKNOWN_CONTEXT_RESET:
        return core::Clause::saying("the graphics processor was reset");
    default:
        return core::Clause::saying("its OpenGL context was lost");
    }
}

core::Error error(core::ErrorCode code, const core::Clause& reason)
{
    return {code, {reason}};
}

/// @param told by an error
void throwIfLost(bool told)
{
    if (!lostBy) {
        // Without robust access a driver says nothing here; then errors may tell.
        const GLenum status = glGetGraphicsResetStatus();
        if (told || status != GL_NO_ERROR)
            lostBy = status;
    }
    if (lostBy)
        throw ContextLost(error(core::ErrorCode::ContextLost, reasonOf(*lostBy)));
}

/// The first of the errors since the last look, GL_NO_ERROR if there is none. Throws ContextLost
/// where one of them, or a look before, says so.
GLenum takeErrors()
{
    if (lostBy)
        throwIfLost(true);
    const GLenum first = glGetError();
    GLenum next = first;
    bool lost = false;
    for (int i = 0; i < mostErrors && next != GL_NO_ERROR; ++i) {
        lost = lost || next == GL_CONTEXT_LOST;
        next = glGetError();
    }
    // Whatever fails may be what comes of it.
    if (first != GL_NO_ERROR)
        throwIfLost(lost);
    return first;
}

QString megabytes(std::size_t bytes)
{
    return QString::number(double(bytes) * 1e-6, 'f', bytes < 10'000'000 ? 2 : 0);
}

} // namespace

GlFailure::GlFailure(core::Error error)
    : std::runtime_error(error.arguments.value(0).toStdString())
    , m_error(std::move(error))
{
}

core::Error errorBeingHandled() noexcept
{
    try {
        throw;
    } catch (const GlFailure& failure) {
        return failure.error();
    } catch (const ShaderError& failure) {
        try {
            return error(core::ErrorCode::GraphicsUnavailable, QString::fromUtf8(failure.what()));
        } catch (...) {
            return core::errorBeingHandled();
        }
    } catch (...) {
        return core::errorBeingHandled();
    }
}

void requireStorage(const char* label, std::size_t bytes)
{
    if (takeErrors() != GL_NO_ERROR)
        throw GlFailure(error(core::ErrorCode::OutOfMemory,
            core::Clause::saying("the graphics processor refused %1 MB for “%2”", megabytes(bytes),
                QLatin1String(label))));
}

void requireMemory(const char* label)
{
    if (takeErrors() == GL_OUT_OF_MEMORY)
        throw GlFailure(error(core::ErrorCode::OutOfMemory,
            core::Clause::saying(
                "the graphics driver has no more for “%1”", QLatin1String(label))));
    throwIfLost(false);
}

void requireNoError()
{
    const GLenum code = takeErrors();
    switch (code) {
    case GL_NO_ERROR:
        return throwIfLost(false); // a driver may say so without an error
    case GL_OUT_OF_MEMORY:
        throw GlFailure(error(core::ErrorCode::OutOfMemory,
            core::Clause::saying("the graphics processor has no more")));
    default:
        throw GlFailure(error(core::ErrorCode::Internal,
            core::Clause::saying("the graphics driver refused a command (0x%1)",
                QStringLiteral("%1").arg(code, 4, 16, QLatin1Char('0')))));
    }
}

void requireContext()
{
    throwIfLost(false);
}

} // namespace gpu
