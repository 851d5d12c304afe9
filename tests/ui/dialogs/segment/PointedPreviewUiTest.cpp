// SPDX-License-Identifier: Apache-2.0
#include "ui/dialogs/segment/PointedPreview.h"

#include "core/edits/kinds/segments/CleanSegment.h"
#include "core/edits/kinds/segments/ReshapeSegment.h"
#include "core/session/questions/VoxelQuestions.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/fixtures/Pen.h"
#include "tests/support/fixtures/panels/CleanUpWindow.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/PlainEdits.h"
#include "tests/support/scenes/SmallStudy.h"
#include "ui/base/NumberText.h"
#include "ui/dialogs/segment/ReshapeDialog.h"
#include "ui/views/SliceView.h"
#include "ui/views/ViewGrid.h"
#include "ui/workspace/CuttingPlane.h"

#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QPushButton>
#include <QSettings>
#include <QSignalSpy>
#include <QtTest>

#include <cmath>

namespace pointedPreviewUiTest {

using test::pointAt;
using test::pointAway;

namespace {

struct Fixture : test::CleanUpWindow {
    Fixture()
        : CleanUpWindow(Answers::ByThemselves)
    {
    }
    /// Two dabs of one segment, the larger one with a hole, and a segment without voxels.
    [[nodiscard]] bool addDabs()
    {
        const core::VolumeGeometry& geometry = workspace.volume()->geometry;
        const glm::dvec3 middle = geometry.toWorld({28.0, 24.0, 10.0});
        apply(test::addSegment("Parts"));
        apply(test::addSegment("Other"));
        apply(test::paintAt(1, {geometry.toWorld({10.0, 10.0, 10.0})}, 2.0));
        one = voxels(1);
        apply(test::paintAt(1, {middle}, 3.0));
        hole = voxels(1);
        apply(test::eraseAt(1, {middle}, 0.3));
        hole -= voxels(1);
        workspace.setActiveSegment(1);
        previewBox().setChecked(true);
        return hole > 0 && one > hole && QTest::qWaitFor([this] { return panel->isVisible(); });
    }
    [[nodiscard]] QDoubleSpinBox& smallMm3()
    {
        return *panel->findChild<QDoubleSpinBox*>(QStringLiteral("cleanUp.smallMm3"));
    }
    /// The rule that is previewed in the views.
    [[nodiscard]] bool previews(core::IslandRule rule)
    {
        const core::Edit* open = session().openEdit();
        const auto* edit = open ? open->as<core::CleanSegment>() : nullptr;
        return edit && edit->rule == rule && session().openIsPreview() && session().openHasBegun();
    }
    /// Every mm³ below that size goes, which is more than that of the first dab.
    [[nodiscard]] double aboveTheFirst()
    {
        return std::ceil(double(one) * workspace.volume()->geometry.voxelVolumeMm3()) + 1.0;
    }

    std::int64_t one = 0; ///< voxels of the smaller dab
    std::int64_t hole = 0; ///< voxels of the hole in the other one
};

} // namespace

/// What a button would do is previewed while it is pointed at.
class PointedPreviewUiTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init()
    {
        test::failOnUnexpectedMessages();
        QSettings().remove(QStringLiteral("cleanUp"));
    }

    /// What a button would do is seen while the pointer rests on it, and gone with the pointer; a
    /// click takes what is seen.
    void isSeenBeforeItIsDone_data()
    {
        QTest::addColumn<QByteArray>("id");
        QTest::addColumn<core::IslandRule>("rule");
        QTest::newRow("holes") << QByteArray("fillHoles") << core::IslandRule::FillHoles;
        QTest::newRow("largest") << QByteArray("keepLargest") << core::IslandRule::KeepLargest;
        QTest::newRow("small") << QByteArray("removeSmall") << core::IslandRule::RemoveSmall;
    }
    void isSeenBeforeItIsDone()
    {
        QFETCH(const QByteArray, id);
        QFETCH(const core::IslandRule, rule);
        Fixture fixture;
        QVERIFY(fixture.addDabs());
        fixture.smallMm3().setValue(fixture.aboveTheFirst());
        const std::int64_t before = fixture.voxels(1);
        const std::int64_t change =
            rule == core::IslandRule::FillHoles ? fixture.hole : -fixture.one;
        const QString expected = fixture.more(change);
        const QByteArray hash = fixture.session().stateHash();
        const std::size_t rows = fixture.rows();
        QPushButton& button = fixture.button(id);
        QCOMPARE(fixture.now(), fixture.sizeOf(before));
        pointAt(button);
        QCOMPARE(fixture.now(), QStringLiteral("%1 → …").arg(fixture.sizeOf(before)));
        QTRY_COMPARE(fixture.now(), expected);
        QVERIFY(fixture.previews(rule));
        QCOMPARE(fixture.rows(), rows);
        pointAway(button);
        QVERIFY(!fixture.session().openEdit());
        QCOMPARE(fixture.now(), fixture.sizeOf(before));
        QVERIFY(fixture.session().settle());
        QCOMPARE(fixture.session().stateHash(), hash);

        pointAt(button);
        QTRY_COMPARE(fixture.now(), expected);
        QSignalSpy said(&fixture.workspace, &ui::Workspace::said);
        QTest::mouseClick(&button, Qt::LeftButton);
        QVERIFY(!fixture.session().openEdit() && fixture.session().settle());
        QCOMPARE(fixture.rows(), rows + 1);
        QCOMPARE(fixture.voxels(1), before + change);
        QTRY_COMPARE(said.size(), 1);
        QVERIFY(said.front().front().toString().endsWith(QStringLiteral("; Ctrl+Z takes it back")));
        // What was done is not done once more while the pointer is still there, nor after undo.
        QTest::qWait(500);
        QVERIFY(!fixture.session().openEdit());
        QVERIFY(fixture.session().undo() && fixture.session().settle());
        QTest::qWait(500);
        QVERIFY(!fixture.session().openEdit());
        QTRY_COMPARE(fixture.now(), fixture.sizeOf(before));
        QCOMPARE(fixture.session().stateHash(), hash);
        // Before it is seen, a click is as fast.
        pointAway(button);
        pointAt(button);
        QTest::mouseClick(&button, Qt::LeftButton);
        QVERIFY(fixture.session().settle());
        QCOMPARE(fixture.voxels(1), before + change);
    }

