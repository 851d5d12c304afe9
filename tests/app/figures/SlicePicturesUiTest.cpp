// SPDX-License-Identifier: Apache-2.0
#include "core/volume/ClipRegion.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/fixtures/WindowFixture.h"
#include "tests/support/fixtures/pictures/Collage.h"
#include "tests/support/fixtures/pictures/FigureWindow.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/PlainEdits.h"
#include "ui/frame/PanelSection.h"
#include "ui/menus/EditableButton.h"
#include "ui/tools/contour/ContourTool.h"
#include "ui/tools/growth/FloodFillTool.h"
#include "ui/tools/growth/PaintTool.h"
#include "ui/tools/nudge/NudgeTool.h"
#include "ui/tools/outline/FillOutlineTool.h"
#include "ui/tools/view/MeasureTool.h"
#include "ui/views/SliceView.h"
#include "ui/views/ViewGrid.h"
#include "ui/views/VolumeView.h"
#include "ui/widgets/HistogramRange.h"
#include "ui/widgets/HistogramRangePlot.h"

#include <QApplication>
#include <QLabel>
#include <QMenu>
#include <QtTest>

#include <algorithm>
#include <cmath>

namespace slicePicturesUiTest {

/// The manual's pictures of what is done on slices of the demonstration head: painting, outlines,
/// the editable range, a contour that evolves, an interval that is moved, measuring, slices that
/// are turned. Mouse and keys are used as by hand. It only runs where somebody wants pictures:
/// BURIN_SCREENSHOTS names the folder.
class SlicePicturesUiTest : public QObject, private test::FigureWindow {
    Q_OBJECT

    using Mouse = test::WindowFixture;

private:
    /// Opens the head with a segment without voxels, which is the active one.
    void openWithSegment(const QString& panel = QStringLiteral("Segments"))
    {
        openHead(panel);
        apply(test::newSegment(QStringLiteral("Ventricle"), 0x4AA3FF));
        workspace().setActiveSegment(1);
    }
    /// A brush that heeds neither edges nor values.
    void takeBrush(double radiusMm, bool isFlat, bool isSquare)
    {
        workspace().setBrushSettings(ui::Workspace::Brush::Paint,
            {.radiusMm = radiusMm, .disc = isFlat, .square = isSquare});
    }

private Q_SLOTS:
    void initTestCase() { wantPictures(); }
    void init() { test::failOnUnexpectedMessages(); }

    /// Six tools at the left horn of the ventricles, each while it is in use.
    void sliceTools()
    {
        openWithSegment();
        const core::RowId empty = session().history().position();
        constexpr double z = 20.0;
        ui::SliceView& axial = axialAlone({-6.0, 31.0, z}, 0.16);
        constexpr QSize size(400, 300);
        std::vector<QImage> panels;
        const auto keep = [&] {
            QVERIFY(waitUntilDrawn());
            panels.push_back(test::middleOf(axial, size));
        };

        ui::Workspace::BrushSettings brush = workspace().brushSettings(ui::Workspace::Brush::Paint);
        brush.radiusMm = 5.0;
        brush.followsEdges = true;
        brush.edgeTolerance = 16.0;
        workspace().setBrushSettings(ui::Workspace::Brush::Paint, brush);
        hand<ui::PaintTool>();
        const Way down{{-18.0, 22.0, z}, {-26.0, 24.0, z}, {-26.0, 31.0, z}, {-23.0, 38.0, z}};
        draw(axial, down);
        keep();
        lift(axial, down.back());

        auto& nudge = hand<ui::NudgeTool>();
        nudge.setSettings({.radiusMm = 4.0});
        const Way out{{-24.0, 34.0, z}, {-17.0, 35.0, z}, {-12.0, 37.0, z}};
        draw(axial, out);
        keep();
        lift(axial, out.back());
        QVERIFY(session().goTo(empty));

        auto& outline = hand<ui::FillOutlineTool>();
        Way around;
        for (int i = 0; i <= 20; ++i) {
            const double turn = 0.27 * i;
            around.push_back({-19.5 + 10.0 * std::sin(turn), 31.0 - 15.0 * std::cos(turn), z});
        }
        draw(axial, around);
        keep();
        outline.cancel();
        lift(axial, around.back());

        outline.setShape(ui::FillOutlineTool::Shape::Livewire);
        for (const glm::dvec3& anchor : Way{{-16.0, 17.5, z}, {-28.0, 25.0, z}, {-20.0, 43.0, z}})
            click(axial, anchor);
        hover(axial, {-13.8, 30.0, z});
        QTest::qWait(restMs);
        keep();
        outline.cancel();

        outline.setShape(ui::FillOutlineTool::Shape::Level);
        hover(axial, {-12.2, 26.0, z});
        QTest::qWait(restMs);
        keep();
        outline.cancel();

        auto& flood = hand<ui::FloodFillTool>();
        flood.setSettings({.tolerance = 16.0});
        click(axial, {-22.0, 24.0, z});
        QTest::qWait(restMs);
        hover(axial, {-15.0, 25.0, z});
        keep();
        QVERIFY(test::keepCollage(
            {{panels[0], panels[1], panels[2]}, {panels[3], panels[4], panels[5]}},
            "slice-tools.png"));
    }

