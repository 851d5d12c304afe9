// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/criteria/GrowCriteria.h"
#include "core/edits/kinds/growth/ShrinkSteps.h"
#include "core/edits/kinds/history/RevertRows.h"
#include "core/session/EditSession.h"
#include "tests/reference/ReferenceEngine.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/CutEdits.h"
#include "tests/support/scenes/PlainEdits.h"
#include "tests/support/scenes/SmallStudy.h"

#include <QTest>

namespace revertTest {

using namespace core;

namespace {

/// The small study with air to its right: a second ball would be out of the first one's reach.
LoadedVolume twoBalls()
{
    const LoadedVolume one = test::smallStudy();
    LoadedVolume two = one;
    const glm::ivec3 size = one.volume.geometry.size;
    const int gap = 64;
    two.volume.geometry.size.x = 2 * size.x + gap;
    two.codes.clear();
    for (int row = 0; row < size.y * size.z; ++row) {
        const auto from = one.codes.begin() + row * size.x;
        two.codes.insert(two.codes.end(), from, from + size.x);
        two.codes.insert(two.codes.end(), std::size_t(gap), std::uint16_t(24));
        two.codes.insert(two.codes.end(), from, from + size.x);
    }
    return two;
}
constexpr double secondBallMm = 40 + 64;

struct Bench {
    explicit Bench(LoadedVolume volume = test::smallStudy())
    {
        session = *EditSession::create(engine, std::move(volume), {});
    }
    Bench(LoadedVolume volume, const std::vector<Edit>& edits)
        : Bench(std::move(volume))
    {
        for (const Edit& edit : edits)
            run(edit);
    }
    void run(const Edit& edit)
    {
        const Result<void> applied = session->apply(edit);
        QVERIFY2(applied, qPrintable(applied ? QString() : applied.error().arguments.join(u' ')));
        const Result<void> settled = session->settle();
        QVERIFY2(settled, qPrintable(settled ? QString() : settled.error().arguments.join(u' ')));
    }
    /// What is said against an edit; nothing may have changed then.
    [[nodiscard]] QString refusal(const Edit& edit)
    {
        const QByteArray before = session->stateHash();
        const std::size_t rows = session->history().rows().size();
        Result<void> result = session->apply(edit);
        if (result)
            result = session->settle();
        if (result || session->stateHash() != before || session->history().rows().size() != rows)
            return QStringLiteral("was not refused");
        const QString argument = result.error().arguments.value(0);
        if (result.error().code == ErrorCode::SegmentLocked)
            return QStringLiteral("locked: ") + argument;
        return result.error().code == ErrorCode::StepsEntangled
            ? argument
            : QStringLiteral("another error: ") + argument;
    }

    reference::ReferenceEngine engine;
    std::unique_ptr<EditSession> session;
};

QByteArray hashOf(const LoadedVolume& volume, const std::vector<Edit>& edits)
{
    const Bench bench(volume, edits);
    return bench.session->stateHash();
}

} // namespace

class RevertTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    void leavesWhatCameAfter()
    {
        const Edit segment = test::addSegment("Brain");
        Bench bench(test::smallStudy(),
            {segment, test::drillAt(0), test::seedInBrain(1), test::growBrain(4)});
        bench.run(RevertRows{{2}});
        QCOMPARE(bench.session->stateHash(),
            hashOf(test::smallStudy(), {segment, test::seedInBrain(1), test::growBrain(4)}));
        const HistoryRow& row = bench.session->history().rows().back();
        QCOMPARE(row.parent, RowId(4)); // the drill itself stays in the history
        QVERIFY2(row.name.startsWith(QStringLiteral("Undo only 'Drill ")), qPrintable(row.name));
        QVERIFY2(row.name.contains(QStringLiteral("mm', ")), qPrintable(row.name));
        QVERIFY(bench.session->undo());
        QVERIFY(bench.session->settle());
        QCOMPARE(bench.session->stateHash(),
            hashOf(test::smallStudy(),
                {segment, test::drillAt(0), test::seedInBrain(1), test::growBrain(4)}));
    }

