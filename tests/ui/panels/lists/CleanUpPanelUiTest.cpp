// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/lists/CleanUpPanel.h"

#include "tests/support/faults/FailingLog.h"
#include "tests/support/fixtures/panels/CleanUpWindow.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/PlainEdits.h"
#include "tests/support/scenes/SmallStudy.h"
#include "ui/base/NumberText.h"
#include "ui/dialogs/segment/ReshapeDialog.h"
#include "ui/dialogs/segment/SplitIslandsDialog.h"
#include "ui/menus/EditableButton.h"
#include "ui/workspace/CuttingPlane.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QSignalSpy>
#include <QtTest>

#include <cmath>

namespace cleanUpPanelUiTest {

namespace {

struct Fixture : test::CleanUpWindow {
    Fixture()
        : CleanUpWindow(Answers::WhenPolled)
    {
    }
    /// Two dabs of one segment, and a segment without voxels.
    void addDabs()
    {
        const core::VolumeGeometry& geometry = workspace.volume()->geometry;
        apply(test::addSegment("Parts"));
        apply(test::addSegment("Other"));
        apply(test::paintAt(1, {geometry.toWorld(glm::dvec3(10.0, 10.0, 10.0))}, 2.0));
        one = voxels(1);
        apply(test::paintAt(1, {geometry.toWorld(glm::dvec3(28.0, 24.0, 10.0))}, 3.0));
        other = voxels(1) - one;
        workspace.setActiveSegment(1);
    }
    [[nodiscard]] QString millilitres(int label)
    {
        return ui::millilitreText(voxels(label), workspace.volume()->geometry.voxelVolumeMm3());
    }
    /// What it says of both parts of a split by the plane; answers come when asked for.
    [[nodiscard]] QString parts()
    {
        session().poll();
        const auto* line = panel->findChild<QLabel*>(QStringLiteral("cleanUp.parts"));
        return line->isVisible() ? line->text() : QString();
    }

    std::int64_t one = 0; ///< voxels of the first dab, the smaller one
    std::int64_t other = 0;
};

} // namespace

class CleanUpPanelUiTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    void takesNoRoomWithoutASegment()
    {
        Fixture fixture;
        QVERIFY(!fixture.panel->hasSomething());
        QTRY_VERIFY(!fixture.panel->isVisible());
        fixture.addDabs();
        QVERIFY(fixture.panel->hasSomething());
        QTRY_VERIFY(fixture.panel->isVisible());
        QCOMPARE(fixture.panel->summary(), QStringLiteral("Parts"));
        fixture.workspace.setActiveSegment(2);
        QCOMPARE(fixture.panel->summary(), QStringLiteral("Other"));
        while (fixture.session().history().canUndo()) {
            QVERIFY(fixture.session().undo());
            QVERIFY(fixture.session().settle());
        }
        QTRY_VERIFY(!fixture.panel->isVisible());
    }

    /// A click is the menu's step, in one row, which is taken back.
    void keepsTheLargestIsland()
    {
        Fixture fixture;
        fixture.addDabs();
        QVERIFY(fixture.one > 10 && fixture.other > fixture.one);
        QTRY_VERIFY(fixture.panel->isVisible());
        const std::size_t rows = fixture.session().history().rows().size();
        QTest::mouseClick(&fixture.button("keepLargest"), Qt::LeftButton);
        QVERIFY(fixture.session().settle());
        QCOMPARE(fixture.voxels(1), fixture.other);
        QCOMPARE(fixture.session().history().rows().size(), rows + 1);
        QVERIFY(fixture.session().undo());
        QVERIFY(fixture.session().settle());
        QCOMPARE(fixture.voxels(1), fixture.one + fixture.other);
    }

