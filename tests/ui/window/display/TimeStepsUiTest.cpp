// SPDX-License-Identifier: Apache-2.0
#include "tests/support/fixtures/ApplicationFixture.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/SmallStudy.h"
#include "tests/support/series/SyntheticSeries.h"
#include "ui/base/Actions.h"
#include "ui/frame/LoadingBar.h"
#include "ui/settings/StudyOpener.h"
#include "ui/views/ViewGrid.h"
#include "ui/window/display/TimeSteps.h"
#include "ui/workspace/Workspace.h"

#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <QMenu>
#include <QPointer>
#include <QSlider>
#include <QTest>

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>

namespace timeStepsUiTest {

/// From one point of a series in time to the next, and back.
class TimeStepsUiTest : public QObject, private test::WithApplication {
    Q_OBJECT

private:
    static constexpr int points = 3;

    /// The points of one series, which differ in trigger time and values.
    void writeSeries() const
    {
        for (int point = 0; point < points; ++point) {
            test::SyntheticSeries series;
            series.fileName = [point](int k) { return QStringLiteral("t%1-%2").arg(point).arg(k); };
            series.adjust = [point](DcmDataset& set, int k) {
                set.putAndInsertString(
                    DCM_TriggerTime, QByteArray::number(80 * (point + 1)).constData());
                set.putAndInsertString(
                    DCM_SOPInstanceUID, QByteArray::number(1000 * (point + 1) + k).constData());
            };
            series.stored = [point](const glm::ivec3& index) { return index.z + point; };
            test::writeSeries(series, path("times"));
        }
    }
    /// -1 while none is open.
    [[nodiscard]] int time() const
    {
        const core::Volume* volume = workspace().volume();
        return volume && volume->alternatives ? volume->alternatives->time : -1;
    }
    [[nodiscard]] QAction& action(const char* id) const
    {
        return window().actionTable()[QLatin1String(id)];
    }
    void waitFor(int point) const
    {
        QTRY_VERIFY_WITH_TIMEOUT(time() == point && !window().opener().busy(), patience);
    }
    /// What a right click on the slider opens.
    [[nodiscard]] QMenu* timeMenu() const
    {
        auto* slider = window().findChild<QSlider*>(QStringLiteral("timeSlider"));
        Q_EMIT slider->customContextMenuRequested(slider->rect().center());
        return qobject_cast<QMenu*>(QApplication::activePopupWidget());
    }
    [[nodiscard]] static QAction& entry(const QMenu& menu, const char* name)
    {
        return *menu.findChild<QAction*>(QLatin1String(name));
    }
    /// Chooses an entry, as a click into the menu does, which closes it.
    static void choose(QMenu& menu, const char* name)
    {
        QAction& chosen = entry(menu, name);
        menu.close();
        chosen.trigger();
    }
    void step(const char* id, int to) const
    {
        action(id).trigger();
        waitFor(to);
    }

private Q_SLOTS:
    void init()
    {
        makeApplication();
        writeSeries();
    }
    void cleanup() { dropApplication(); }

