// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/lists/StatisticsPanel.h"

#include "core/export/common/ImportedSegments.h"
#include "core/export/common/StatisticsText.h"
#include "core/session/past/PastImports.h"
#include "core/session/questions/VoxelQuestions.h"
#include "tests/support/cases/SurfaceCases.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/fixtures/ApplicationFixture.h"
#include "tests/support/fixtures/WorkspaceFixture.h"
#include "tests/support/program/OwnSettings.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/PlainEdits.h"
#include "ui/dialogs/export/ExportDialog.h"
#include "ui/frame/PanelSection.h"
#include "ui/models/StatisticsModel.h"

#include <QAbstractItemModelTester>
#include <QAction>
#include <QClipboard>
#include <QComboBox>
#include <QGuiApplication>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>
#include <QTableView>
#include <QtTest>

#include <utility>

namespace statisticsPanelUiTest {

namespace {

using ui::StatisticsModel;

/// The panel on the small head; it is not shown yet.
class StatisticsFixture : public test::WorkspaceFixture {
public:
    explicit StatisticsFixture(core::LoadedVolume volume = test::smallHead::volume())
        : WorkspaceFixture(std::move(volume))
        , panel(workspace)
        , table(*panel.findChild<QTableView*>(QStringLiteral("segmentStatistics")))
    {
        panel.resize(ui::PanelSection::leastWidth, 400);
    }
    void add(const QString& name) { apply(test::newSegment(name, 0x4080C0)); }
    void paint(int segment, const glm::dvec3& place, double radiusMm)
    {
        apply(test::paintAt(segment, {place}, radiusMm));
    }
    /// Questions are answered when somebody polls.
    [[nodiscard]] bool measured()
    {
        session().poll();
        QCoreApplication::processEvents();
        return !panel.statistics().isLooking();
    }
    [[nodiscard]] std::int64_t count() const { return panel.statistics().measuredSegments(); }
    [[nodiscard]] QVariant at(int row, const char* key, int role = StatisticsModel::NumberRole)
    {
        return table.model()->index(row, StatisticsModel::columnOf(QLatin1String(key))).data(role);
    }
    [[nodiscard]] QString text(int row, const char* key)
    {
        return at(row, key, Qt::DisplayRole).toString();
    }
    [[nodiscard]] QString name(int row) const
    {
        return table.model()->headerData(row, Qt::Vertical).toString();
    }
    [[nodiscard]] QStringList names() const
    {
        QStringList all;
        for (int row = 0; row < table.model()->rowCount(); ++row)
            all += name(row);
        return all;
    }
    [[nodiscard]] QAction& action(const char* name) const
    {
        return *panel.findChild<QAction*>(QLatin1String(name));
    }
    void clickHeader(const char* key)
    {
        const QHeaderView* header = table.horizontalHeader();
        const int column = StatisticsModel::columnOf(QLatin1String(key));
        QTest::mouseClick(header->viewport(), Qt::LeftButton, {},
            QPoint(header->sectionViewportPosition(column) + header->sectionSize(column) / 2,
                header->height() / 2));
    }
    /// What an export of all segments would write as CSV.
    [[nodiscard]] QByteArray exportedCsv()
    {
        const auto labels = session().questions().labels(0);
        const core::LoadedVolume head = test::smallHead::volume();
        const core::ExportRequest request{.format = core::ExportFormat::Csv,
            .file = QStringLiteral("a.csv"),
            .segments = session().document().segments,
            .planes = {{.plane = 0, .labels = *labels}},
            .codes = head.codes,
            .imported = core::importedAs(session().document().segments,
                core::doneImports(session().history()), head.volume.geometry.voxelCount())};
        const auto selection = core::selectMask(*workspace.volume(), request);
        const auto all = core::segmentStatistics(*workspace.volume(), request, *selection, {});
        return core::statisticsCsv(*all, *workspace.volume());
    }

