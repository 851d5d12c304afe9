// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/growth/GrowFromSeeds.h"
#include "core/edits/kinds/layers/AddLayer.h"
#include "core/edits/kinds/pieces/ChangePiece.h"
#include "core/edits/kinds/segments/CleanSegment.h"
#include "core/morphology/SegmentShape.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/fixtures/WindowFixture.h"
#include "tests/support/fixtures/pictures/Collage.h"
#include "tests/support/fixtures/pictures/FigureWindow.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/PlainEdits.h"
#include "ui/base/Actions.h"
#include "ui/dialogs/segment/ReshapeDialog.h"
#include "ui/dialogs/segment/SplitIslandsDialog.h"
#include "ui/frame/PanelSection.h"
#include "ui/panels/growth/SpreadBar.h"
#include "ui/tools/contour/ContourTool.h"
#include "ui/tools/growth/BarrierTool.h"
#include "ui/tools/growth/SeedTool.h"
#include "ui/tools/growth/ShrinkTool.h"
#include "ui/tools/sculpt/CarveBrushTool.h"
#include "ui/tools/sculpt/DrillTool.h"
#include "ui/tools/sculpt/LaserTool.h"
#include "ui/tools/sculpt/PeelTool.h"
#include "ui/tools/sculpt/PieceTool.h"
#include "ui/tools/sculpt/ScissorsTool.h"
#include "ui/tools/view/ClipHandles.h"
#include "ui/tools/view/ClipTool.h"
#include "ui/tools/view/UndoHereTool.h"
#include "ui/views/SliceView.h"
#include "ui/views/ViewGrid.h"
#include "ui/views/VolumeView.h"

#include <QAction>
#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QToolButton>
#include <QtTest>

#include <cmath>

namespace toolPicturesUiTest {

/// The manual's pictures of tools that no other figure shows in use: those that carve, those of
/// growth, clipping, pieces, Revert; and of dialogs, the window, and what lies between voxels. It
/// only runs where somebody wants pictures: BURIN_SCREENSHOTS names the folder.
class ToolPicturesUiTest : public QObject, private test::FigureWindow {
    Q_OBJECT

    using Mouse = test::WindowFixture;
    using Pixels = std::vector<QPointF>;

private:
    static constexpr double z = 20.0; ///< mm; the slice in which the ventricles are largest
    static constexpr QSize headSize{400, 330};

    [[nodiscard]] ui::VolumeView& stage() { return window().views().volume(); }
    /// The 3D view alone, looking at the forehead.
    void openForehead()
    {
        openHead();
        window().views().maximise(&stage());
        stage().flyTo({0.0, -40.0, 45.0}, {-0.45, -1.0, 0.45});
        ui::Camera camera = stage().camera();
        camera.heightMm = 250.0;
        stage().setCamera(camera);
        rest();
    }
    /// A pixel of the 3D view, right of and below its middle.
    [[nodiscard]] QPointF at(double right, double down)
    {
        return {stage().width() / 2.0 + right, stage().height() / 2.0 + down};
    }
    /// Waits until what stands open is drawn; to settle would end it.
    void drawn()
    {
        for (int picture = 0; picture < 2; ++picture) {
            QTest::qWait(restMs);
            QVERIFY(wait([this] { return window().views().refined(); }));
        }
    }
    /// Presses and moves the mouse over the 3D view; the button stays down.
    /// @param stands whether something stands open that is to stay so
    void press(const Pixels& way, bool stands = false)
    {
        Mouse::hover(stage(), way.front());
        QTest::qWait(restMs);
        Mouse::mouse(stage(), QEvent::MouseButtonPress, way.front());
        for (const QPointF& each : way)
            Mouse::mouse(stage(), QEvent::MouseMove, each);
        stands ? drawn() : rest();
    }
    void release(const QPointF& where)
    {
        Mouse::mouse(stage(), QEvent::MouseButtonRelease, where);
        drawn();
    }
    /// A closed curve around a place of the 3D view, all but its end.
    [[nodiscard]] Pixels around(const QPointF& middle, double wide, double high)
    {
        Pixels way;
        for (double turn = 2.2; turn < 8.2; turn += 0.1)
            way.push_back(middle + QPointF(wide * std::cos(turn), -high * std::sin(turn)));
        return way;
    }
    [[nodiscard]] static Pixels line(const QPointF& from, const QPointF& to)
    {
        Pixels way;
        for (int i = 0; i <= 20; ++i)
            way.push_back(from + (to - from) * (i / 20.0));
        return way;
    }
    template <class Dialog> QImage pictureOfDialog()
    {
        auto* found = window().findChild<Dialog*>();
        if (!found)
            qFatal("no dialog");
        static_cast<void>(QTest::qWaitForWindowExposed(found));
        // What a preview would come to stands in brackets.
        if (const auto* size = found->template findChild<QLabel*>(QStringLiteral("reshapeNow")))
            static_cast<void>(wait([size] { return size->text().endsWith(u')'); }));
        QTest::qWait(restMs);
        const QImage picture = found->grab().toImage();
        found->close();
        return picture;
    }

private Q_SLOTS:
    void initTestCase() { wantPictures(); }
    void init() { test::failOnUnexpectedMessages(); }

