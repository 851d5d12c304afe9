// SPDX-License-Identifier: Apache-2.0
#include "ui/models/HistoryModel.h"
#include "tests/support/program/LongRun.h"

#include "core/edits/kinds/segments/ChangeSegment.h"
#include "core/sessionfile/HistoryListing.h"
#include "tests/support/fixtures/WorkspaceFixture.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/PlainEdits.h"
#include "ui/workspace/ViewSteps.h"

#include <QAbstractItemModelTester>
#include <QRandomGenerator>
#include <QSignalSpy>
#include <QtTest>

namespace historyModelTest {

using test::WorkspaceFixture;
using ui::HistoryModel;

namespace {

core::Edit growSteps(int steps)
{
    return test::growBetween(0.0, 20.0, steps);
}

QStringList names(const HistoryModel& model)
{
    QStringList result;
    for (int row = 0; row < model.rowCount(); ++row)
        result += model.index(row).data().toString();
    return result;
}

core::RowId rowOf(const QModelIndex& index)
{
    return index.data(HistoryModel::RowIdRole).toLongLong();
}

bool isHeading(const QModelIndex& index)
{
    return index.data(HistoryModel::HeadingRole).toBool();
}

/// A cheap step.
core::ChangeSegment renamed(int number)
{
    return {.segment = 1, .name = QStringLiteral("name %1").arg(number)};
}

void setAllFolded(HistoryModel& model, bool folded)
{
    for (int row = 0; row < model.rowCount(); ++row) {
        if (isHeading(model.index(row)))
            model.setData(model.index(row), folded, HistoryModel::FoldedRole);
    }
}

std::vector<core::RowId> listedLine(const HistoryModel& model)
{
    std::vector<core::RowId> line;
    for (int row = 0; row < model.rowCount(); ++row) {
        if (model.index(row).data(HistoryModel::DepthRole).toInt() == 0)
            line.push_back(rowOf(model.index(row)));
    }
    return line;
}

/// What is wrong with a list whose branches are all unfolded; empty: nothing.
QString complaint(const HistoryModel& model, const core::History& history)
{
    std::vector<core::RowId> line = history.line();
    line.insert(line.begin(), 0);
    if (listedLine(model) != line || model.line() != line)
        return QStringLiteral("the current line is another");
    if (rowOf(model.index(model.currentRow())) != history.position())
        return QStringLiteral("the current row is another");
    if (line.at(std::size_t(model.linePosition())) != history.position())
        return QStringLiteral("the position on the line is another");

    std::map<core::RowId, core::RowId> forks; // tip → where on the line
    for (const core::HistoryBranch& branch : core::branchesOf(history)) {
        if (!branch.current)
            forks[branch.tip] = branch.forksAt;
    }
    std::set<core::RowId> listed;
    std::vector<core::RowId> lastAtDepth; // the row that the next one of a depth comes after
    for (int row = 0; row < model.rowCount(); ++row) {
        const QModelIndex index = model.index(row);
        const core::RowId id = rowOf(index);
        const auto depth = std::size_t(index.data(HistoryModel::DepthRole).toInt());
        if (depth > lastAtDepth.size())
            return QStringLiteral("entry %1 is too deep").arg(row);
        if (isHeading(index)) {
            const auto fork = forks.find(id);
            if (fork == forks.end() || fork->second != lastAtDepth[0])
                return QStringLiteral("no branch to %1 forks off there").arg(id);
            forks.erase(fork);
            lastAtDepth.resize(depth);
            lastAtDepth.push_back(lastAtDepth.back());
            continue;
        }
        if (!listed.insert(id).second)
            return QStringLiteral("row %1 is listed twice").arg(id);
        if (id != 0 && history.row(id).parent != lastAtDepth.at(depth))
            return QStringLiteral("row %1 comes after another one").arg(id);
        lastAtDepth.resize(depth);
        lastAtDepth.push_back(id);
    }
    if (!forks.empty())
        return QStringLiteral("the branch to %1 is missing").arg(forks.begin()->first);
    if (listed.size() != history.rows().size() + 1)
        return QStringLiteral("rows are missing");
    return {};
}

} // namespace

class HistoryModelTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void listsTheLineAndMarksWhereOneIs()
    {
        WorkspaceFixture fixture;
        HistoryModel model(fixture.workspace);
        QAbstractItemModelTester tester(
            &model, QAbstractItemModelTester::FailureReportingMode::QtTest);
        QCOMPARE(model.rowCount(), 1); // the study as opened
        QCOMPARE(model.currentRow(), 0);

