// SPDX-License-Identifier: Apache-2.0
#include "core/session/questions/TouchSearch.h"
#include "core/session/EditSession.h"
#include "core/session/questions/VoxelQuestions.h"
#include "tests/reference/ReferenceEngine.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/PlainEdits.h"
#include "tests/support/scenes/SmallStudy.h"

#include <QTest>

namespace touchSearchTest {

using namespace core;

namespace {

struct Bench {
    explicit Bench(const std::vector<Edit>& edits)
    {
        session = *EditSession::create(engine, test::smallStudy(), {});
        for (const Edit& edit : edits)
            run(edit);
    }
    void run(const Edit& edit)
    {
        QVERIFY(session->apply(edit));
        QVERIFY(session->settle());
    }
    [[nodiscard]] RowId lastTouching(const Touch& touch)
    {
        RowId found = -1;
        session->questions().lastTouching(touch, [&found](RowId row) { found = row; });
        [&] { QVERIFY(session->settle()); }();
        return found;
    }

    reference::ReferenceEngine engine;
    std::unique_ptr<EditSession> session;
};

VoxelBox box(const glm::ivec3& low, const glm::ivec3& high)
{
    return {low, high};
}

} // namespace

class TouchSearchTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    void aSegmentIsTouchedByItsSeedsAndGrowths()
    {
        Bench bench({test::addSegment("Brain"), test::addSegment("Bone"), test::seedInBrain(1),
            test::growBrain(3), test::seedInBone(2), test::drillAt(0)});
        QCOMPARE(bench.lastTouching({.segment = 2}), RowId(5));
        QCOMPARE(bench.lastTouching({.segment = 1}), RowId(4));
        QCOMPARE(bench.lastTouching({.segment = 9}), RowId(0));
        bench.run(test::growBone(2)); // also the brain's seeds go on, but find no bone
        QCOMPARE(bench.lastTouching({.segment = 2}), RowId(7));
        QCOMPARE(bench.lastTouching({.segment = 1}), RowId(4));
    }

    /// Found, undone alone, and asked again: the one before.
    void whatWasTakenBackIsPassedOver()
    {
        Bench bench({test::addSegment("Brain"), test::seedInBrain(1), test::growBrain(2),
            test::growBrain(2), test::drillAt(0)});
        for (const RowId expected : {RowId(4), RowId(3), RowId(2), RowId(0)}) {
            const RowId row = bench.lastTouching({.segment = 1});
            QCOMPARE(row, expected);
            if (row != 0)
                bench.run(test::revertRows({row}));
        }
        QCOMPARE(bench.session->document().segment(1)->voxels, 0);
    }

    void aBoxIsTouchedByWhatChangedInsideIt()
    {
        const glm::ivec3 size = test::smallStudy().volume.geometry.size;
        Bench bench({test::addSegment("Brain"), test::drillAt(-6), test::drillAt(6)});
        const VoxelBox left = box({0, 0, 0}, {size.x / 2 - 2, size.y, size.z});
        const VoxelBox right = box({size.x / 2 + 2, 0, 0}, size);
        const RowId first = bench.lastTouching({.segment = 0, .box = left});
        const RowId second = bench.lastTouching({.segment = 0, .box = right});
        QVERIFY(first != second);
        QCOMPARE(std::min(first, second), RowId(2));
        QCOMPARE(std::max(first, second), RowId(3));
        bench.run(test::seedInBrain(1));
        QCOMPARE(bench.lastTouching({.segment = 0, .box = box({0, 0, 0}, size)}), RowId(4));
        QCOMPARE(bench.lastTouching({.segment = 0, .box = box({0, 0, 0}, {1, 1, 1})}), RowId(0));
        QCOMPARE(bench.lastTouching({.segment = 0, .box = {}}), RowId(0));
        // In order with what waits, and never changing anything.
        const QByteArray hash = bench.session->stateHash();
        RowId found = -1;
        QVERIFY(bench.session->undo());
        bench.session->questions().lastTouching(
            {.segment = 0, .box = box({0, 0, 0}, size)}, [&found](RowId row) { found = row; });
        QVERIFY(bench.session->redo());
        QVERIFY(bench.session->settle());
        QCOMPARE(found, RowId(3));
        QCOMPARE(bench.session->stateHash(), hash);
    }
};

BURIN_TEST(TouchSearchTest)

} // namespace touchSearchTest

#include "TouchSearchTest.moc"