    /// Six tools that carve or clip, each while it is in use.
    void sculptTools()
    {
        openForehead();
        const core::RowId whole = session().history().position();
        std::vector<QImage> panels;
        const auto keep = [&] { panels.push_back(test::middleOf(stage(), headSize)); };

        hand<ui::DrillTool>();
        Pixels way = line(at(-130.0, -60.0), at(10.0, -60.0));
        press(way);
        keep();
        release(way.back());

        hand<ui::LaserTool>();
        way = line(at(-110.0, 40.0), at(-40.0, 60.0));
        press(way);
        keep();
        release(way.back());
        rest();
        QVERIFY(session().goTo(whole));

        auto& peel = hand<ui::PeelTool>();
        way = around(at(-10.0, -30.0), 110.0, 75.0);
        press(way);
        release(way.back());
        QVERIFY(peel.isOpen());
        way = line(at(-70.0, -50.0), at(-70.0, -10.0));
        press(way, true);
        keep();
        release(way.back());
        rest();
        QVERIFY(session().goTo(whole));

        hand<ui::ScissorsTool>();
        way = around(at(-10.0, -30.0), 100.0, 70.0);
        press(way);
        keep();
        release(way.back());
        rest();
        QVERIFY(session().goTo(whole));

        hand<ui::CarveBrushTool>();
        way = line(at(-130.0, -80.0), at(20.0, -30.0));
        press(way);
        keep();
        release(way.back());
        rest();
        QVERIFY(session().goTo(whole));

        stage().flyTo({0.0, 0.0, 10.0}, {-0.6, -1.0, 0.45});
        ui::Camera camera = stage().camera();
        camera.heightMm = 560.0;
        stage().setCamera(camera);
        core::ClipRegion clip = workspace().clip();
        clip.box.on = true;
        clip.box.maximum.z = 135.0;
        workspace().setClip(clip);
        hand<ui::ClipTool>();
        rest();
        constexpr int top = 5;
        for (const ui::ClipHandle& handle :
            ui::clipHandles(stage().context(), clip, workspace().volume()->geometry)) {
            if (handle.face == top)
                Mouse::hover(stage(), handle.pixel);
        }
        rest();
        keep();
        QVERIFY(test::keepCollage(
            {{panels[0], panels[1], panels[2]}, {panels[3], panels[4], panels[5]}},
            "sculpt-tools.png"));
    }

    /// Seeds, a barrier, where growth stops at it, and what shrinking would take back.
    void growthTools()
    {
        openHead();
        apply(test::newSegment(QStringLiteral("Ventricles"), 0x4AA3FF));
        workspace().setActiveSegment(1);
        ui::SliceView& axial = axialAlone({-6.0, 8.0, z}, 0.24);
        constexpr QSize size(296, 330);
        std::vector<QImage> panels;
        const auto keep = [&] {
            QVERIFY(waitUntilDrawn());
            panels.push_back(test::middleOf(axial, size));
        };
        hand<ui::SeedTool>();
        const Way seeds{{-18.0, 19.0, z}, {-24.0, 21.0, z}, {-27.0, 26.0, z}};
        draw(axial, seeds);
        keep();
        lift(axial, seeds.back());
        rest();
        const core::RowId seeded = session().history().position();
        apply(test::growBetween(-20, 18, 100));
        Mouse::hover(axial, QPointF(5.0, 5.0));

        hand<ui::ShrinkTool>().setRest(600000);
        const Way back{{-12.0, -13.0, z}, {-5.0, -11.0, z}};
        draw(axial, back);
        rest();
        keep();
        window().findChild<ui::ShrinkTool*>()->cancel();
        lift(axial, back.back());
        QVERIFY(session().goTo(seeded));

        ui::Workspace::BrushSettings brush =
            workspace().brushSettings(ui::Workspace::Brush::Barrier);
        brush.radiusMm = 4.0;
        workspace().setBrushSettings(ui::Workspace::Brush::Barrier, brush);
        hand<ui::BarrierTool>();
        const Way across{{-31.0, 34.0, z}, {-12.0, 34.0, z}};
        draw(axial, across);
        keep();
        lift(axial, across.back());
        rest();
        apply(test::growBetween(-20, 18, 25));
        Mouse::hover(axial, QPointF(5.0, 5.0));
        rest();
        keep();
        QVERIFY(test::keepCollage({panels}, "growth-tools.png"));
    }

