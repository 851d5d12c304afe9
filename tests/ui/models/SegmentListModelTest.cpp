// SPDX-License-Identifier: Apache-2.0
#include "ui/models/SegmentListModel.h"

#include "core/edits/kinds/segments/InvertSegment.h"
#include "core/edits/kinds/segments/MoveSegment.h"
#include "core/edits/kinds/segments/RemoveSegment.h"
#include "tests/support/fixtures/WorkspaceFixture.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/PlainEdits.h"
#include "tests/support/scenes/TestVolumes.h"
#include "ui/base/NumberText.h"
#include "ui/workspace/SegmentActions.h"

#include <QAbstractItemModelTester>
#include <QColor>
#include <QSignalSpy>
#include <QtTest>

#include <array>
#include <utility>

namespace segmentListModelTest {

using test::WorkspaceFixture;
using ui::SegmentListModel;

class SegmentListModelTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void followsTheDocument()
    {
        WorkspaceFixture fixture;
        SegmentListModel model(fixture.workspace);
        QAbstractItemModelTester tester(
            &model, QAbstractItemModelTester::FailureReportingMode::QtTest);
        QCOMPARE(model.rowCount(), 0);
        const auto first = ui::addSegment(fixture.workspace);
        const auto second = ui::addSegment(fixture.workspace);
        QVERIFY(first && second);
        QCOMPARE(model.rowCount(), 2);
        QCOMPARE(model.index(0).data().toString(), QStringLiteral("Segment 1"));
        QCOMPARE(model.index(1).data().toString(), QStringLiteral("Segment 2"));
        QVERIFY(model.index(0).data(SegmentListModel::ColourRole)
            != model.index(1).data(SegmentListModel::ColourRole));
        QVERIFY(model.index(1).data(SegmentListModel::ActiveRole).toBool());
        QVERIFY(!model.index(0).data(SegmentListModel::ActiveRole).toBool());
        QCOMPARE(model.rowOf(*second), 1);

        QVERIFY(fixture.session().undo());
        fixture.settle();
        QCOMPARE(model.rowCount(), 1);
        QCOMPARE(model.rowOf(*second), -1);
    }

    /// However segments come, go and move, a row that stays is the same row.
    void rowsThatStayAreTheSame()
    {
        WorkspaceFixture fixture;
        SegmentListModel model(fixture.workspace);
        QAbstractItemModelTester tester(
            &model, QAbstractItemModelTester::FailureReportingMode::QtTest);
        test::Random random(23);
        for (int step = 0; step < 120; ++step) {
            std::vector<std::pair<int, QPersistentModelIndex>> kept;
            for (int row = 0; row < model.rowCount(); ++row)
                kept.emplace_back(
                    model.index(row).data(SegmentListModel::LabelRole).toInt(), model.index(row));
            const auto& segments = fixture.session().document().segments;
            const int count = int(segments.size());
            const int what = test::randomInt(random, 0, 4);
            const int place = count > 0 ? test::randomInt(random, 1, count) : 0;
            const int label = count > 0 ? segments[std::size_t(place - 1)].label : 0;
            if (count < 2 || (what == 0 && count < 8))
                QVERIFY(ui::addSegment(fixture.workspace));
            else if (what == 1)
                QVERIFY(fixture.session().apply(core::RemoveSegment{.segment = label}));
            else if (what < 4)
                QVERIFY(fixture.session().apply(core::MoveSegment{
                    .segment = label, .place = test::randomInt(random, 1, count)}));
            else
                QVERIFY(fixture.session().undo());
            fixture.settle();
            for (const auto& [before, index] : kept) {
                QCOMPARE(index.isValid(), fixture.session().document().segment(before) != nullptr);
                if (index.isValid())
                    QCOMPARE(index.data(SegmentListModel::LabelRole).toInt(), before);
            }
        }
    }

    void changesAreStepsOfUndoButVisibilityIsNone()
    {
        WorkspaceFixture fixture;
        SegmentListModel model(fixture.workspace);
        QAbstractItemModelTester tester(
            &model, QAbstractItemModelTester::FailureReportingMode::QtTest);
        QVERIFY(ui::addSegment(fixture.workspace));
        const QModelIndex row = model.index(0);
        const auto position = [&fixture] { return fixture.session().history().position(); };
        const auto before = position();

        QVERIFY(model.setData(row, QStringLiteral("Skull"), Qt::EditRole));
        fixture.settle();
        QCOMPARE(row.data().toString(), QStringLiteral("Skull"));
        QCOMPARE(position(), before + 1);
        QVERIFY(!model.setData(row, QStringLiteral("  "), Qt::EditRole));
        QVERIFY(!model.setData(row, QStringLiteral("Skull"), Qt::EditRole));

        QVERIFY(model.setData(row, QColor(0x10, 0x20, 0x30), SegmentListModel::ColourRole));
        fixture.settle();
        QCOMPARE(fixture.session().document().segments[0].rgb, 0x102030u);

        QCOMPARE(
            row.data(SegmentListModel::CodeTextRole).toString(), QStringLiteral("not coded yet"));
        QVERIFY(model.setData(row,
            QStringList{QStringLiteral("SCT"), QStringLiteral("89546000"), QStringLiteral("Skull")},
            SegmentListModel::CodeRole));
        fixture.settle();
        QCOMPARE(row.data(SegmentListModel::CodeTextRole).toString(), QStringLiteral("Skull"));

        QVERIFY(!row.data(SegmentListModel::LockedRole).toBool());
        QVERIFY(model.setData(row, true, SegmentListModel::LockedRole));
        QVERIFY(!model.setData(row, true, SegmentListModel::LockedRole));
        fixture.settle();
        QVERIFY(row.data(SegmentListModel::LockedRole).toBool());
        QCOMPARE(position(), before + 4);

        const auto shown = position();
        QSignalSpy changed(&model, &QAbstractItemModel::dataChanged);
        QVERIFY(model.setData(row, false, SegmentListModel::VisibleRole));
        QVERIFY(!row.data(SegmentListModel::VisibleRole).toBool());
        QVERIFY(changed.count() > 0);
        QCOMPARE(position(), shown);
    }

