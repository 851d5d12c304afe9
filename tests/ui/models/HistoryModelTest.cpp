// SPDX-License-Identifier: Apache-2.0
#include "ui/models/HistoryModel.h"

#include "tests/support/WorkspaceFixture.h"

#include <QAbstractItemModelTester>
#include <QSignalSpy>
#include <QtTest>

using test::WorkspaceFixture;
using ui::HistoryModel;

namespace {

core::GrowSteps growSteps(int steps)
{
    core::GrowSteps grow;
    grow.lower = 0.0;
    grow.upper = 20.0;
    grow.steps = steps;
    return grow;
}

QStringList names(const HistoryModel& model)
{
    QStringList result;
    for (int row = 0; row < model.rowCount(); ++row)
        result += model.index(row).data().toString();
    return result;
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

        fixture.apply(core::AddSegment{QStringLiteral("Ventricle, left"), 0x4a9bff, {}});
        fixture.apply(WorkspaceFixture::middleSeed(1));
        fixture.apply(growSteps(2));
        QCOMPARE(model.rowCount(), 4);
        QCOMPARE(model.currentRow(), 3);
        // A segment's name keeps its comma; what a growth changed stands at the right.
        QVERIFY(names(model)[1].contains(QStringLiteral("Ventricle, left")));
        QVERIFY(model.index(1).data(HistoryModel::DetailRole).toString().isEmpty());
        QVERIFY(!names(model)[3].contains(QLatin1Char(',')));
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

    void anotherBranchDoesNotConfuse()
    {
        WorkspaceFixture fixture;
        HistoryModel model(fixture.workspace);
        QAbstractItemModelTester tester(
            &model, QAbstractItemModelTester::FailureReportingMode::QtTest);
        fixture.apply(core::AddSegment{QStringLiteral("A"), 1, {}});
        fixture.apply(WorkspaceFixture::middleSeed(1));
        fixture.apply(growSteps(1));
        QVERIFY(fixture.session().undo());
        fixture.settle();
        const auto left = model.index(3).data(HistoryModel::RowIdRole).toLongLong();
        QSignalSpy removed(&model, &QAbstractItemModel::rowsRemoved);
        fixture.apply(growSteps(2));
        QCOMPARE(model.rowCount(), 4);
        QVERIFY(removed.count() > 0);
        QVERIFY(model.index(3).data(HistoryModel::RowIdRole).toLongLong() != left);
        // Walking back to the row that was left shows its branch again.
        QVERIFY(fixture.session().goTo(left));
        fixture.settle();
        QCOMPARE(model.rowCount(), 4);
        QCOMPARE(model.index(3).data(HistoryModel::RowIdRole).toLongLong(), left);
        QCOMPARE(model.currentRow(), 3);
    }

    void isEmptyWithoutAStudy()
    {
        WorkspaceFixture fixture;
        HistoryModel model(fixture.workspace);
        QAbstractItemModelTester tester(
            &model, QAbstractItemModelTester::FailureReportingMode::QtTest);
        fixture.apply(core::AddSegment{QStringLiteral("A"), 1, {}});
        QSignalSpy reset(&model, &QAbstractItemModel::modelReset);
        fixture.workspace.setSession(nullptr);
        QCOMPARE(reset.count(), 1);
        QCOMPARE(model.rowCount(), 0);
        QCOMPARE(model.currentRow(), -1);
    }
};

QTEST_GUILESS_MAIN(HistoryModelTest)
#include "HistoryModelTest.moc"
