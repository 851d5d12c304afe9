// SPDX-License-Identifier: Apache-2.0
#include "core/edits/document/DocumentEdits.h"
#include "gpu/engine/GpuEngine.h"
#include "tests/support/cases/EngineConformance.h"
#include "tests/support/cases/RandomEdits.h"
#include "tests/support/faults/LosingGl.h"
#include "tests/support/fixtures/EditEngineFixture.h"
#include "tests/support/program/LongRun.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/SmallStudy.h"

#include <QTest>

#include <algorithm>
#include <condition_variable>
#include <mutex>

namespace contextLossGlTest {

using namespace core;
using test::LosingGl;

namespace {

constexpr int brainCode = 40 + 1024;

GrowBurst burst()
{
    return {.lowCode = brainCode, .highCode = brainCode, .generation = 0, .overwritable = {}};
}

enum class Kind { Grow, Drill, Swap, Trace };

/// The small study in an engine, and a step that is about to be done.
class Stage {
public:
    Stage(EditEngine& engine, Kind kind)
        : m_engine(engine)
        , m_kind(kind)
    {
        const LoadedVolume study = test::smallStudy();
        m_document = initialDocument(study.volume);
        m_isOpen = m_engine.openVolume(study.volume.geometry.size, study.codes).has_value();
        submitWhole(m_engine, SeedPlacement{.plane = 0, .label = 1, .voxels = {{20, 18, 17}}});
        if (kind == Kind::Swap)
            submitWhole(m_engine, burst(), {GrowAdvance{}});
        m_engine.finish();
        for (const EngineResult& result : m_engine.collect())
            m_grown = result.changes;
    }

    [[nodiscard]] bool isOpen() const { return m_isOpen; }

    /// @return all that came of it; the step's own result is the last one
    std::vector<EngineResult> act()
    {
        switch (m_kind) {
        case Kind::Grow:
            submitWhole(m_engine, burst(), {GrowAdvance{}});
            break;
        case Kind::Drill: {
            const Edit stroke = test::drillAt(0);
            const DrillCut cut = test::drillCutOf(stroke, m_document);
            submitWhole(m_engine, cut, {DrillPath{test::drillSamplesOf(stroke, cut)}});
            break;
        }
        case Kind::Swap: {
            SwapBricks back;
            for (const BrickChange& change : m_grown)
                back.bricks.push_back({.key = change.key, .bytes = change.before});
            m_engine.submit(std::move(back));
            break;
        }
        case Kind::Trace:
            m_engine.submit(TraceTolerance{
                .rule = {.plane = 0, .label = 1, .connectivity = 6}, .toTheEnd = true});
            break;
        }
        m_engine.finish();
        return m_engine.collect();
    }

private:
    EditEngine& m_engine;
    Kind m_kind;
    Document m_document;
    std::vector<BrickChange> m_grown;
    bool m_isOpen = false;
};

bool same(const std::vector<BrickChange>& a, const std::vector<BrickChange>& b)
{
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
        [](const BrickChange& one, const BrickChange& other) {
            return one.key == other.key && one.before == other.before && one.after == other.after;
        });
}

bool isLoss(const EngineResult& result)
{
    return result.error && result.error->code == ErrorCode::ContextLost;
}

/// Pictures of a view, as they come.
class Pictures {
public:
    explicit Pictures(gpu::FrameSource& source)
        : m_source(source)
    {
        source.setListener([this](const gpu::Frame& frame) {
            if (!frame.failure && frame.quality != gpu::Frame::Quality::Refined)
                return;
            {
                const std::lock_guard lock(m_mutex);
                m_last = frame;
            }
            m_arrived.notify_one();
        });
    }
    ~Pictures() { m_source.setListener({}); }

