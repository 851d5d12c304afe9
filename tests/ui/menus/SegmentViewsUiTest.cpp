// SPDX-License-Identifier: Apache-2.0
#include "ui/menus/SegmentViews.h"

#include "tests/support/cases/SurfaceCases.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/fixtures/WindowFixture.h"
#include "tests/support/fixtures/WorkspaceFixture.h"
#include "tests/support/program/OwnSettings.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/PlainEdits.h"
#include "tests/support/scenes/SmallStudy.h"
#include "ui/panels/lists/SegmentDelegate.h"
#include "ui/panels/lists/SegmentsPanel.h"
#include "ui/views/ViewGrid.h"
#include "ui/workspace/CuttingPlane.h"
#include "ui/workspace/ViewSteps.h"

#include <QApplication>
#include <QListView>
#include <QMenu>
#include <QMouseEvent>
#include <QSettings>
#include <QSignalSpy>
#include <QTest>
#include <QTimer>

namespace segmentViewsUiTest {

namespace {

/// The window with nine segments, of which the panel shows six at once.
class Fixture : public test::WindowFixture {
public:
    explicit Fixture(core::LoadedVolume volume = test::smallStudy(), int segments = 9)
        : WindowFixture(std::move(volume))
    {
        window.addPanel(new ui::SegmentsPanel(workspace));
        window.showPanels(true);
        window.activateWindow();
        if (!QTest::qWaitForWindowActive(&window))
            qFatal("the window does not become active");
        list = window.findChild<QListView*>(QStringLiteral("segmentList"));
        for (int number = 1; number <= segments; ++number)
            apply(test::newSegment(QStringLiteral("S%1").arg(number)));
        workspace.setActiveSegment(1);
        axial().setFocus();
    }
    [[nodiscard]] ui::SliceView& axial() { return window.views().axial(); }
    [[nodiscard]] QAction& action(const char* id)
    {
        return window.actionTable()[QLatin1String(id)];
    }
    void settle()
    {
        for (int round = 0; round < 5; ++round) {
            if (!session().settle())
                qFatal("not settled");
            session().poll();
        }
    }
    /// The labels that are shown.
    [[nodiscard]] QList<int> shown()
    {
        QList<int> labels;
        for (const core::Segment& each : session().document().segments) {
            if (each.visible)
                labels += each.label;
        }
        return labels;
    }
    void clickEye(int row, Qt::KeyboardModifiers keys = {})
    {
        const QRect place = list->visualRect(list->model()->index(row, 0));
        QTest::mouseClick(
            list->viewport(), Qt::LeftButton, keys, ui::SegmentDelegate::eyeRect(place).center());
    }
    /// Straight to a view: what the display's own pointer does is none of its business.
    void pointAt(ui::ImageView& view, const QPointF& at)
    {
        QMouseEvent move(QEvent::MouseMove, at, view.mapToGlobal(at), Qt::NoButton, {}, {});
        QCoreApplication::sendEvent(&view, &move);
    }
    void leave(ui::ImageView& view)
    {
        QEvent left(QEvent::Leave);
        QCoreApplication::sendEvent(&view, &left);
    }

    QListView* list = nullptr;
};

} // namespace

class SegmentViewsUiTest : public QObject {
    Q_OBJECT

private:
    test::OwnSettings m_settings;

private Q_SLOTS:
    void init()
    {
        test::failOnUnexpectedMessages();
        m_settings.clear();
    }

    /// Q and W, round and round; the list follows, and the history has nothing of it.
    void keysGoThroughTheSegments()
    {
        Fixture fixture;
        const std::size_t rows = fixture.session().history().rows().size();
        QSignalSpy said(&fixture.workspace, &ui::Workspace::said);
        QTest::keyClick(&fixture.axial(), Qt::Key_W);
        QCOMPARE(fixture.workspace.activeSegment(), 2);
        QCOMPARE(said.back().front().toString(), QStringLiteral("'S2' is active"));
        QTest::keyClick(&fixture.axial(), Qt::Key_Q);
        QTest::keyClick(&fixture.axial(), Qt::Key_Q);
        QCOMPARE(fixture.workspace.activeSegment(), 9);
        const auto isSeen = [&fixture](int row) {
            const QRect place = fixture.list->visualRect(fixture.list->model()->index(row, 0));
            return fixture.list->viewport()->rect().contains(place.center());
        };
        QTRY_VERIFY(isSeen(8));
        QVERIFY(!isSeen(0));
        // The list's own keys are no obstacle.
        fixture.list->setFocus();
        QTRY_VERIFY(fixture.list->hasFocus());
        QTest::keyClick(fixture.list, Qt::Key_W);
        QCOMPARE(fixture.workspace.activeSegment(), 1);
        QTRY_VERIFY(isSeen(0));
        QCOMPARE(fixture.list->currentIndex().row(), 0);
        // Where none is active, from either end.
        fixture.workspace.setActiveSegment(0);
        fixture.action("segments.previous").trigger();
        QCOMPARE(fixture.workspace.activeSegment(), 9);
        fixture.workspace.setActiveSegment(0);
        fixture.action("segments.next").trigger();
        QCOMPARE(fixture.workspace.activeSegment(), 1);
        QCOMPARE(fixture.session().history().rows().size(), rows);
    }