    /// A square, a cube, a ball and the eraser while they are in use; what they left behind, seen
    /// from the front; and the ball on the 3D view.
    void brushes()
    {
        openHead();
        apply(test::newSegment(QStringLiteral("Lesion"), 0xE07A5F));
        workspace().setActiveSegment(1);
        constexpr double z = 20.0;
        constexpr double y = 22.0; // where they are seen from the front
        constexpr double mmPerPixel = 0.16;
        const glm::dvec3 middle(-6.0, y, z);
        ui::SliceView& axial = axialAlone(middle, mmPerPixel);
        constexpr QSize size(400, 300);
        std::vector<QImage> panels;
        const auto stroke = [&](ui::ImageView& view, const Way& way) {
            draw(view, way);
            QVERIFY(waitUntilDrawn());
            panels.push_back(test::middleOf(view, size));
            lift(view, way.back());
            rest();
        };
        auto& tool = hand<ui::PaintTool>();
        tool.setErases(false);
        takeBrush(4.0, true, true);
        stroke(axial, {{-31.0, y, z}, {-25.0, y, z}});
        takeBrush(4.0, false, true);
        stroke(axial, {{-14.0, y, z}, {-8.0, y, z}});
        takeBrush(6.0, false, false);
        stroke(axial, {{9.0, y, z}, {13.0, 36.0, z}});
        tool.setErases(true);
        takeBrush(3.5, false, false);
        stroke(axial, {{-2.0, 32.0, z}, {24.0, 30.0, z}});
        tool.setErases(false);

        ui::ViewGrid& views = window().views();
        views.maximise(&views.coronal());
        QCoreApplication::processEvents();
        views.coronal().setPlace({.centreLps = middle, .mmPerPixel = mmPerPixel});
        rest();
        panels.push_back(test::middleOf(views.coronal(), size));

        ui::VolumeView& stage = views.volume();
        views.maximise(&stage);
        stage.flyTo({0.0, -40.0, 45.0}, {-0.45, -1.0, 0.45});
        ui::Camera camera = stage.camera();
        camera.heightMm = 250.0;
        stage.setCamera(camera);
        rest();
        takeBrush(7.0, false, false);
        stroke(stage, {{-30.0, -40.0, 50.0}, {0.0, -40.0, 38.0}, {28.0, -40.0, 50.0}});
        QVERIFY(test::keepCollage(
            {{panels[0], panels[1], panels[2]}, {panels[3], panels[4], panels[5]}}, "brushes.png"));
    }