    /// It says which voxels may change, and that is chosen there, too.
    void keepsToTheEditableRange()
    {
        Fixture fixture;
        fixture.addDabs();
        QTRY_VERIFY(fixture.panel->isVisible());
        auto* button = fixture.panel->findChild<ui::EditableButton*>();
        QVERIFY(button && button->isVisible());
        QCOMPARE(button->text(), QStringLiteral("changes all voxels"));
        QVERIFY(button->width() >= fixture.button("keepLargest").width());
        core::ClipRegion clip = fixture.workspace.clip();
        clip.box.on = true;
        clip.box.minimum.x = 18.0; // without the first dab
        fixture.workspace.setClip(clip);
        fixture.workspace.setEditableSettings({.on = true, .boxed = true});
        QCOMPARE(button->text(), QStringLiteral("editable: in the clip box"));
        QVERIFY(button->toolTip().contains(QStringLiteral("editable: in the clip box")));
        const std::size_t rows = fixture.session().history().rows().size();
        QSignalSpy said(&fixture.workspace, &ui::Workspace::said);
        QTest::mouseClick(&fixture.button("keepLargest"), Qt::LeftButton);
        QVERIFY(fixture.session().settle());
        QCOMPARE(fixture.voxels(1), fixture.one + fixture.other);
        QCOMPARE(fixture.session().history().rows().size(), rows);
        QTRY_COMPARE(said.size(), 1);
        QVERIFY(
            said.back().front().toString().endsWith(QStringLiteral("(editable: in the clip box)")));
        button->menu()->findChild<QCheckBox*>(QStringLiteral("editableOn"))->click();
        QCOMPARE(button->text(), QStringLiteral("changes all voxels"));
        QTest::mouseClick(&fixture.button("keepLargest"), Qt::LeftButton);
        QVERIFY(fixture.session().settle());
        QCOMPARE(fixture.voxels(1), fixture.other);
    }

    /// The size is offered for the segment, and what is typed counts.
    void removesIslandsBelowASize()
    {
        Fixture fixture;
        fixture.addDabs();
        QTRY_VERIFY(fixture.panel->isVisible());
        auto* size = fixture.panel->findChild<QDoubleSpinBox*>(QStringLiteral("cleanUp.smallMm3"));
        QVERIFY(size && size->isEnabled());
        const double voxelMm3 = fixture.workspace.volume()->geometry.voxelVolumeMm3();
        const double offered = 0.01 * double(fixture.one + fixture.other) * voxelMm3;
        QVERIFY(std::abs(size->value() - offered) <= 0.05);
        QSignalSpy said(&fixture.workspace, &ui::Workspace::said);
        QTest::mouseClick(&fixture.button("removeSmall"), Qt::LeftButton);
        QVERIFY(fixture.session().settle());
        QTRY_COMPARE(said.size(), 1);
        QVERIFY(said.front().front().toString().contains(QStringLiteral("has no island below")));
        size->selectAll();
        QTest::keyClicks(size, QString::number(double(fixture.one) * voxelMm3 + 1.0, 'f', 1));
        QTest::keyClick(size, Qt::Key_Return);
        QTest::mouseClick(&fixture.button("removeSmall"), Qt::LeftButton);
        QVERIFY(fixture.session().settle());
        QCOMPARE(fixture.voxels(1), fixture.other);
        // It stays, whichever segment comes next.
        const double typed = size->value();
        fixture.workspace.setActiveSegment(2);
        QCOMPARE(size->value(), typed);
        fixture.apply(test::lockSegment(2));
        QVERIFY(!size->isEnabled());
    }

    void itIsTheActiveSegments()
    {
        Fixture fixture;
        fixture.addDabs();
        fixture.apply(test::paintAt(
            2, {fixture.workspace.volume()->geometry.toWorld(glm::dvec3(10.0, 24.0, 10.0))}, 2.0));
        fixture.workspace.setActiveSegment(2);
        const std::int64_t before = fixture.voxels(2);
        QSignalSpy said(&fixture.workspace, &ui::Workspace::said);
        QTest::mouseClick(&fixture.button("keepLargest"), Qt::LeftButton);
        QVERIFY(fixture.session().settle());
        QTRY_COMPARE(said.size(), 1);
        QCOMPARE(said.front().front().toString(), QStringLiteral("'Other' is one island already"));
        QCOMPARE(fixture.voxels(2), before);
        QCOMPARE(fixture.voxels(1), fixture.one + fixture.other);
    }