    void followsTheOrder()
    {
        WorkspaceFixture fixture;
        SegmentListModel model(fixture.workspace);
        QAbstractItemModelTester tester(
            &model, QAbstractItemModelTester::FailureReportingMode::QtTest);
        for (int i = 0; i < 3; ++i)
            QVERIFY(ui::addSegment(fixture.workspace));
        fixture.settle();
        fixture.apply(core::MoveSegment{.segment = 3, .place = 1});
        for (int row = 0; row < 3; ++row)
            QCOMPARE(model.index(row).data(SegmentListModel::LabelRole).toInt(),
                (std::array{3, 1, 2})[std::size_t(row)]);
        QCOMPARE(model.rowOf(2), 2);
    }

    void tellsVolumes()
    {
        QCOMPARE(ui::millilitreText(0, 1.0), QStringLiteral("—"));
        const QLocale previous;
        QLocale::setDefault(QLocale::c());
        QCOMPARE(ui::millilitreText(9840, 1.0), QStringLiteral("9.84 mL"));
        QCOMPARE(ui::millilitreText(98400, 1.0), QStringLiteral("98.4 mL"));
        QCOMPARE(ui::millilitreText(1000000, 1.5), QStringLiteral("1 500 mL"));
        QLocale::setDefault(previous);

        WorkspaceFixture fixture;
        SegmentListModel model(fixture.workspace);
        QVERIFY(ui::addSegment(fixture.workspace));
        fixture.apply(WorkspaceFixture::middleSeed(1));
        fixture.apply(test::growBetween(0.0, 20.0));
        const auto voxels = test::smallHead::voxelsOf(test::smallHead::ventricleHu);
        QVERIFY(voxels > 100);
        QCOMPARE(fixture.session().document().segments[0].voxels, voxels);
        QCOMPARE(model.index(0).data(SegmentListModel::VolumeRole).toString(),
            ui::millilitreText(voxels, 1.5));
    }

    /// Millilitres that nobody has measured are not told, as in the panel Statistics.
    void tellsVoxelsWhereVolumesAreUnknown()
    {
        const auto textOn = [](core::LoadedVolume volume) {
            WorkspaceFixture fixture(std::move(volume));
            SegmentListModel model(fixture.workspace);
            fixture.apply(test::newSegment(QStringLiteral("Ventricle")));
            fixture.apply(
                test::thresholdOf(1, test::smallHead::ventricleHu, test::smallHead::ventricleHu));
            return model.index(0).data(SegmentListModel::VolumeRole).toString();
        };
        const auto voxels = test::smallHead::voxelsOf(test::smallHead::ventricleHu);
        core::LoadedVolume unknown = test::smallHead::volume();
        unknown.volume.problems.push_back({.kind = core::VolumeProblem::Kind::AssumedSpacing,
            .said = {core::ProblemCode::SpacingAssumed}});
        QCOMPARE(
            textOn(std::move(unknown)), QStringLiteral("%1 voxels").arg(ui::countText(voxels)));
        core::LoadedVolume uneven = test::smallHead::volume();
        for (int k = 0; k < test::smallHead::side; ++k)
            uneven.volume.geometry.slicePositions.emplace_back(
                -20.0, -20.0, k < test::smallHead::side / 2 ? k : 2.0 * k);
        QCOMPARE(textOn(std::move(uneven)), QStringLiteral("≈ ") + ui::millilitreText(voxels, 1.5));
    }

    /// The interval that a segment follows, until its voxels are changed by anything else.
    void tellsWhatItFollows()
    {
        WorkspaceFixture fixture;
        SegmentListModel model(fixture.workspace);
        QVERIFY(ui::addSegment(fixture.workspace));
        fixture.settle();
        const QModelIndex row = model.index(0);
        const QString tip = row.data(Qt::ToolTipRole).toString();
        QCOMPARE(tip, QStringLiteral("Segment 1\nnot coded yet"));
        QCOMPARE(row.data(SegmentListModel::FollowsRole).toString(), QString());
        fixture.apply(test::thresholdOf(1, 0.0, 20.0));
        const QString follows = QStringLiteral("follows 0 … 20 HU");
        QCOMPARE(row.data(SegmentListModel::FollowsRole).toString(), follows);
        QCOMPARE(row.data(Qt::ToolTipRole).toString(), tip + u'\n' + follows);
        QVERIFY(
            row.data(Qt::AccessibleTextRole).toString().endsWith(QStringLiteral(", ") + follows));
        fixture.apply(core::InvertSegment{.segment = 1});
        QCOMPARE(row.data(SegmentListModel::FollowsRole).toString(), QString());
        QCOMPARE(row.data(Qt::ToolTipRole).toString(), tip);
        QVERIFY(fixture.session().undo());
        fixture.settle();
        QCOMPARE(row.data(SegmentListModel::FollowsRole).toString(), follows);
    }
};

BURIN_TEST(SegmentListModelTest)

} // namespace segmentListModelTest

#include "SegmentListModelTest.moc"
