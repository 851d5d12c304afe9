// SPDX-License-Identifier: Apache-2.0
#include "tests/support/cases/RandomRepair.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/fixtures/EditEngineFixture.h"
#include "tests/support/program/LongRun.h"
#include "tests/support/program/TestProgram.h"

#include <QtTest>

namespace randomRepairGlTest {

/// What RandomRepairTest does on the oracle, on the GPU; the oracle carries its branches out anew
/// and must come to the same hashes.
class RandomRepairGlTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { QVERIFY2(m_gpu.isReady(), m_gpu.why()); }
    void init() { test::failOnUnexpectedMessages(); }
    void cleanup() { QCOMPARE(m_gpu.newErrors(), 0); }

    void equalsTheOracle_data()
    {
        QTest::addColumn<uint>("seed");
        for (uint seed = 31; seed < (test::longRun() ? 37u : 32u); ++seed)
            QTest::addRow("seed %u", seed) << seed;
    }
    void equalsTheOracle()
    {
        QFETCH(uint, seed);
        const test::RandomRepair repair =
            test::runRandomRepair(m_gpu.engine(), test::longRun() ? 500 : 60, seed);
        QVERIFY2(repair.failure.isEmpty(), qPrintable(repair.failure));
        QVERIFY(repair.done.size() > 10);
    }

private:
    test::EditEngineFixture m_gpu;
};

BURIN_TEST(RandomRepairGlTest)

} // namespace randomRepairGlTest

#include "RandomRepairGlTest.moc"
