// SPDX-License-Identifier: Apache-2.0
#include "gpu/engine/GpuEngine.h"

#include "core/base/Guarded.h"
#include "gpu/engine/EngineThread.h"
#include "gpu/engine/GpuEditEngine.h"
#include "gpu/fields/textures/VolumeTextures.h"
#include "gpu/frame/FrameScheduler.h"
#include "gpu/gl/GlFailure.h"
#include "gpu/gl/context/EglContext.h"

#include <utility>

namespace gpu {

namespace {

/// All that must be made and destroyed with the context current.
struct OnThread {
    ShaderLibrary shaders = ShaderLibrary::builtIn();
    VolumeTextures textures;
    GpuEditEngine edits;
    FrameScheduler frames;

    explicit OnThread(EngineThread& thread)
        : edits(EditContext{thread, textures, shaders})
        , frames({.volume = textures, .edits = edits, .shaders = shaders, .wake = [&thread] {
                      thread.wake();
                  }})
    {
    }
};

QString glText(GLenum name)
{
    return QString::fromUtf8(reinterpret_cast<const char*>(glGetString(name)));
}

} // namespace

class GpuEngine::Implementation {
public:
    explicit Implementation(std::unique_ptr<GlContext> context)
        : m_thread(std::move(context))
    {
    }
    ~Implementation()
    {
        if (!m_onThread)
            return;
        constexpr int tries = 3;
        for (int i = 0; i < tries; ++i) {
            const core::Result<void> done =
                core::guarded([this] { m_thread.run([this] { end(); }); });
            if (done)
                return;
        }
        static_cast<void>(m_onThread.release()); // on no other thread can it be destroyed
    }

    core::Result<void> start()
    {
        if (auto started = m_thread.start(); !started)
            return started;
        core::Result<void> result;
        m_thread.run([&] {
            m_renderer = glText(GL_RENDERER);
            m_version = glText(GL_VERSION);
            try {
                m_onThread = std::make_unique<OnThread>(m_thread);
            } catch (...) {
                core::Error error = errorBeingHandled();
                if (error.code == core::ErrorCode::GraphicsUnavailable)
                    error.arguments.prepend(m_renderer);
                result = tl::unexpected(std::move(error));
                return;
            }
            m_thread.setSlices([this] { return m_editing = m_onThread->edits.work(); },
                [this] { return m_onThread->frames.work(m_editing); });
        });
        return result;
    }

    EngineThread m_thread;
    std::unique_ptr<OnThread> m_onThread;
    QString m_renderer;
    QString m_version;

private:
    void end()
    {
        m_thread.setSlices({}, {});
        m_onThread.reset();
    }

    bool m_editing = false; ///< engine thread
};

core::Result<std::unique_ptr<GpuEngine>> GpuEngine::create()
{
    return core::guarded([]() -> core::Result<std::unique_ptr<GpuEngine>> {
        auto context = EglContext::create();
        if (!context)
            return tl::unexpected(context.error());
        return create(std::move(*context));
    });
}

core::Result<std::unique_ptr<GpuEngine>> GpuEngine::create(std::unique_ptr<GlContext> context)
{
    return core::guarded([&]() -> core::Result<std::unique_ptr<GpuEngine>> {
        auto implementation = std::make_unique<Implementation>(std::move(context));
        if (auto started = implementation->start(); !started)
            return tl::unexpected(started.error());
        return std::unique_ptr<GpuEngine>(new GpuEngine(std::move(implementation)));
    });
}

GpuEngine::GpuEngine(std::unique_ptr<Implementation> implementation)
    : m_implementation(std::move(implementation))
{
    m_frames.setSource(&m_implementation->m_onThread->frames);
}

GpuEngine::~GpuEngine()
{
    m_frames.setSource(nullptr);
}

bool GpuEngine::isContextLost()
{
    bool lost = false;
    m_implementation->m_thread.run([&lost] {
        try {
            requireNoError();
        } catch (const ContextLost&) {
            lost = true;
        } catch (const GlFailure&) {
            // Of no matter here: every slice looks at its own end.
        }
    });
    return lost;
}

core::Result<void> GpuEngine::renew()
{
    return core::guarded([this]() -> core::Result<void> {
        auto made = create();
        if (!made)
            return tl::unexpected(made.error());
        // Only one of the two hands on to it.
        (*made)->m_frames.setSource(nullptr);
        m_frames.setSource(&(*made)->m_implementation->m_onThread->frames);
        m_implementation.swap((*made)->m_implementation);
        return {};
    });
}

core::EditEngine& GpuEngine::edits()
{
    return m_implementation->m_onThread->edits;
}

FrameSource& GpuEngine::frames()
{
    return m_frames;
}

void GpuEngine::setVolumeGeometry(
    const core::VolumeGeometry& geometry, const core::VoxelEncoding& encoding)
{
    m_implementation->m_thread.run(
        [&] { m_implementation->m_onThread->textures.setGeometry(geometry, encoding); });
}

QString GpuEngine::rendererName() const
{
    return m_implementation->m_renderer;
}

QString GpuEngine::versionText() const
{
    return m_implementation->m_version;
}

} // namespace gpu