    void withoutSegmentsThereIsNothingToGoThrough()
    {
        Fixture fixture(test::smallStudy(), 0);
        for (const char* id :
            {"segments.previous", "segments.next", "segments.centre", "segments.alone"})
            QVERIFY2(!fixture.action(id).isEnabled(), id);
        fixture.apply(test::newSegment(QStringLiteral("First")));
        QVERIFY(fixture.action("segments.next").isEnabled());
        fixture.action("segments.next").trigger();
        QCOMPARE(fixture.workspace.activeSegment(), 1);
        fixture.action("segments.next").trigger();
        QCOMPARE(fixture.workspace.activeSegment(), 1);
        QVERIFY(!fixture.action("segments.alone").isEnabled()); // it is the only one
    }

    void aKeyTakesTheSegmentUnderThePointer()
    {
        Fixture fixture;
        const glm::dvec3 place =
            fixture.workspace.volume()->geometry.toWorld(glm::dvec3(10.0, 10.0, 10.0));
        fixture.apply(test::paintAt(4, {place}, 3.0));
        fixture.workspace.setCrosshairLps(place);
        QSignalSpy said(&fixture.workspace, &ui::Workspace::said);
        fixture.pointAt(fixture.axial(), fixture.axial().context().toPixel(place));
        QTest::keyClick(&fixture.axial(), Qt::Key_Q, Qt::ShiftModifier);
        fixture.settle();
        QCOMPARE(fixture.workspace.activeSegment(), 4);
        QCOMPARE(said.back().front().toString(), QStringLiteral("'S4' is active"));
        // Beside it the active one stays.
        const glm::dvec3 beside =
            fixture.workspace.volume()->geometry.toWorld(glm::dvec3(20.0, 20.0, 10.0));
        fixture.pointAt(fixture.axial(), fixture.axial().context().toPixel(beside));
        fixture.action("segments.underPointer").trigger();
        fixture.settle();
        QCOMPARE(fixture.workspace.activeSegment(), 4);
        QCOMPARE(said.back().front().toString(), QStringLiteral("No segment lies there"));
        fixture.leave(fixture.axial());
        fixture.action("segments.underPointer").trigger();
        fixture.settle();
        QCOMPARE(
            said.back().front().toString(), QStringLiteral("Point at a segment in a view first"));
    }

    /// In the 3D view it is the one that is seen, through a volume that steps back.
    void the3dViewHasOneUnderThePointerToo()
    {
        Fixture fixture(test::smallHead::volume(), 1);
        fixture.apply(test::ballMask(glm::ivec3(test::smallHead::side), 6.0));
        const core::Segment ball = fixture.session().document().segments.back();
        QVERIFY(ball.voxels > 100);
        fixture.workspace.setActiveSegment(1);
        ui::Workspace::VolumeDisplay display = fixture.workspace.volumeDisplay();
        display.surfaceThreshold = 300.0;
        display.context = gpu::Context::Translucent;
        fixture.workspace.setVolumeDisplay(display);
        ui::VolumeView& view = fixture.window.views().volume();
        view.lookFrom({0.0, -1.0, 0.0});
        fixture.pointAt(view, QRectF(view.rect()).center());
        fixture.action("segments.underPointer").trigger();
        fixture.settle();
        QCOMPARE(fixture.workspace.activeSegment(), int(ball.label));
        QSignalSpy said(&fixture.workspace, &ui::Workspace::said);
        fixture.pointAt(view, {12.0, view.height() / 2.0}); // beside the head
        fixture.action("segments.underPointer").trigger();
        fixture.settle();
        QCOMPARE(said.back().front().toString(), QStringLiteral("Nothing is seen there"));
        QCOMPARE(fixture.workspace.activeSegment(), int(ball.label));
    }

