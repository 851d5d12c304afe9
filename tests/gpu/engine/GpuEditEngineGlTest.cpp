// SPDX-License-Identifier: Apache-2.0
#include "gpu/engine/GpuEditEngine.h"

#include "core/growth/SeedWord.h"
#include "gpu/gl/context/EglContext.h"
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
    void keepsWhatIsSuspended();

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

/// Three bricks of different values beside each other; what an interval suspends of them stays
/// known from drag to drag.
void GpuEditEngineGlTest::keepsWhatIsSuspended()
{
    const glm::ivec3 size(48, 16, 16);
    std::vector<std::uint16_t> codes;
    for (int i = 0; i < size.x * size.y * size.z; ++i)
        codes.push_back(std::uint16_t(100 * (1 + i % size.x / 16)));
    QVERIFY(m_engine->openVolume(size, codes));
    const core::SeedPlacement seed{.plane = 0, .label = 1, .voxels = {{2, 2, 2}}};
    core::submitWhole(*m_engine, seed);
    std::uint32_t generation = resultOf(
        core::submitWhole(*m_engine, core::GrowBurst{.lowCode = 100, .highCode = 300},
            {core::GrowAdvance{}})).generation;
    QVERIFY(generation > 1);
    const auto drag = [&](int high, bool keep, core::Ending ending) {
        m_engine->submit(core::BeginEdit{core::GrowBurst{.lowCode = 100,
            .highCode = high,
            .opening = core::GrowOpening::Narrow,
            .generation = generation}});
        m_engine->submit(core::ExtendEdit{core::GrowAdvance{}});
        const core::EngineResult asked =
            resultOf(m_engine->submit(core::CompareGrowth{.keep = keep}));
        core::EngineResult ended = resultOf(m_engine->submit(core::EndEdit{ending}));
        if (asked.error || ended.error)
            qFatal("the drag to %d failed", high);
        if (ending == core::Ending::Commit)
            generation = ended.generation;
        return ended;
    };
    const auto isMarked = [&] {
        bool is = false;
        m_thread->run([&] { is = m_textures->cutPreview() != nullptr; });
        return is;
    };
    /// From which x to which, in whole bricks; none if nothing is suspended.
    const auto isSuspended = [&](int from, int to) {
        core::VoxelBox box;
        m_thread->run([&] { box = m_textures->suspended(); });
        return isMarked() && !box.empty() && box.minimum.x == from && box.maximum.x == to;
    };
    const auto isNothingSuspended = [&] {
        core::VoxelBox box;
        m_thread->run([&] { box = m_textures->suspended(); });
        return box.empty();
    };
    QVERIFY(!isMarked());
    drag(100, true, core::Ending::Commit);
    QVERIFY(isSuspended(16, 48));
    drag(200, true, core::Ending::Commit); // the middle is reinstated
    QVERIFY(isSuspended(32, 48));
    drag(100, true, core::Ending::Rollback);
    QVERIFY(isSuspended(32, 48));
    drag(300, true, core::Ending::Commit);
    QVERIFY(isNothingSuspended() && isMarked());
    drag(200, true, core::Ending::Commit);
    QVERIFY(isSuspended(32, 48));
    drag(200, true, core::Ending::Commit); // nothing changes
    QVERIFY(isSuspended(32, 48));
    drag(200, false, core::Ending::Commit);
    QVERIFY(isNothingSuspended() && !isMarked());
    // Whoever asks no more, begins another edit or undoes this one sees none.
    drag(100, true, core::Ending::Commit);
    QVERIFY(isSuspended(16, 32));
    QVERIFY(!resultOf(m_engine->submit(core::DropCutPreview{})).error);
    QVERIFY(isNothingSuspended() && !isMarked());
    drag(200, true, core::Ending::Commit);
    QVERIFY(isNothingSuspended() && isMarked());
    core::submitWhole(*m_engine, seed);
    m_engine->finish();
    QVERIFY(!isMarked());
    core::SwapBricks back;
    for (const core::BrickChange& change : drag(100, true, core::Ending::Commit).changes)
        back.bricks.push_back({.key = change.key, .bytes = change.before});
    QVERIFY(isSuspended(16, 32));
    QVERIFY(!resultOf(m_engine->submit(back)).error);
    QVERIFY(isNothingSuspended() && !isMarked());
}

BURIN_TEST(GpuEditEngineGlTest)

} // namespace gpuEditEngineGlTest

#include "GpuEditEngineGlTest.moc"