    ui::StatisticsPanel panel;
    QTableView& table;
};

QList<QList<QByteArray>> cellsOf(const QByteArray& csv)
{
    QList<QList<QByteArray>> rows;
    for (const QByteArray& line : csv.trimmed().split('\n'))
        rows += line.trimmed().split(',');
    return rows;
}

} // namespace

/// The table of statistics in the window.
class StatisticsPanelUiTest : public QObject {
    Q_OBJECT

private:
    test::OwnSettings m_settings;

private Q_SLOTS:
    void init()
    {
        test::failOnUnexpectedMessages();
        m_settings.clear();
    }

    void aPaintedSegmentHasItsNumbers()
    {
        StatisticsFixture fixture;
        const QAbstractItemModelTester tester(
            fixture.table.model(), QAbstractItemModelTester::FailureReportingMode::QtTest);
        fixture.panel.show();
        const auto* empty = fixture.panel.findChild<QLabel*>(QStringLiteral("noStatistics"));
        const auto* button =
            fixture.panel.findChild<QPushButton*>(QStringLiteral("exportStatistics"));
        QVERIFY(empty->isVisible() && !fixture.table.isVisible() && !button->isEnabled());
        fixture.add(QStringLiteral("Brain"));
        QVERIFY(!empty->isVisible() && fixture.table.isVisible() && button->isEnabled());
        QCOMPARE(fixture.names(), QStringList{QStringLiteral("Brain")});
        QCOMPARE(fixture.text(0, "volumeMl"), QStringLiteral("—"));
        QVERIFY(!fixture.at(0, "volumeMl").isValid());
        QTRY_VERIFY(fixture.measured());
        QCOMPARE(fixture.count(), std::int64_t(0)); // nothing is there

        // In the ventricle, whose values are all 8 HU; voxels are of 1.5 mm³.
        fixture.paint(1, {0.0, 0.0, 0.0}, 3.0);
        QVERIFY(fixture.at(0, "mean", StatisticsModel::BehindRole).toBool());
        QCOMPARE(fixture.panel.summary(), QStringLiteral("measuring …"));
        QTRY_VERIFY(fixture.measured());
        QCOMPARE(fixture.panel.summary(), QString());
        const auto voxels = fixture.session().document().segment(1)->voxels;
        QVERIFY(voxels > 50);
        QCOMPARE(fixture.at(0, "voxels").toDouble(), double(voxels));
        QCOMPARE(fixture.at(0, "volumeMl").toDouble(), double(voxels) * 1.5 / 1000.0);
        QCOMPARE(fixture.at(0, "mean").toDouble(), test::smallHead::ventricleHu);
        QCOMPARE(fixture.at(0, "standardDeviation").toDouble(), 0.0);
        QCOMPARE(fixture.text(0, "maximum"), QStringLiteral("8"));
        QVERIFY(!fixture.at(0, "mean", StatisticsModel::BehindRole).toBool());
        QVERIFY(!fixture.at(0, "mean", Qt::ForegroundRole).isValid());

        // More of it, beyond the ventricle: the old numbers stand there, dimmed, until the new do.
        fixture.paint(1, {8.0, 0.0, 0.0}, 3.0);
        QVERIFY(fixture.at(0, "mean", StatisticsModel::BehindRole).toBool());
        QVERIFY(fixture.at(0, "mean", Qt::ForegroundRole).isValid());
        QCOMPARE(fixture.at(0, "voxels").toDouble(), double(voxels));
        QTRY_VERIFY(fixture.measured());
        QVERIFY(!fixture.at(0, "mean", Qt::ForegroundRole).isValid());
        QCOMPARE(fixture.at(0, "voxels").toDouble(),
            double(fixture.session().document().segment(1)->voxels));
        QVERIFY(fixture.at(0, "mean").toDouble() > test::smallHead::ventricleHu);
        QCOMPARE(fixture.at(0, "maximum").toDouble(), test::smallHead::brainHu);

        // Undo brings the numbers back, and at last takes them away.
        QVERIFY(fixture.session().undo());
        fixture.settle();
        QTRY_VERIFY(fixture.measured());
        QCOMPARE(fixture.at(0, "voxels").toDouble(), double(voxels));
        QCOMPARE(fixture.at(0, "maximum").toDouble(), test::smallHead::ventricleHu);
        QVERIFY(fixture.session().undo());
        fixture.settle();
        QCOMPARE(fixture.text(0, "mean"), QStringLiteral("—"));
        QTRY_VERIFY(fixture.measured());
        QVERIFY(fixture.session().undo());
        fixture.settle();
        QVERIFY(empty->isVisible() && !fixture.table.isVisible());
    }