    /// Alone, and then as it was before, and not simply all.
    void oneAloneAndAsBefore()
    {
        Fixture fixture(test::smallStudy(), 4);
        const std::size_t rows = fixture.session().history().rows().size();
        QAction& alone = fixture.action("segments.alone");
        QCOMPARE(alone.text(), QStringLiteral("Show only 'S1'"));
        alone.trigger();
        QCOMPARE(fixture.shown(), (QList<int>{1}));
        QCOMPARE(alone.text(), QStringLiteral("Show all segments"));
        alone.trigger();
        QCOMPARE(fixture.shown(), (QList<int>{1, 2, 3, 4}));

        fixture.clickEye(2);
        QCOMPARE(fixture.shown(), (QList<int>{1, 2, 4}));
        fixture.clickEye(1, Qt::ControlModifier);
        QCOMPARE(fixture.shown(), (QList<int>{2}));
        // One that was hidden, too, and from one to the other.
        fixture.clickEye(2, Qt::ControlModifier);
        QCOMPARE(fixture.shown(), (QList<int>{3}));
        fixture.workspace.setActiveSegment(3);
        QCOMPARE(alone.text(), QStringLiteral("Show the others again"));
        fixture.clickEye(2, Qt::ControlModifier);
        QCOMPARE(fixture.shown(), (QList<int>{1, 2, 4}));

        // Who goes on with the eyes does not mean what was before.
        alone.trigger();
        QCOMPARE(fixture.shown(), (QList<int>{3}));
        fixture.clickEye(0);
        fixture.clickEye(0);
        QCOMPARE(fixture.shown(), (QList<int>{3}));
        QCOMPARE(alone.text(), QStringLiteral("Show all segments"));
        alone.trigger();
        QCOMPARE(fixture.shown(), (QList<int>{1, 2, 3, 4}));
        QCOMPARE(fixture.session().history().rows().size(), rows);
    }

    /// Undo right after clicks of eyes means these, all of them.
    void undoOpensTheEyesAgain()
    {
        Fixture fixture(test::smallStudy(), 4);
        const QAction& undo = fixture.action("edit.undo");
        const QAction& redo = fixture.action("edit.redo");
        const QString step = QStringLiteral("Undo: Hide 3 segments");
        const QString before = QStringLiteral("Undo: Add segment 'S4'");
        QTRY_COMPARE(undo.text(), before);
        const auto position = fixture.session().history().position();
        fixture.clickEye(0);
        QTest::qWait(500); // a pause is no end
        fixture.clickEye(1);
        fixture.clickEye(3, Qt::ControlModifier);
        QCOMPARE(fixture.shown(), (QList<int>{4}));
        QCOMPARE(undo.text(), step);
        fixture.action("edit.undo").trigger();
        QCOMPARE(fixture.shown(), (QList<int>{1, 2, 3, 4}));
        QCOMPARE(fixture.session().history().position(), position);
        QCOMPARE(undo.text(), before);
        QCOMPARE(redo.text(), QStringLiteral("Redo: Hide 3 segments"));
        fixture.action("edit.redo").trigger();
        QCOMPARE(fixture.shown(), (QList<int>{4}));
        fixture.action("edit.undo").trigger();
        QCOMPARE(fixture.shown(), (QList<int>{1, 2, 3, 4}));

        // What comes to nothing is none.
        fixture.clickEye(2);
        fixture.clickEye(2);
        QCOMPARE(undo.text(), before);
        QVERIFY(!redo.isEnabled());
    }

    /// In the order in which it was done, whatever it was.
    void undoGoesThroughClipsAndEyes()
    {
        Fixture fixture(test::smallStudy(), 4);
        const QAction& undo = fixture.action("edit.undo");
        const core::ClipRegion whole = fixture.workspace.clip();
        core::ClipRegion clip = whole;
        clip.box.on = true;
        clip.box.maximum.x -= 5.0;
        fixture.clickEye(0);
        fixture.workspace.viewSteps().change(clip);
        fixture.clickEye(1);
        QCOMPARE(undo.text(), QStringLiteral("Undo: Hide 'S2'"));
        fixture.action("edit.undo").trigger();
        QCOMPARE(fixture.shown(), (QList<int>{2, 3, 4}));
        QVERIFY(fixture.workspace.clip() == clip);
        QCOMPARE(undo.text(), QStringLiteral("Undo: Clip"));
        fixture.action("edit.undo").trigger();
        QVERIFY(fixture.workspace.clip() == whole);
        QCOMPARE(fixture.shown(), (QList<int>{2, 3, 4}));
        fixture.action("edit.undo").trigger();
        QCOMPARE(fixture.shown(), (QList<int>{1, 2, 3, 4}));

        // A step that follows comes first; what was hidden stays meanwhile.
        fixture.clickEye(0);
        fixture.apply(test::newSegment(QStringLiteral("Later")));
        QTRY_COMPARE(undo.text(), QStringLiteral("Undo: Add segment 'Later'"));
        fixture.action("edit.undo").trigger();
        fixture.settle();
        QCOMPARE(fixture.shown(), (QList<int>{2, 3, 4}));
        QTRY_COMPARE(undo.text(), QStringLiteral("Undo: Hide 'S1'"));
        fixture.action("edit.undo").trigger();
        QCOMPARE(fixture.shown(), (QList<int>{1, 2, 3, 4}));
    }

