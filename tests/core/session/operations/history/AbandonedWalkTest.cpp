// SPDX-License-Identifier: Apache-2.0
#include "core/session/operations/EditOperation.h"
#include "core/session/operations/OperationQueue.h"
#include "core/session/operations/history/WalkOperation.h"
#include "tests/reference/ReferenceEngine.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/PlainEdits.h"
#include "tests/support/scenes/SmallStudy.h"

#include <QTest>

#include <memory>
#include <new>
#include <optional>
#include <vector>

namespace abandonedWalkTest {

using namespace core;

namespace {

using Aim = WalkOperation::Aim;

/// Two strokes of segment 1 that share bricks, of which nothing is in memory: to walk over them,
/// their differences are read.
struct Bench {
    Bench()
    {
        LoadedVolume study = test::smallStudy();
        isReady = engine.openVolume(study.volume.geometry.size, study.codes).has_value();
        queue = std::make_unique<OperationQueue>(
            engine, std::move(study.volume), nullptr, std::function<void()>());
        queue->setErrorListener([this](const Error& error) { told.push_back(error.code); });
        state().recent.setMostBytes(0);
        const VolumeGeometry& grid = test::smallGrid();
        for (const Edit& edit :
            {test::addSegment("Organ"), test::paintAt(1, {grid.toWorld({18.0, 18.0, 12.0})}, 4.0),
                test::paintAt(1, {grid.toWorld({22.0, 18.0, 12.0})}, 5.0)}) {
            isReady = queue->check(edit).has_value() && isReady;
            queue->submit(operationOf(edit));
            isReady = queue->settle().has_value() && isReady;
        }
        isReady = state().history.rows().size() == 3 && isReady;
    }
    [[nodiscard]] SessionState& state() const { return queue->state(); }
    [[nodiscard]] QByteArray hash() const
    {
        return state().worker->stateHash(state().documentJson());
    }
    void begin(Aim aim, RowId target = 0) const
    {
        queue->submit(std::make_unique<WalkOperation>(aim, target));
    }
    /// As where there is no memory for what the session's thread is about to do.
    void refuseMemory() const
    {
        queue->guard([] { throw std::bad_alloc(); });
    }
    /// Whether session and engine are where those of the other one are.
    [[nodiscard]] bool isLike(const Bench& other) const
    {
        return state().history.position() == other.state().history.position()
            && hash() == other.hash()
            && reference::DenseFields::changes(engine.fields(), other.engine.fields()).empty();
    }

    reference::ReferenceEngine engine;
    std::unique_ptr<OperationQueue> queue;
    std::vector<ErrorCode> told;
    bool isReady = true;
};

} // namespace

/// Memory that is refused on the session's thread while the difference of a row is being read gives
/// the walk up, and what was read is nobody's.
class AbandonedWalkTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    void theNextWalkReadsItsOwnDifferences_data()
    {
        QTest::addColumn<Aim>("first");
        QTest::addColumn<Aim>("next");
        QTest::addColumn<RowId>("target");
        QTest::newRow("undo, undo") << Aim::Undo << Aim::Undo << RowId(0);
        QTest::newRow("undo, two rows") << Aim::Undo << Aim::Row << RowId(1);
        QTest::newRow("a row, undo") << Aim::Row << Aim::Undo << RowId(0);
    }
    void theNextWalkReadsItsOwnDifferences()
    {
        QFETCH(const Aim, first);
        QFETCH(const Aim, next);
        QFETCH(const RowId, target);
        const Bench whole;
        const Bench expected;
        expected.begin(next, target);
        QVERIFY(whole.isReady && expected.isReady && expected.queue->settle());

        const Bench bench;
        bench.begin(first, 1);
        bench.refuseMemory();
        bench.begin(next, target);
        // All that was asked for until then is taken in at once.
        bench.state().worker->finish();
        QVERIFY(!bench.queue->settle());
        QCOMPARE(bench.told, std::vector{ErrorCode::OutOfMemory});
        QVERIFY(!bench.state().lost() && bench.queue->idle());
        QVERIFY(bench.isLike(expected));
        bench.begin(Aim::Row, 3);
        QVERIFY(bench.queue->settle());
        QVERIFY(bench.isLike(whole));
    }

    /// Where nothing follows, the session stays where it was, however often memory is refused.
    void aloneItChangesNothing()
    {
        const Bench whole;
        const Bench bench;
        QVERIFY(bench.isReady);
        bench.begin(Aim::Undo);
        bench.refuseMemory();
        bench.refuseMemory();
        QVERIFY(!bench.queue->idle()); // until the difference is there
        QVERIFY(!bench.queue->settle());
        QVERIFY(!bench.state().lost() && bench.queue->idle());
        QVERIFY(bench.isLike(whole));
        bench.begin(Aim::Undo);
        QVERIFY(bench.queue->settle());
        QCOMPARE(bench.state().history.position(), RowId(2));
    }
};

BURIN_TEST(AbandonedWalkTest)

} // namespace abandonedWalkTest

#include "AbandonedWalkTest.moc"
