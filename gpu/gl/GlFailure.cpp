// SPDX-License-Identifier: Apache-2.0
#include "gpu/gl/GlFailure.h"

#include "core/base/Guarded.h"
#include "gpu/gl/Gl.h"
#include "gpu/shaders/ShaderLibrary.h"

namespace gpu {

namespace {

/// A lost context reports itself for ever.
constexpr int mostErrors = 64;

/// The first of the errors since the last look, GL_NO_ERROR if there is none.
GLenum takeErrors()
{
    const GLenum first = glGetError();
    GLenum next = first;
    for (int i = 0; i < mostErrors && next != GL_NO_ERROR; ++i)
        next = glGetError();
    return first;
}

core::Error error(core::ErrorCode code, const QString& text)
{
    return {code, {text}};
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
            QStringLiteral("the graphics processor refused %1 MB for “%2”")
                .arg(megabytes(bytes), QLatin1String(label))));
}

void requireMemory(const char* label)
{
    if (takeErrors() == GL_OUT_OF_MEMORY)
        throw GlFailure(error(core::ErrorCode::OutOfMemory,
            QStringLiteral("the graphics driver has no more for “%1”").arg(QLatin1String(label))));
}

void requireNoError()
{
    switch (const GLenum code = takeErrors()) {
    case GL_NO_ERROR:
        return;
    case GL_OUT_OF_MEMORY:
        throw GlFailure(error(
            core::ErrorCode::OutOfMemory, QStringLiteral("the graphics processor has no more")));
    default:
        throw GlFailure(error(core::ErrorCode::Internal,
            QStringLiteral("the graphics driver refused a command (0x%1)")
                .arg(code, 4, 16, QLatin1Char('0'))));
    }
}

} // namespace gpu
