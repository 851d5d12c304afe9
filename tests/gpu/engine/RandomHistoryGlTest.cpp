// SPDX-License-Identifier: Apache-2.0
#include "tests/reference/ReferenceEngine.h"
#include "tests/support/cases/RandomHistory.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/fixtures/EditEngineFixture.h"
#include "tests/support/program/LongRun.h"
#include "tests/support/program/TestProgram.h"

#include <QtTest>

namespace randomHistoryGlTest {

/// What RandomHistoryTest does on the oracle, on the GPU: the same truth and the same hashes.
class RandomHistoryGlTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { QVERIFY2(m_gpu.isReady(), m_gpu.why()); }
    void init() { test::failOnUnexpectedMessages(); }
    void cleanup() { QCOMPARE(m_gpu.newErrors(), 0); }

    void equalsTheTruthAfterEveryStep_data()
    {
        QTest::addColumn<uint>("seed");
        for (uint seed = 11; seed < (test::longRun() ? 19u : 12u); ++seed)
            QTest::addRow("seed %u", seed) << seed;
    }
    void equalsTheTruthAfterEveryStep()
    {
        QFETCH(uint, seed);
        const int commands = test::longRun() ? 500 : 120;
        const test::RandomHistory history = test::runRandomHistory(m_gpu.engine(), commands, seed);
        QVERIFY2(history.failure.isEmpty(), qPrintable(history.failure));
        reference::ReferenceEngine oracle;
        QCOMPARE(test::runRandomHistory(oracle, commands, seed).hashes, history.hashes);
    }

    void withEditableRanges()
    {
        const int commands = test::longRun() ? 400 : 80;
        const test::RandomHistory history =
            test::runRandomHistory(m_gpu.engine(), commands, 103, {}, {.limited = true});
        QVERIFY2(history.failure.isEmpty(), qPrintable(history.failure));
        reference::ReferenceEngine oracle;
        QCOMPARE(test::runRandomHistory(oracle, commands, 103, {}, {.limited = true}).hashes,
            history.hashes);
    }

    void withOverlappingMasks()
    {
        const int commands = test::longRun() ? 400 : 80;
        const test::RandomHistory history =
            test::runRandomHistory(m_gpu.engine(), commands, 202, {}, {.planes = true});
        QVERIFY2(history.failure.isEmpty(), qPrintable(history.failure));
        reference::ReferenceEngine oracle;
        QCOMPARE(test::runRandomHistory(oracle, commands, 202, {}, {.planes = true}).hashes,
            history.hashes);
    }

    void withSmoothedGrowth()
    {
        const int commands = test::longRun() ? 400 : 80;
        const test::RandomHistory history =
            test::runRandomHistory(m_gpu.engine(), commands, 302, {}, {.smoothed = true});
        QVERIFY2(history.failure.isEmpty(), qPrintable(history.failure));
        reference::ReferenceEngine oracle;
        QCOMPARE(test::runRandomHistory(oracle, commands, 302, {}, {.smoothed = true}).hashes,
            history.hashes);
    }

private:
    test::EditEngineFixture m_gpu;
};

BURIN_TEST(RandomHistoryGlTest)

} // namespace randomHistoryGlTest

#include "RandomHistoryGlTest.moc"
