// SPDX-License-Identifier: Apache-2.0
#include "core/sessionfile/records/RowText.h"
#include "core/edits/kinds/growth/GrowSteps.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/CutEdits.h"

#include <QTest>

namespace rowTextTest {

using namespace core;

namespace {

HistoryRow grownRow(GrowSteps grow)
{
    return {.id = 7,
        .parent = 5,
        .name = QStringLiteral("Grow 'Brain' 3 steps, +12 voxels"),
        .edit = std::move(grow),
        .statistics = {.voxelsChanged = 12, .bricks = 2, .generations = 3, .milliseconds = 1.5},
        .origin = {.at = QDateTime({2026, 11, 21}, {14, 2, 3, 45}, Qt::UTC),
            .author = QStringLiteral("Dr. Jörg \"J\" Müller"),
            .program = QStringLiteral("burin 0.1.0")},
        .growthGeneration = 4};
}

GrowSteps growth(bool tellsHeld)
{
    return {.criteria = {.lower = 0, .upper = 100}, .steps = 3, .tellsHeld = tellsHeld};
}

} // namespace

/// What a row of the history is in a file, and what rows of earlier files mean.
class RowTextTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void comesBackAsItWas_data()
    {
        QTest::addColumn<bool>("tellsHeld");
        QTest::addRow("tells what was held") << true;
        QTest::addRow("does not") << false;
    }
    void comesBackAsItWas()
    {
        QFETCH(bool, tellsHeld);
        const HistoryRow row = grownRow(growth(tellsHeld));
        const Result<HistoryRow> back = RowText::of(row).row();
        QVERIFY(back);
        QCOMPARE(back->id, row.id);
        QCOMPARE(back->parent, row.parent);
        QCOMPARE(back->name, row.name);
        QCOMPARE(back->edit.get<GrowSteps>().steps, std::optional<int>(3));
        QCOMPARE(back->edit.get<GrowSteps>().tellsHeld, tellsHeld);
        QCOMPARE(back->statistics.voxelsChanged, row.statistics.voxelsChanged);
        QCOMPARE(back->statistics.generations, 3);
        QCOMPARE(back->growthGeneration, 4u);
        QCOMPARE(back->origin.at, row.origin.at);
        QCOMPARE(back->origin.author, row.origin.author);
        QCOMPARE(RowText::of(*back).chain(QString()), RowText::of(row).chain(QString()));
    }

    /// Who follows an interval is said by rows where there is something to say: others are the
    /// bytes that they always were.
    void intervalsComeBack()
    {
        HistoryRow row = grownRow(growth(true));
        const QString plain = RowText::of(row).statistics;
        QVERIFY(!plain.contains(QStringLiteral("nterval")));
        QVERIFY(!RowText::of(row).row()->statistics.followsInterval);
        row.statistics.followsInterval = true;
        row.statistics.intervalsLeft = {3, 200};
        const Result<HistoryRow> back = RowText::of(row).row();
        QVERIFY(back && back->statistics.followsInterval);
        QCOMPARE(back->statistics.intervalsLeft, (std::vector<int>{3, 200}));
        QCOMPARE(RowText::of(*back).statistics, RowText::of(row).statistics);
    }

    /// Up to schema 3 growth did not tell voxels that a segment held before from those that it grew
    /// over; such a row does not say so, and is carried out again as it was then.
    void aRowFromBeforeGrowsByItsOwnRule()
    {
        RowText text = RowText::of(grownRow(growth(true)));
        QJsonObject edit = parsed(text.edit);
        QVERIFY(edit.contains(QStringLiteral("tellsHeld")));
        edit.remove(QStringLiteral("tellsHeld"));
        text.edit = compact(edit);
        const Result<HistoryRow> back = text.row();
        QVERIFY(back);
        QVERIFY(!back->edit.get<GrowSteps>().tellsHeld);
    }

    /// The first drills took every sample for a corner of the path, and their rows do not say so.
    void aDrillFromBeforeKeepsItsCorners()
    {
        HistoryRow row = grownRow(growth(true));
        row.edit = test::drillWith({.view = OrthographicView{.targetLps = {0, 0, 9}},
            .samples = std::vector<PenSample>{{.pressure = 1.0}}});
        RowText text = RowText::of(row);
        QVERIFY(test::factsOfStroke(text.row()->edit).byTime);
        QJsonObject edit = parsed(text.edit);
        QVERIFY(edit.value(QStringLiteral("byTime")).toBool());
        edit.remove(QStringLiteral("byTime"));
        text.edit = compact(edit);
        const Result<HistoryRow> back = text.row();
        QVERIFY(back);
        QVERIFY(!test::factsOfStroke(back->edit).byTime);
    }

    void anUnknownEditIsRefused()
    {
        RowText text = RowText::of(grownRow(growth(true)));
        text.edit = QStringLiteral("{\"edit\":\"fold\"}");
        QVERIFY(!text.row());
    }
};

BURIN_TEST(RowTextTest)

} // namespace rowTextTest

#include "RowTextTest.moc"