    void numbersAreThoseOfTheExport()
    {
        StatisticsFixture fixture;
        fixture.panel.show();
        for (const char* name : {"One", "Two", "Three"})
            fixture.add(QLatin1String(name));
        fixture.paint(1, {0.0, 2.0, 1.0}, 7.0);
        fixture.paint(2, {9.0, 0.0, 3.0}, 6.0); // as far as it is free
        fixture.paint(3, {-12.0, -3.0, -6.0}, 5.0);
        QTRY_VERIFY(fixture.measured());
        QCOMPARE(fixture.count(), std::int64_t(3));
        const auto csv = cellsOf(fixture.exportedCsv());
        QCOMPARE(csv.size(), 4);
        const QAbstractItemModel& model = *fixture.table.model();
        for (int row = 0; row < 3; ++row) {
            QCOMPARE(fixture.name(row), QString::fromUtf8(csv[row + 1][1]));
            for (int column = 1; column < model.columnCount(); ++column) {
                const QByteArray key =
                    model.headerData(column, Qt::Horizontal, StatisticsModel::KeyRole)
                        .toString()
                        .toLatin1();
                if (key.startsWith("import")) // nothing was
                    continue;
                const qsizetype place = csv[0].indexOf(key);
                QVERIFY2(place >= 0, key.constData());
                const QVariant number = model.index(row, column).data(StatisticsModel::NumberRole);
                QVERIFY2(number.isValid(), key.constData());
                // To the last bit.
                QVERIFY2(number.toDouble() == csv[row + 1][place].toDouble(), key.constData());
            }
        }
    }

    void whatHasChangedSinceTheImport()
    {
        StatisticsFixture fixture;
        fixture.panel.show();
        fixture.apply(test::ballMask(fixture.workspace.volume()->geometry.size, 4.0));
        fixture.add(QStringLiteral("Drawn"));
        fixture.paint(2, {-12.0, -3.0, -6.0}, 3.0);
        QTRY_VERIFY(fixture.measured());
        QCOMPARE(fixture.text(0, "importAddedMl"), QStringLiteral("0"));
        QCOMPARE(fixture.text(0, "importTakenMl"), QStringLiteral("0"));
        QCOMPARE(fixture.at(0, "importDice").toDouble(), 1.0);
        fixture.paint(1, {9.0, 0.0, 3.0}, 3.0);
        fixture.apply(test::eraseAt(1, {{0.0, 0.0, 0.0}}, 2.0));
        QTRY_VERIFY(fixture.measured());
        QVERIFY(fixture.at(0, "importAddedMl").toDouble() > 0.0);
        QVERIFY(fixture.at(0, "importTakenMl").toDouble() > 0.0);
        QVERIFY(fixture.at(0, "importDice").toDouble() < 1.0);
        const auto csv = cellsOf(fixture.exportedCsv());
        for (const char* key : {"importAddedMl", "importTakenMl", "importDice"}) {
            const qsizetype place = csv[0].indexOf(key);
            QVERIFY2(place >= 0, key);
            QVERIFY2(fixture.at(0, key).toDouble() == csv[1][place].toDouble(), key);
            // What was drawn has none.
            QVERIFY2(!fixture.at(1, key).isValid(), key);
            QCOMPARE(fixture.text(1, key), QStringLiteral("—"));
            // They are there for who wants them.
            const int column = StatisticsModel::columnOf(QLatin1String(key));
            QVERIFY(fixture.table.isColumnHidden(column));
            fixture.action(qPrintable(QStringLiteral("statisticsColumn.") + QLatin1String(key)))
                .trigger();
            QVERIFY(!fixture.table.isColumnHidden(column));
        }
    }

