// SPDX-License-Identifier: Apache-2.0
#include "tests/support/EditEngineFixture.h"

#include "gpu/edit/BarrierBricks.h"
#include "gpu/gl/DebugOutput.h"
#include "gpu/gl/EglContext.h"

#include <epoxy/gl.h>

namespace test {

EditEngineFixture::OnThread::OnThread(gpu::EngineThread& thread)
    : engine(gpu::EditContext{.thread = thread, .textures = textures, .shaders = shaders})
{
}

EditEngineFixture::EditEngineFixture()
{
    auto context = gpu::EglContext::create({.debug = true});
    if (!context) {
        m_why = context.error().arguments.join(QStringLiteral(": ")).toUtf8();
        return;
    }
    m_thread = std::make_unique<gpu::EngineThread>(std::move(*context));
    if (const auto started = m_thread->start(); !started) {
        m_why = started.error().arguments.join(QStringLiteral(": ")).toUtf8();
        return;
    }
    m_thread->run([this] {
        gpu::DebugOutput::install();
        m_errorsSeen = gpu::DebugOutput::errorCount();
        m_rendererName = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
        m_onThread = std::make_unique<OnThread>(*m_thread);
        m_thread->setSlices(
            [this] {
                const bool more = m_onThread->engine.work();
                m_idle = !more;
                return more;
            },
            [] { return false; });
    });
}

EditEngineFixture::~EditEngineFixture()
{
    if (!m_onThread)
        return;
    m_thread->run([this] {
        m_thread->setSlices([] { return false; }, [] { return false; });
        m_onThread.reset();
    });
}

int EditEngineFixture::newErrors()
{
    const int total = gpu::DebugOutput::errorCount();
    const int fresh = total - m_errorsSeen;
    m_errorsSeen = total;
    return fresh;
}

void EditEngineFixture::showSegments(const std::bitset<256>& labels)
{
    m_thread->run([&] { m_onThread->engine.showSegments(labels); });
}

void EditEngineFixture::showAtTolerance(const std::optional<gpu::ToleranceDisplay>& shown)
{
    m_thread->run([&] { m_onThread->engine.showAtTolerance(shown); });
}

reference::DenseArray<std::uint8_t> EditEngineFixture::read(gpu::VolumeField field)
{
    m_idle = false;
    m_thread->wake();
    while (!m_idle)
        std::this_thread::yield();
    reference::DenseArray<std::uint8_t> bytes;
    m_thread->run([&] {
        gpu::VolumeTextures& textures = m_onThread->textures;
        if (field == gpu::VolumeField::BarrierBricks && !textures.barriers()->texture()) {
            bytes.size = textures.grid().bricks();
            bytes.values.resize(std::size_t(textures.grid().brickCount()), 0);
            return;
        }
        const gpu::Texture3D& texture = field == gpu::VolumeField::Labels ? textures.labels()
            : field == gpu::VolumeField::Radiation                        ? textures.radiation()
            : field == gpu::VolumeField::BarrierBricks ? textures.barriers()->texture()
                                                       : textures.segmentation();
        bytes.size = texture.size();
        bytes.values.resize(texture.bytes());
        texture.read(glm::ivec3(0), bytes.size, std::as_writable_bytes(std::span(bytes.values)));
    });
    return bytes;
}

} // namespace test