    /// One that is drawn to the end, or refused.
    gpu::Frame ask(const VolumeGeometry& geometry)
    {
        gpu::SliceScene scene;
        scene.centreLps = geometry.toWorld(glm::dvec3(geometry.size) / 2.0);
        scene.window = {.centre = 40.0, .width = 400.0};
        m_source.forget(1);
        {
            const std::lock_guard lock(m_mutex);
            m_last.reset();
        }
        m_source.request({.view = 1, .sizePixels = {64, 64}, .scene = scene});
        std::unique_lock lock(m_mutex);
        m_arrived.wait_for(lock, std::chrono::minutes(2), [this] { return m_last.has_value(); });
        return std::exchange(m_last, {}).value_or(gpu::Frame());
    }

private:
    gpu::FrameSource& m_source;
    std::mutex m_mutex;
    std::condition_variable m_arrived;
    std::optional<gpu::Frame> m_last; ///< guarded
};

} // namespace

/// The driver gives the context up, at any place where that can be found: it is told as such, no
/// edit that was under way is told as done, and another engine does it as if nothing had been.
class ContextLossGlTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void isToldAndNothingIsDone_data();
    void isToldAndNothingIsDone();
    void isToldToWhoAsksNothing();
    void anotherEngineGoesOn();
    void whileAVolumeOpens();
};

void ContextLossGlTest::isToldAndNothingIsDone_data()
{
    QTest::addColumn<int>("kind");
    QTest::addColumn<bool>("byStatus");
    const auto rows = [](const char* name, Kind kind) {
        QTest::addRow("%s", name) << int(kind) << false;
        QTest::addRow("%s, by the status alone", name) << int(kind) << true;
    };
    rows("grow", Kind::Grow);
    rows("drill", Kind::Drill);
    rows("swap", Kind::Swap);
    rows("trace", Kind::Trace);
}

void ContextLossGlTest::isToldAndNothingIsDone()
{
    QFETCH(int, kind);
    QFETCH(bool, byStatus);
    std::vector<BrickChange> expected;
    int looks = 0;
    {
        test::EditEngineFixture gpu;
        QVERIFY2(gpu.isReady(), gpu.why());
        Stage stage(gpu.engine(), Kind(kind));
        QVERIFY(stage.isOpen());
        const LosingGl counting(0);
        const std::vector<EngineResult> results = stage.act();
        QVERIFY(!results.empty() && !results.back().error);
        expected = results.back().changes;
        QVERIFY(Kind(kind) == Kind::Trace || !expected.empty());
        looks = counting.looks();
        QCOMPARE(counting.lost(), 0);
    }
    QVERIFY(looks > 0);
    const int tried = test::longRun() ? looks : std::min(looks, 5);
    int undone = 0;
    for (int i = 0; i < tried; ++i) {
        const int first = 1 + i * looks / tried;
        test::EditEngineFixture gpu;
        QVERIFY2(gpu.isReady(), gpu.why());
        Stage stage(gpu.engine(), Kind(kind));
        const LosingGl losing(
            first, 0, byStatus ? LosingGl::Tells::ByStatus : LosingGl::Tells::ByError);
        const std::vector<EngineResult> results = stage.act();
        const QByteArray where = QByteArray::number(first) + " of " + QByteArray::number(looks);
        QVERIFY2(!results.empty(), where.constData());
        for (const EngineResult& result : results)
            QVERIFY2(!result.error || isLoss(result), where.constData());
        const auto step = std::find_if(results.rbegin(), results.rend(),
            [](const EngineResult& result) { return result.ticket != 0; });
        QVERIFY2(step != results.rend(), where.constData());
        if (isLoss(*step)) {
            ++undone;
            QVERIFY2(step->changes.empty(), where.constData());
        } else {
            QVERIFY2(same(step->changes, expected), where.constData()); // it was done before
        }
        if (losing.lost() == 0)
            continue; // how often is looked varies a little
        // Nothing works any more, and why is said each time.
        gpu.engine().submit(ReadBricks{{{Field::Labels, 0, 0}}});
        QVERIFY2(isLoss(test::lastResult(gpu.engine())), where.constData());
        const LoadedVolume study = test::smallStudy();
        const auto opened = gpu.engine().openVolume(study.volume.geometry.size, study.codes);
        QVERIFY2(!opened && opened.error().code == ErrorCode::ContextLost, where.constData());
    }
    QVERIFY(undone > 0);
    qInfo("%d of %d losses in %d looks undid the step", undone, tried, looks);
}

