// SPDX-License-Identifier: Apache-2.0
#include "tests/support/cases/RandomRepair.h"
#include "tests/reference/ReferenceEngine.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/program/LongRun.h"
#include "tests/support/program/TestProgram.h"

#include <QTest>

#include <map>

namespace randomRepairTest {

/// Repairs in any order, with undo, branches and files.
class RandomRepairTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    void aPlaceOfTheHistoryAlwaysHoldsTheSame_data()
    {
        QTest::addColumn<uint>("seed");
        for (uint seed = 1; seed <= (test::longRun() ? 20u : 3u); ++seed)
            QTest::addRow("seed %u", seed) << seed;
    }
    void aPlaceOfTheHistoryAlwaysHoldsTheSame()
    {
        QFETCH(uint, seed);
        reference::ReferenceEngine engine;
        const test::RandomRepair repair =
            test::runRandomRepair(engine, test::longRun() ? 500 : 100, seed);
        QVERIFY2(repair.failure.isEmpty(), qPrintable(repair.failure));
        for (const auto& [kind, count] : repair.done)
            m_done[kind] += count;
    }
    void cleanupTestCase()
    {
        for (const auto& [kind, count] : m_done)
            qInfo("%s: %d", qPrintable(kind), count);
        // No kind was left out.
        for (const char* kind :
            {"surface", "mark", "changeMarks", "spherePush", "planeScrape", "pointDrag", "smooth",
                "attract", "template", "writeBack", "surfaceBarrier", "followMask", "dropSurface",
                "chunks", "chunkToggle", "paint", "undo", "redo", "goTo", "reopen", "given up"})
            QVERIFY2(m_done[QLatin1String(kind)] > 0, kind);
        // A short run may have none.
        if (test::longRun())
            QVERIFY(m_done[QStringLiteral("template aborted")] > 0);
    }

private:
    std::map<QString, int> m_done;
};

BURIN_TEST(RandomRepairTest)

} // namespace randomRepairTest

#include "RandomRepairTest.moc"
