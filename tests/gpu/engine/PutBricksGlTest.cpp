// SPDX-License-Identifier: Apache-2.0
#include "tests/support/cases/PutBricks.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/fixtures/EditEngineFixture.h"
#include "tests/support/program/TestProgram.h"

#include <QtTest>

namespace putBricksGlTest {

/// What PutBricksTest asks of the oracle, of the GPU.
class PutBricksGlTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { QVERIFY2(m_gpu.isReady(), m_gpu.why()); }
    void init() { test::failOnUnexpectedMessages(); }
    void cleanup() { QCOMPARE(m_gpu.newErrors(), 0); }
    void keepsItsPromises_data() { test::addPutBricksRows(); }
    void keepsItsPromises()
    {
        QFETCH(QString, name);
        const QString wrong = test::tryPutBricks(m_gpu.engine(), name);
        QVERIFY2(wrong.isEmpty(), qPrintable(wrong));
    }

private:
    test::EditEngineFixture m_gpu;
};

BURIN_TEST(PutBricksGlTest)

} // namespace putBricksGlTest

#include "PutBricksGlTest.moc"