    /// The field is that of its button: what it asks for is seen at once.
    void thePreviewFollowsTheField()
    {
        Fixture fixture;
        QVERIFY(fixture.addDabs());
        QDoubleSpinBox& size = fixture.smallMm3();
        const QString nothing =
            QStringLiteral("%1\nstays as it is").arg(fixture.sizeOf(fixture.voxels(1)));
        pointAt(size);
        QTRY_COMPARE(fixture.now(), nothing);
        QVERIFY(fixture.previews(core::IslandRule::RemoveSmall));
        size.setValue(fixture.aboveTheFirst());
        QTRY_COMPARE(fixture.now(), fixture.more(-fixture.one));
        pointAway(size);
        QVERIFY(!fixture.session().openEdit());
        // Who comes to it by the keyboard sees the same, and what a button would do.
        fixture.window.activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&fixture.window));
        size.setFocus(Qt::MouseFocusReason);
        QTRY_COMPARE(fixture.now(), fixture.more(-fixture.one));
        fixture.button("fillHoles").setFocus(Qt::TabFocusReason);
        QTRY_COMPARE(fixture.now(), fixture.more(fixture.hole));
        fixture.button("keepLargest").setFocus(Qt::MouseFocusReason);
        QVERIFY(!fixture.session().openEdit());
    }

    /// Switched off, folded away or with another segment, nothing is left of it.
    void thePreviewEnds()
    {
        Fixture fixture;
        QVERIFY(fixture.addDabs());
        const QByteArray hash = fixture.session().stateHash();
        const QString expected = fixture.more(-fixture.one);
        QPushButton& button = fixture.button("keepLargest");
        pointAt(button);
        QTRY_COMPARE(fixture.now(), expected);
        fixture.previewBox().setChecked(false);
        QVERIFY(!fixture.session().openEdit());
        pointAway(button);
        pointAt(button);
        QTest::qWait(500);
        QVERIFY(!fixture.session().openEdit());
        fixture.previewBox().setChecked(true);
        QTRY_COMPARE(fixture.now(), expected);
        fixture.panel->hide();
        QVERIFY(!fixture.session().openEdit());
        fixture.panel->show();
        QTest::qWait(500);
        QVERIFY(!fixture.session().openEdit());
        pointAt(button);
        QTRY_COMPARE(fixture.now(), expected);
        fixture.workspace.setActiveSegment(2);
        QTRY_COMPARE(fixture.now(), QStringLiteral("%1\nstays as it is").arg(fixture.sizeOf(0)));
        QCOMPARE(fixture.session().openEdit()->get<core::CleanSegment>().segment, 2);
        fixture.workspace.setActiveSegment(1);
        QTRY_COMPARE(fixture.now(), expected);
        // Where only part of it may change, only that is seen.
        core::ClipRegion clip = fixture.workspace.clip();
        clip.box.on = true;
        clip.box.minimum.x = 18.0; // without the first dab
        fixture.workspace.setClip(clip);
        fixture.workspace.setEditableSettings({.on = true, .boxed = true});
        QTRY_COMPARE(fixture.now(),
            QStringLiteral("%1\nstays as it is").arg(fixture.sizeOf(fixture.voxels(1))));
        fixture.workspace.setEditableSettings({});
        QTRY_COMPARE(fixture.now(), expected);
        // Any step takes it back.
        fixture.apply(test::addSegment("Third"));
        QVERIFY(!fixture.session().openEdit());
        QTRY_COMPARE(fixture.now(), fixture.sizeOf(fixture.voxels(1)));
        QVERIFY(fixture.session().undo() && fixture.session().settle());
        QCOMPARE(fixture.session().stateHash(), hash);
        fixture.apply(test::lockSegment(1));
        pointAway(button);
        pointAt(button);
        QTest::qWait(500);
        QVERIFY(!fixture.session().openEdit());
    }

    /// A pen that goes on to a view leaves the button without a word of Qt.
    void thePreviewEndsWithThePen()
    {
        Fixture fixture;
        QVERIFY(fixture.addDabs());
        QPushButton& button = fixture.button("keepLargest");
        const QString expected = fixture.more(-fixture.one);
        ui::ImageView& view = fixture.window.views().axial();
        test::Pen overTheView(view);
        test::Pen overTheButton(button);
        quint64 ms = 1000;
        pointAt(button);
        overTheButton.hover(QPointF(3.0, 3.0), ++ms);
        QTRY_COMPARE(fixture.now(), expected);
        overTheButton.hover(QPointF(5.0, 3.0), ++ms);
        QVERIFY(fixture.previews(core::IslandRule::KeepLargest));
        overTheView.hover(QPointF(50.0, 50.0), ++ms);
        QVERIFY(!fixture.session().openEdit());
        pointAt(button);
        QTRY_COMPARE(fixture.now(), expected);
        QEvent away(QEvent::TabletLeaveProximity);
        QCoreApplication::sendEvent(qApp, &away);
        QVERIFY(!fixture.session().openEdit());
    }

    /// The parts of a split are those of the segment, and not of what is previewed of it.
    void thePartsOfASplitAreWithoutIt()
    {
        Fixture fixture;
        QVERIFY(fixture.addDabs());
        const core::VolumeGeometry& geometry = fixture.workspace.volume()->geometry;
        const auto parts = [&] {
            const auto* line = fixture.panel->findChild<QLabel*>(QStringLiteral("cleanUp.parts"));
            return line->isVisible() ? line->text() : QString();
        };
        const QString expected =
            QStringLiteral("Parts: %1 · Parts 1: %2")
                .arg(ui::millilitreText(fixture.one, geometry.voxelVolumeMm3()),
                    ui::millilitreText(fixture.voxels(1) - fixture.one, geometry.voxelVolumeMm3()));
        QPushButton& button = fixture.button("keepLargest");
        pointAt(button);
        QTRY_COMPARE(fixture.now(), fixture.more(-fixture.one));
        ui::CuttingPlane& plane = fixture.workspace.plane();
        plane.setPose(
            ui::CuttingPlane::poseFacing(geometry.toWorld({20.0, 18.0, 10.0}), {1.0, 0.0, 0.0}));
        plane.show();
        QTest::qWait(400);
        QCOMPARE(parts(), QString());
        pointAway(button);
        QTRY_COMPARE(parts(), expected);
        pointAt(button);
        QTRY_COMPARE(fixture.now(), fixture.more(-fixture.one));
        QTest::qWait(300);
        QCOMPARE(parts(), expected);
    }

    /// Whoever passes over the panel leaves the preview of a dialog alone.
    void theDialogsGoFirst()
    {
        Fixture fixture;
        QVERIFY(fixture.addDabs());
        QTest::mouseClick(&fixture.button("smooth"), Qt::LeftButton);
        auto* dialog = fixture.window.findChild<ui::ReshapeDialog*>();
        QVERIFY(dialog);
        QTRY_VERIFY(fixture.session().isOpen<core::ReshapeSegment>());
        QPushButton& button = fixture.button("keepLargest");
        pointAt(button);
        QTest::qWait(600);
        QVERIFY(fixture.session().isOpen<core::ReshapeSegment>());
        dialog->close();
        QTRY_COMPARE(fixture.now(), fixture.more(-fixture.one));
        QVERIFY(fixture.previews(core::IslandRule::KeepLargest));
        pointAway(button);
        QVERIFY(!fixture.session().openEdit());
    }

    /// Whoever reads whole label planes (an audit, an export) would have to begin again.
    void whoReadsGoesFirst()
    {
        Fixture fixture;
        QVERIFY(fixture.addDabs());
        auto reading = fixture.session().questions().beginReading();
        pointAt(fixture.button("keepLargest"));
        QTest::qWait(600);
        QVERIFY(!fixture.session().openEdit());
        reading.reset();
        QTRY_COMPARE(fixture.now(), fixture.more(-fixture.one));
        QVERIFY(fixture.previews(core::IslandRule::KeepLargest));
    }

    void theBoxIsRemembered()
    {
        // Nobody's segment changes in the views while he only passes over the panel.
        QSettings().remove(QStringLiteral("cleanUp/preview"));
        for (const bool isOn : {false, true, false}) {
            Fixture fixture;
            QCOMPARE(fixture.previewBox().isChecked(), isOn);
            fixture.previewBox().setChecked(!isOn);
        }
    }
};

BURIN_WINDOW_TEST(PointedPreviewUiTest)

} // namespace pointedPreviewUiTest

#include "PointedPreviewUiTest.moc"