    void onlyWhatHasChangedIsMeasured()
    {
        StatisticsFixture fixture;
        fixture.panel.show();
        fixture.add(QStringLiteral("One"));
        fixture.add(QStringLiteral("Two"));
        fixture.paint(1, {-8.0, 0.0, 0.0}, 3.0);
        fixture.paint(2, {8.0, 0.0, 0.0}, 2.0);
        QTRY_VERIFY(fixture.measured());
        QCOMPARE(fixture.count(), std::int64_t(2));
        // Several steps in a row are one measurement, and the other segment is left alone.
        for (const double y : {-1.0, 0.0, 1.0})
            fixture.paint(2, {8.0, y, 0.0}, 3.0);
        QVERIFY(fixture.at(1, "mean", StatisticsModel::BehindRole).toBool());
        QVERIFY(!fixture.at(0, "mean", StatisticsModel::BehindRole).toBool());
        QTRY_VERIFY(fixture.measured());
        QCOMPARE(fixture.count(), std::int64_t(3));
        QCOMPARE(fixture.at(1, "voxels").toDouble(),
            double(fixture.session().document().segment(2)->voxels));
        // What is painted and taken back before anybody looked is as it was.
        fixture.paint(2, {8.0, 4.0, 0.0}, 3.0);
        QVERIFY(fixture.session().undo());
        fixture.settle();
        QTRY_VERIFY(fixture.measured());
        QCOMPARE(fixture.count(), std::int64_t(3));
        QVERIFY(!fixture.at(1, "mean", StatisticsModel::BehindRole).toBool());
        // A name is no voxel.
        fixture.apply(test::renameSegment(1, QStringLiteral("Other")));
        QCOMPARE(fixture.name(0), QStringLiteral("Other"));
        QTRY_VERIFY(fixture.measured());
        QCOMPARE(fixture.count(), std::int64_t(3));
    }

    void aHiddenPanelAsksNothing()
    {
        StatisticsFixture fixture;
        fixture.add(QStringLiteral("One"));
        fixture.paint(1, {0.0, 0.0, 0.0}, 3.0);
        QVERIFY(!fixture.panel.statistics().isLooking());
        QVERIFY(fixture.measured());
        QCOMPARE(fixture.count(), std::int64_t(0));
        fixture.panel.show();
        QVERIFY(fixture.panel.statistics().isLooking());
        QTRY_VERIFY(fixture.measured());
        QCOMPARE(fixture.count(), std::int64_t(1));
        // What was begun ends when nobody looks any more.
        fixture.paint(1, {0.0, 3.0, 0.0}, 3.0);
        QVERIFY(fixture.panel.statistics().isLooking());
        fixture.panel.hide();
        QVERIFY(!fixture.panel.statistics().isLooking());
        fixture.paint(1, {0.0, -3.0, 0.0}, 3.0);
        QVERIFY(!fixture.panel.statistics().isLooking());
        QCOMPARE(fixture.count(), std::int64_t(1));
        fixture.panel.show();
        QTRY_VERIFY(fixture.measured());
        QCOMPARE(fixture.count(), std::int64_t(2));
        QCOMPARE(fixture.at(0, "voxels").toDouble(),
            double(fixture.session().document().segment(1)->voxels));
        // Another session has none of it.
        fixture.workspace.setSession(nullptr);
        QCOMPARE(fixture.table.model()->rowCount(), 0);
        QVERIFY(!fixture.panel.statistics().of(1));
    }

