// SPDX-License-Identifier: Apache-2.0
#include "tests/reference/ReferenceEngine.h"
#include "tests/support/cases/EngineCases.h"
#include "tests/support/faults/RefusingGl.h"
#include "tests/support/fixtures/EditEngineFixture.h"
#include "tests/support/fixtures/WatchedEngine.h"
#include "tests/support/program/LongRun.h"
#include "tests/support/program/TestProgram.h"

#include <QtTest>

#include <algorithm>

namespace refusedShaderGlTest {

using test::EngineCase;
using test::RefusingGl;

namespace {

/// One of each kind of edit whose shaders are compiled when they are first needed.
std::vector<EngineCase> cases()
{
    std::vector<EngineCase> made;
    for (const auto& some : {test::relabelCases(1), test::barrierCases(1), test::spreadCases(1),
             test::outlineCases(1), test::thresholdCases(1), test::segmentScissorsCases(1),
             test::seedGroupCases(1), test::passageCases(1)})
        made.push_back(some.back());
    return made;
}

} // namespace

/// The driver refuses a shader in the middle of a session: the edit that needs it is refused with
/// everything as it was, and succeeds when the driver takes the shader later.
class RefusedShaderGlTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void anEditIsRefused_data();
    void anEditIsRefused();
    void cleanupTestCase() { QVERIFY(m_refused > 0); }

private:
    int m_refused = 0; ///< edits
};

void RefusedShaderGlTest::anEditIsRefused_data()
{
    QTest::addColumn<int>("number");
    int number = 0;
    for (const EngineCase& each : cases())
        QTest::addRow("%s", each.name.constData()) << number++;
}

void RefusedShaderGlTest::anEditIsRefused()
{
    QFETCH(int, number);
    const EngineCase engineCase = cases().at(std::size_t(number));
    reference::ReferenceEngine oracle;
    const test::EngineOutcome expected = test::runCase(oracle, engineCase);
    int calls = 0;
    {
        // An engine compiles each shader once, so each try has an engine of its own.
        test::EditEngineFixture gpu;
        QVERIFY2(gpu.isReady(), gpu.why());
        RefusingGl counting(RefusingGl::Shader{0});
        test::WatchedEngine watched(gpu, counting);
        (void)test::runCase(watched, engineCase);
        QVERIFY2(watched.found.isEmpty(), qPrintable(watched.found));
        QCOMPARE(watched.failedEdits, 0);
        calls = counting.calls();
    }
    const int tried = test::longRun() ? calls : std::min(calls, 2);
    for (int i = 0; i < tried; ++i) {
        const int shader = 1 + i * calls / tried;
        test::EditEngineFixture gpu;
        QVERIFY2(gpu.isReady(), gpu.why());
        {
            RefusingGl refusing(RefusingGl::Shader{shader});
            test::WatchedEngine watched(gpu, refusing);
            (void)test::runCase(watched, engineCase);
            QVERIFY2(watched.found.isEmpty(),
                qPrintable(QStringLiteral("shader %1 of %2: %3")
                               .arg(shader)
                               .arg(calls)
                               .arg(watched.found)));
            QCOMPARE(watched.lost, 0);
            // The engine also compiles ahead where it is idle, so that there may be fewer than
            // before.
            QVERIFY(refusing.refused() <= 1);
            m_refused += watched.failedEdits;
        }
        const QString later = test::difference(expected, test::runCase(gpu.engine(), engineCase));
        QVERIFY2(later.isEmpty(),
            qPrintable(QStringLiteral("after shader %1: %2").arg(shader).arg(later)));
    }
}

BURIN_TEST(RefusedShaderGlTest)

} // namespace refusedShaderGlTest

#include "RefusedShaderGlTest.moc"
