// SPDX-License-Identifier: Apache-2.0
#include "core/base/MemoryReserve.h"
#include "core/brick/BrickGrid.h"
#include "core/edits/kinds/Edit.h"
#include "core/edits/kinds/chunks/ChunkToggle.h"
#include "core/edits/kinds/chunks/DivideSegment.h"
#include "core/edits/kinds/growth/BarrierStroke.h"
#include "core/edits/kinds/growth/ChangeInterval.h"
#include "core/edits/kinds/growth/ShrinkAt.h"
#include "core/edits/kinds/growth/ShrinkSteps.h"
#include "core/edits/kinds/sculpt/ScissorsCut.h"
#include "core/edits/kinds/segments/FillOutline.h"
#include "core/session/EditSession.h"
#include "core/session/SessionChunks.h"
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

#include <atomic>
#include <cstdlib>
#include <functional>
#include <new>
#include <vector>

namespace workOfStepsGlTest {

// This program's operator new counts what our own code allocates (not libraries, among them the
// driver) in large pieces.

extern "C" {
extern char __executable_start;
extern char etext;
}

namespace {

constexpr std::size_t leastCounted = 65536;

std::atomic<bool> counting = false;
std::atomic<std::int64_t> allocations = 0;
std::atomic<std::int64_t> bytesAllocated = 0;

void* allocated(std::size_t bytes, const void* caller)
{
    if (counting && bytes >= leastCounted && caller >= &__executable_start && caller < &etext) {
        ++allocations;
        bytesAllocated += std::int64_t(bytes);
    }
    if (void* place = std::malloc(bytes > 0 ? bytes : 1))
        return place;
    throw core::MemoryRefused(bytes);
}

} // namespace

} // namespace workOfStepsGlTest

void* operator new(std::size_t bytes)
{
    return workOfStepsGlTest::allocated(bytes, __builtin_return_address(0));
}

void* operator new[](std::size_t bytes)
{
    return workOfStepsGlTest::allocated(bytes, __builtin_return_address(0));
}

void operator delete(void* place) noexcept
{
    std::free(place);
}

void operator delete(void* place, std::size_t) noexcept
{
    std::free(place);
}

void operator delete[](void* place) noexcept
{
    std::free(place);
}

void operator delete[](void* place, std::size_t) noexcept
{
    std::free(place);
}