/// A growth that runs at its pace, and nobody submits anything.
void ContextLossGlTest::isToldToWhoAsksNothing()
{
    test::EditEngineFixture gpu;
    QVERIFY2(gpu.isReady(), gpu.why());
    Stage stage(gpu.engine(), Kind::Grow);
    QVERIFY(stage.isOpen());
    gpu.engine().submit(BeginEdit{burst()});
    gpu.engine().submit(ExtendEdit{GrowAdvance{.generationsPerSecond = 2.0}});
    QTRY_VERIFY_WITH_TIMEOUT(gpu.engine().growthProgress().generation >= 1, 60000);
    const LosingGl losing(1);
    std::vector<EngineResult> results;
    const auto told = [&] {
        results = gpu.engine().collect(); // each is handed out once
        return !results.empty();
    };
    QVERIFY(QTest::qWaitFor(told, 60000));
    QCOMPARE(losing.lost(), 1);
    QCOMPARE(results.size(), std::size_t(1));
    QCOMPARE(results[0].ticket, Ticket(0));
    QVERIFY(isLoss(results[0]));
    QVERIFY(!gpu.engine().growthProgress().open);
    // The end that it would have had.
    gpu.engine().submit(EndEdit{Ending::Commit});
    const EngineResult ended = test::lastResult(gpu.engine());
    QVERIFY(isLoss(ended));
    QVERIFY(ended.changes.empty());
}

void ContextLossGlTest::anotherEngineGoesOn()
{
    const auto made = gpu::GpuEngine::create();
    QVERIFY(made);
    gpu::GpuEngine& engine = **made;
    const LoadedVolume study = test::smallStudy();
    const VolumeGeometry& geometry = study.volume.geometry;
    Pictures pictures(engine.frames());

    engine.setVolumeGeometry(geometry, study.volume.encoding);
    std::vector<BrickChange> expected;
    gpu::Frame picture;
    {
        Stage stage(engine.edits(), Kind::Grow);
        expected = stage.act().back().changes;
        picture = pictures.ask(geometry);
        QVERIFY(picture.rgba);
        QVERIFY(!engine.isContextLost());
    }
    const LosingGl losing(1);
    Stage stage(engine.edits(), Kind::Grow);
    QVERIFY(!stage.isOpen());
    const gpu::Frame refused = pictures.ask(geometry);
    QVERIFY(refused.failure && refused.failure->code == ErrorCode::ContextLost);
    QVERIFY(engine.isContextLost());
    QCOMPARE(losing.lost(), 1);

    QVERIFY(engine.renew());
    QVERIFY(!engine.isContextLost());
    engine.setVolumeGeometry(geometry, study.volume.encoding);
    Stage again(engine.edits(), Kind::Grow);
    QVERIFY(again.isOpen());
    const std::vector<EngineResult> results = again.act();
    QVERIFY(!results.empty() && !results.back().error);
    QVERIFY(same(results.back().changes, expected));
    const gpu::Frame drawn = pictures.ask(geometry);
    QVERIFY(drawn.rgba && *drawn.rgba == *picture.rgba);
}

void ContextLossGlTest::whileAVolumeOpens()
{
    const LoadedVolume study = test::smallStudy();
    int looks = 0;
    {
        test::EditEngineFixture gpu;
        QVERIFY2(gpu.isReady(), gpu.why());
        const LosingGl counting(0);
        QVERIFY(gpu.engine().openVolume(study.volume.geometry.size, study.codes));
        looks = counting.looks();
    }
    QVERIFY(looks >= 4);
    for (const int first : {1, looks / 2}) {
        test::EditEngineFixture gpu;
        QVERIFY2(gpu.isReady(), gpu.why());
        const LosingGl losing(first);
        const auto opened = gpu.engine().openVolume(study.volume.geometry.size, study.codes);
        QCOMPARE(losing.lost(), 1);
        QVERIFY(!opened);
        QCOMPARE(opened.error().code, ErrorCode::ContextLost); // and not OutOfMemory
    }
}

BURIN_TEST(ContextLossGlTest)

} // namespace contextLossGlTest

#include "ContextLossGlTest.moc"
