// SPDX-License-Identifier: Apache-2.0
#include "core/session/past/RecentGrowth.h"

#include "core/edits/kinds/growth/BarrierStroke.h"
#include "core/edits/kinds/growth/ChangeInterval.h"
#include "core/edits/kinds/growth/GrowSteps.h"
#include "core/edits/kinds/growth/ResumeGrowth.h"
#include "core/edits/kinds/growth/SeedStroke.h"
#include "core/edits/kinds/segments/ChangeSegment.h"
#include "core/session/EditSession.h"
#include "core/session/questions/VoxelQuestions.h"
#include "tests/reference/ReferenceEngine.h"
#include "tests/support/cases/growth/LeakPhantoms.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/PlainEdits.h"
#include "tests/support/scenes/SmallStudy.h"

#include <QTest>

#include <algorithm>

namespace recentGrowthTest {

using namespace core;

namespace {

constexpr glm::ivec3 size{40, 6, 5};

/// A bar whose values are 0 at its left end and rise by 2 a voxel.
LoadedVolume ramp()
{
    test::Codes codes = test::constantVolume(size, 0);
    for (int z = 0; z < size.z; ++z) {
        for (int y = 0; y < size.y; ++y) {
            for (int x = 0; x < size.x; ++x)
                codes.at({x, y, z}) = std::uint16_t(2 * x);
        }
    }
    test::LeakPhantom phantom;
    phantom.codes = codes;
    return test::loadedVolume(phantom);
}

/// A session in memory with segments 1 and 2.
class Bench {
public:
    Bench()
    {
        session = *EditSession::create(engine, ramp(), {});
        run(test::addSegment("A"));
        run(test::addSegment("B"));
    }
    void run(const Edit& edit)
    {
        const Result<void> applied = session->apply(edit);
        QVERIFY2(applied, qPrintable(applied ? QString() : applied.error().arguments.join(u' ')));
        QVERIFY(session->settle());
    }
    [[nodiscard]] static SeedStroke seed(int segment, int x)
    {
        return {segment, {ramp().volume.geometry.toWorld({x, 3, 2})}};
    }
    [[nodiscard]] static Edit grow(double upper, std::optional<int> steps = {})
    {
        return test::growBetween(0.0, upper, steps);
    }
    [[nodiscard]] static ChangeInterval interval(double upper, std::optional<int> steps = {})
    {
        ChangeInterval change;
        change.criteria.upper = upper;
        change.steps = steps;
        return change;
    }
    [[nodiscard]] std::size_t rows() const { return session->history().rows().size(); }
    [[nodiscard]] QString lastName() const { return session->history().rows().back().name; }
    [[nodiscard]] std::int64_t voxels(int segment) const
    {
        const std::vector<std::uint8_t> labels = *session->questions().labels(0);
        return std::count(labels.begin(), labels.end(), std::uint8_t(segment));
    }

    reference::ReferenceEngine engine; ///< outlives the session
    std::unique_ptr<EditSession> session;
};

/// Of the bar, so many slices.
constexpr std::int64_t slices(int count)
{
    return std::int64_t(count) * size.y * size.z;
}

} // namespace

/// What a growth goes by when it goes on.
class RecentGrowthTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    /// A seed outside the interval waits: to widen it is what a user does next.
    void aSeedThatWaitsIsReachedByWidening()
    {
        Bench bench;
        bench.run(Bench::seed(1, 20));
        const std::size_t before = bench.rows();
        bench.run(Bench::grow(30.0));
        QCOMPARE(bench.rows(), before + 1);
        QCOMPARE(bench.lastName(), QStringLiteral("Grow 0 … 30, no voxel"));
        QCOMPARE(bench.voxels(1), std::int64_t(0));
        bench.run(Bench::interval(60.0));
        QCOMPARE(bench.voxels(1), slices(31));
        QVERIFY(bench.session->undo());
        QVERIFY(bench.session->undo());
        QVERIFY(bench.session->settle());
        QVERIFY(!recentCriteria(bench.session->history(), 0));
        QVERIFY(bench.session->redo());
        QVERIFY(bench.session->settle());
        QCOMPARE(recentCriteria(bench.session->history(), 0)->upper, 30.0);
    }