        fixture.apply(test::newSegment(QStringLiteral("Ventricle, left"), 0x4a9bff));
        fixture.apply(WorkspaceFixture::middleSeed(1));
        fixture.apply(growSteps(2));
        QCOMPARE(model.rowCount(), 4);
        QCOMPARE(model.currentRow(), 3);
        // A segment's name keeps its comma; what a growth changed stands at the right.
        QVERIFY(names(model)[1].contains(QStringLiteral("Ventricle, left")));
        QVERIFY(model.index(1).data(HistoryModel::DetailRole).toString().isEmpty());
        QVERIFY(names(model)[3].endsWith(QStringLiteral("'Ventricle, left' 2 steps")));
        QVERIFY(model.index(3)
                    .data(HistoryModel::DetailRole)
                    .toString()
                    .contains(QStringLiteral("voxel")));

        QVERIFY(fixture.session().undo());
        QVERIFY(fixture.session().undo());
        fixture.settle();
        QCOMPARE(model.rowCount(), 4);
        QCOMPARE(model.currentRow(), 1);
        QVERIFY(model.index(1).data(HistoryModel::CurrentRole).toBool());
        QVERIFY(!model.index(1).data(HistoryModel::UndoneRole).toBool());
        QVERIFY(model.index(2).data(HistoryModel::UndoneRole).toBool());
        QVERIFY(model.index(3).data(HistoryModel::UndoneRole).toBool());
    }

    void anOldFutureIsABranch()
    {
        WorkspaceFixture fixture;
        HistoryModel model(fixture.workspace);
        QAbstractItemModelTester tester(
            &model, QAbstractItemModelTester::FailureReportingMode::QtTest);
        fixture.apply(test::newSegment(QStringLiteral("A"), 1));
        fixture.apply(WorkspaceFixture::middleSeed(1));
        fixture.apply(growSteps(1));
        QVERIFY(!model.summary().contains(QStringLiteral("branch")));
        QVERIFY(fixture.session().undo());
        fixture.settle();
        const core::RowId left = rowOf(model.index(3));
        const QString leftName = names(model)[3];
        fixture.apply(growSteps(2));

        // Under the row it forks off, folded; the line goes on below it.
        QCOMPARE(listedLine(model), (std::vector<core::RowId>{0, 1, 2, 4}));
        QCOMPARE(model.rowCount(), 5);
        const QModelIndex heading = model.index(3);
        QVERIFY(isHeading(heading));
        QVERIFY(heading.data(HistoryModel::FoldedRole).toBool());
        QCOMPARE(rowOf(heading), left);
        QCOMPARE(heading.data().toString(), QStringLiteral("Branch to %1").arg(leftName));
        QCOMPARE(heading.data(HistoryModel::DetailRole).toString(), QStringLiteral("1 step"));
        QCOMPARE(heading.data(Qt::AccessibleTextRole).toString(),
            QStringLiteral("Branch, folded: 1 step, last '%1'").arg(leftName));
        QVERIFY(!heading.data(HistoryModel::UndoneRole).toBool());
        QVERIFY(!heading.data(HistoryModel::VoxelsRole).toBool());
        QVERIFY(model.summary().startsWith(QStringLiteral("3 steps · 1 branch · ")));

        QVERIFY(model.setData(heading, false, HistoryModel::FoldedRole));
        QVERIFY(!model.setData(heading, false, HistoryModel::FoldedRole)); // it is
        QVERIFY(!model.setData(model.index(0), false, HistoryModel::FoldedRole));
        QCOMPARE(model.rowCount(), 6);
        const QModelIndex branchRow = model.index(4);
        QCOMPARE(rowOf(branchRow), left);
        QVERIFY(!isHeading(branchRow));
        QCOMPARE(branchRow.data(HistoryModel::DepthRole).toInt(), 1);
        QCOMPARE(branchRow.data().toString(), leftName);
        QVERIFY(branchRow.data(HistoryModel::LastRole).toBool());
        QVERIFY(!branchRow.data(HistoryModel::CurrentRole).toBool());
        QCOMPARE(model.headingOf(branchRow), heading);
        QVERIFY(!model.headingOf(model.index(5)).isValid());
        QCOMPARE(model.currentRow(), 5);
        QCOMPARE(model.indexOnLine(3), model.index(5));

        // Walking to the row that was left makes its branch the line, and the line a branch.
        QVERIFY(fixture.session().goTo(left));
        fixture.settle();
        QCOMPARE(listedLine(model), (std::vector<core::RowId>{0, 1, 2, left}));
        QVERIFY(isHeading(model.index(3)));
        QCOMPARE(rowOf(model.index(3)), core::RowId(4));
        QCOMPARE(model.currentRow(), model.rowCount() - 1);
        QVERIFY(model.setData(model.index(3), false, HistoryModel::FoldedRole));
        QVERIFY(model.setData(model.index(3), true, HistoryModel::FoldedRole));
        QCOMPARE(model.rowCount(), 5);
    }

