// SPDX-License-Identifier: Apache-2.0
#include "ui/dialogs/segment/SplitIslandsDialog.h"

#include "core/brick/VoxelRuns.h"
#include "core/document/SegmentColours.h"
#include "core/edits/kinds/splitting/SplitIslands.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/fixtures/WindowFixture.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/PlainEdits.h"
#include "tests/support/scenes/PlainMasks.h"
#include "tests/support/scenes/SmallStudy.h"
#include "ui/base/ErrorText.h"
#include "ui/base/NumberText.h"
#include "ui/menus/EditableButton.h"

#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QPushButton>
#include <QSettings>
#include <QSignalSpy>
#include <QTimer>
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
        // As the engine's thread wakes the window in the program.
        QObject::connect(&wakeUp, &QTimer::timeout, [this] {
            if (core::EditSession* open = workspace.session())
                open->poll();
        });
        wakeUp.start(10);
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
        apply(test::maskImport(
            QStringLiteral("specks.nii"), size, {{QStringLiteral("Specks"), runs}}));
        workspace.setActiveSegment(session().document().segments.back().label);
    }
    [[nodiscard]] std::int64_t voxels(int label)
    {
        return session().document().segment(label)->voxels;
    }
    /// The dialog after the menu Segments has opened it.
    [[nodiscard]] ui::SplitIslandsDialog& opened()
    {
        window.actionTable()[QStringLiteral("segments.splitIslands")].trigger();
        return *window.findChild<ui::SplitIslandsDialog*>();
    }

    QTimer wakeUp;
    std::int64_t small = 0; ///< voxels of a dab
    std::int64_t large = 0;
    std::int64_t middle = 0;
};

QDoubleSpinBox& sizeOf(const QWidget& dialog)
{
    return *dialog.findChild<QDoubleSpinBox*>(QStringLiteral("splitMm3"));
}

QString resultOf(const QWidget& dialog)
{
    return dialog.findChild<QLabel*>(QStringLiteral("splitResult"))->text();
}

QPushButton& splitOf(const QWidget& dialog)
{
    return *dialog.findChild<QPushButton*>(QStringLiteral("applySplit"));
}

} // namespace

class SplitIslandsDialogUiTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init()
    {
        test::failOnUnexpectedMessages();
        QSettings().remove(QStringLiteral("split"));
    }

    /// How many have voxels that may change is not known before; the dialog says which may.
    void keepsToTheEditableRange()
    {
        Fixture fixture;
        ui::SplitIslandsDialog& dialog = fixture.opened();
        sizeOf(dialog).setValue(0.0);
        QTRY_COMPARE(resultOf(dialog), QStringLiteral("2 of 3 islands become segments"));
        const auto* button = dialog.findChild<ui::EditableButton*>();
        QVERIFY(button && button->isVisible());
        QCOMPARE(button->text(), QStringLiteral("changes all voxels"));
        core::ClipRegion clip = fixture.workspace.clip();
        clip.box.on = true;
        clip.box.maximum.y = 18.5; // the small dab alone
        fixture.workspace.setClip(clip);
        fixture.workspace.setEditableSettings({.on = true, .boxed = true});
        QCOMPARE(button->text(), QStringLiteral("editable: in the clip box"));
        QCOMPARE(resultOf(dialog),
            QStringLiteral(
                "Up to 2 of 3 islands become segments: those with voxels that may change"));
        splitOf(dialog).click();
        QVERIFY(fixture.session().settle());
        const auto& row = fixture.session().history().rows().back();
        const auto* split = row.edit.as<core::SplitIslands>();
        QVERIFY(split && split->editable && split->editable->box);
        QCOMPARE(fixture.session().document().segments.size(), std::size_t(2));
        QCOMPARE(fixture.voxels(2), fixture.small);
        QCOMPARE(fixture.voxels(1), fixture.middle + fixture.large);
    }

    /// It says how many there will be, and a click is one step, which is taken back; the dialog
    /// stays for another size.
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
        const QString twoOfThree = QStringLiteral("2 of 3 islands become segments");
        QTRY_COMPARE(resultOf(dialog), twoOfThree);
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
        const QString none = QStringLiteral("No island beside the largest is so large");
        QTRY_COMPARE(resultOf(dialog), none);
        QVERIFY(!splitOf(dialog).isEnabled());
        QCOMPARE(splitOf(dialog).toolTip(), none);

        QVERIFY(fixture.session().undo() && fixture.session().settle());
        QCOMPARE(fixture.voxels(1), all);
        QTRY_COMPARE(resultOf(dialog), twoOfThree);
        const double voxelMm3 = fixture.workspace.volume()->geometry.voxelVolumeMm3();
        sizeOf(dialog).setValue((double(fixture.small) + 0.5) * voxelMm3);
        QCOMPARE(resultOf(dialog), QStringLiteral("1 of 3 islands becomes a segment"));
        QTest::mouseClick(&splitOf(dialog), Qt::LeftButton);
        QVERIFY(fixture.session().settle());
        QTRY_COMPARE(said.size(), 2);
        QCOMPARE(fixture.voxels(1), fixture.large + fixture.small);
        QCOMPARE(fixture.voxels(2), fixture.middle);
        QVERIFY(!fixture.session().document().segment(3));
        QTRY_COMPARE(resultOf(dialog), none);
        sizeOf(dialog).setValue(0.0);
        QCOMPARE(resultOf(dialog), QStringLiteral("1 of 2 islands becomes a segment"));
        QVERIFY(splitOf(dialog).isEnabled());

        fixture.apply(test::lockSegment(1));
        QTRY_VERIFY(!splitOf(dialog).isEnabled());
        QCOMPARE(splitOf(dialog).toolTip(), QStringLiteral("'Parts' is locked"));
        dialog.close();
    }

    /// The new segments are seen in their colours before they are made, and taken as they are seen.
    void areSeenBeforeTheyAreMade()
    {
        Fixture fixture;
        const double voxelMm3 = fixture.workspace.volume()->geometry.voxelVolumeMm3();
        const auto sized = [voxelMm3](std::int64_t voxels) {
            return ui::volumeText(double(voxels) * voxelMm3 / 1000.0);
        };
        const auto sees = [&](int label) {
            return fixture.workspace.segmentDisplay().visible[std::size_t(label)];
        };
        const QByteArray hash = fixture.session().stateHash();
        const std::size_t rows = fixture.rows();
        const std::int64_t all = fixture.voxels(1);
        const std::uint32_t colour = core::usualSegmentColour(1);
        ui::SplitIslandsDialog& dialog = fixture.opened();
        const auto* now = dialog.findChild<QLabel*>(QStringLiteral("splitNow"));
        QVERIFY(now && !sees(2));
        const QString both =
            QStringLiteral("Preview: %1 → %2 (−%3)")
                .arg(sized(all), sized(fixture.large), sized(fixture.middle + fixture.small));
        QTRY_COMPARE(now->text(), both);
        QVERIFY(fixture.session().isOpen<core::SplitIslands>());
        QVERIFY(sees(2) && sees(3) && !sees(4));
        QCOMPARE(fixture.workspace.segmentDisplay().rgb[2], colour);
        QCOMPARE(fixture.session().document().segments.size(), std::size_t(1));
        QCOMPARE(fixture.rows(), rows);
        sizeOf(dialog).setValue((double(fixture.small) + 0.5) * voxelMm3);
        QTRY_COMPARE(now->text(),
            QStringLiteral("Preview: %1 → %2 (−%3)")
                .arg(sized(all), sized(all - fixture.middle), sized(fixture.middle)));
        QVERIFY(sees(2) && !sees(3));
        dialog.close();
        QVERIFY(!fixture.session().openEdit() && !sees(2));
        QVERIFY(fixture.session().settle());
        QCOMPARE(fixture.session().stateHash(), hash);

        QVERIFY(&fixture.opened() == &dialog);
        QTRY_COMPARE(now->text(), both);
        QSignalSpy drawn(&fixture.workspace, &ui::Workspace::viewOptionsChanged);
        dialog.findChild<QCheckBox*>(QStringLiteral("splitPreview"))->setChecked(false);
        QVERIFY(!fixture.session().openEdit() && !sees(2) && drawn.size() > 0);
        dialog.findChild<QCheckBox*>(QStringLiteral("splitPreview"))->setChecked(true);
        QTRY_COMPARE(now->text(), both);
        QTest::mouseClick(&splitOf(dialog), Qt::LeftButton);
        QVERIFY(!fixture.session().openEdit() && fixture.session().settle());
        QCOMPARE(fixture.rows(), rows + 1);
        QCOMPARE(fixture.session().document().segments.size(), std::size_t(3));
        QCOMPARE(fixture.voxels(1), fixture.large);
        QCOMPARE(fixture.voxels(2), fixture.middle);
        QCOMPARE(fixture.session().document().segment(2)->rgb, colour);
        QTRY_COMPARE(now->text(), QStringLiteral("Now: %1").arg(sized(fixture.large)));
        dialog.close();

        // Of which islands may change, it is known when they are worked out.
        QVERIFY(fixture.session().undo() && fixture.session().settle());
        core::ClipRegion clip = fixture.workspace.clip();
        clip.box.on = true;
        clip.box.maximum.y = 18.5; // the small dab alone
        fixture.workspace.setClip(clip);
        fixture.workspace.setEditableSettings({.on = true, .boxed = true});
        sizeOf(fixture.opened()).setValue(0.0);
        QTRY_COMPARE(now->text(),
            QStringLiteral("Preview: %1 → %2 (−%3)")
                .arg(sized(all), sized(all - fixture.small), sized(fixture.small)));
        QVERIFY(sees(2) && !sees(3));
        dialog.close();
    }

    /// It says how many there are and how many there can be; who asks all the same, by a recipe or
    /// before they have been counted, is told, and what helps. Nothing has changed.
    void tooManyAreRefused()
    {
        Fixture fixture;
        fixture.addSpecks(280);
        ui::SplitIslandsDialog& dialog = fixture.opened();
        sizeOf(dialog).setValue(0.0);
        QCOMPARE(sizeOf(dialog).text(), QStringLiteral("any size"));
        const QString tooMany =
            QStringLiteral("279 islands are so large, but there can be only 253 segments more");
        QTRY_COMPARE(resultOf(dialog), tooMany);
        QVERIFY(!splitOf(dialog).isEnabled());
        QCOMPARE(splitOf(dialog).toolTip(), tooMany);
        dialog.close();

        const std::size_t rows = fixture.rows();
        QVERIFY(fixture.session().apply(core::SplitIslands{.segment = 2}));
        const core::Result<void> refused = fixture.session().settle();
        QVERIFY(!refused && refused.error().code == core::ErrorCode::TooManyIslands);
        QCOMPARE(ui::errorText(refused.error()),
            QStringLiteral("segment 'Specks' has 279 islands beside the largest, and there can be "
                           "253 segments more; with a larger minimum small islands stay with it"));
        QCOMPARE(fixture.rows(), rows);
        QCOMPARE(fixture.session().document().segments.size(), std::size_t(2));
    }
};

BURIN_WINDOW_TEST(SplitIslandsDialogUiTest)

} // namespace splitIslandsDialogUiTest

#include "SplitIslandsDialogUiTest.moc"