    void isTakenBackLikeAnyStep()
    {
        const std::vector<Edit> edits{
            test::addSegment("Brain"), test::drillAt(0), test::seedInBrain(1)};
        Bench bench(test::smallStudy(), edits);
        bench.run(RevertRows{{2}});
        bench.run(RevertRows{{4}});
        QCOMPARE(bench.session->stateHash(), hashOf(test::smallStudy(), edits));
    }

    /// A step and what took it back cancel each other: the one before is free again. But what comes
    /// back must find what it read.
    /// Its members are of the generations that they were, and the next growth goes on after them.
    void aShrinkingThatIsUndone()
    {
        const std::vector<Edit> grown{
            test::addSegment("Brain"), test::seedInBrain(1), test::growBrain(4)};
        std::vector<Edit> edits = grown;
        edits.emplace_back(ShrinkSteps{.steps = 2});
        Bench bench(test::smallStudy(), edits);
        const auto counter = [](const Bench& of) {
            return of.session->document().growths.front().generation;
        };
        const std::uint32_t shrunk = counter(bench);
        bench.run(RevertRows{{4}});
        QCOMPARE(counter(bench), shrunk + 2);
        QCOMPARE(bench.session->stateHash(), hashOf(test::smallStudy(), grown));
        bench.run(test::growBrain());
        std::vector<Edit> further = grown;
        further.emplace_back(test::growBrain());
        QCOMPARE(bench.session->stateHash(), hashOf(test::smallStudy(), further));
    }

    void oneAfterTheOther()
    {
        const std::vector<Edit> edits{test::addSegment("Brain"), test::seedInBrain(1),
            test::growBrain(2), test::growBrain(2), test::drillAt(0), test::drillAt(2)};
        Bench bench(test::smallStudy(), edits);
        bench.run(RevertRows{{4}}); // row 7
        QVERIFY(bench.refusal(RevertRows{{4}}).contains(QStringLiteral("was taken back before")));
        QVERIFY(bench.refusal(RevertRows{{5}}).contains(QStringLiteral("(row 6) wrote or read")));
        bench.run(RevertRows{{3}}); // row 8
        bench.run(RevertRows{{2}}); // row 9
        QCOMPARE(bench.session->document().segment(1)->voxels, 0);
        QVERIFY(bench.refusal(RevertRows{{8}}).contains(QStringLiteral("(row 9) wrote or read")));
        QVERIFY(bench.refusal(RevertRows{{7}}).contains(QStringLiteral(") wrote or read")));
        bench.run(RevertRows{{9}});
        bench.run(RevertRows{{8}});
        bench.run(RevertRows{{7}});
        QCOMPARE(bench.session->stateHash(), hashOf(test::smallStudy(), edits));
        // The same with strokes: the second starts on the floor of the first.
        bench.run(RevertRows{{6}}); // row 13
        bench.run(RevertRows{{5}}); // row 14
        QVERIFY(bench.refusal(RevertRows{{13}}).contains(QStringLiteral("(row 14) wrote or read")));
    }

    void severalAtOnceWhereOneAloneIsRefused()
    {
        Bench bench(test::smallStudy(),
            {test::addSegment("Brain"), test::drillAt(-2), test::drillAt(0), test::drillAt(1)});
        QVERIFY(bench.refusal(RevertRows{{2}}).contains(QStringLiteral("(row 3) wrote")));
        QVERIFY(bench.refusal(RevertRows{{2, 3}}).contains(QStringLiteral("(row 4) wrote")));
        QVERIFY(bench.refusal(RevertRows{{2, 4}}).contains(QStringLiteral("(row 3) wrote")));
        bench.run(RevertRows{{3, 4}});
        QCOMPARE(bench.session->stateHash(),
            hashOf(test::smallStudy(), {test::addSegment("Brain"), test::drillAt(-2)}));
    }

