// SPDX-License-Identifier: Apache-2.0
#include "core/brick/ThreadWithoutVoxels.h"
#include "core/edits/kinds/history/RevertRows.h"
#include "core/edits/kinds/imports/ImportMask.h"
#include "core/session/EditSession.h"
#include "core/session/SegmentWork.h"
#include "tests/support/cases/BoxedMasks.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/PlainEdits.h"
#include "tests/support/scenes/SmallStudy.h"
#include "tests/support/scenes/sessions/SessionBench.h"

#include <QTemporaryDir>
#include <QTest>

namespace revertImportTest {

using namespace core;

namespace {

/// Each in one brick of its own.
const VoxelBox lowBox{{2, 2, 2}, {12, 12, 12}};
const VoxelBox farBox{{18, 18, 18}, {30, 30, 30}};

Edit importOf(const std::vector<VoxelBox>& boxes)
{
    return test::importOfBoxes(boxes, test::smallGrid().size);
}

/// Into segment 1, so that it can be taken back alone.
Edit importInto(const std::vector<VoxelBox>& boxes)
{
    ImportMask mask = test::importOfBoxes(boxes, test::smallGrid().size);
    mask.as = SegmentWord{.number = 1, .name = {}};
    return mask;
}

/// A ball in the brick of lowBox.
Edit paintLow()
{
    return test::paintAt(1, {test::smallGrid().toWorld({8.0, 8.0, 8.0})}, 3.0);
}

struct Bench : test::SessionBench {
    explicit Bench(const std::vector<Edit>& edits, bool isLate = false)
        : SessionBench(isLate)
    {
        for (const Edit& edit : edits)
            run(edit);
    }
};

QByteArray hashOf(const std::vector<Edit>& edits)
{
    return Bench(edits).session->stateHash();
}

} // namespace

/// "Undo only here" where imports of masks are among the steps: what they hold counts, and is not
/// looked at on the thread of a window.
class RevertImportTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init()
    {
        test::failOnUnexpectedMessages();
        m_looks = ThreadWithoutVoxels::looks();
    }
    void cleanup() { QCOMPARE(ThreadWithoutVoxels::looks(), m_looks); }

    /// And brought back, which asks for what it had read.
    void takenBackAlone_data()
    {
        QTest::addColumn<bool>("isLate");
        QTest::newRow("at once") << false;
        QTest::newRow("late") << true;
    }
    void takenBackAlone()
    {
        QFETCH(const bool, isLate);
        const Edit segment = test::addSegment("A"), import = importInto({lowBox, farBox}),
                   drill = test::drillAt(0.0);
        const QByteArray without = hashOf({segment, drill});
        const QByteArray with = hashOf({segment, import, drill});
        QVERIFY(with != without);
        const Bench bench({segment, import, drill}, isLate);
        const ThreadWithoutVoxels here;
        bench.run(RevertRows{{2}});
        QCOMPARE(bench.session->stateHash(), without);
        bench.run(RevertRows{{4}});
        QCOMPARE(bench.session->stateHash(), with);
        QCOMPARE(bench.rows().size(), std::size_t(5));
    }

    /// An import has read where it has voxels, whether or not it got them, and nowhere else.
    void oneBehindTheStep()
    {
        const Edit segment = test::addSegment("A");
        {
            const QByteArray without = hashOf({segment, importOf({farBox})});
            const Bench apart({segment, paintLow(), importOf({farBox})});
            const ThreadWithoutVoxels here;
            apart.run(RevertRows{{2}});
            QCOMPARE(apart.session->stateHash(), without);
        }
        const VoxelBox inPaint{{7, 7, 7}, {9, 9, 9}}; // all of which segment 1 keeps
        const VoxelBox besidePaint{{13, 13, 13}, {15, 15, 15}};
        for (const VoxelBox& close : {inPaint, besidePaint}) {
            const Bench bench({segment, paintLow(), importOf({farBox, close})});
            QCOMPARE(bench.rows().size(), std::size_t(3));
            const QByteArray before = bench.session->stateHash();
            const ThreadWithoutVoxels here;
            QVERIFY(bench.tried(RevertRows{{2}}).contains(QStringLiteral("(row 3) wrote or read")));
            QCOMPARE(bench.rows().size(), std::size_t(3));
            QCOMPARE(bench.session->stateHash(), before);
        }
    }

    /// What an import read must be as it was when it comes back.
    void oneThatComesBack()
    {
        const Edit segment = test::addSegment("A");
        for (const bool isClose : {true, false}) {
            const Edit import = importInto({isClose ? lowBox : farBox});
            const QByteArray alone = hashOf({segment, import});
            const Bench bench({segment, paintLow(), import});
            const ThreadWithoutVoxels here;
            bench.run(RevertRows{{3}}); // row 4
            bench.run(RevertRows{{2}}); // row 5
            QCOMPARE(bench.session->document().segment(1)->voxels, std::int64_t(0));
            const QString refused = bench.tried(RevertRows{{4}});
            QCOMPARE(refused.contains(QStringLiteral("(row 5) wrote or read")), isClose);
            QCOMPARE(refused.isEmpty(), !isClose);
            if (!isClose)
                QCOMPARE(bench.session->stateHash(), alone);
        }
    }

    /// Whoever does not want to wait for it leaves everything as it was.
    void aborted()
    {
        const Bench bench({test::addSegment("A"), paintLow(), importOf({farBox})});
        const QByteArray before = bench.session->stateHash();
        const ThreadWithoutVoxels here;
        QVERIFY(bench.session->apply(RevertRows{{2}}));
        QCOMPARE(bench.session->segmentWork().percent(), std::optional<int>(0));
        QVERIFY(!bench.session->segmentWork().isPreview());
        bench.session->segmentWork().abort();
        const Result<void> settled = bench.session->settle();
        QVERIFY(!settled);
        QVERIFY(settled.error().code == ErrorCode::Cancelled);
        QVERIFY(!bench.session->segmentWork().percent());
        QCOMPARE(bench.rows().size(), std::size_t(3));
        QCOMPARE(bench.session->stateHash(), before);
        bench.run(RevertRows{{2}});
        QCOMPARE(bench.rows().size(), std::size_t(4));
    }

    /// Aborted is only what somebody aborts: in a session that ends meanwhile it is a step.
    void isAwaitedAtTheEnd()
    {
        const QTemporaryDir folder;
        const QString file = folder.filePath(QStringLiteral("session.burin"));
        test::SessionBench bench(false, test::smallStudy(), file);
        for (const Edit& edit : {test::addSegment("A"), paintLow(), importOf({farBox})})
            bench.run(edit);
        QVERIFY(bench.session->apply(RevertRows{{2}}));
        QVERIFY(bench.session->segmentWork().percent());
        bench.session.reset();
        const auto opened = EditSession::open(bench.inner, test::smallStudy(), file);
        QVERIFY(opened);
        QCOMPARE((*opened)->history().rows().size(), std::size_t(4));
        QVERIFY((*opened)->history().rows().back().edit.is<RevertRows>());
    }

    /// Nothing is to be worked out where there is no import.
    void withoutImports()
    {
        const Bench bench({test::addSegment("A"), paintLow()});
        QVERIFY(bench.session->apply(RevertRows{{2}}));
        QVERIFY(!bench.session->segmentWork().percent());
        bench.session->segmentWork().abort();
        QVERIFY(bench.session->settle());
        QCOMPARE(bench.rows().size(), std::size_t(3));
    }

private:
    std::int64_t m_looks = 0;
};

BURIN_TEST(RevertImportTest)

} // namespace revertImportTest

#include "RevertImportTest.moc"