    void opensTheDialogs()
    {
        Fixture fixture;
        fixture.addDabs();
        QVERIFY(!fixture.window.findChild<ui::ReshapeDialog*>());
        QTest::mouseClick(&fixture.button("smooth"), Qt::LeftButton);
        auto* dialog = fixture.window.findChild<ui::ReshapeDialog*>();
        QVERIFY(dialog && dialog->isVisible());
        auto* operation = dialog->findChild<QComboBox*>(QStringLiteral("reshapeOperation"));
        QVERIFY(operation);
        const int smoothing = operation->currentIndex();
        QTest::mouseClick(&fixture.button("margin"), Qt::LeftButton);
        QVERIFY(operation->currentIndex() != smoothing);
        dialog->close();
        QVERIFY(!fixture.window.findChild<ui::SplitIslandsDialog*>());
        QTest::mouseClick(&fixture.button("splitIslands"), Qt::LeftButton);
        auto* split = fixture.window.findChild<ui::SplitIslandsDialog*>();
        QVERIFY(split && split->isVisible());
        split->close();
    }

    /// Where a cutting plane is shown: what lies behind it becomes a segment, in one row.
    void splitsByThePlane()
    {
        Fixture fixture;
        fixture.addDabs();
        QTRY_VERIFY(fixture.panel->isVisible());
        QPushButton& split = fixture.button("splitByPlane");
        QAction& entry = fixture.window.actionTable()[QStringLiteral("segments.splitByPlane")];
        QVERIFY(!split.isEnabled() && !entry.isEnabled());
        QCOMPARE(split.toolTip(), QStringLiteral("no cutting plane is shown"));
        const core::VolumeGeometry& geometry = fixture.workspace.volume()->geometry;
        ui::CuttingPlane& plane = fixture.workspace.plane();
        plane.setPose(ui::CuttingPlane::poseFacing(
            geometry.toWorld(glm::dvec3(20.0, 18.0, 10.0)), {1.0, 0.0, 0.0}));
        plane.show();
        QVERIFY(split.isEnabled() && entry.isEnabled());
        QCOMPARE(split.toolTip(), QStringLiteral("Split 'Parts' by the cutting plane"));
        const std::size_t rows = fixture.session().history().rows().size();
        QSignalSpy said(&fixture.workspace, &ui::Workspace::said);
        QTest::mouseClick(&split, Qt::LeftButton);
        QVERIFY(fixture.session().settle());
        QTRY_COMPARE(said.size(), 1);
        QCOMPARE(said.front().front().toString(),
            QStringLiteral("Split 'Parts' by a plane, −%1 voxels. Parts: %2 · Parts 1: %3; Ctrl+Z "
                           "takes it back")
                .arg(QString::number(fixture.other), fixture.millilitres(1),
                    fixture.millilitres(3)));
        QCOMPARE(fixture.session().history().rows().size(), rows + 1);
        QCOMPARE(fixture.voxels(1), fixture.one);
        QCOMPARE(fixture.voxels(3), fixture.other);
        QCOMPARE(fixture.session().document().segment(3)->name, QStringLiteral("Parts 1"));
        QCOMPARE(fixture.workspace.activeSegment(), 1);
        QTest::mouseClick(&split, Qt::LeftButton);
        QVERIFY(fixture.session().settle());
        QTRY_COMPARE(said.size(), 2);
        QCOMPARE(said.back().front().toString(),
            QStringLiteral("all of 'Parts' lies on one side of the cutting plane"));
        QVERIFY(fixture.session().undo() && fixture.session().settle());
        QCOMPARE(fixture.voxels(1), fixture.one + fixture.other);
        QVERIFY(!fixture.session().document().segment(3));
        ui::CuttingPlane::Look look = plane.look();
        look.shown = false;
        plane.setLook(look);
        QVERIFY(!split.isEnabled() && !entry.isEnabled());
    }