    void branchesHangWhereTheyFork()
    {
        WorkspaceFixture fixture;
        HistoryModel model(fixture.workspace);
        QAbstractItemModelTester tester(
            &model, QAbstractItemModelTester::FailureReportingMode::QtTest);
        core::EditSession& session = fixture.session();
        const auto goTo = [&](core::RowId row) {
            QVERIFY(session.goTo(row));
            fixture.settle();
        };
        // 0 ─ 1 ─ 2 ─ 3          a branch at the very beginning: 8
        //      └─ 4 ─ 5 ─ 6      and one of a branch: 7, behind 5
        fixture.apply(test::newSegment(QStringLiteral("A"), 1));
        fixture.apply(renamed(2));
        fixture.apply(renamed(3));
        goTo(1);
        for (int step = 4; step <= 6; ++step)
            fixture.apply(renamed(step));
        goTo(5);
        fixture.apply(renamed(7));
        goTo(0);
        fixture.apply(test::newSegment(QStringLiteral("B"), 1));
        goTo(3);

        const auto listed = [&] {
            QStringList entries;
            for (int row = 0; row < model.rowCount(); ++row) {
                const QModelIndex index = model.index(row);
                const int depth = index.data(HistoryModel::DepthRole).toInt();
                const QString form =
                    isHeading(index) ? QStringLiteral("%1branch to %2") : QStringLiteral("%1%2");
                entries += form.arg(QString(depth, u'>')).arg(rowOf(index));
            }
            return entries.join(u' ');
        };
        QCOMPARE(listed(), QStringLiteral("0 >branch to 8 1 >branch to 7 2 3"));
        setAllFolded(model, false);
        QCOMPARE(listed(),
            QStringLiteral("0 >branch to 8 >8 1 >branch to 7 >4 >5 >>branch to 6 >>6 >7 2 3"));
        QCOMPARE(model.summary(), QStringLiteral("3 steps · 3 branches"));
        QCOMPARE(complaint(model, session.history()), QString());

        // Into the middle of a branch: the rest of it can be redone; it stays unfolded where it is.
        goTo(4);
        QCOMPARE(
            listed(), QStringLiteral("0 >branch to 8 >8 1 >branch to 3 4 5 >branch to 6 >6 7"));
        QVERIFY(model.index(model.rowCount() - 1).data(HistoryModel::UndoneRole).toBool());
        setAllFolded(model, true);
        QCOMPARE(listed(), QStringLiteral("0 >branch to 8 1 >branch to 3 4 5 >branch to 6 7"));
    }

    void agreesWithTheHistoryWhateverIsDone()
    {
        const int steps = qEnvironmentVariableIntValue("BURIN_LONG") ? 2000 : 300;
        WorkspaceFixture fixture;
        HistoryModel unfolded(fixture.workspace);
        HistoryModel mixed(fixture.workspace);
        const auto mode = QAbstractItemModelTester::FailureReportingMode::QtTest;
        QAbstractItemModelTester testUnfolded(&unfolded, mode);
        QAbstractItemModelTester testMixed(&mixed, mode);
        core::EditSession& session = fixture.session();
        const core::History& history = session.history();
        fixture.apply(test::newSegment(QStringLiteral("A"), 1));
        QRandomGenerator random(20260);
        for (int step = 0; step < steps; ++step) {
            const int what = random.bounded(10);
            if (what < 5 && history.position() != 0)
                QVERIFY(session.apply(renamed(step)));
            else if (what == 5 && history.canUndo())
                QVERIFY(session.undo());
            else if (what == 6 && history.canRedo())
                QVERIFY(session.redo());
            else
                QVERIFY(session.goTo(random.bounded(int(history.rows().size()) + 1)));
            fixture.settle();
            setAllFolded(unfolded, false);
            QVERIFY2(complaint(unfolded, history).isEmpty(),
                qPrintable(
                    QStringLiteral("step %1: %2").arg(step).arg(complaint(unfolded, history))));

            const QModelIndex any = mixed.index(random.bounded(mixed.rowCount()));
            mixed.setData(any, random.bounded(2) == 0, HistoryModel::FoldedRole);
            QCOMPARE(listedLine(mixed), listedLine(unfolded));
            QCOMPARE(rowOf(mixed.index(mixed.currentRow())), history.position());
            QCOMPARE(mixed.summary(), unfolded.summary());
        }
        QVERIFY(core::branchesOf(history).size() > 20);
    }