    void masksStayAndTheLookGoesAlong()
    {
        window().opener().open(
            path("times"), test::SyntheticSeries().seriesUid + QStringLiteral("@2"));
        waitFor(1);
        QVERIFY(action("file.previousTime").isEnabled());
        QVERIFY(action("file.nextTime").isEnabled());
        edit(test::addSegment("At the second point"));
        const glm::dvec3 crosshair = workspace().volume()->geometry.toWorld({5.0, 4.0, 3.0});
        workspace().setCrosshairLps(crosshair);
        workspace().setWindowLevel({-1015.0, 30.0});
        ui::Workspace::ViewOptions options = workspace().viewOptions();
        options.colours = gpu::ColourMap::HotIron;
        workspace().setViewOptions(options);
        ui::Workspace::VolumeDisplay stage = workspace().volumeDisplay();
        stage.mode = gpu::RenderMode::Mip;
        workspace().setVolumeDisplay(stage);
        window().views().axial().setPlace({.centreLps = crosshair, .mmPerPixel = 0.125});
        ui::Workspace::GrowSettings growth = workspace().growSettings();
        growth.boxed = true;
        growth.box = core::GrowBox{.fromLps = crosshair - 1.0, .toLps = crosshair + 1.0};
        workspace().setGrowSettings(growth);

        // To a point that was never open: all of the look goes along, nothing that was drawn.
        step("file.nextTime", 2);
        QCOMPARE(time(), 2);
        QVERIFY(!action("file.nextTime").isEnabled());
        QVERIFY(action("file.previousTime").isEnabled());
        QVERIFY(session().document().segments.empty());
        QVERIFY(glm::distance(workspace().crosshairLps(), crosshair) < 1e-9);
        QVERIFY(workspace().growSettings().boxed);
        QVERIFY(workspace().growSettings().box == growth.box);
        QCOMPARE(workspace().windowLevel(), (core::WindowLevel{-1015.0, 30.0}));
        QVERIFY(workspace().viewOptions().colours == gpu::ColourMap::HotIron);
        QVERIFY(workspace().volumeDisplay().mode == gpu::RenderMode::Mip);
        QVERIFY(window().views().axial().place().has_value());
        QCOMPARE(window().views().axial().place()->mmPerPixel, 0.125);

        // Back to one that has been looked at: its 3D view is its own, the grey scale goes along.
        workspace().setWindowLevel({-1000.0, 60.0});
        stage.mode = gpu::RenderMode::Xray;
        workspace().setVolumeDisplay(stage);
        step("file.previousTime", 1);
        QCOMPARE(time(), 1);
        QCOMPARE(session().document().segments.size(), std::size_t(1));
        QCOMPARE(workspace().windowLevel(), (core::WindowLevel{-1000.0, 60.0}));
        QVERIFY(workspace().volumeDisplay().mode == gpu::RenderMode::Mip);

        step("file.previousTime", 0);
        QCOMPARE(time(), 0);
        QVERIFY(!action("file.previousTime").isEnabled());
        QVERIFY(session().document().segments.empty());
    }

    /// Between two points the views show the one before: neither black, nor the start page.
    void viewsKeepTheirPicturesUntilTheNextPoint()
    {
        window().opener().open(
            path("times"), test::SyntheticSeries().seriesUid + QStringLiteral("@2"));
        waitFor(1);
        workspace().setWindowLevel({-1015.0, 30.0});
        QVERIFY(test::waitUntilDrawn(window(), workspace()));
        ui::ViewGrid& views = window().views();
        const QImage before = views.axial().grab().toImage();
        QImage between;
        int closed = 0;
        QObject watched;
        QObject::connect(&workspace(), &ui::Workspace::sessionChanged, &watched, [&] {
            if (workspace().volume())
                return;
            ++closed;
            for (ui::ImageView* view : {static_cast<ui::ImageView*>(&views.axial()),
                     static_cast<ui::ImageView*>(&views.sagittal()),
                     static_cast<ui::ImageView*>(&views.coronal()),
                     static_cast<ui::ImageView*>(&views.volume())})
                QVERIFY(view->isVisible() && view->holdsPicture());
            between = views.axial().grab().toImage();
        });
        step("file.nextTime", 2);
        QCOMPARE(closed, 1);
        QVERIFY(between == before);
        QTRY_VERIFY_WITH_TIMEOUT(!views.holdsPictures(), patience);
        QVERIFY(test::waitUntilDrawn(window(), workspace()));
        const QImage after = views.axial().grab().toImage();
        QVERIFY(after != before);

        // Where it takes longer, the picture is dimmed and says what is awaited.
        views.holdPictures(QStringLiteral("Opening point 1 of 3"));
        QVERIFY(views.axial().grab().toImage() == after);
        QTRY_VERIFY_WITH_TIMEOUT(views.axial().grab().toImage() != after, patience);
        views.releasePictures();
        QVERIFY(views.axial().grab().toImage() == after);
    }

