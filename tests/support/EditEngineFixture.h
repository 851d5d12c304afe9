// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gpu/edit/GpuEditEngine.h"
#include "tests/reference/DenseFields.h"

#include <QByteArray>

#include <atomic>
#include <memory>

namespace test {

/// The GPU's edit engine on an engine thread of its own, without renderers, and its textures within
/// reach. Messages of GL about errors count.
class EditEngineFixture {
public:
    EditEngineFixture();
    ~EditEngineFixture();
    EditEngineFixture(const EditEngineFixture&) = delete;
    EditEngineFixture& operator=(const EditEngineFixture&) = delete;

    [[nodiscard]] bool isReady() const { return bool(m_onThread); }
    [[nodiscard]] const char* why() const { return m_why.constData(); }
    [[nodiscard]] const QByteArray& rendererName() const { return m_rendererName; }
    [[nodiscard]] core::EditEngine& engine() { return m_onThread->engine; }
    /// GL errors since the last call.
    [[nodiscard]] int newErrors();

    /// Which labels the segmentation map is to show.
    void showSegments(const std::bitset<256>& labels);
    /// At which tolerance a segment is to be shown.
    void showAtTolerance(const std::optional<gpu::ToleranceDisplay>& shown);
    /// Derived textures once they have caught up; call it after finish().
    [[nodiscard]] reference::DenseArray<std::uint8_t> read(gpu::VolumeField field);

private:
    struct OnThread {
        gpu::ShaderLibrary shaders = gpu::ShaderLibrary::builtIn();
        gpu::VolumeTextures textures;
        gpu::GpuEditEngine engine;

        explicit OnThread(gpu::EngineThread& thread);
    };

    std::unique_ptr<gpu::EngineThread> m_thread;
    std::unique_ptr<OnThread> m_onThread;
    std::atomic<bool> m_idle = false;
    QByteArray m_rendererName;
    QByteArray m_why;
    int m_errorsSeen = 0;
};

} // namespace test
