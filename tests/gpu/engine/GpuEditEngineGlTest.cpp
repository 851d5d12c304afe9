// SPDX-License-Identifier: Apache-2.0
#include "gpu/engine/GpuEditEngine.h"

#include "core/growth/SeedWord.h"
#include "gpu/gl/EglContext.h"
#include "tests/support/program/TestProgram.h"

#include <QTest>

namespace gpuEditEngineGlTest {

/// What is the GPU engine's own: pages, queues, batches. Rules shared with the oracle are held by
/// EngineConformanceGlTest.
class GpuEditEngineGlTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init();
    void cleanup();
    void growsABall();
    void survivesAnOverflowingQueue();
    void swapsBackAndForth();

private:
    core::EngineResult resultOf(core::Ticket ticket);

    std::unique_ptr<gpu::EngineThread> m_thread;
    std::unique_ptr<gpu::VolumeTextures> m_textures;
    std::unique_ptr<gpu::ShaderLibrary> m_shaders;
    std::unique_ptr<gpu::GpuEditEngine> m_engine;
};

void GpuEditEngineGlTest::init()
{
    auto context = gpu::EglContext::create({});
    QVERIFY(context);
    m_thread = std::make_unique<gpu::EngineThread>(std::move(*context));
    QVERIFY(m_thread->start());
    m_thread->run([this] {
        m_textures = std::make_unique<gpu::VolumeTextures>();
        m_shaders = std::make_unique<gpu::ShaderLibrary>(gpu::ShaderLibrary::builtIn());
        m_engine = std::make_unique<gpu::GpuEditEngine>(
            gpu::EditContext{.thread = *m_thread, .textures = *m_textures, .shaders = *m_shaders});
        m_thread->setSlices([this] { return m_engine->work(); }, [] { return false; });
    });
}

void GpuEditEngineGlTest::cleanup()
{
    m_thread->run([this] {
        m_thread->setSlices([] { return false; }, [] { return false; });
        m_engine.reset();
        m_textures.reset();
    });
    m_thread.reset();
}

core::EngineResult GpuEditEngineGlTest::resultOf(core::Ticket ticket)
{
    m_engine->finish();
    for (core::EngineResult& result : m_engine->collect()) {
        if (result.ticket == ticket)
            return std::move(result);
    }
    return {.ticket = 0, .error = core::Error{}};
}

void GpuEditEngineGlTest::growsABall()
{
    const glm::ivec3 size(50, 40, 37);
    QVERIFY(m_engine->openVolume(
        size, std::vector<std::uint16_t>(std::size_t(size.x * size.y * size.z), 100)));
    core::submitWhole(
        *m_engine, core::SeedPlacement{.plane = 0, .label = 3, .voxels = {{20, 20, 20}}});
    const core::EngineResult result = resultOf(core::submitWhole(*m_engine,
        core::GrowBurst{.lowCode = 100, .highCode = 100, .generation = 0, .overwritable = {}},
        {core::GrowAdvance{.steps = 5}}));
    QVERIFY(!result.error);
    QCOMPARE(result.generation, 6u);
    // Voxels within five face steps: the octahedral numbers' difference, 1 + 6 + 18 + 38 + 66 +
    // 102.
    QCOMPARE(result.statistics.voxelsChanged, 231);
}

void GpuEditEngineGlTest::survivesAnOverflowingQueue()
{
    // Half a million seeds at once: more than the queue holds at first.
    const glm::ivec3 size(128, 128, 64);
    QVERIFY(m_engine->openVolume(
        size, std::vector<std::uint16_t>(std::size_t(size.x * size.y * size.z), 7)));
    core::SeedPlacement seeds{.plane = 0, .label = 1, .voxels = {}};
    for (int z = 0; z < size.z; ++z)
        for (int y = 0; y < size.y; ++y)
            for (int x = (y + z) % 2; x < size.x; x += 2)
                seeds.voxels.emplace_back(x, y, z);
    core::submitWhole(*m_engine, seeds);
    const core::EngineResult result = resultOf(core::submitWhole(*m_engine,
        core::GrowBurst{.lowCode = 0, .highCode = 10, .generation = 0, .overwritable = {}},
        {core::GrowAdvance{}}));
    QVERIFY(!result.error);
    QVERIFY(result.atClosure);
    QCOMPARE(result.statistics.voxelsChanged, std::int64_t(size.x) * size.y * size.z);
    QCOMPARE(result.generation, 2u);
}

void GpuEditEngineGlTest::swapsBackAndForth()
{
    const glm::ivec3 size(33, 20, 18);
    QVERIFY(m_engine->openVolume(
        size, std::vector<std::uint16_t>(std::size_t(size.x * size.y * size.z), 1)));
    core::submitWhole(
        *m_engine, core::SeedPlacement{.plane = 0, .label = 1, .voxels = {{0, 0, 0}}});
    const core::EngineResult grown = resultOf(core::submitWhole(*m_engine,
        core::GrowBurst{.lowCode = 0, .highCode = 1, .generation = 0, .overwritable = {}},
        {core::GrowAdvance{}}));
    QVERIFY(grown.changes.size() > 1);
    core::SwapBricks back;
    for (const core::BrickChange& change : grown.changes)
        back.bricks.push_back({.key = change.key, .bytes = change.before});
    const core::EngineResult undone = resultOf(m_engine->submit(back));
    QCOMPARE(undone.changes.size(), grown.changes.size());
    for (std::size_t i = 0; i < undone.changes.size(); ++i) {
        QCOMPARE(undone.changes[i].before, grown.changes[i].after);
        QCOMPARE(undone.changes[i].after, grown.changes[i].before);
    }
}

BURIN_TEST(GpuEditEngineGlTest)

} // namespace gpuEditEngineGlTest

#include "GpuEditEngineGlTest.moc"