    /// Sketches in two segments, and who would get what lies between them.
    void growFromSeeds()
    {
        openHead(QStringLiteral("Growth"));
        apply(test::newSegment(QStringLiteral("Ventricles"), 0x4AA3FF));
        apply(test::newSegment(QStringLiteral("Brain"), 0xE6C84A));
        ui::SliceView& axial = axialAlone({0.0, 6.0, z}, 0.3);
        hand<ui::SeedTool>();
        const auto sketch = [&](int segment, const std::vector<Way>& strokes) {
            workspace().setActiveSegment(segment);
            for (const Way& stroke : strokes) {
                draw(axial, stroke);
                lift(axial, stroke.back());
                rest();
            }
        };
        sketch(1,
            {Way{{-7.9, -27.0, z}, {-8.0, -16.0, z}}, Way{{8.5, -27.0, z}, {8.6, -16.0, z}},
                Way{{-18.0, 23.0, z}, {-22.0, 34.0, z}}, Way{{20.0, 23.0, z}, {23.0, 34.0, z}}});
        sketch(2,
            {Way{{-29.0, -28.0, z}, {-31.0, 10.0, z}}, Way{{29.0, -28.0, z}, {31.0, 10.0, z}},
                Way{{-24.0, -42.0, z}, {-10.0, -45.0, z}}, Way{{10.0, -45.0, z}, {24.0, -42.0, z}},
                Way{{-36.0, 44.0, z}, {-26.0, 56.0, z}}, Way{{26.0, 56.0, z}, {36.0, 44.0, z}},
                Way{{0.0, -34.0, z}, {0.0, -12.0, z}}, Way{{-15.0, -24.0, z}, {-14.0, 8.0, z}},
                Way{{15.0, -24.0, z}, {14.0, 8.0, z}}, Way{{-9.0, 16.0, z}, {-12.0, 40.0, z}},
                Way{{9.0, 16.0, z}, {12.0, 40.0, z}}, Way{{-30.0, 20.0, z}, {-32.0, 38.0, z}},
                Way{{30.0, 20.0, z}, {32.0, 38.0, z}}});
        Mouse::hover(axial, QPointF(5.0, 5.0));
        rest();
        constexpr QSize size(330, 380);
        std::vector<QImage> panels{test::middleOf(axial, size)};
        auto* bar = window().findChild<ui::SpreadBar*>();
        QVERIFY(bar);
        bar->findChild<QToolButton*>(QStringLiteral("spreadFold"))->click();
        auto* preview = bar->findChild<QPushButton*>(QStringLiteral("spreadPreview"));
        QVERIFY(wait([preview] { return preview->isEnabled(); }));
        preview->click();
        QVERIFY(wait([this] {
            return session().isOpen<core::GrowFromSeeds>() && session().openHasBegun()
                && !session().growthProgress().running;
        }));
        drawn();
        panels.push_back(test::middleOf(axial, size));
        // Of the panel only what this is about.
        const QImage whole = pictureOf(QStringLiteral("Growth"));
        const QPoint corner = bar->mapTo(&section(QStringLiteral("Growth")), QPoint());
        panels.push_back(whole.copy(0, corner.y(), whole.width(), bar->height()));
        bar->cancel();
        QVERIFY(test::keepCollage({panels}, "grow-from-seeds.png"));
    }

    /// A stroke that is taken back at its place, while a later one stays.
    void revert()
    {
        openHead();
        apply(test::newSegment(QStringLiteral("Lesion"), 0xE07A5F));
        workspace().setActiveSegment(1);
        ui::SliceView& axial = axialAlone({0.0, 5.0, z}, 0.3);
        apply(test::paintDiscAt(1, {-18.0, -5.0, z}, {0.0, 0.0, 1.0}, 9.0));
        apply(test::paintDiscAt(1, {24.0, -8.0, z}, {0.0, 0.0, 1.0}, 10.0));
        apply(test::paintDiscAt(1, {6.0, 26.0, z}, {0.0, 0.0, 1.0}, 8.0));
        hand<ui::UndoHereTool>();
        hover(axial, {-18.0, -5.0, z});
        rest();
        constexpr QSize size(400, 300);
        std::vector<QImage> panels{test::middleOf(axial, size)};
        click(axial, {-18.0, -5.0, z});
        Mouse::hover(axial, QPointF(5.0, 5.0));
        rest();
        panels.push_back(test::middleOf(axial, size));
        foldAllBut({QStringLiteral("Segments"), QStringLiteral("History")});
        rest();
        panels.push_back(pictureOf(QStringLiteral("History")));
        QVERIFY(test::keepCollage({panels}, "revert.png"));
    }