    /// However many steps came since: undo takes back what was done last, each in its turn, and
    /// redo brings it back in the same order.
    void eyesBetweenStepsAreTakenBackInTheirTurn()
    {
        Fixture fixture(test::smallStudy(), 2);
        const auto trigger = [&fixture](const char* id) {
            fixture.action(id).trigger();
            fixture.settle();
        };
        const auto segments = [&fixture] { return fixture.session().document().segments.size(); };
        fixture.clickEye(0);
        fixture.apply(test::newSegment(QStringLiteral("S3")));
        fixture.clickEye(1);
        fixture.clickEye(0);
        fixture.apply(test::newSegment(QStringLiteral("S4")));
        QCOMPARE(fixture.shown(), (QList<int>{1, 3, 4}));
        const QAction& undo = fixture.action("edit.undo");
        QTRY_COMPARE(undo.text(), QStringLiteral("Undo: Add segment 'S4'"));
        trigger("edit.undo");
        QTRY_COMPARE(undo.text(), QStringLiteral("Undo: Show and hide segments"));
        trigger("edit.undo");
        QCOMPARE(fixture.shown(), (QList<int>{2, 3}));
        QTRY_COMPARE(undo.text(), QStringLiteral("Undo: Add segment 'S3'"));
        trigger("edit.undo");
        QCOMPARE(segments(), std::size_t(2));
        QTRY_COMPARE(undo.text(), QStringLiteral("Undo: Hide 'S1'"));
        trigger("edit.undo");
        QCOMPARE(fixture.shown(), (QList<int>{1, 2}));
        const QAction& redo = fixture.action("edit.redo");
        QCOMPARE(redo.text(), QStringLiteral("Redo: Hide 'S1'"));
        trigger("edit.redo");
        QCOMPARE(fixture.shown(), (QList<int>{2}));
        trigger("edit.redo");
        QCOMPARE(segments(), std::size_t(3));
        QTRY_COMPARE(redo.text(), QStringLiteral("Redo: Show and hide segments"));
        trigger("edit.redo");
        QCOMPARE(fixture.shown(), (QList<int>{1, 3}));
        QTRY_COMPARE(redo.text(), QStringLiteral("Redo: Add segment 'S4'"));
        // Who does something else instead has given up what was undone.
        trigger("edit.undo");
        fixture.apply(test::newSegment(QStringLiteral("Other")));
        trigger("edit.undo");
        QTRY_COMPARE(redo.text(), QStringLiteral("Redo: Add segment 'Other'"));
    }

    /// A clip that was set since is none of an eye's business.
    void anEyeTakesBackNothingElse()
    {
        Fixture fixture(test::smallStudy(), 2);
        core::ClipRegion clip = fixture.workspace.clip();
        clip.box.on = true;
        clip.box.maximum.x -= 5.0;
        fixture.clickEye(0);
        const core::RowId row = fixture.session().history().position();
        fixture.apply(test::newSegment(QStringLiteral("S3")));
        fixture.workspace.viewSteps().change(clip);
        fixture.clickEye(1);
        QVERIFY(fixture.session().goTo(row));
        fixture.settle();
        fixture.action("edit.undo").trigger();
        QVERIFY(fixture.workspace.clip() == clip);
        QCOMPARE(fixture.shown(), (QList<int>{1}));
    }