    /// What is shut now may be opened later: then the growth goes on by what was asked for last.
    void anIntervalThatReachesNothingYetIsKept()
    {
        Bench bench;
        bench.run(Bench::seed(1, 3));
        bench.run(Bench::grow(30.0));
        QCOMPARE(bench.voxels(1), slices(16));
        BarrierStroke wall;
        wall.path.radiusMm = 23.4; // from the right end as far as the growth
        wall.path.pointsLps = {ramp().volume.geometry.toWorld({39, 3, 2})};
        bench.run(wall);
        const std::size_t before = bench.rows();
        bench.run(Bench::interval(60.0));
        QCOMPARE(bench.rows(), before + 1);
        QCOMPARE(bench.lastName(), QStringLiteral("Interval 0 … 60, no voxel"));
        wall.erase = true;
        bench.run(wall);
        bench.run(ResumeGrowth{});
        QCOMPARE(bench.voxels(1), slices(31));
        QVERIFY(!bench.session->apply(test::revertRows({RowId(before + 1)}))
            || !bench.session->settle());
    }

    void whatChangesNothingAtAllLeavesNoRow()
    {
        Bench bench;
        bench.run(Bench::grow(30.0)); // there is no seed
        QCOMPARE(bench.rows(), std::size_t(2));
        bench.run(Bench::seed(1, 3));
        bench.run(Bench::grow(30.0));
        const std::size_t before = bench.rows();
        bench.run(Bench::grow(30.0));
        bench.run(Bench::interval(30.0));
        bench.run(ResumeGrowth{});
        QCOMPARE(bench.rows(), before);
    }

    /// Grown anew from the seeds or not, a change of interval goes on from where the growth stood.
    void stepsAfterAChangeCountFromWhatThereIs()
    {
        Bench one;
        one.run(Bench::seed(1, 10));
        one.run(Bench::grow(60.0, 6));
        one.run(Bench::interval(62.0, 2));

        Bench two;
        two.run(Bench::seed(1, 10));
        two.run(Bench::seed(2, 39)); // too bright: it waits, but it competes
        two.run(Bench::grow(60.0, 6));
        two.run(Bench::interval(62.0, 2));
        const auto& change = two.session->history().rows().back().edit.get<ChangeInterval>();
        QVERIFY(change.fromSeeds.value_or(false));
        QCOMPARE(change.steps.value_or(-1), 8);
        QVERIFY(one.voxels(1) > 0);
        QCOMPARE(two.voxels(1), one.voxels(1));
        QCOMPARE(two.session->document().growth(0)->generation, 9u);
    }

    /// Segments with intervals of their own: each grows, is changed and goes on by itself.
    void oneSegmentGrowsWhileAnotherRests()
    {
        Bench bench;
        bench.run(Bench::seed(1, 3));
        bench.run(Bench::seed(2, 30));
        GrowSteps first{.criteria = {.lower = 0.0, .upper = 18.0, .segments = std::vector<int>{1}}};
        bench.run(first);
        QCOMPARE(bench.voxels(1), slices(10));
        QCOMPARE(bench.voxels(2), std::int64_t(0));
        GrowSteps second{
            .criteria = {.lower = 50.0, .upper = 100.0, .segments = std::vector<int>{2}}};
        bench.run(second);
        QCOMPARE(bench.voxels(1), slices(10));
        QCOMPARE(bench.voxels(2), slices(15));
        // The change is that of the last growth's segment; it need not begin at the seeds.
        bench.run(ChangeInterval{.criteria = {.lower = 56.0, .upper = 100.0}});
        QCOMPARE(bench.voxels(1), slices(10));
        QCOMPARE(bench.voxels(2), slices(12));
        const auto& change = bench.session->history().rows().back().edit.get<ChangeInterval>();
        QCOMPARE(change.fromSeeds, std::optional(false));
        QCOMPARE(change.criteria.segments, std::optional(std::vector<int>{2}));
        for (int undo = 0; undo < 3; ++undo)
            QVERIFY(bench.session->undo());
        QVERIFY(bench.session->settle());
        QCOMPARE(bench.voxels(1), std::int64_t(0));
    }