    /// The skull cap, lifted and laid aside, with the panel.
    void pieces()
    {
        openHead(QStringLiteral("Pieces"));
        window().views().maximise(&stage());
        stage().lookFrom({-0.35, -1.0, 0.7});
        rest();
        apply(core::AddLayer{.name = QStringLiteral("Skull cap")});
        workspace().setActiveLayer(2);
        auto& peel = hand<ui::PeelTool>();
        peel.setDepthMm(11.0);
        const Pixels way = around(at(-10.0, -130.0), 150.0, 100.0);
        press(way);
        release(way.back());
        peel.confirm();
        rest();
        window().actionTable()[QStringLiteral("pieces.lift")].trigger();
        rest();
        QVERIFY(!session().document().pieces.empty());
        const int piece = session().document().pieces.front().id;
        apply(core::ChangePiece{.piece = piece,
            .offsetMm = glm::dvec3(95.0, 0.0, 0.0),
            .rotationDegrees = glm::dvec3(0.0, 35.0, 0.0)});
        hand<ui::PieceTool>();
        rest();
        QVERIFY(test::keepCollage(
            {{test::middleOf(stage(), QSize(664, 580)), pictureOf(QStringLiteral("Pieces"))}},
            "pieces.png"));
    }

    /// The same voxels, as acquired, linear and cubic.
    void interpolation()
    {
        openHead();
        ui::SliceView& axial = axialAlone({-20.0, 31.0, z}, 0.045);
        constexpr QSize size(400, 300);
        std::vector<QImage> panels;
        for (const gpu::Interpolation each :
            {gpu::Interpolation::Nearest, gpu::Interpolation::Linear, gpu::Interpolation::Cubic}) {
            ui::Workspace::ViewOptions options = workspace().viewOptions();
            options.interpolation = each;
            workspace().setViewOptions(options);
            rest();
            panels.push_back(test::middleOf(axial, size));
        }
        QVERIFY(test::keepCollage({panels}, "interpolation.png"));
    }

    /// With Ctrl a contour takes a part of the segment away.
    void contourErases()
    {
        openHead(QStringLiteral("Contour"));
        apply(test::newSegment(QStringLiteral("Ventricle"), 0x4AA3FF));
        workspace().setActiveSegment(1);
        apply(test::paintDiscAt(1, {-14.0, 30.0, z}, {0.0, 0.0, 1.0}, 18.0));
        auto& tool = hand<ui::ContourTool>();
        tool.setSettings({.bubbleMm = 3.0, .generations = 60});
        ui::SliceView& axial = axialAlone({-4.0, 31.0, z}, 0.2);
        QVERIFY(waitUntilDrawn());
        const QPointF where = axial.context().toPixel({-8.0, 33.0, z});
        Mouse::hover(axial, where, Qt::ControlModifier);
        QTest::qWait(restMs);
        constexpr QSize size(336, 360);
        std::vector<QImage> panels{test::middleOf(axial, size)};
        Mouse::click(axial, where, Qt::ControlModifier);
        QVERIFY(wait([&] {
            return tool.run().track() && !tool.run().isWorking() && !tool.run().isPlaying();
        }));
        tool.run().goTo(30);
        QVERIFY(wait([&] { return tool.run().isInSight(); }));
        hover(axial, {-17.0, 43.0, z});
        rest();
        panels.push_back(test::middleOf(axial, size));
        panels.push_back(pictureOf(QStringLiteral("Contour")));
        QVERIFY(test::keepCollage({panels}, "contour-erases.png"));
    }

    /// The dialogs for a whole segment that no other picture shows.
    void segmentDialogs()
    {
        openHead();
        apply(test::newSegment(QStringLiteral("Skull"), 0xE6C84A));
        workspace().setActiveSegment(1);
        apply(test::thresholdOf(1, 300.0));
        std::vector<QImage> dialogs;
        for (const core::ShapeOperation operation :
            {core::ShapeOperation::Gaussian, core::ShapeOperation::Hollow}) {
            workspace().askToReshape(1, operation);
            dialogs.push_back(pictureOfDialog<ui::ReshapeDialog>());
        }
        workspace().askToSplitIslands(1);
        const auto* now = window().findChild<QLabel*>(QStringLiteral("splitNow"));
        QVERIFY(wait([now] { return now->text().endsWith(u')'); }));
        dialogs.push_back(pictureOfDialog<ui::SplitIslandsDialog>());
        QVERIFY(test::keepCollage({dialogs}, "segment-dialogs.png"));
    }

    /// The window as it opens, with all its tools.
    void wholeWindow()
    {
        start();
        window().resize(1440, 900);
        m_application->openDemonstration();
        QVERIFY(wait([this] { return workspace().session() != nullptr; }));
        rest();
        QVERIFY(test::keepCollage({{window().grab().toImage()}}, "window.png"));
    }
};

BURIN_WINDOW_TEST(ToolPicturesUiTest)

} // namespace toolPicturesUiTest

#include "ToolPicturesUiTest.moc"