    /// Both volumes follow the plane, before anything is split.
    void tellsBothPartsOfThePlane()
    {
        Fixture fixture;
        fixture.addDabs();
        QTRY_VERIFY(fixture.panel->isVisible());
        QCOMPARE(fixture.parts(), QString());
        const core::VolumeGeometry& geometry = fixture.workspace.volume()->geometry;
        ui::CuttingPlane& plane = fixture.workspace.plane();
        const auto place = [&](double column) {
            plane.setPose(ui::CuttingPlane::poseFacing(
                geometry.toWorld(glm::dvec3(column, 18.0, 10.0)), {1.0, 0.0, 0.0}));
        };
        const double voxelMm3 = geometry.voxelVolumeMm3();
        const auto text = [voxelMm3](std::int64_t one, std::int64_t other) {
            return QStringLiteral("Parts: %1 · Parts 1: %2")
                .arg(ui::millilitreText(one, voxelMm3), ui::millilitreText(other, voxelMm3));
        };
        place(20.0);
        plane.show();
        QTRY_COMPARE(fixture.parts(), text(fixture.one, fixture.other));
        place(1.0);
        QTRY_COMPARE(fixture.parts(), QStringLiteral("all of Parts lies on one side"));
        place(20.0);
        plane.flip();
        QTRY_COMPARE(fixture.parts(), text(fixture.other, fixture.one));
        // After a step it is counted anew; another segment has other parts.
        fixture.apply(test::paintAt(1, {geometry.toWorld(glm::dvec3(10.0, 20.0, 10.0))}, 2.0));
        const std::int64_t more = fixture.voxels(1) - fixture.other;
        QVERIFY(more > fixture.one);
        QTRY_COMPARE(fixture.parts(), text(fixture.other, more));
        fixture.workspace.setActiveSegment(2);
        QTRY_COMPARE(fixture.parts(), QStringLiteral("all of Other lies on one side"));
        fixture.workspace.setActiveSegment(1);
        QTRY_COMPARE(fixture.parts(), text(fixture.other, more));
        // Where less may change than is counted, nothing is told.
        fixture.workspace.setEditableSettings({.on = true, .byValue = true, .upper = 100.0});
        QTRY_COMPARE(fixture.parts(), QString());
        fixture.workspace.setEditableSettings({});
        QTRY_COMPARE(fixture.parts(), text(fixture.other, more));
        ui::CuttingPlane::Look look = plane.look();
        look.shown = false;
        plane.setLook(look);
        QTRY_COMPARE(fixture.parts(), QString());
    }

    void whatCannotBeSaysWhy()
    {
        Fixture fixture;
        fixture.addDabs();
        QPushButton& fill = fixture.button("fillHoles");
        QVERIFY(fill.isEnabled());
        QCOMPARE(fill.toolTip(), QStringLiteral("Fill holes of 'Parts'"));
        fixture.apply(test::lockSegment(1));
        for (const auto* each : fixture.panel->findChildren<QPushButton*>()) {
            QVERIFY2(!each->isEnabled(), qPrintable(each->text()));
            QCOMPARE(each->toolTip(), QStringLiteral("'Parts' is locked"));
        }
        fixture.workspace.setActiveSegment(2);
        QVERIFY(fill.isEnabled());
    }

    void itsWordsFit()
    {
        Fixture fixture;
        fixture.addDabs();
        QTRY_VERIFY(fixture.panel->isVisible());
        QCoreApplication::sendPostedEvents(); // layouts are posted events
        const auto buttons = fixture.panel->findChildren<QPushButton*>();
        QCOMPARE(buttons.size(), 11);
        for (const auto* each : buttons) {
            QVERIFY2(each->fontMetrics().horizontalAdvance(each->text()) <= each->width() - 8,
                qPrintable(each->text()));
            QVERIFY(fixture.panel->rect().contains(each->geometry()));
        }
        const auto& now = *fixture.panel->findChild<QLabel*>(QStringLiteral("cleanUpNow"));
        QVERIFY(now.fontMetrics().horizontalAdvance(QStringLiteral("12043.2 mL → 12041.1 mL"))
            <= now.width());
    }
};

BURIN_WINDOW_TEST(CleanUpPanelUiTest)

} // namespace cleanUpPanelUiTest

#include "CleanUpPanelUiTest.moc"
