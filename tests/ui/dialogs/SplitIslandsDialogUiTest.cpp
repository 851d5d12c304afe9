// SPDX-License-Identifier: Apache-2.0
#include "ui/dialogs/SplitIslandsDialog.h"

#include "core/brick/VoxelRuns.h"
#include "core/edits/kinds/segments/ImportMask.h"
#include "core/edits/kinds/splitting/SplitIslands.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/fixtures/WindowFixture.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/PlainEdits.h"
#include "tests/support/scenes/SmallStudy.h"
#include "ui/base/ErrorText.h"

#include <QDoubleSpinBox>
#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>
#include <QtTest>

namespace splitIslandsDialogUiTest {

namespace {

/// A segment of three dabs, and one of many voxels that do not touch each other.
struct Fixture : test::WindowFixture {
    Fixture()
        : WindowFixture(test::smallStudy())
    {
        apply(test::addSegment("Parts"));
        dab({10.0, 10.0, 10.0}, 2.0, small);
        dab({28.0, 24.0, 10.0}, 4.0, large);
        dab({10.0, 26.0, 24.0}, 3.0, middle);
        workspace.setActiveSegment(1);
    }
    [[nodiscard]] core::EditSession& session() { return *workspace.session(); }
    void apply(const core::Edit& edit)
    {
        QVERIFY(session().apply(edit));
        QVERIFY(session().settle());
    }
    void dab(const glm::dvec3& index, double radiusMm, std::int64_t& voxelsOfIt)
    {
        const std::int64_t before = voxels(1);
        apply(test::paintAt(1, {workspace.volume()->geometry.toWorld(index)}, radiusMm));
        voxelsOfIt = voxels(1) - before;
    }
    void addSpecks(int count)
    {
        const glm::ivec3 size = workspace.volume()->geometry.size;
        core::VoxelRuns runs;
        for (int i = 0; i < count; ++i)
            runs.append(std::uint64_t(2 * (i / 20) * size.x + 2 * (i % 20)), 1);
        core::ImportMask specks{.file = QStringLiteral("specks.nii")};
        specks.size = size;
        specks.segments = {{.name = QStringLiteral("Specks"),
            .rgb = 7,
            .code = {},
            .voxels = core::packedRuns(runs)}};
        apply(specks);
        workspace.setActiveSegment(session().document().segments.back().label);
    }
    [[nodiscard]] std::int64_t voxels(int label)
    {
        return session().document().segment(label)->voxels;
    }
    [[nodiscard]] std::size_t rows() { return session().history().rows().size(); }
    /// The dialog after the menu Segments has opened it.
    [[nodiscard]] ui::SplitIslandsDialog& opened()
    {
        window.actionTable()[QStringLiteral("segments.splitIslands")].trigger();
        return *window.findChild<ui::SplitIslandsDialog*>();
    }

