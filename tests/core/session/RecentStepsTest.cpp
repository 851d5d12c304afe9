// SPDX-License-Identifier: Apache-2.0
#include "core/session/EditOperation.h"
#include "core/session/OperationQueue.h"
#include "core/session/WalkOperation.h"
#include "tests/reference/ReferenceEngine.h"
#include "tests/support/FailingLog.h"
#include "tests/support/SmallStudy.h"

#include <QTest>

using namespace core;

/// How much of the history stays in memory, uncompressed.
class RecentStepsTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    void theOldestMakeRoom()
    {
        reference::ReferenceEngine engine;
        LoadedVolume study = test::smallStudy();
        QVERIFY(engine.openVolume(study.volume.geometry.size, study.codes));
        OperationQueue queue(engine, std::move(study.volume), nullptr, {});
        SessionState& state = queue.state();
        for (const double x : {-3.0, 0.0, 3.0}) {
            queue.submit(operationOf(test::drillAt(x)));
            QVERIFY(queue.settle());
        }
        for (const RowId row : {1, 2, 3})
            QVERIFY(state.recent(row));
        const std::size_t all = state.recentBytes();
        state.setRecentBytes(all);
        QVERIFY(state.recent(1));
        state.setRecentBytes(all - 1);
        QVERIFY(!state.recent(1));
        QVERIFY(state.recent(2));
        QVERIFY(state.recentBytes() < all);
        state.setRecentBytes(0);
        QVERIFY(!state.recent(3));
        QCOMPARE(state.recentBytes(), std::size_t(0));

        // What left it still comes back.
        const QByteArray hash = state.worker->stateHash(state.documentJson());
        for (const RowId row : {0, 3}) {
            queue.submit(std::make_unique<WalkOperation>(WalkOperation::Aim::Row, row));
            QVERIFY(queue.settle());
            QCOMPARE(state.history.position(), row);
        }
        QCOMPARE(state.worker->stateHash(state.documentJson()), hash);
        queue.submit(operationOf(test::drillAt(5)));
        QVERIFY(queue.settle());
        QVERIFY(!state.recent(4));
        state.setRecentBytes(all);
        queue.submit(operationOf(test::drillAt(-6)));
        QVERIFY(queue.settle());
        QVERIFY(state.recent(5));
    }
};

QTEST_GUILESS_MAIN(RecentStepsTest)
#include "RecentStepsTest.moc"