    void aPointThatIsCalledOffLeavesNoPictures()
    {
        window().opener().open(path("times"), test::SyntheticSeries().seriesUid);
        waitFor(0);
        QVERIFY(test::waitUntilDrawn(window(), workspace()));
        QObject watched;
        QObject::connect(&workspace(), &ui::Workspace::sessionChanged, &watched, [&] {
            if (!workspace().session())
                QMetaObject::invokeMethod(
                    &watched, [this] { window().closeStudy(); }, Qt::QueuedConnection);
        });
        action("file.nextTime").trigger();
        QTRY_VERIFY_WITH_TIMEOUT(!workspace().session() && !window().opener().busy(), patience);
        QVERIFY(!window().views().holdsPictures());
        QVERIFY(!window().views().axial().isVisible());
    }

    /// Where slices were zoomed, turned or oblique at a point, and are not at the next: nothing of
    /// that comes back.
    void theSamePlaceIsSeenWhereSlicesLayOtherwise()
    {
        window().opener().open(
            path("times"), test::SyntheticSeries().seriesUid + QStringLiteral("@2"));
        waitFor(1);
        ui::SliceView& axial = window().views().axial();
        ui::MprPlanes& planes = window().views().planes();
        axial.setPlace({.centreLps = workspace().crosshairLps(), .mmPerPixel = 0.125});
        axial.setTurn({true, 1});
        planes.turnOthers(ui::SliceOrientation::Axial, 0.6);
        step("file.nextTime", 2);
        QVERIFY(axial.place().has_value());
        QVERIFY(axial.turn() == (ui::SliceTurn{true, 1}));
        QVERIFY(!planes.alongPatient());
        axial.resetView();
        planes.reset();
        step("file.previousTime", 1);
        QVERIFY(!axial.place());
        QVERIFY(axial.turn().isUpright());
        QVERIFY(planes.alongPatient());
    }

    /// The slider's menu leads to both ends, and says which point is chosen.
    void theSlidersMenuLeadsToBothEnds()
    {
        window().opener().open(
            path("times"), test::SyntheticSeries().seriesUid + QStringLiteral("@2"));
        waitFor(1);
        QMenu* menu = timeMenu();
        QVERIFY(menu);
        QVERIFY(entry(*menu, "firstTime").isEnabled() && entry(*menu, "lastTime").isEnabled());
        choose(*menu, "lastTime");
        waitFor(2);
        menu = timeMenu();
        QVERIFY(menu);
        QVERIFY(entry(*menu, "firstTime").isEnabled() && !entry(*menu, "lastTime").isEnabled());
        choose(*menu, "copyTime");
        const QString copied = QGuiApplication::clipboard()->text();
        QVERIFY2(copied.startsWith(QLatin1String("Point 3 of 3")), qPrintable(copied));
        QVERIFY2(
            copied.contains(QLatin1String("240 ms")) && !copied.endsWith(u'.'), qPrintable(copied));
        menu = timeMenu();
        QVERIFY(menu);
        choose(*menu, "firstTime");
        waitFor(0);
    }