    /// Eyes before and after a step of the history that was taken back are two steps.
    void aStepBetweenEyesPartsThem()
    {
        Fixture fixture(test::smallStudy(), 4);
        const QAction& undo = fixture.action("edit.undo");
        fixture.clickEye(0);
        fixture.apply(test::newSegment(QStringLiteral("Later")));
        fixture.action("edit.undo").trigger();
        fixture.settle();
        QTRY_COMPARE(undo.text(), QStringLiteral("Undo: Hide 'S1'"));
        fixture.clickEye(1);
        QCOMPARE(fixture.shown(), (QList<int>{3, 4}));
        fixture.action("edit.undo").trigger();
        QCOMPARE(fixture.shown(), (QList<int>{2, 3, 4}));
        fixture.action("edit.undo").trigger();
        QCOMPARE(fixture.shown(), (QList<int>{1, 2, 3, 4}));
    }

    /// What comes back is what was shown just before, not before something that was undone.
    void undoEndsWhatWasAlone()
    {
        Fixture fixture(test::smallStudy(), 4);
        core::ClipRegion clip = fixture.workspace.clip();
        clip.box.on = true;
        fixture.clickEye(2);
        fixture.workspace.viewSteps().change(clip);
        fixture.action("segments.alone").trigger();
        QCOMPARE(fixture.shown(), (QList<int>{1}));
        for (int step = 0; step < 3; ++step)
            fixture.action("edit.undo").trigger();
        QCOMPARE(fixture.shown(), (QList<int>{1, 2, 3, 4}));
        fixture.action("segments.alone").trigger();
        QCOMPARE(fixture.shown(), (QList<int>{1}));
        fixture.action("segments.alone").trigger();
        QCOMPARE(fixture.shown(), (QList<int>{1, 2, 3, 4}));
    }

    /// However many eyes open or close, whoever follows the list is told once.
    void manyEyesAreOneChange()
    {
        Fixture fixture;
        int told = 0;
        QObject listener;
        QObject::connect(&fixture.workspace, &ui::Workspace::documentChanged, &listener,
            [&told](const core::DocumentChange& change) {
                told += change.what == core::DocumentChange::What::Segments ? 1 : 0;
            });
        fixture.action("segments.alone").trigger();
        QCOMPARE(fixture.shown(), (QList<int>{1}));
        QCOMPARE(told, 1);
        fixture.action("edit.undo").trigger();
        QCOMPARE(fixture.shown().size(), 9);
        QCOMPARE(told, 2);
    }

    /// The menu of a row is about that segment, whichever is active.
    void aRowsMenuGoesThereAndShowsItAlone()
    {
        Fixture fixture(test::smallStudy(), 3);
        const glm::dvec3 place =
            fixture.workspace.volume()->geometry.toWorld(glm::dvec3(30.0, 8.0, 6.0));
        fixture.apply(test::paintAt(2, {place}, 3.2));
        const QPoint at = fixture.list->visualRect(fixture.list->model()->index(1, 0)).center();
        const auto choose = [&](const QString& text) {
            bool chosen = false;
            QTimer::singleShot(0, &fixture.window, [&] {
                auto* menu = qobject_cast<QMenu*>(QApplication::activePopupWidget());
                QVERIFY(menu);
                for (QAction* each : menu->actions()) {
                    if (each->text() != text || !each->isEnabled())
                        continue;
                    each->trigger();
                    chosen = true;
                }
                menu->close();
            });
            Q_EMIT fixture.list->customContextMenuRequested(at);
            return chosen;
        };
        QVERIFY(choose(QStringLiteral("Show only 'S2'")));
        QCOMPARE(fixture.shown(), (QList<int>{2}));
        QVERIFY(choose(QStringLiteral("Show all segments")));
        QCOMPARE(fixture.shown(), (QList<int>{1, 2, 3}));
        QVERIFY(choose(QStringLiteral("Centre views on it")));
        const bool isThere = QTest::qWaitFor(
            [&] {
                fixture.session().poll();
                return glm::length(fixture.workspace.crosshairLps() - place) < 1e-9;
            },
            60000);
        QVERIFY(isThere);
        QCOMPARE(fixture.workspace.activeSegment(), 1);
    }