    /// Clicks of eyes without anything between them are one row, and so is a clip. They lie on the
    /// current line after the row at which they were made, and have no rows of the session.
    void changesOfTheViewStandUnderTheirRow()
    {
        WorkspaceFixture fixture;
        HistoryModel model(fixture.workspace);
        QAbstractItemModelTester tester(
            &model, QAbstractItemModelTester::FailureReportingMode::QtTest);
        ui::ViewSteps& view = fixture.workspace.viewSteps();
        const auto data = [&model](int row, int role) { return model.index(row).data(role); };
        fixture.apply(test::newSegment(QStringLiteral("A"), 1));
        fixture.apply(test::newSegment(QStringLiteral("B"), 2));
        view.showSegment(1, false);
        QCOMPARE(model.rowCount(), 4);
        QCOMPARE(names(model)[3], QStringLiteral("Hide 'A'"));
        view.showSegment(2, false);
        QCOMPARE(model.rowCount(), 4);
        QCOMPARE(names(model)[3], QStringLiteral("Hide 2 segments"));
        QCOMPARE(model.currentRow(), 3);
        QCOMPARE(model.linePosition(), 2);
        QCOMPARE(rowOf(model.index(3)), core::RowId(2));
        QCOMPARE(data(3, HistoryModel::ViewStepRole).toInt(), 1);
        QCOMPARE(data(2, HistoryModel::ViewStepRole).toInt(), 0);
        QVERIFY(
            data(3, HistoryModel::LastRole).toBool() && !data(2, HistoryModel::LastRole).toBool());
        QCOMPARE(fixture.session().history().rows().size(), std::size_t(2));
        QCOMPARE(model.line(), (std::vector<core::RowId>{0, 1, 2}));

        core::ClipRegion clip = fixture.workspace.clip();
        clip.box.on = true;
        view.change(clip);
        QCOMPARE(names(model)[4], QStringLiteral("Clip"));
        fixture.apply(test::newSegment(QStringLiteral("C"), 3));
        QCOMPARE(model.rowCount(), 6);
        QVERIFY(names(model)[5].contains(QStringLiteral("'C'")));
        QCOMPARE(model.currentRow(), 5);
        QCOMPARE(rowOf(model.indexOnLine(2)), core::RowId(2));
        QCOMPARE(model.indexOnLine(3).row(), 5);

        QVERIFY(fixture.session().undo());
        fixture.settle();
        QCOMPARE(model.currentRow(), 4);
        QVERIFY(!data(4, HistoryModel::UndoneRole).toBool());
        QVERIFY(data(5, HistoryModel::UndoneRole).toBool());
        view.undo();
        QCOMPARE(model.currentRow(), 3);
        QVERIFY(data(4, HistoryModel::UndoneRole).toBool());
        view.goTo(0);
        QCOMPARE(model.currentRow(), 2);
        QVERIFY(data(3, HistoryModel::UndoneRole).toBool());
        view.goTo(1);
        QCOMPARE(model.currentRow(), 3);

        // What was undone goes when something else is done, and the old future is a branch below.
        fixture.apply(test::newSegment(QStringLiteral("D"), 4));
        QCOMPARE(model.rowCount(), 6);
        QCOMPARE(names(model)[3], QStringLiteral("Hide 2 segments"));
        QVERIFY(isHeading(model.index(4)));
        QVERIFY(names(model)[5].contains(QStringLiteral("'D'")));
        QCOMPARE(model.currentRow(), 5);
        // Eyes that come to nothing leave none.
        view.showSegment(1, true);
        QCOMPARE(names(model)[6], QStringLiteral("Show 'A'"));
        view.showSegment(1, false);
        QCOMPARE(model.rowCount(), 6);
    }

    void isEmptyWithoutAStudy()
    {
        WorkspaceFixture fixture;
        HistoryModel model(fixture.workspace);
        QAbstractItemModelTester tester(
            &model, QAbstractItemModelTester::FailureReportingMode::QtTest);
        fixture.apply(test::newSegment(QStringLiteral("A"), 1));
        QSignalSpy reset(&model, &QAbstractItemModel::modelReset);
        fixture.workspace.setSession(nullptr);
        QCOMPARE(reset.count(), 1);
        QCOMPARE(model.rowCount(), 0);
        QCOMPARE(model.currentRow(), -1);
    }
};

BURIN_TEST(HistoryModelTest)

} // namespace historyModelTest

#include "HistoryModelTest.moc"
