// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/chunks/DivideSegment.h"
#include "core/edits/kinds/criteria/GrowCriteria.h"
#include "core/edits/kinds/growth/GrowFromSeeds.h"
#include "core/edits/kinds/growth/PlugLeak.h"
#include "core/edits/kinds/growth/ResumeGrowth.h"
#include "core/session/EditSession.h"
#include "core/session/SessionChunks.h"
#include "tests/support/fixtures/WorkTest.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/GradedBall.h"
#include "tests/support/scenes/PlainEdits.h"

#include <QtTest>

#include <optional>
#include <vector>

namespace workOfGrowthGlTest {

using namespace core;
using test::CountedSession;
using Ball = test::GradedBall;

namespace {

constexpr int organ = 1;
constexpr int wall = 2; ///< with a narrow hole, through which the growth leaks
constexpr int left = 3;
constexpr int right = 4;

/// A growth of all of the ball that it reaches.
Edit growth(std::optional<int> steps, int connectivity)
{
    return test::growBy({.lower = Ball::threshold,
                            .upper = Ball::valueAt(0.0),
                            .connectivity = connectivity,
                            .segments = std::vector<int>{organ}},
        steps);
}

} // namespace

/// What it costs to resume a growth, to plug its leak, to share voxels out among seeds and to
/// divide a segment into chunks, counted as by WorkOfStepsGlTest.
class WorkOfGrowthGlTest : public test::WorkTest {
    Q_OBJECT

public:
    WorkOfGrowthGlTest()
        : WorkTest(QStringLiteral("growth"))
    {
    }

private:
    void prepare(CountedSession& counts) override;
    void takeSteps(CountedSession& counts, int round) override;
    [[nodiscard]] test::MoreWork allowed(const QByteArray& step) const override;
    static void divide(CountedSession& counts);
    static void shareOut(CountedSession& counts);
    static void leak(CountedSession& counts);
};

void WorkOfGrowthGlTest::prepare(CountedSession& counts)
{
    for (const char* name : {"Organ", "Wall", "Left", "Right"})
        counts.prepare(test::newSegment(QLatin1String(name)));
    const glm::dvec3 door = Ball::at(2.0, 0.0, 0.0);
    counts.prepare(test::paintDiscAt(wall, door, {1.0, 0.0, 0.0}, Ball::radius + 3.0));
    counts.prepare(test::eraseAt(wall, {door}, 2.5));
}

/// What lies around the segment, and then the chunks, which are worked out on a thread of their
/// own.
void WorkOfGrowthGlTest::divide(CountedSession& counts)
{
    SessionChunks& chunks = counts.session().chunks();
    counts.prepare(test::paintAt(left, {Ball::at(-6.0, -10.0, -6.0)}, 4.0));
    counts.step("division", DivideSegment{.segment = left, .marginMm = 3.0});
    counts.work(
        "chunks of a division", [&] { static_cast<void>(chunks.map()); },
        [&] { return chunks.map() || chunks.whyNot(); });
    if (!chunks.map())
        qWarning("there are no chunks");
}

/// In a single brick: with several, how often each of them is visited is a matter of chance.
void WorkOfGrowthGlTest::shareOut(CountedSession& counts)
{
    const glm::dvec3 corner(5.0 * BrickGrid::side);
    const glm::dvec3 opposite = corner + double(BrickGrid::side - 1);
    counts.prepare(test::paintSeedsAt(left, {corner + 3.0}, 1.5));
    counts.prepare(test::paintSeedsAt(right, {opposite - 3.0}, 1.5));
    counts.step("growing from seeds",
        GrowFromSeeds{.segments = std::vector<int>{left, right},
            .box = GrowBox{.fromLps = corner, .toLps = opposite}});
}

void WorkOfGrowthGlTest::leak(CountedSession& counts)
{
    counts.prepare(test::seedAt(organ, {Ball::at(-8.0, 0.0, 0.0)}));
    counts.prepare(growth(4, 6));
    counts.step("resuming a growth", ResumeGrowth{.steps = 2});
    // Over corners too, it comes to all of the hole in the same generation.
    counts.prepare(growth(std::nullopt, 26));
    counts.step("plug of a leak", PlugLeak{.pointLps = Ball::at(14.0, 0.0, 0.0)});
    counts.step("undo of a plug", [&] { return bool(counts.session().undo()); });
}

void WorkOfGrowthGlTest::takeSteps(CountedSession& counts, int /*round*/)
{
    divide(counts);
    shareOut(counts);
    leak(counts);
}

test::MoreWork WorkOfGrowthGlTest::allowed(const QByteArray& step) const
{
    if (step == "division") // the segment lies in two portions
        return onAll(2);
    // The rest is told bricks, or looks for those that hold something. Chunks know their box alone.
    return test::MoreWork{.tables = step != "chunks of a division"};
}

BURIN_TEST(WorkOfGrowthGlTest)

} // namespace workOfGrowthGlTest

#include "WorkOfGrowthGlTest.moc"