    /// Fill, outline or both, in slices; the 3D view is not drawn again for that.
    void slicesShowFillOrOutline()
    {
        Fixture fixture(test::smallStudy(), 1);
        const auto drawn = [&fixture](const ui::ImageView& view) {
            return fixture.frames.lastRequest(view.viewId()).segments;
        };
        const ui::VolumeView& volume = fixture.window.views().volume();
        const gpu::SegmentDisplay usual;
        QCOMPARE(drawn(fixture.axial()).fillOpacity, usual.fillOpacity);
        QVERIFY(fixture.action("segments.fillAndOutline").isChecked());
        fixture.action("segments.outline").trigger();
        QTRY_COMPARE(drawn(fixture.axial()).fillOpacity, 0.0f);
        QCOMPARE(drawn(fixture.axial()).outlineWidthPixels, usual.outlineWidthPixels);
        QVERIFY(!fixture.action("segments.fillMore").isEnabled());
        fixture.action("segments.fill").trigger();
        QTRY_COMPARE(drawn(fixture.axial()).outlineWidthPixels, 0.0f);
        QCOMPARE(drawn(fixture.axial()).fillOpacity, usual.fillOpacity);
        QVERIFY(fixture.action("segments.fill").isChecked());
        QVERIFY(!fixture.action("segments.fillAndOutline").isChecked());

        QSignalSpy said(&fixture.workspace, &ui::Workspace::said);
        QTest::keyClick(&fixture.axial(), Qt::Key_Period);
        QTRY_COMPARE(drawn(fixture.axial()).fillOpacity, 0.4f);
        QCOMPARE(said.back().front().toString(),
            QStringLiteral("Segments are filled to 40 % in slices"));
        for (int press = 0; press < 20; ++press)
            QTest::keyClick(&fixture.axial(), Qt::Key_Comma);
        QTRY_COMPARE(drawn(fixture.axial()).fillOpacity, 0.05f);
        QCOMPARE(drawn(volume).fillOpacity, usual.fillOpacity);
        QCOMPARE(drawn(volume).outlineWidthPixels, usual.outlineWidthPixels);
        // The cutting plane in the 3D view is drawn as slices are.
        fixture.workspace.plane().setLook({.shown = true});
        QTRY_COMPARE(drawn(volume).fillOpacity, 0.05f);
        QCOMPARE(drawn(volume).outlineWidthPixels, 0.0f);
    }

    /// Smooth or voxel by voxel; slices are not drawn again for that.
    void bodiesAreSmoothOrVoxelByVoxel()
    {
        {
            Fixture fixture(test::smallStudy(), 1);
            const auto voxelTrue = [&fixture](const ui::ImageView& view) {
                return fixture.frames.lastRequest(view.viewId()).segments.voxelTrue;
            };
            const ui::VolumeView& volume = fixture.window.views().volume();
            QTRY_VERIFY(fixture.action("segments.smoothBodies").isChecked());
            QVERIFY(!voxelTrue(volume));
            fixture.action("segments.voxelTrueBodies").trigger();
            QTRY_VERIFY(voxelTrue(volume));
            QVERIFY(!voxelTrue(fixture.axial()));
            QTRY_VERIFY(fixture.action("segments.voxelTrueBodies").isChecked());
            QVERIFY(!fixture.action("segments.smoothBodies").isChecked());
        }
        {
            Fixture fixture(test::smallStudy(), 1);
            QTRY_VERIFY(fixture.action("segments.voxelTrueBodies").isChecked());
            fixture.action("segments.smoothBodies").trigger();
        }
        {
            Fixture fixture(test::smallStudy(), 1);
            QTRY_VERIFY(fixture.action("segments.smoothBodies").isChecked());
        }
        QSettings().setValue(QStringLiteral("segments/voxelTrue"), QStringLiteral("cubes"));
        Fixture fixture(test::smallStudy(), 1);
        QTRY_VERIFY(fixture.action("segments.smoothBodies").isChecked());
    }

    void theNextWindowShowsThemSo()
    {
        {
            Fixture fixture(test::smallStudy(), 1);
            fixture.action("segments.outline").trigger();
            fixture.action("segments.fill").trigger();
            fixture.action("segments.fillMore").trigger();
        }
        {
            Fixture fixture(test::smallStudy(), 1);
            QVERIFY(fixture.action("segments.fill").isChecked());
            QCOMPARE(fixture.workspace.viewOptions().segmentFillPercent, 40);
        }
        // What nobody could have chosen is none.
        QSettings().setValue(QStringLiteral("segments/drawing"), QStringLiteral("stripes"));
        QSettings().setValue(QStringLiteral("segments/fillPercent"), 900);
        Fixture fixture(test::smallStudy(), 1);
        QVERIFY(fixture.action("segments.fillAndOutline").isChecked());
        QCOMPARE(fixture.workspace.viewOptions().segmentFillPercent, 100);
    }
};

BURIN_WINDOW_TEST(SegmentViewsUiTest)

} // namespace segmentViewsUiTest

#include "SegmentViewsUiTest.moc"
