// SPDX-License-Identifier: Apache-2.0
#include "core/base/MemoryReserve.h"
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
#include "tests/support/fixtures/WorkTest.h"
#include "tests/support/program/Sanitizer.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/CutEdits.h"
#include "tests/support/scenes/GradedBall.h"
#include "tests/support/scenes/PlainEdits.h"

#include <QtTest>

#include <cstdlib>
#include <functional>
#include <new>
#include <vector>

namespace workOfStepsGlTest {

// This program's operator new counts what our own code allocates in large pieces.

extern "C" {
extern char __executable_start;
extern char etext;
}

// The address sanitizer has its own, which these would replace for all tests of the program.
#if !__has_feature(address_sanitizer)

namespace {

void* allocated(std::size_t bytes, const void* caller)
{
    using Large = test::LargeAllocations;
    if (Large::counting && bytes >= Large::leastCounted && caller >= &__executable_start
        && caller < &etext) {
        ++Large::count;
        Large::bytes += std::int64_t(bytes);
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

#endif

using namespace core;
using test::CountedSession;
using Ball = test::GradedBall;

/// What a step of the hand costs does not depend on how large the volume is: it is counted in calls
/// and bytes, in a small volume and in a large one that hold the same; and in the small one it is
/// not more than was recorded. Who needs more records it, and says why in the commit.
class WorkOfStepsGlTest : public test::WorkTest {
    Q_OBJECT

public:
    WorkOfStepsGlTest()
        : WorkTest(QStringLiteral("steps"))
    {
    }

private:
    void prepare(CountedSession& counts) override;
    void takeSteps(CountedSession& counts, int round) override;
    [[nodiscard]] test::MoreWork allowed(const QByteArray& step) const override;
};

void WorkOfStepsGlTest::prepare(CountedSession& counts)
{
    counts.prepare(test::newSegment(QStringLiteral("A")));
}

void WorkOfStepsGlTest::takeSteps(CountedSession& counts, int round)
{
    EditSession& known = counts.session();
    const auto step = [&](const char* name, const std::function<bool()>& taken) {
        counts.step(name, taken);
    };
    const auto apply = [&](const Edit& edit) { return bool(known.apply(edit)); };
    const auto penAt = [](double x) {
        return test::CutWords{.view = Ball::front(),
            .radiusMm = 4.0,
            .depthMm = 5.0,
            .surfaceThreshold = Ball::threshold,
            .samples = std::vector<PenSample>{{.xMm = x, .yMm = 0.3, .pressure = 0.7},
                {.xMm = x + 2.0, .yMm = 1.7, .pressure = 1.0, .tSeconds = 0.1}}};
    };
    const glm::dvec3 middle = Ball::middle;
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
            Ball::squareAround({0.0, 12.0}, 4.0)));
    });
    step("scissors", [&] {
        return apply(ScissorsCut{.view = Ball::front(),
            .polygonMm = Ball::squareAround({10.0, -11.0}, 3.0),
            .depthMm = 4.0,
            .surfaceThreshold = Ball::threshold});
    });
    step("outline", [&] {
        return apply(FillOutline{.segment = 1,
            .originLps = middle - glm::dvec3(0.0, 0.0, 10.0),
            .polygonMm = Ball::squareAround({0.0, 0.0}, 6.0)});
    });
    step("paint along edges", [&] {
        return apply(test::paintAlongEdgesAt(1, {middle + glm::dvec3(14.0, 0.0, 0.0)}, 4.0, 60.0));
    });

    // Parts of steps: what one event of a slider costs.
    counts.prepare(test::growBetween(500.0, 2000.0, 12));
    counts.tell([&] { counts.begin(ShrinkSteps{.steps = 0}); });
    counts.event("scrub of a growth", [&] { known.extend(ToSteps{3}); });
    counts.end(Ending::Rollback);
    ChangeInterval change;
    change.criteria.lower = 600.0;
    change.criteria.upper = 2000.0;
    counts.tell([&] {
        counts.begin(change);
        known.extend(GrowAdvance{.steps = 1});
    });
    const auto interval = [&known](double lower) {
        known.extend(ToInterval{.lower = lower, .upper = 2000.0});
        known.extend(GrowAdvance{.steps = 1});
    };
    const auto told = [&](double lower) {
        counts.tell([&] { interval(lower); });
        gpu().rest();
    };
    // Once before it counts: the memory of bricks doubles when it is full, however large a volume.
    told(Ball::valueAt(11.0));
    told(600.0);
    counts.event("narrower interval", [&] { interval(Ball::valueAt(11.0)); });
    counts.event("wider interval", [&] { interval(600.0); });
    told(Ball::valueAt(11.0));
    counts.end(Ending::Commit);
    if (!known.history().rows().back().edit.is<ChangeInterval>())
        qWarning("the interval took nothing away");
    step("cut of a growth", [&] {
        return apply(
            ShrinkAt{.pointsLps = {middle - glm::dvec3(aside) + glm::dvec3(6.0, 0.0, 0.0)}});
    });

    counts.prepare(DivideSegment{.segment = 1, .marginMm = 6.0});
    gpu().awaitChunks(known);
    step("chunk", [&] {
        return apply(ChunkToggle{
            .segment = 1, .chunks = 6, .pointsLps = {middle + glm::dvec3(10.0, 4.0, 0.0)}});
    });
    step("undo of a chunk", [&] { return bool(known.undo()); });
}

test::MoreWork WorkOfStepsGlTest::allowed(const QByteArray& /*step*/) const
{
    return test::MoreWork{.tables = true};
}

BURIN_TEST(WorkOfStepsGlTest)

} // namespace workOfStepsGlTest

#include "WorkOfStepsGlTest.moc"