    void rowsAreSortedAndCopied()
    {
        StatisticsFixture fixture;
        fixture.panel.show();
        for (const char* name : {"B", "C", "A"})
            fixture.add(QLatin1String(name));
        fixture.paint(1, {-9.0, 0.0, 0.0}, 5.0);
        fixture.paint(2, {0.0, 0.0, 9.0}, 3.0);
        fixture.paint(3, {9.0, 0.0, 0.0}, 4.0);
        QTRY_VERIFY(fixture.measured());
        const auto order = [](const char* letters) {
            return QString::fromLatin1(letters).split(QLatin1Char(' '));
        };
        QCOMPARE(fixture.names(), order("B C A"));
        fixture.clickHeader("volumeMl");
        QCOMPARE(fixture.names(), order("C A B"));
        fixture.clickHeader("volumeMl");
        QCOMPARE(fixture.names(), order("B A C"));
        fixture.clickHeader("volumeMl");
        QCOMPARE(fixture.names(), order("B C A"));
        fixture.action("sortStatisticsByName").trigger();
        QCOMPARE(fixture.names(), order("A B C"));

        // All rows, as they stand there.
        fixture.table.clearSelection();
        fixture.action("copyStatistics").trigger();
        QStringList lines = QGuiApplication::clipboard()->text().trimmed().split(QLatin1Char('\n'));
        QCOMPARE(lines.size(), 4);
        QVERIFY2(lines[0].startsWith(
                     QStringLiteral("Segment\tVolume (mL)\tMean (HU)\t± SD (HU)\tMin (HU)\t")),
            qPrintable(lines[0]));
        const QStringList cells = lines[1].split(QLatin1Char('\t'));
        QCOMPARE(cells.size(), lines[0].split(QLatin1Char('\t')).size());
        QCOMPARE(cells[0], QStringLiteral("A"));
        QVERIFY(cells[1].toDouble() == fixture.at(0, "volumeMl").toDouble());
        QVERIFY(cells[2].toDouble() == fixture.at(0, "mean").toDouble());

        // The selected one, by the key.
        fixture.panel.activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&fixture.panel));
        fixture.table.selectRow(2);
        fixture.table.setFocus();
        QTRY_VERIFY(fixture.table.hasFocus());
        QTest::keyClick(&fixture.table, Qt::Key_C, Qt::ControlModifier);
        lines = QGuiApplication::clipboard()->text().trimmed().split(QLatin1Char('\n'));
        QCOMPARE(lines.size(), 2);
        QVERIFY(lines[1].startsWith(QStringLiteral("C\t")));
        fixture.action("sortStatisticsAsListed").trigger();
        QCOMPARE(fixture.names(), order("B C A"));
    }

    void columnsAreChosen()
    {
        const int voxels = StatisticsModel::columnOf(QStringLiteral("voxels"));
        const int mean = StatisticsModel::columnOf(QStringLiteral("mean"));
        {
            StatisticsFixture fixture;
            QVERIFY(fixture.table.isColumnHidden(voxels));
            QVERIFY(!fixture.table.isColumnHidden(mean));
            fixture.action("statisticsColumn.voxels").trigger();
            fixture.action("statisticsColumn.mean").trigger();
            QVERIFY(!fixture.table.isColumnHidden(voxels));
            QVERIFY(fixture.table.isColumnHidden(mean));
            QVERIFY(!fixture.panel.asText().contains(QStringLiteral("Mean")));
            QVERIFY(fixture.panel.asText().contains(QStringLiteral("\tVoxels\n")));
        }
        // They are remembered; the last one stays.
        StatisticsFixture fixture;
        QVERIFY(!fixture.table.isColumnHidden(voxels));
        QVERIFY(fixture.table.isColumnHidden(mean));
        for (int column = 1; column < fixture.table.model()->columnCount(); ++column) {
            const QString key = fixture.table.model()
                                    ->headerData(column, Qt::Horizontal, StatisticsModel::KeyRole)
                                    .toString();
            QAction& each = fixture.action(qPrintable(QStringLiteral("statisticsColumn.") + key));
            if (each.isChecked() && column != voxels)
                each.trigger();
        }
        QVERIFY(!fixture.action("statisticsColumn.voxels").isEnabled());
        fixture.action("statisticsColumn.mean").trigger();
        QVERIFY(fixture.action("statisticsColumn.voxels").isEnabled());
    }

    void itFitsTheColumnOfPanels()
    {
        StatisticsFixture fixture;
        fixture.panel.show();
        fixture.add(QStringLiteral("Left ventricle with its papillary muscles"));
        fixture.paint(1, {0.0, 0.0, 0.0}, 3.0);
        QTRY_VERIFY(fixture.measured());
        QVERIFY(fixture.panel.minimumSizeHint().width() <= ui::PanelSection::leastWidth);
        QCOMPARE(fixture.panel.width(), ui::PanelSection::leastWidth);
        // The name leaves room for numbers, and stays when they scroll.
        const QHeaderView& names = *fixture.table.verticalHeader();
        QVERIFY(names.isVisible() && names.width() <= fixture.panel.width() / 2);
        QVERIFY(fixture.table.isColumnHidden(0));
        const QHeaderView& header = *fixture.table.horizontalHeader();
        const int volume = StatisticsModel::columnOf(QStringLiteral("volumeMl"));
        QVERIFY(header.sectionSize(volume)
            >= header.fontMetrics().horizontalAdvance(QStringLiteral("Volume")));
        QCOMPARE(fixture.table.model()->index(0, volume).data(Qt::TextAlignmentRole).toInt(),
            int(Qt::AlignRight | Qt::AlignVCenter));
        // Volume, mean and deviation are seen beside the name, with all of their headings.
        fixture.panel.resize(300, 400);
        for (const char* key : {"volumeMl", "mean", "standardDeviation"}) {
            const int column = StatisticsModel::columnOf(QLatin1String(key));
            const QString heading = fixture.table.model()
                                        ->headerData(column, Qt::Horizontal, Qt::DisplayRole)
                                        .toString();
            for (const QString& line : heading.split(QLatin1Char('\n')))
                QVERIFY2(header.sectionSize(column) >= header.fontMetrics().horizontalAdvance(line),
                    qPrintable(line));
            const int end = header.sectionViewportPosition(column) + header.sectionSize(column);
            QVERIFY2(end <= fixture.table.viewport()->width(),
                qPrintable(
                    QStringLiteral("%1 of %2").arg(end).arg(fixture.table.viewport()->width())));
        }
        // The one by which the table is sorted has room for the arrow, too.
        const int narrow = header.sectionSize(volume);
        fixture.clickHeader("volumeMl");
        QVERIFY(header.sectionSize(volume) > narrow);
        fixture.action("sortStatisticsAsListed").trigger();
        QCOMPARE(header.sectionSize(volume), narrow);
    }

    void unknownSpacingLeavesVoxels()
    {
        core::LoadedVolume volume = test::smallHead::volume();
        volume.volume.problems.push_back({.kind = core::VolumeProblem::Kind::AssumedSpacing,
            .said = {core::ProblemCode::SpacingAssumed}});
        StatisticsFixture fixture(std::move(volume));
        fixture.panel.show();
        fixture.add(QStringLiteral("One"));
        fixture.paint(1, {0.0, 0.0, 0.0}, 3.0);
        QTRY_VERIFY(fixture.measured());
        const int column = StatisticsModel::columnOf(QStringLiteral("volumeMl"));
        QCOMPARE(fixture.table.model()->headerData(column, Qt::Horizontal, Qt::EditRole).toString(),
            QStringLiteral("Volume (voxels)"));
        QCOMPARE(fixture.at(0, "volumeMl").toDouble(),
            double(fixture.session().document().segment(1)->voxels));
        for (const char* key :
            {"surfaceMm2", "sphericity", "longestDiameterMm", "acrossDiameterMm"}) {
            QVERIFY2(!fixture.at(0, key).isValid(), key);
            QCOMPARE(fixture.text(0, key), QStringLiteral("—"));
        }
        QCOMPARE(fixture.at(0, "mean").toDouble(), test::smallHead::ventricleHu);
    }

    /// The button opens the dialog of all exports, with the table's format chosen.
    void theButtonOpensTheExport()
    {
        test::ApplicationFixture fixture;
        fixture.open(fixture.path("case/ct"));
        fixture.edit(test::newSegment(QStringLiteral("One"), 0x4080C0));
        auto* panel = fixture.window().findChild<ui::StatisticsPanel*>();
        QVERIFY(panel);
        QVERIFY(!panel->isVisible()); // it starts folded
        fixture.window().bringUp(*panel);
        QTRY_VERIFY(panel->isVisible());
        panel->findChild<QPushButton*>(QStringLiteral("exportStatistics"))->click();
        auto* dialog = fixture.window().findChild<ui::ExportDialog*>();
        QVERIFY(dialog && dialog->isVisible());
        const auto* format = dialog->findChild<QComboBox*>(QStringLiteral("exportFormat"));
        QCOMPARE(format->currentData().toInt(), int(core::ExportFormat::Csv));
        static_cast<QDialog*>(dialog)->reject();
    }
};

BURIN_WINDOW_TEST(StatisticsPanelUiTest)

} // namespace statisticsPanelUiTest

#include "StatisticsPanelUiTest.moc"