    /// The shapes of outline that follow no edge, each while it is drawn; the lasso is among the
    /// tools of slices.
    void outlines()
    {
        openWithSegment();
        constexpr double z = 20.0;
        ui::SliceView& axial = axialAlone({-6.0, 31.0, z}, 0.16);
        constexpr QSize size(400, 300);
        std::vector<QImage> panels;
        const auto keep = [&] {
            QVERIFY(waitUntilDrawn());
            panels.push_back(test::middleOf(axial, size));
        };
        using Shape = ui::FillOutlineTool::Shape;
        auto& outline = hand<ui::FillOutlineTool>();
        outline.setShape(Shape::Polygon);
        for (const glm::dvec3& corner :
            Way{{-15.5, 17.0, z}, {-25.0, 20.0, z}, {-29.0, 29.0, z}, {-22.0, 43.0, z}})
            click(axial, corner);
        hover(axial, {-13.5, 31.0, z});
        QTest::qWait(restMs);
        keep();
        outline.cancel();
        const Way across{{-30.0, 16.5, z}, {-12.0, 44.0, z}};
        for (const Shape shape : {Shape::Rectangle, Shape::Ellipse}) {
            outline.setShape(shape);
            draw(axial, across);
            keep();
            outline.cancel();
            lift(axial, across.back());
        }
        QVERIFY(test::keepCollage({panels}, "outlines.png"));
    }

    /// One stroke with an editable range of values, and with one in the clip box; the button that
    /// tells the range, and the menu in which it is chosen.
    void editableRange()
    {
        openWithSegment(QStringLiteral("Clean up"));
        const core::RowId empty = session().history().position();
        constexpr double z = 20.0;
        ui::SliceView& axial = axialAlone({-6.0, 31.0, z}, 0.16);
        constexpr QSize size(400, 300);
        std::vector<QImage> panels;
        hand<ui::PaintTool>().setErases(false);
        takeBrush(9.0, true, false);
        const auto paintWithin = [&](const ui::EditableSettings& range) {
            workspace().setEditableSettings(range);
            const Way down{{-25.0, 20.0, z}, {-22.0, 30.0, z}, {-18.0, 42.0, z}};
            draw(axial, down);
            QVERIFY(waitUntilDrawn());
            panels.push_back(test::middleOf(axial, size));
            lift(axial, down.back());
            QVERIFY(session().goTo(empty));
        };
        ui::EditableSettings range{.on = true, .byValue = true, .lower = -20.0, .upper = 16.0};
        paintWithin(range);
        const core::VolumeGeometry& geometry = workspace().volume()->geometry;
        const glm::dvec3 one = geometry.toIndex({-30.0, 24.0, z - 12.0});
        const glm::dvec3 other = geometry.toIndex({-15.0, 39.0, z + 12.0});
        core::ClipRegion clip = workspace().clip();
        clip.box = {.minimum = glm::min(one, other), .maximum = glm::max(one, other), .on = true};
        workspace().setClip(clip);
        paintWithin({.on = true, .boxed = true});

        range.boxed = true;
        workspace().setEditableSettings(range);
        rest();
        auto* button = section(QStringLiteral("Clean up")).findChild<ui::EditableButton*>();
        QVERIFY(button);
        QMenu& menu = *button->menu();
        menu.popup(button->mapToGlobal(QPoint(0, button->height())));
        QVERIFY(QTest::qWaitForWindowExposed(&menu));
        QTest::qWait(restMs);
        const std::vector<QImage> chosen{button->grab().toImage(), menu.grab().toImage()};
        menu.close();
        QVERIFY(test::keepCollage({panels, chosen}, "editable-range.png"));
    }

    /// A contour in the horn after some generations, its panel, and its body in the 3D view.
    void contour()
    {
        openWithSegment(QStringLiteral("Contour"));
        constexpr double z = 20.0;
        auto& tool = hand<ui::ContourTool>();
        tool.setSettings({.bubbleMm = 3.0, .generations = 60});
        ui::SliceView& axial = axialAlone({-4.0, 31.0, z}, 0.2);
        QVERIFY(waitUntilDrawn());
        click(axial, {-24.0, 24.0, z});
        QVERIFY(wait([&] {
            return tool.run().track() && !tool.run().isWorking() && !tool.run().isPlaying();
        }));
        constexpr QSize size(336, 360);
        std::vector<QImage> panels;
        for (const int generation : {6, 40}) {
            tool.run().goTo(generation);
            QVERIFY(wait([&] { return tool.run().isInSight(); }));
            hover(axial, {-17.0, 43.0, z});
            rest();
            panels.push_back(test::middleOf(axial, size));
        }
        ui::VolumeView& stage = window().views().volume();
        window().views().maximise(&stage);
        show(gpu::Context::Translucent);
        rest();
        panels.push_back(test::middleOf(stage, size));
        panels.push_back(pictureOf(QStringLiteral("Contour")));
        QVERIFY(test::keepCollage({panels}, "contour.png"));
    }

