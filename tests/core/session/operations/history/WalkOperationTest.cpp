// SPDX-License-Identifier: Apache-2.0
#include "core/session/operations/history/WalkOperation.h"

#include "core/session/EditSession.h"
#include "core/session/questions/VoxelQuestions.h"
#include "tests/reference/ReferenceEngine.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/SmallStudy.h"

#include <QTest>

#include <memory>
#include <optional>

namespace walkOperationTest {

using namespace core;

namespace {

/// A session with a segment and two drills, and a seed on another branch.
struct Bench {
    Bench()
    {
        session = *EditSession::create(engine, test::smallStudy(), {});
        run(test::addSegment("Brain"));
        run(test::drillAt(0));
        run(test::drillAt(3));
        if (!session->goTo(1) || !session->settle())
            qFatal("not walked");
        run(test::seedInBrain(1));
    }
    void run(const Edit& edit) const
    {
        if (!session->apply(edit) || !session->settle())
            qFatal("not carried out");
    }
    [[nodiscard]] RowId position() const { return session->history().position(); }

    reference::ReferenceEngine engine;
    std::unique_ptr<EditSession> session;
};

using Foreseen = std::optional<RowId>;

} // namespace

/// Where walks that wait or run will arrive.
class WalkOperationTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void whereWalksArriveIsKnownBefore()
    {
        const Bench bench;
        EditSession& session = *bench.session;
        QCOMPARE(bench.position(), RowId(4));
        QCOMPARE(session.foreseenPosition(), Foreseen(4));
        QVERIFY(session.goTo(3));
        QVERIFY(!session.idle());
        QCOMPARE(session.foreseenPosition(), Foreseen(3));
        QVERIFY(session.undo());
        QCOMPARE(session.foreseenPosition(), Foreseen(2));
        session.questions().afterAll([] {});
        QVERIFY(session.undo());
        QVERIFY(session.redo());
        const Foreseen foreseen = session.foreseenPosition();
        QVERIFY(session.settle());
        QCOMPARE(foreseen, Foreseen(bench.position()));
        QCOMPARE(session.foreseenPosition(), foreseen);
        for (int i = 0; i < 5; ++i)
            QVERIFY(session.undo());
        QCOMPARE(session.foreseenPosition(), Foreseen(0));
        QVERIFY(session.settle());
        QCOMPARE(bench.position(), RowId(0));
    }

    /// It may become a row.
    void withAnEditUnderWayItIsNot()
    {
        const Bench bench;
        EditSession& session = *bench.session;
        QVERIFY(session.apply(test::drillAt(-3)));
        QVERIFY(!session.idle());
        QVERIFY(!session.foreseenPosition());
        QVERIFY(session.undo());
        QVERIFY(!session.foreseenPosition());
        QVERIFY(session.settle());
        QCOMPARE(session.foreseenPosition(), Foreseen(4));
        QVERIFY(session.begin(test::growBrain()));
        QVERIFY(!session.foreseenPosition());
        session.end(Ending::Rollback);
        QVERIFY(session.settle());
        QCOMPARE(session.foreseenPosition(), Foreseen(4));
    }
};

BURIN_TEST(WalkOperationTest)

} // namespace walkOperationTest

#include "WalkOperationTest.moc"
