// SPDX-License-Identifier: Apache-2.0
#include "core/brick/BrickGrid.h"
#include "core/edits/kinds/Edit.h"
#include "core/edits/kinds/chunks/ChunkToggle.h"
#include "core/edits/kinds/chunks/DivideSegment.h"
#include "core/edits/kinds/growth/ChangeInterval.h"
#include "core/edits/kinds/growth/ShrinkSteps.h"
#include "core/session/EditSession.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/faults/WorkOfGl.h"
#include "tests/support/fixtures/EditEngineFixture.h"
#include "tests/support/program/LongRun.h"
#include "tests/support/program/RecordedWork.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/CutEdits.h"
#include "tests/support/scenes/GradedBall.h"
#include "tests/support/scenes/PlainEdits.h"

#include <QtTest>

#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

namespace workOfPicturesGlTest {

using namespace core;
using test::GlWork;
using Ball = test::GradedBall;

namespace {

struct Counted {
    QByteArray name;
    GlWork work;
    gpu::FrameScheduler::Counters drawn;
};

constexpr int smallSide = 128;
constexpr gpu::ViewId stage = 1; ///< the 3D view
constexpr gpu::ViewId firstSlice = 2;

int longSide()
{
    return test::longRun() ? 512 : 192;
}

gpu::SegmentDisplay shownSegments()
{
    gpu::SegmentDisplay display;
    display.visible[1] = true;
    display.rgb[1] = 0x59C07A;
    return display;
}

/// A coarse picture of it is asked for as long as something moves.
gpu::FrameRequest stageAt(double degrees, bool moving)
{
    const double angle = degrees * std::numbers::pi / 180.0;
    gpu::VolumeScene scene;
    scene.targetLps = Ball::middle;
    scene.eyeLps = Ball::middle + 200.0 * glm::dvec3(std::sin(angle), -std::cos(angle), 0.0);
    scene.heightMm = 80.0;
    scene.surfaceThreshold = Ball::threshold;
    return {.view = stage,
        .sizePixels = {360, 280},
        .scene = scene,
        .segments = shownSegments(),
        .interacting = moving,
        .single = true};
}

/// Along x, y or z.
gpu::FrameRequest sliceAt(int axis, double offMiddle)
{
    glm::dvec3 centre = Ball::middle;
    centre[axis] += offMiddle;
    gpu::SliceScene scene;
    scene.centreLps = centre;
    scene.rightLps = axis == 0 ? glm::dvec3(0.0, 1.0, 0.0) : glm::dvec3(1.0, 0.0, 0.0);
    scene.downLps = axis == 2 ? glm::dvec3(0.0, 1.0, 0.0) : glm::dvec3(0.0, 0.0, -1.0);
    scene.mmPerPixel = 0.4;
    scene.window = {1000.0, 1000.0};
    return {.view = firstSlice + axis,
        .sizePixels = {200, 200},
        .scene = scene,
        .segments = shownSegments()};
}

std::vector<test::CountedStep> recordable(const std::vector<Counted>& steps)
{
    std::vector<test::CountedStep> all;
    for (const Counted& step : steps)
        all.push_back({step.name,
            {{"pictures", step.drawn.frames}, {"tiles", step.drawn.tiles},
                {"draws", step.work.draws}, {"pixels", step.work.pixels},
                {"dispatches", step.work.dispatches}, {"groups", step.work.groups},
                {"bytes up", step.work.bytesUp}, {"bytes down", step.work.bytesDown},
                {"bytes within", step.work.bytesWithin}}});
    return all;
}

} // namespace

/// What the pictures of a 3D view and of three slices cost, and those that follow from a step of
/// the hand together with it: as many rays, uploads and kernels in a large volume as in a small one
/// that hold the same, and in the small one not more than was recorded.
class WorkOfPicturesGlTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { QVERIFY2(m_gpu.isReady(), m_gpu.why()); }
    void init() { test::failOnUnexpectedMessages(); }
    void cleanup() { QCOMPARE(m_gpu.newErrors(), 0); }
    void doesNotGrowWithTheVolume();

private:
    /// The steps, each for the second time: the first one makes programs and buffers.
    std::vector<Counted> stepsIn(int side);

