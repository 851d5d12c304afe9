// SPDX-License-Identifier: Apache-2.0
#include "core/history/History.h"
#include "core/edits/kinds/history/RevertRows.h"
#include "tests/support/program/TestProgram.h"

#include <QTest>

namespace historyTest {

using namespace core;

namespace {

HistoryRow named(const char* name)
{
    HistoryRow row;
    row.name = QLatin1String(name);
    return row;
}

/// a ─ b ─ c
///  └─ d ─ e      position e
History branched()
{
    History history;
    const RowId a = history.append(named("a"));
    history.append(named("b"));
    history.append(named("c"));
    history.moveTo(a);
    history.append(named("d"));
    history.append(named("e"));
    return history;
}

} // namespace

class HistoryTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void startsAtTheBeginning()
    {
        const History history;
        QCOMPARE(history.position(), RowId(0));
        QVERIFY(!history.canUndo());
        QVERIFY(!history.canRedo());
        QVERIFY(history.pathTo(0).empty());
    }

    void appendingAfterUndoBranchesAndForgetsNothing()
    {
        const History history = branched();
        QCOMPARE(history.rows().size(), std::size_t(5));
        QCOMPARE(history.row(4).parent, RowId(1));
        QCOMPARE(history.pathTo(5), (std::vector<RowId>{1, 4, 5}));
        QCOMPARE(history.pathTo(3), (std::vector<RowId>{1, 2, 3}));
        QCOMPARE(history.row(3).name, QStringLiteral("c"));
    }

    void whatWasTakenBackDoesNotStand()
    {
        History history = branched(); // 1 ─ 4 ─ 5
        const auto revert = [&history](std::vector<std::int64_t> rows) {
            HistoryRow row = named("revert");
            row.edit = RevertRows{std::move(rows)};
            history.append(std::move(row));
        };
        QCOMPARE(history.standing(), (std::vector<RowId>{1, 4, 5}));
        revert({4, 5});
        QCOMPARE(history.standing(), (std::vector<RowId>{1, 6}));
        revert({6}); // brings them back
        QCOMPARE(history.standing(), (std::vector<RowId>{1, 4, 5, 7}));
        history.moveTo(6);
        QCOMPARE(history.standing(), (std::vector<RowId>{1, 6}));
    }

    void redoGoesWhereOneWasLast()
    {
        History history = branched();
        history.moveTo(1);
        QCOMPARE(history.redoTarget(), RowId(4));
        history.moveTo(3);
        QVERIFY(!history.canRedo());
        history.moveTo(0);
        QCOMPARE(history.redoTarget(), RowId(1));
        history.moveTo(1);
        QCOMPARE(history.redoTarget(), RowId(2));
    }

    void isRestoredAsItWas()
    {
        History before = branched();
        before.moveTo(3);
        before.moveTo(1);
        const History after = History::restored(before.rows(), {{0, 1}, {1, 2}, {2, 3}, {4, 5}}, 1);
        QCOMPARE(after.position(), RowId(1));
        QCOMPARE(after.redoTarget(), RowId(2));
        QCOMPARE(after.pathTo(5), before.pathTo(5));
        QCOMPARE(History::restored(before.rows(), {}, 1).redoTarget(), RowId(4));
    }
};

BURIN_TEST(HistoryTest)

} // namespace historyTest

#include "HistoryTest.moc"