    std::int64_t small = 0; ///< voxels of a dab
    std::int64_t large = 0;
    std::int64_t middle = 0;
};

QDoubleSpinBox& sizeOf(const QWidget& dialog)
{
    return *dialog.findChild<QDoubleSpinBox*>(QStringLiteral("splitMm3"));
}

QPushButton& splitOf(const QWidget& dialog)
{
    return *dialog.findChild<QPushButton*>(QStringLiteral("applySplit"));
}

} // namespace

class SplitIslandsDialogUiTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    /// A click is one step, which is taken back; the dialog stays for another size.
    void splitsFromASizeOn()
    {
        Fixture fixture;
        QVERIFY(
            fixture.small > 5 && fixture.middle > fixture.small && fixture.large > fixture.middle);
        const QAction& action =
            fixture.window.actionTable()[QStringLiteral("segments.splitIslands")];
        QCOMPARE(action.text(), QStringLiteral("Split islands of 'Parts' into segments …"));
        ui::SplitIslandsDialog& dialog = fixture.opened();
        QVERIFY(dialog.isVisible() && !dialog.isModal());
        QVERIFY(dialog.windowType() == Qt::Tool); // the window's keys work in it, too
        QCOMPARE(dialog.findChild<QLabel*>(QStringLiteral("splitWhose"))->text(),
            QStringLiteral("Parts"));
        QVERIFY(sizeOf(dialog).value() > 0.0 && sizeOf(dialog).value() < 100.0);
        QSignalSpy said(&fixture.workspace, &ui::Workspace::said);
        const std::size_t rows = fixture.rows();
        const std::int64_t all = fixture.voxels(1);
        QTest::mouseClick(&splitOf(dialog), Qt::LeftButton);
        QVERIFY(fixture.session().settle());
        QTRY_COMPARE(said.size(), 1);
        QCOMPARE(said.front().front().toString(),
            QStringLiteral("Split 2 islands off 'Parts', −%1 voxels; Ctrl+Z takes it back")
                .arg(fixture.middle + fixture.small));
        QCOMPARE(fixture.rows(), rows + 1);
        QCOMPARE(fixture.voxels(1), fixture.large);
        QCOMPARE(fixture.voxels(2), fixture.middle);
        QCOMPARE(fixture.voxels(3), fixture.small);
        QCOMPARE(fixture.session().document().segment(2)->name, QStringLiteral("Parts 1"));
        QCOMPARE(fixture.session().document().segment(3)->name, QStringLiteral("Parts 2"));

        QVERIFY(fixture.session().undo() && fixture.session().settle());
        QCOMPARE(fixture.voxels(1), all);
        QVERIFY(dialog.isVisible() && splitOf(dialog).isEnabled());
        const double voxelMm3 = fixture.workspace.volume()->geometry.voxelVolumeMm3();
        sizeOf(dialog).setValue((double(fixture.small) + 0.5) * voxelMm3);
        QTest::mouseClick(&splitOf(dialog), Qt::LeftButton);
        QVERIFY(fixture.session().settle());
        QTRY_COMPARE(said.size(), 2);
        QCOMPARE(fixture.voxels(1), fixture.large + fixture.small);
        QCOMPARE(fixture.voxels(2), fixture.middle);
        QVERIFY(!fixture.session().document().segment(3));

        sizeOf(dialog).setValue((double(fixture.small) + 2.0) * voxelMm3);
        QTest::mouseClick(&splitOf(dialog), Qt::LeftButton);
        QVERIFY(fixture.session().settle());
        QTRY_COMPARE(said.size(), 3);
        QCOMPARE(said.back().front().toString(),
            QStringLiteral("'Parts' has no other island that is large enough"));
        fixture.apply(test::lockSegment(1));
        QVERIFY(!splitOf(dialog).isEnabled());
        QCOMPARE(splitOf(dialog).toolTip(), QStringLiteral("'Parts' is locked"));
        dialog.close();
    }

    /// It says how many there are, how many there can be, and what helps; nothing has changed.
    void tooManyAreRefused()
    {
        Fixture fixture;
        fixture.addSpecks(280);
        ui::SplitIslandsDialog& dialog = fixture.opened();
        sizeOf(dialog).setValue(0.0);
        QCOMPARE(sizeOf(dialog).text(), QStringLiteral("any size"));
        const std::size_t rows = fixture.rows();
        QSignalSpy failed(&fixture.workspace, &ui::Workspace::failed);
        QTest::mouseClick(&splitOf(dialog), Qt::LeftButton);
        static_cast<void>(fixture.session().settle());
        QTRY_COMPARE(failed.size(), 1);
        const auto error = failed.front().front().value<core::Error>();
        QVERIFY(error.code == core::ErrorCode::TooManyIslands);
        QCOMPARE(ui::errorText(error),
            QStringLiteral("segment 'Specks' has 279 islands beside the largest, and there can be "
                           "253 segments more; with a larger minimum small islands stay with it"));
        QCOMPARE(fixture.rows(), rows);
        QCOMPARE(fixture.session().document().segments.size(), std::size_t(2));
        QVERIFY(dialog.isVisible() && splitOf(dialog).isEnabled());
        dialog.close();
    }
};

BURIN_WINDOW_TEST(SplitIslandsDialogUiTest)

} // namespace splitIslandsDialogUiTest

#include "SplitIslandsDialogUiTest.moc"