    test::EditEngineFixture m_gpu;
};

std::vector<Counted> WorkOfPicturesGlTest::stepsIn(int side)
{
    std::vector<Counted> all;
    const LoadedVolume study = Ball::in(side);
    const auto session = EditSession::create(m_gpu.engine(), study, {});
    if (!session)
        return all;
    EditSession& known = **session;
    m_gpu.place(study.volume);
    test::WorkOfGl work;
    const auto require = [](const Result<void>& done) {
        if (!done)
            qWarning("a step was refused");
    };
    const auto settle = [&] { require(known.settle()); };
    const auto step = [&](const char* name, const std::function<void()>& taken) {
        m_gpu.rest();
        static_cast<void>(work.take());
        m_gpu.doInTurn(known, taken);
        const gpu::FrameScheduler::Counters drawn = m_gpu.draw();
        all.push_back({name, work.take(), drawn});
        if (!known.transactionOpen()) // or it would end
            settle();
    };
    // Then the pictures are those of before the step.
    const auto look = [&] { static_cast<void>(m_gpu.draw()); };
    const auto prepare = [&](const Edit& edit) {
        m_gpu.doInTurn(known, [&] { require(known.apply(edit)); });
        settle();
    };
    const auto end = [&](Ending ending) {
        m_gpu.doInTurn(known, [&] { known.end(ending); });
        settle();
    };
    for (int axis = 0; axis < 3; ++axis)
        m_gpu.request(sliceAt(axis, 0.0));
    m_gpu.request(stageAt(0.0, true));
    look();
    prepare(test::newSegment(QStringLiteral("A")));
    const RowId beginning = known.history().position();
    for (int round = 0; round < 2; ++round) {
        all.clear();
        const double degrees = 10.0 + 10.0 * round;
        step("moving picture", [&] { m_gpu.request(stageAt(degrees, true)); });
        step("settled picture", [&] { m_gpu.request(stageAt(degrees, false)); });
        step("next slice", [&] { m_gpu.request(sliceAt(2, 1.0 + round)); });

        const Edit drill = test::drillWith({.view = Ball::front(),
            .radiusMm = 4.0,
            .depthMm = 5.0,
            .surfaceThreshold = Ball::threshold,
            .samples = std::vector<PenSample>{{.xMm = 3.0, .yMm = 0.3, .pressure = 0.7},
                {.xMm = 5.0, .yMm = 1.7, .pressure = 1.0, .tSeconds = 0.1}}});
        const std::vector<PenSample> pen = test::factsOfStroke(drill).samples;
        // All that follows is done while something moves: to settle costs what it cost above.
        m_gpu.request(stageAt(degrees, true));
        look();
        m_gpu.doInTurn(known, [&] {
            require(known.begin(test::begunStroke(drill)));
            known.extend(PenSamples{.samples = {pen[0]}});
        });
        look();
        step("tick of the drill", [&] { known.extend(PenSamples{.samples = {pen[1]}}); });
        end(Ending::Commit);
        look();
        step("undo of the drill", [&] { require(known.undo()); });
        step("redo of the drill", [&] { require(known.redo()); });

        prepare(test::seedAt(1, {Ball::middle}));
        look();
        m_gpu.doInTurn(known, [&] {
            require(known.begin(test::growBetween(500.0, 2000.0, 20)));
            known.extend(GrowAdvance{.steps = 6});
        });
        look();
        step("generation of a growth", [&] { known.extend(GrowAdvance{.steps = 1}); });
        end(Ending::Commit);
        look();

        m_gpu.doInTurn(known, [&] { require(known.begin(ShrinkSteps{.steps = 0})); });
        look();
        step("scrub of a growth", [&] { known.extend(ToSteps{2}); });
        end(Ending::Rollback);
        ChangeInterval change;
        change.criteria.lower = 600.0;
        change.criteria.upper = 2000.0;
        m_gpu.doInTurn(known, [&] {
            require(known.begin(change));
            known.extend(GrowAdvance{.steps = 1});
        });
        look();
        step("event of the interval", [&] {
            known.extend(ToInterval{.lower = Ball::valueAt(5.0), .upper = 2000.0});
            known.extend(GrowAdvance{.steps = 1});
        });
        end(Ending::Rollback);
        look();

        prepare(DivideSegment{.segment = 1, .marginMm = 6.0});
        m_gpu.awaitChunks(known);
        look();
        step("click on a chunk", [&] {
            require(known.apply(ChunkToggle{.segment = 1,
                .chunks = 6,
                .pointsLps = {Ball::middle + glm::dvec3(10.0, 2.0, 0.0)}}));
        });
        step("undo of a chunk", [&] { require(known.undo()); });
        step("back through the history", [&] { require(known.goTo(beginning)); });
    }
    return all;
}