    /// Found by RandomHistoryTest: both decide on the drill, one by way of what it took back.
    void stepsThatDecideOnTheSameAreTakenBackOneByOne()
    {
        Bench bench(test::smallStudy(),
            {test::drillAt(0), RevertRows{{1}}, RevertRows{{2}}, RevertRows{{1}}});
        QVERIFY(bench.refusal(RevertRows{{3, 4}}).contains(QStringLiteral("both decides on")));
        bench.run(RevertRows{{4}});
        QCOMPARE(bench.session->stateHash(), hashOf(test::smallStudy(), {test::drillAt(0)}));
        bench.run(RevertRows{{3}});
        QCOMPARE(bench.session->stateHash(), hashOf(test::smallStudy(), {}));
    }

    void aGrowthHoldsItsSeeds()
    {
        Bench bench(test::smallStudy(),
            {test::addSegment("Brain"), test::seedInBrain(1), test::growBrain(3)});
        const QString refusal = bench.refusal(RevertRows{{2}});
        QVERIFY2(refusal.startsWith(QStringLiteral("'Grow ")), qPrintable(refusal));
        QVERIFY2(refusal.contains(QStringLiteral("after 'Seed stroke")), qPrintable(refusal));
        QVERIFY2(refusal.endsWith(QStringLiteral("(row 2)")), qPrintable(refusal));
        bench.run(RevertRows{{2, 3}});
        QVERIFY2(bench.session->history().rows().back().name.startsWith(
                     QStringLiteral("Undo only 2 steps, ")),
            qPrintable(bench.session->history().rows().back().name));
        // The counter of generations never goes back but with its row.
        bench.run(RevertRows{{4}});
        QCOMPARE(bench.session->stateHash(),
            hashOf(test::smallStudy(),
                {test::addSegment("Brain"), test::seedInBrain(1), test::growBrain(3)}));
    }

    void strokesApartDoNotHoldEachOther()
    {
        Bench bench(twoBalls(), {test::drillAt(0), test::drillAt(secondBallMm)});
        QVERIFY(bench.session->history().rows().at(1).statistics.voxelsChanged > 100);
        bench.run(RevertRows{{1}});
        QCOMPARE(bench.session->stateHash(), hashOf(twoBalls(), {test::drillAt(secondBallMm)}));
    }

    /// A cut reads down to where it could end, not what lies behind that.
    void cutsFromOppositeSidesDoNotHoldEachOther()
    {
        LoadedVolume block = test::smallStudy();
        const glm::ivec3 size(40, 96, 34);
        block.volume.geometry.size = size;
        block.codes.clear();
        for (int row = 0; row < size.y * size.z; ++row) {
            const bool isBone = row % size.y >= 6 && row % size.y < 90;
            block.codes.insert(
                block.codes.end(), std::size_t(size.x), std::uint16_t(isBone ? 2024 : 24));
        }
        const Edit before = test::drillAt(0);
        OrthographicView fromBehind = test::factsOfStroke(before).view;
        fromBehind.eyeLps.y += 400;
        const Edit behind = test::drillWith({.view = fromBehind}, before);
        for (const auto& [first, second] :
            {std::pair<Edit, Edit>(before, behind), std::pair<Edit, Edit>(behind, before)}) {
            Bench bench(block, {first, second});
            QVERIFY(bench.session->history().rows().at(1).statistics.voxelsChanged > 100);
            bench.run(RevertRows{{1}});
            QCOMPARE(bench.session->stateHash(), hashOf(block, {second}));
        }
        // One that goes on where the other ended, or could have come there, does.
        Bench same(block, {test::drillAt(0), test::drillAt(0)});
        QVERIFY(same.refusal(RevertRows{{1}}).contains(QStringLiteral("wrote or read")));
        const Edit deep = test::drillWith({.depthMm = 80.0}, behind);
        Bench through(block, {test::drillAt(0), deep});
        QVERIFY(through.refusal(RevertRows{{1}}).contains(QStringLiteral("wrote or read")));
    }