namespace workOfStepsGlTest {

using namespace core;
using test::GlWork;
using Ball = test::GradedBall;

namespace {

struct Counted {
    QByteArray name;
    GlWork work;
    int bricks = 0; ///< that the step changed; 0: it is a part of a step
    std::int64_t allocations = 0; ///< of at least 64 KiB
    std::int64_t bytesAllocated = 0; ///< by them
};

constexpr int smallSide = 128;

int longSide()
{
    return test::longRun() ? 512 : 192;
}

/// A square in the front view's plane.
std::vector<glm::dvec2> squareAround(const glm::dvec2& place, double halfMm)
{
    return {place + glm::dvec2(-halfMm, -halfMm), place + glm::dvec2(halfMm, -halfMm),
        place + glm::dvec2(halfMm, halfMm), place + glm::dvec2(-halfMm, halfMm)};
}

std::vector<test::CountedStep> recordable(const std::vector<Counted>& steps)
{
    std::vector<test::CountedStep> all;
    for (const Counted& step : steps)
        all.push_back({step.name,
            {{"bricks", step.bricks}, {"dispatches", step.work.dispatches},
                {"groups", step.work.groups}, {"bytes up", step.work.bytesUp},
                {"bytes down", step.work.bytesDown}, {"bytes within", step.work.bytesWithin},
                {"large allocations", step.allocations}, {"bytes in them", step.bytesAllocated}}});
    return all;
}

} // namespace

/// What a step of the hand costs does not depend on how large the volume is: it is counted in calls
/// and bytes, in a small volume and in a large one that hold the same; and in the small one it is
/// not more than was recorded. Who needs more records it, and says why in the commit.
class WorkOfStepsGlTest : public QObject {
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

std::vector<Counted> WorkOfStepsGlTest::stepsIn(int side)
{
    std::vector<Counted> all;
    const auto session = EditSession::create(m_gpu.engine(), Ball::in(side), {});
    if (!session)
        return all;
    EditSession& known = **session;
    test::WorkOfGl work;
    const auto count = [&](const char* name, const std::function<bool()>& taken, bool whole) {
        m_gpu.rest();
        static_cast<void>(work.take());
        allocations = 0;
        bytesAllocated = 0;
        counting = true;
        bool done = false;
        m_gpu.doInTurn(known, [&] { done = taken(); });
        if (whole) // and its difference is there
            done = done && known.settle();
        counting = false;
        all.push_back({name, work.take(), 0, allocations, bytesAllocated});
        if (!done)
            qWarning("%s failed", name);
    };
    const auto step = [&](const char* name, const std::function<bool()>& taken) {
        count(name, taken, true);
        all.back().bricks = known.history().rows().back().statistics.bricks;
    };
    const auto event = [&](const char* name, const std::function<void()>& told) {
        const auto taken = [&] {
            told();
            return known.transactionOpen();
        };
        count(name, taken, false);
    };
    const auto begin = [&](const Edit& edit) {
        if (!known.begin(edit))
            qWarning("an edit did not begin");
    };
    const auto end = [&](Ending ending) {
        m_gpu.doInTurn(known, [&] { known.end(ending); });
        if (!known.settle())
            qWarning("an edit did not end");
    };
    const auto apply = [&](const Edit& edit) { return bool(known.apply(edit)); };
    const auto prepare = [&](const Edit& edit) {
        bool done = false;
        m_gpu.doInTurn(known, [&] { done = bool(known.apply(edit)); });
        if (!done || !known.settle())
            qWarning("what steps need is not there");
    };
    const auto penAt = [](double x) {
        return test::CutWords{.view = Ball::front(),
            .radiusMm = 4.0,
            .depthMm = 5.0,
            .surfaceThreshold = Ball::threshold,
            .samples = std::vector<PenSample>{{.xMm = x, .yMm = 0.3, .pressure = 0.7},
                {.xMm = x + 2.0, .yMm = 1.7, .pressure = 1.0, .tSeconds = 0.1}}};
    };
    const glm::dvec3 middle = Ball::middle;
    prepare(test::newSegment(QStringLiteral("A")));
    const RowId beginning = known.history().position();
    for (int round = 0; round < 2; ++round) {
        all.clear();
        const double aside = round * 6.0;
        step("paint", [&] { return apply(test::paintAt(1, {middle + glm::dvec3(aside)}, 4.0)); });
        step("undo of paint", [&] { return bool(known.undo()); });
        step("redo of paint", [&] { return bool(known.redo()); });
        step("erase", [&] { return apply(test::eraseAt(1, {middle + glm::dvec3(aside)}, 3.0)); });
        step("drill", [&] { return apply(test::drillWith(penAt(aside))); });
        step("undo of drill", [&] { return bool(known.undo()); });
        step("redo of drill", [&] { return bool(known.redo()); });
        step("laser", [&] { return apply(test::laserWith(penAt(-aside - 4.0))); });
        step("carve", [&] { return apply(test::carveAt({middle - glm::dvec3(aside)}, 4.0)); });
        step("seeds", [&] { return apply(test::seedAt(1, {middle - glm::dvec3(aside)})); });
        step("grow", [&] { return apply(test::growBetween(500.0, 2000.0, 5)); });
        step("shrink", [&] { return apply(ShrinkSteps{.steps = 3}); });
        step("undo of shrink", [&] { return bool(known.undo()); });

        step("barrier", [&] {
            return apply(BarrierStroke{
                .path = {.radiusMm = 2.0, .pointsLps = {middle + glm::dvec3(0.0, 0.0, 18.0)}}});
        });
        step("peel", [&] {
            return apply(test::peelWith(
                {.view = Ball::front(), .depthMm = 3.0, .surfaceThreshold = Ball::threshold},
                squareAround({0.0, 12.0}, 4.0)));
        });
        step("scissors", [&] {
            return apply(ScissorsCut{.view = Ball::front(),
                .polygonMm = squareAround({10.0, -11.0}, 3.0),
                .depthMm = 4.0,
                .surfaceThreshold = Ball::threshold});
        });
        step("outline", [&] {
            return apply(FillOutline{.segment = 1,
                .originLps = middle - glm::dvec3(0.0, 0.0, 10.0),
                .polygonMm = squareAround({0.0, 0.0}, 6.0)});
        });
        step("paint along edges", [&] {
            return apply(
                test::paintAlongEdgesAt(1, {middle + glm::dvec3(14.0, 0.0, 0.0)}, 4.0, 60.0));
        });

        // Parts of steps: what one event of a slider costs.
        prepare(test::growBetween(500.0, 2000.0, 12));
        m_gpu.doInTurn(known, [&] { begin(ShrinkSteps{.steps = 0}); });
        event("scrub of a growth", [&] { known.extend(ToSteps{3}); });
        end(Ending::Rollback);
        ChangeInterval change;
        change.criteria.lower = 600.0;
        change.criteria.upper = 2000.0;
        m_gpu.doInTurn(known, [&] {
            begin(change);
            known.extend(GrowAdvance{.steps = 1});
        });
        const auto interval = [&known](double lower) {
            known.extend(ToInterval{.lower = lower, .upper = 2000.0});
            known.extend(GrowAdvance{.steps = 1});
        };
        const auto told = [&](double lower) {
            m_gpu.doInTurn(known, [&] { interval(lower); });
            m_gpu.rest();
        };
        // Once before it counts: the memory of bricks doubles when it is full, however large a
        // volume.
        told(Ball::valueAt(11.0));
        told(600.0);
        event("narrower interval", [&] { interval(Ball::valueAt(11.0)); });
        event("wider interval", [&] { interval(600.0); });
        told(Ball::valueAt(11.0));
        end(Ending::Commit);
        if (!known.history().rows().back().edit.is<ChangeInterval>())
            qWarning("the interval took nothing away");
        step("cut of a growth", [&] {
            return apply(
                ShrinkAt{.pointsLps = {middle - glm::dvec3(aside) + glm::dvec3(6.0, 0.0, 0.0)}});
        });

        prepare(DivideSegment{.segment = 1, .marginMm = 6.0});
        while (!known.chunks().map() && !known.chunks().whyNot()) {
            m_gpu.engine().finish();
            known.poll();
            QThread::msleep(1);
        }
        step("chunk", [&] {
            return apply(ChunkToggle{
                .segment = 1, .chunks = 6, .pointsLps = {middle + glm::dvec3(10.0, 4.0, 0.0)}});
        });
        step("undo of a chunk", [&] { return bool(known.undo()); });
        step("back through the history", [&] { return bool(known.goTo(beginning)); });
    }
    return all;
}

void WorkOfStepsGlTest::doesNotGrowWithTheVolume()
{
    const std::vector<Counted> small = stepsIn(smallSide);
    QVERIFY(!small.empty());
    // What an interval asks of the driver depends on where it computes.
    QStringList wrong;
    if (m_gpu.rendererName().contains("llvmpipe"))
        wrong = test::grownSinceRecorded(QStringLiteral("steps.txt"), recordable(small));
    const std::vector<Counted> large = stepsIn(longSide());
    QCOMPARE(large.size(), small.size());
    // Tables of a few words for each brick are written and read whole, some of them by each of the
    // steps that go back through the history, and there are some in memory; voxels of a brick are
    // 4096.
    constexpr int tableBytes = 48;
    constexpr int memoryBytes = 64;
    const auto bricksOf = [](int side) { return BrickGrid{glm::ivec3(side)}.brickCount(); };
    const std::int64_t moreBricks = bricksOf(longSide()) - bricksOf(smallSide);
    for (std::size_t i = 0; i < small.size(); ++i) {
        const GlWork& a = small[i].work;
        const GlWork& b = large[i].work;
        const char* name = small[i].name.constData();
        for (const Counted& step : {small[i], large[i]})
            qInfo("%-24s %3d bricks, %3d dispatches of %4lld groups, up %6lld, down %6lld, within "
                  "%6lld, made %7lld bytes, %2lld large allocations of %7lld bytes",
                name, step.bricks, step.work.dispatches, qlonglong(step.work.groups),
                qlonglong(step.work.bytesUp), qlonglong(step.work.bytesDown),
                qlonglong(step.work.bytesWithin), qlonglong(step.work.bytesMade),
                qlonglong(step.allocations), qlonglong(step.bytesAllocated));
        const auto demand = [&](const char* what, std::int64_t found, std::int64_t most) {
            if (found > most)
                wrong += QStringLiteral("%1 in the large volume: %2 %3, at most %4 are right")
                             .arg(QLatin1String(name))
                             .arg(qlonglong(found))
                             .arg(QLatin1String(what))
                             .arg(qlonglong(most));
        };
        const std::int64_t more = tableBytes * moreBricks;
        // A front that is wide is held as bits of the whole volume (FrontBits), three a voxel.
        const std::int64_t frontBits =
            small[i].name == "wider interval" ? 1600 * moreBricks : std::int64_t(0);
        if (large[i].bricks != small[i].bricks)
            wrong += QStringLiteral("%1: %2 bricks in the large volume, %3 in the small one")
                         .arg(QLatin1String(name))
                         .arg(large[i].bricks)
                         .arg(small[i].bricks);
        demand("dispatches", b.dispatches, a.dispatches);
        demand("groups", b.groups, a.groups);
        demand("bytes up", b.bytesUp, a.bytesUp + more);
        demand("bytes down", b.bytesDown, a.bytesDown + more);
        demand("bytes within", b.bytesWithin, a.bytesWithin + more + frontBits);
        demand("bytes made", b.bytesMade, a.bytesMade + more + frontBits);
        demand("bytes allocated", large[i].bytesAllocated,
            small[i].bytesAllocated + memoryBytes * moreBricks);
    }
    QVERIFY2(wrong.isEmpty(), qPrintable(wrong.join(QLatin1Char('\n'))));
}

BURIN_TEST(WorkOfStepsGlTest)

} // namespace workOfStepsGlTest

#include "WorkOfStepsGlTest.moc"