    /// The interval of a growth is narrowed, and what that suspends stands in the 3D view.
    void suspended()
    {
        openHead(QStringLiteral("Growth"));
        constexpr double z = 20.0;
        apply(test::newSegment(QStringLiteral("Ventricles"), 0x4AA3FF));
        workspace().setActiveSegment(1);
        apply(test::seedAt(1, {{-22.0, 24.0, z}, {22.0, 24.0, z}}));
        apply(test::growBetween(-20, 20, 40));
        ui::Workspace::ViewOptions options = workspace().viewOptions();
        options.suspendedBodies = true;
        workspace().setViewOptions(options);
        workspace().setCrosshairLps({-18.0, 31.0, z});
        show(gpu::Context::Hidden);
        ui::VolumeView& stage = window().views().volume();
        stage.flyTo({0.0, 20.0, z}, {-0.3, -1.0, 0.7});
        ui::Camera camera = stage.camera();
        camera.heightMm = 90.0;
        stage.setCamera(camera);
        window().views().axial().setPlace({.centreLps = {0.0, 20.0, z}, .mmPerPixel = 0.25});
        rest();
        auto* range = window().findChild<ui::HistogramRange*>(QStringLiteral("growthInterval"));
        ui::HistogramRangePlot& plot = *range->plot();
        plot.showValues(-60.0, 60.0);
        const auto at = [&plot](double value) {
            return QPoint(int(std::lround(plot.xOf(value))), plot.height() / 2);
        };
        QTest::mousePress(&plot, Qt::LeftButton, {}, at(20.0));
        QTest::mouseMove(&plot, at(15.0));
        QTest::mouseMove(&plot, at(10.0));
        const auto* words = window().findChild<QLabel*>(QStringLiteral("growIntervalChange"));
        QVERIFY(
            wait([words] { return !words->text().isEmpty() && !words->text().endsWith(u'…'); }));
        // As far as what the interval comes to.
        const QImage whole = pictureOf(QStringLiteral("Growth"));
        const QPoint below(0, words->height() + 8);
        const QImage panel = whole.copy(
            0, 0, whole.width(), words->mapTo(&section(QStringLiteral("Growth")), below).y());
        QTest::mouseRelease(&plot, Qt::LeftButton, {}, at(10.0));
        rest();
        constexpr QSize size(360, 226);
        QVERIFY(test::keepCollage(
            {{panel, test::middleOf(window().views().axial(), size), test::middleOf(stage, size)}},
            "suspended.png"));
    }

