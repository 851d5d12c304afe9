// SPDX-License-Identifier: Apache-2.0
#include "tests/reference/DelayedEngine.h"
#include "tests/reference/ReferenceEngine.h"
#include "tests/support/cases/StrokeCases.h"
#include "tests/support/cases/StrokeHashes.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/fixtures/EditEngineFixture.h"
#include "tests/support/program/LongRun.h"
#include "tests/support/program/TestProgram.h"

#include <QtTest>

namespace strokeHashGlTest {

/// The hashes of everything that can become of an edit are those of the oracle.
class StrokeHashGlTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { QVERIFY2(m_gpu.isReady(), m_gpu.why()); }
    void init() { test::failOnUnexpectedMessages(); }
    void cleanup() { QCOMPARE(m_gpu.newErrors(), 0); }
    void agrees_data();
    void agrees();

private:
    test::EditEngineFixture m_gpu;
};

void StrokeHashGlTest::agrees_data()
{
    QTest::addColumn<test::StrokeCase>("stroke");
    QTest::addColumn<bool>("delayed");
    // StrokeHashTest delays the oracle at other cases, every day.
    int row = 1;
    for (const test::StrokeCase& stroke : test::strokeCases(test::longRun() ? 100 : 6))
        QTest::addRow("%s", stroke.name.constData())
            << stroke << (test::longRun() || row++ % 6 == 0);
}

void StrokeHashGlTest::agrees()
{
    QFETCH(test::StrokeCase, stroke);
    QFETCH(bool, delayed);
    reference::ReferenceEngine oracle;
    // That the oracle agrees with itself is StrokeHashTest's.
    const test::StrokeEnds expected = test::strokeEnds(oracle, stroke);
    const QString direct = test::difference(expected, test::runStroke(m_gpu.engine(), stroke));
    QVERIFY2(direct.isEmpty(), qPrintable(direct));
    if (!delayed)
        return;
    reference::DelayedEngine late(m_gpu.engine(), 12);
    const QString lately = test::difference(expected, test::runStroke(late, stroke));
    QVERIFY2(lately.isEmpty(), qPrintable(lately));
}

BURIN_TEST(StrokeHashGlTest)

} // namespace strokeHashGlTest

#include "StrokeHashGlTest.moc"