    /// Playing goes round until it is stopped, and what is drawn stops it.
    void playingGoesRound()
    {
        window().opener().open(
            path("times"), test::SyntheticSeries().seriesUid + QStringLiteral("@2"));
        waitFor(1);
        auto& steps = *window().findChild<ui::TimeSteps*>();
        // As fast as the points open.
        steps.play(1000.0);
        QVERIFY(steps.isPlaying());
        QList<int> seen{1};
        QObject watched;
        int started = 0;
        QObject::connect(&window().opener(), &ui::StudyOpener::started, &watched, [&] {
            ++started;
            QVERIFY(!window().loading().isVisible());
        });
        QObject::connect(
            &workspace(), &ui::Workspace::sessionChanged, &watched, [this, &seen, &steps] {
                if (time() < 0)
                    return;
                seen += time();
                if (seen.size() == 5)
                    steps.pause();
            });
        QTRY_VERIFY_WITH_TIMEOUT(!steps.isPlaying() && !window().opener().busy(), patience);
        QCOMPARE(seen, (QList<int>{1, 2, 0, 1, 2}));
        QVERIFY(started >= 4);
        QTest::qWait(20);
        QCOMPARE(time(), 2);

        // The menu says that it plays, and pauses.
        steps.play(0.001);
        QMenu* menu = timeMenu();
        QVERIFY(menu);
        QCOMPARE(entry(*menu, "playTimes").text(), QStringLiteral("Pause"));
        choose(*menu, "playTimes");
        QVERIFY(!steps.isPlaying());
        menu = timeMenu();
        QVERIFY(menu);
        QCOMPARE(entry(*menu, "playTimes").text(), QStringLiteral("Play"));
        choose(*menu, "playTimes");
        QVERIFY(steps.isPlaying());

        // So slowly that no other point follows.
        steps.play(0.001);
        edit(test::addSegment("Drawn meanwhile"));
        QTRY_VERIFY_WITH_TIMEOUT(!steps.isPlaying(), patience);
        QCOMPARE(time(), 2);
        QCOMPARE(session().document().segments.size(), std::size_t(1));
    }

    /// Its menu stays while it plays, and pauses it.
    void theMenuStaysWhileItPlays()
    {
        window().opener().open(path("times"), test::SyntheticSeries().seriesUid);
        waitFor(0);
        auto& steps = *window().findChild<ui::TimeSteps*>();
        QAction& play = action("file.playTimes");
        QVERIFY(play.isEnabled());
        QCOMPARE(play.text(), QStringLiteral("Play points in time"));
        steps.play(5.0);
        QVERIFY(play.text().startsWith(QLatin1String("Pause")));
        // While the next point is being opened.
        QPointer<QMenu> menu;
        QObject watched;
        QObject::connect(&window().opener(), &ui::StudyOpener::started, &watched, [&] {
            if (!menu)
                menu = timeMenu();
        });
        waitFor(1);
        QVERIFY(menu);
        QTest::qWait(1000);
        QVERIFY(menu && menu->isVisible());
        // What it is about does not change under it.
        QCOMPARE(time(), 1);
        QVERIFY(steps.isPlaying());
        choose(*menu, "playTimes");
        QVERIFY(!steps.isPlaying());
        QCOMPARE(play.text(), QStringLiteral("Play points in time"));

        play.trigger();
        QVERIFY(steps.isPlaying());
        play.trigger();
        QVERIFY(!steps.isPlaying());
    }

    void anotherStudyEndsPlaying()
    {
        window().opener().open(path("times"), test::SyntheticSeries().seriesUid);
        waitFor(0);
        auto& steps = *window().findChild<ui::TimeSteps*>();
        steps.play(0.001);
        QVERIFY(steps.isPlaying());
        window().opener().open(path("case/ct"));
        QTRY_VERIFY_WITH_TIMEOUT(!steps.hasPoint(1) && !window().opener().busy(), patience);
        QVERIFY(!steps.isPlaying());
        steps.play(1.0); // there is nothing to play
        QVERIFY(!steps.isPlaying());
    }

    /// What is opened otherwise begins with its own look.
    void anotherOpeningTakesNothingAlong()
    {
        window().opener().open(path("times"), test::SyntheticSeries().seriesUid);
        waitFor(0);
        workspace().setWindowLevel({-1015.0, 30.0});
        window().opener().open(
            path("times"), test::SyntheticSeries().seriesUid + QStringLiteral("@3"));
        waitFor(2);
        QVERIFY(workspace().windowLevel() != (core::WindowLevel{-1015.0, 30.0}));
    }

    void aStudyWithoutPointsHasNoSteps()
    {
        open(path("case/ct"));
        QVERIFY(!action("file.playTimes").isEnabled());
        QVERIFY(!action("file.previousTime").isEnabled());
        QVERIFY(!action("file.nextTime").isEnabled());
    }
};

BURIN_WINDOW_TEST(TimeStepsUiTest)

} // namespace timeStepsUiTest

#include "TimeStepsUiTest.moc"