    /// What is measured on one slice, and the panels that list it.
    void measuring()
    {
        openHead();
        window().resize(1400, 900);
        foldAllBut({QStringLiteral("Segments"), QStringLiteral("Measurements"),
            QStringLiteral("Statistics")});
        constexpr double z = 20.0;
        apply(test::newSegment(QStringLiteral("Ventricles"), 0x4AA3FF));
        apply(test::seedAt(
            1, {{-22.0, 24.0, z}, {-8.0, -18.0, z}, {8.0, -18.0, z}, {22.0, 24.0, z}}));
        apply(test::growBetween(-20, 18, 14));
        apply(test::newSegment(QStringLiteral("Skull"), 0xE6C84A));
        apply(test::thresholdOf(2, 300.0));
        ui::SliceView& axial = axialAlone({0.0, 2.0, z}, 0.3);
        auto& tool = hand<ui::MeasureTool>();
        using Kind = core::Measurement::Kind;
        const auto drag = [&](Kind kind, const Way& way) {
            tool.setKind(kind);
            draw(axial, way);
            lift(axial, way.back());
            QTest::qWait(100);
        };
        drag(Kind::Distance, {{-60.0, -8.0, z}, {62.0, -8.0, z}});
        drag(Kind::Ellipse, {{28.0, -45.0, z}, {50.0, -25.0, z}});
        drag(Kind::Angle, {{-50.0, -50.0, z}, {-8.0, -30.0, z}});
        click(axial, {-45.0, -20.0, z});
        QTest::qWait(100);
        drag(Kind::Rectangle, {{-55.0, 16.0, z}, {-42.0, 30.0, z}});
        tool.setText(QStringLiteral("choroid plexus"));
        drag(Kind::Arrow, {{-21.0, 30.0, z}, {-42.0, 52.0, z}});
        tool.setKind(Kind::Probe);
        click(axial, {0.0, -40.0, z});
        QTest::qWait(restMs);
        Mouse::hover(axial, QPointF(5.0, 5.0));
        rest();
        const QImage slice = test::middleOf(axial, QSize(640, 660));
        const QImage list = pictureOf(QStringLiteral("Measurements"));
        // The table in a window of its own, where it has room.
        ui::PanelSection& table = section(QStringLiteral("Statistics"));
        Q_EMIT table.floatRequested(true);
        QVERIFY(wait([&] { return table.isFloating(); }));
        table.resize(slice.width() + 8 + list.width(), 180);
        QTest::qWait(restMs);
        QVERIFY(test::keepCollage({{slice, list}, {table.grab().toImage()}}, "measuring.png"));
    }

    /// Slices that were turned about the crosshair, a slab, and the lens.
    void turnedSlices()
    {
        openHead();
        ui::Workspace::ViewOptions options = workspace().viewOptions();
        options.showCrosshair = true;
        workspace().setViewOptions(options);
        workspace().setActiveTool(nullptr);
        workspace().setCrosshairLps({-18.0, 31.0, 20.0});
        ui::SliceView& axial = window().views().axial();
        QVERIFY(waitUntilDrawn());
        const double away = 0.4 * std::min(axial.width(), axial.height());
        const QPointF cross = axial.crosshairPixel();
        Mouse::hover(axial, cross + QPointF(away, 0.0));
        Mouse::mouse(axial, QEvent::MouseButtonPress, cross + QPointF(away, 0.0));
        QPointF last;
        for (int degrees = 0; degrees <= 24; degrees += 3) {
            const double turn = degrees * M_PI / 180.0;
            last = cross + away * QPointF(std::cos(turn), std::sin(turn));
            Mouse::mouse(axial, QEvent::MouseMove, last);
        }
        Mouse::mouse(axial, QEvent::MouseButtonRelease, last);
        Mouse::hover(axial, last);
        QVERIFY(waitUntilDrawn());
        std::vector<QImage> panels{
            axial.grab().toImage(), window().views().coronal().grab().toImage()};
        const core::WindowLevel grey = workspace().windowLevel();
        workspace().setWindowLevel({.centre = 150.0, .width = 500.0});
        options.slabMode = gpu::SlabMode::Maximum;
        options.slabMm = 20.0;
        workspace().setViewOptions(options);
        QVERIFY(waitUntilDrawn());
        std::vector<QImage> second{window().views().coronal().grab().toImage()};
        options.slabMode = gpu::SlabMode::Off;
        workspace().setWindowLevel(grey);
        workspace().setViewOptions(options);
        Mouse::hover(axial, axial.crosshairPixel() + QPointF(40.0, 0.0));
        QTest::keyPress(&axial, Qt::Key_Z);
        rest();
        second.push_back(axial.grab().toImage());
        QTest::keyRelease(&axial, Qt::Key_Z);
        QVERIFY(test::keepCollage({panels, second}, "turned-slices.png"));
    }
};

BURIN_WINDOW_TEST(SlicePicturesUiTest)

} // namespace slicePicturesUiTest

#include "SlicePicturesUiTest.moc"