    /// Who is gone or locked by now rests; the others go on.
    void goingOnWithoutThoseThatAreGone()
    {
        Bench bench;
        bench.run(Bench::seed(1, 3));
        bench.run(Bench::seed(2, 30));
        GrowSteps both{
            .criteria = {.lower = 0.0, .upper = 100.0, .segments = std::vector<int>{1, 2}}};
        both.steps = 2;
        bench.run(both);
        const std::int64_t first = bench.voxels(1);
        const std::int64_t second = bench.voxels(2);
        bench.run(ChangeSegment{.segment = 2, .locked = true});
        bench.run(ResumeGrowth{.steps = 1});
        QVERIFY(bench.voxels(1) > first);
        QCOMPARE(bench.voxels(2), second);
        const auto& resumed = bench.session->history().rows().back().edit.get<GrowSteps>();
        QCOMPARE(resumed.criteria.segments, std::optional(std::vector<int>{1}));
        // With nobody left it says why.
        bench.run(ChangeSegment{.segment = 1, .locked = true});
        const Result<void> refused = bench.session->apply(ResumeGrowth{.steps = 1});
        QVERIFY(!refused || !bench.session->settle());
    }

    /// Seeds and growths leave barriers as they are; undo and "undo only" do not.
    void barriersAreThoseOfTheLastRowThatChangedThem()
    {
        Bench bench;
        const auto last = [&bench] { return lastBarrierRow(bench.session->history()); };
        const auto undo = [&bench] {
            QVERIFY(bench.session->undo());
            QVERIFY(bench.session->settle());
        };
        bench.run(Bench::seed(1, 3));
        bench.run(test::revertRows({bench.session->history().position()}));
        QCOMPARE(last(), RowId(0)); // what was taken back was none
        BarrierStroke wall;
        wall.path.pointsLps = {ramp().volume.geometry.toWorld({20, 3, 2})};
        bench.run(wall);
        const RowId first = bench.session->history().position();
        QCOMPARE(last(), first);
        bench.run(test::revertRows({first}));
        QCOMPARE(last(), bench.session->history().position());
        undo();
        QCOMPARE(last(), first);
        bench.run(Bench::seed(1, 3));
        bench.run(Bench::grow(20.0));
        QCOMPARE(last(), first);
        wall.path.pointsLps = {ramp().volume.geometry.toWorld({30, 3, 2})};
        bench.run(wall);
        QCOMPARE(last(), bench.session->history().position());
        undo();
        QCOMPARE(last(), first);
        for (int steps = 0; steps < 3; ++steps) // the growth, its seed, the first barrier
            undo();
        QCOMPARE(last(), RowId(0));
    }

    void whatHasGrownIsKnownByPlane()
    {
        Bench bench;
        const auto grown = [&bench](int plane) {
            return grownIn(bench.session->history(), std::uint8_t(plane)).to_ulong();
        };
        bench.run(Bench::seed(1, 3));
        bench.run(Bench::seed(2, 30));
        QCOMPARE(grown(0), 0UL);
        bench.run(
            GrowSteps{.criteria = {.lower = 0.0, .upper = 10.0, .segments = std::vector<int>{1}}});
        QCOMPARE(grown(0), 1UL << 1);
        QCOMPARE(grown(1), 0UL);
        bench.run(Bench::grow(100.0));
        QCOMPARE(grown(0), (1UL << 1) | (1UL << 2));
        QVERIFY(bench.session->undo());
        QVERIFY(bench.session->settle());
        QCOMPARE(grown(0), 1UL << 1);
    }

    void namesCountStepsThatWereAskedFor()
    {
        Bench bench;
        bench.run(Bench::seed(1, 10));
        bench.run(Bench::grow(60.0, 6));
        QVERIFY2(bench.lastName().startsWith(QStringLiteral("Grow 'A' 6 steps, +")),
            qPrintable(bench.lastName()));
        bench.run(Bench::grow(60.0, 1));
        QVERIFY2(bench.lastName().startsWith(QStringLiteral("Grow 'A' 1 step, +")),
            qPrintable(bench.lastName()));
    }
};

BURIN_TEST(RecentGrowthTest)

} // namespace recentGrowthTest

#include "RecentGrowthTest.moc"