    /// A growth asks its members' neighbours, no one else.
    void aGrowthElsewhereDoesNotHoldWhatWasPainted()
    {
        const glm::dvec3 middle = test::pointsInBrain().front();
        const glm::dvec3 other = middle + glm::dvec3(secondBallMm, 0, 0);
        const auto painted = [](const glm::dvec3& at) { return test::paintAt(1, {at}); };
        const Edit seed = test::seedAt(2, {other});
        for (const bool onlyVisible : {false, true}) {
            const std::vector<Edit> rest{
                seed, test::growBy({.lower = 0, .upper = 100, .onlyVisible = onlyVisible}, 4)};
            const std::vector<Edit> segments{test::addSegment("A"), test::addSegment("B")};
            const auto with = [&](const std::vector<Edit>& first) {
                std::vector<Edit> all = segments;
                all.insert(all.end(), first.begin(), first.end());
                all.insert(all.end(), rest.begin(), rest.end());
                return all;
            };
            Bench apart(twoBalls(), with({painted(middle)}));
            apart.run(RevertRows{{3}});
            QCOMPARE(apart.session->stateHash(), hashOf(twoBalls(), with({})));
            Bench close(twoBalls(), with({painted(other + glm::dvec3(0, 8, 0))}));
            QVERIFY(close.refusal(RevertRows{{3}}).contains(QStringLiteral("wrote or read")));
            // Where the front would have come is where coverage counts, with "only visible".
            Bench cutApart(twoBalls(), with({test::drillAt(0)}));
            cutApart.run(RevertRows{{3}});
            QCOMPARE(cutApart.session->stateHash(), hashOf(twoBalls(), with({})));
            Bench cutClose(twoBalls(), with({test::drillAt(secondBallMm)}));
            const bool refused =
                cutClose.refusal(RevertRows{{3}}).contains(QStringLiteral("wrote or read"));
            QCOMPARE(refused, onlyVisible);
            // Seeds that wait anywhere would have grown.
            Bench waiting(twoBalls(), with({test::seedInBrain(1)}));
            QVERIFY(waiting.refusal(RevertRows{{3}}).contains(QStringLiteral("wrote or read")));
        }
    }

    void aLockedSegmentKeepsItsVoxels()
    {
        Bench bench(test::smallStudy(),
            {test::addSegment("Brain"), test::seedInBrain(1), test::growBrain(3), test::drillAt(0),
                test::lockSegment(1)});
        QCOMPARE(bench.refusal(RevertRows{{2, 3}}), QStringLiteral("locked: Brain"));
        bench.run(RevertRows{{4}}); // the drill has nothing to do with it
        bench.run(test::lockSegment(1, false));
        bench.run(RevertRows{{2, 3}});
        QCOMPARE(bench.session->document().segment(1)->voxels, 0);
    }

    void onlyStepsThatWereDoneAndChangedVoxels()
    {
        Bench bench(test::smallStudy(), {test::addSegment("Brain"), test::drillAt(0)});
        QVERIFY(bench.session->undo());
        QVERIFY(bench.session->settle());
        QVERIFY(bench.refusal(RevertRows{{2}}).contains(QStringLiteral("row 2 is not among")));
        QVERIFY(bench.refusal(RevertRows{{77}}).contains(QStringLiteral("row 77 is not among")));
        QVERIFY(bench.refusal(RevertRows{{1}})
                    .contains(QStringLiteral(
                        "(row 1) changed no voxel, only what the list of segments says; change")));
        for (const RevertRows& wrong : {RevertRows{}, RevertRows{{0}}, RevertRows{{2, 1}},
                 RevertRows{{1, 1}}, RevertRows{{-3}}}) {
            const Result<void> applied = bench.session->apply(wrong);
            QVERIFY(!applied);
            QCOMPARE(applied.error().code, ErrorCode::InvalidField);
        }
    }
};

BURIN_TEST(RevertTest)

} // namespace revertTest

#include "RevertTest.moc"