void WorkOfPicturesGlTest::doesNotGrowWithTheVolume()
{
    const std::vector<Counted> small = stepsIn(smallSide);
    QVERIFY(!small.empty());
    // What an interval asks of the driver depends on where it computes.
    QStringList wrong;
    if (m_gpu.rendererName().contains("llvmpipe"))
        wrong = test::grownSinceRecorded(QStringLiteral("pictures.txt"), recordable(small));
    const std::vector<Counted> large = stepsIn(longSide());
    QCOMPARE(large.size(), small.size());
    // Tables of a few words for each brick are written and read whole: the map by which rays skip
    // what is empty, pages.
    constexpr int tableBytes = 64;
    const auto bricksOf = [](int side) { return BrickGrid{glm::ivec3(side)}.brickCount(); };
    const std::int64_t more =
        std::int64_t(tableBytes) * (bricksOf(longSide()) - bricksOf(smallSide));
    for (std::size_t i = 0; i < small.size(); ++i) {
        const char* name = small[i].name.constData();
        for (const Counted& step : {small[i], large[i]})
            qInfo("%-24s %2lld pictures of %3lld tiles, %3d draws of %8lld pixels, %3d dispatches "
                  "of %4lld groups, up %6lld, down %7lld, within %6lld bytes",
                name, qlonglong(step.drawn.frames), qlonglong(step.drawn.tiles), step.work.draws,
                qlonglong(step.work.pixels), step.work.dispatches, qlonglong(step.work.groups),
                qlonglong(step.work.bytesUp), qlonglong(step.work.bytesDown),
                qlonglong(step.work.bytesWithin));
        test::TooMuch much(small[i].name, "the large volume");
        const GlWork& a = small[i].work;
        const GlWork& b = large[i].work;
        if (small[i].drawn.frames == 0)
            wrong += QStringLiteral("%1: no picture").arg(QLatin1String(name));
        much.demand("pictures", large[i].drawn.frames, small[i].drawn.frames);
        much.demand("tiles", large[i].drawn.tiles, small[i].drawn.tiles);
        much.demand("draws", b.draws, a.draws);
        much.demand("pixels", b.pixels, a.pixels);
        much.demand("dispatches", b.dispatches, a.dispatches);
        much.demand("groups", b.groups, a.groups);
        much.demand("bytes up", b.bytesUp, a.bytesUp + more);
        much.demand("bytes down", b.bytesDown, a.bytesDown + more);
        much.demand("bytes within", b.bytesWithin, a.bytesWithin + more);
        wrong += much.sentences();
    }
    QVERIFY2(wrong.isEmpty(), qPrintable(wrong.join(QLatin1Char('\n'))));
}

BURIN_TEST(WorkOfPicturesGlTest)

} // namespace workOfPicturesGlTest

#include "WorkOfPicturesGlTest.moc"
