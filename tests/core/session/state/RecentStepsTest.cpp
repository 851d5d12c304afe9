// SPDX-License-Identifier: Apache-2.0
#include "core/session/state/RecentSteps.h"
#include "core/session/EditSession.h"
#include "core/session/SessionStorage.h"
#include "tests/reference/ReferenceEngine.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/SmallStudy.h"
#include "tests/support/series/SessionFiles.h"

#include <QTemporaryDir>
#include <QTest>

#include <random>

namespace recentStepsTest {

using namespace core;

namespace {

Changes changesOf(std::size_t bytes, std::uint8_t value)
{
    std::vector<BrickChange> changes(1);
    changes[0].key = {.field = Field::Coverage, .plane = 1, .brick = value};
    changes[0].before = std::vector<std::uint8_t>(bytes, value);
    changes[0].after = std::vector<std::uint8_t>(bytes, std::uint8_t(value + 100));
    return std::make_shared<const std::vector<BrickChange>>(std::move(changes));
}

} // namespace

class RecentStepsTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    void knowsBothSides_data()
    {
        QTest::addColumn<bool>("takenBack");
        QTest::newRow("carried out") << false;
        QTest::newRow("taken back") << true;
    }
    void knowsBothSides()
    {
        QFETCH(bool, takenBack);
        RecentSteps steps;
        steps.keep(5, changesOf(10, 1), takenBack);
        QVERIFY(!steps.images(4, true));
        for (const bool withRow : {true, false}) {
            const auto images = steps.images(5, withRow);
            QVERIFY(images && images->size() == 1);
            QVERIFY((images->front().key == BrickKey{Field::Coverage, 1, 1}));
            QCOMPARE(int(images->front().bytes.read().front()), withRow != takenBack ? 101 : 1);
        }
        // What was there before is replaced, whichever way it was.
        steps.keep(5, changesOf(10, 7), !takenBack);
        QCOMPARE(int(steps.images(5, true)->front().bytes.read().front()), takenBack ? 107 : 7);
    }

    void letsGoOfWhatWasUsedLongestAgo()
    {
        RecentSteps steps;
        steps.setMostBytes(3 * 2048 + 1000);
        for (RowId row = 1; row <= 3; ++row)
            steps.keep(row, changesOf(1024, std::uint8_t(row)), false);
        QVERIFY(steps.images(1, true)); // now 2 is the oldest
        steps.keep(4, changesOf(1024, 4), false);
        QVERIFY(!steps.images(2, true));
        QVERIFY(steps.images(1, true) && steps.images(3, true) && steps.images(4, true));
        steps.keep(4, changesOf(1024, 4), true); // no second time
        QVERIFY(steps.images(1, true) && steps.images(3, true));
        steps.keep(9, changesOf(100000, 9), false); // more than there may be
        for (RowId row = 1; row <= 9; ++row)
            QVERIFY(!steps.images(row, true));
        steps.keep(1, changesOf(10, 1), false);
        QVERIFY(steps.images(1, true));
        steps.setMostBytes(0);
        QVERIFY(!steps.images(1, true));
    }

    /// Walks lead to the same voxels, from memory, from the file, and from some of each.
    void walksDoNotDependOnMemory_data()
    {
        QTest::addColumn<qulonglong>("bytes");
        QTest::newRow("none") << qulonglong(0);
        QTest::newRow("some") << qulonglong(200000);
        QTest::newRow("all") << qulonglong(RecentSteps::usualBytes);
    }
    void walksDoNotDependOnMemory()
    {
        QFETCH(qulonglong, bytes);
        const QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("a.burin"));
        test::makeSession(path);
        reference::ReferenceEngine engine;
        const auto session = EditSession::open(engine, test::smallStudy(), path);
        QVERIFY(session);
        (*session)->storage().setStepMemory(std::size_t(bytes));
        const History& history = (*session)->history();
        std::mt19937 random(3);
        for (int walk = 0; walk < 40; ++walk) {
            const auto row = RowId(random() % (history.rows().size() + 1));
            QVERIFY((*session)->goTo(row));
            QVERIFY((*session)->settle());
            QCOMPARE(history.position(), row);
            if (row > 0)
                QCOMPARE((*session)->stateHash(), history.row(row).stateHash);
        }
    }
};

BURIN_TEST(RecentStepsTest)

} // namespace recentStepsTest

#include "RecentStepsTest.moc"
