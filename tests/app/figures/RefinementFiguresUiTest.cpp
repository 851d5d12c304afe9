// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/segments/CleanSegment.h"
#include "core/edits/kinds/segments/ReshapeSegment.h"
#include "core/edits/kinds/surface/AttractSurface.h"
#include "core/edits/kinds/surface/LaySurface.h"
#include "core/edits/kinds/surface/MarkSurface.h"
#include "core/edits/kinds/surface/PlaneScrape.h"
#include "core/edits/kinds/surface/SmoothSurface.h"
#include "core/edits/kinds/surface/WriteBack.h"
#include "core/edits/kinds/values/ThresholdSegment.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/fixtures/pictures/ManualWindow.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/FigurePanels.h"
#include "tests/support/scenes/PlainEdits.h"
#include "ui/tools/refine/RefineTool.h"
#include "ui/views/SliceView.h"
#include "ui/views/ViewGrid.h"
#include "ui/views/VolumeView.h"
#include "ui/workspace/CuttingPlane.h"
#include "ui/workspace/Refinement.h"

#include <QPainter>
#include <QtTest>

#include <cmath>

namespace refinementFiguresUiTest {

namespace {

constexpr QSize panelSize(430, 400);
const glm::dvec3 leakBegins(40, -33, 42);
const glm::dvec3 leakEnds(50, -44, 44);

} // namespace

/// The paper's figures of refinement again (seed B, figures 6, 7 and 8), in the real window on a
/// lesion of the demonstration study, and of the tools that none of them shows. It takes a minute,
/// so it only runs where somebody wants the pictures: BURIN_SCREENSHOTS names the folder;
/// resources/help/refine-*.png.
class RefinementFiguresUiTest : public QObject, private test::ManualWindow {
    Q_OBJECT

private:
    [[nodiscard]] ui::CuttingPlane& plane() { return workspace().plane(); }
    /// Of a view as it is on the screen, without what stands in its corners.
    [[nodiscard]] QImage panel(ui::ImageView& view, double zoom = 1.0)
    {
        const QImage seen = view.grab().toImage();
        const QSize part = panelSize / zoom;
        const QPoint corner((seen.width() - part.width()) / 2, (seen.height() - part.height()) / 2);
        return seen.copy(QRect(corner, part))
            .scaled(panelSize, Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
    }
    /// Lesion and plane alone: pen and stage, nothing written over the pictures.
    void prepare()
    {
        openLesion();
        showPicturesOnly();
        window().views().arrange(ui::ViewGrid::Layout::PenAndStage);
        QVERIFY(plane().passThrough({10, 4, 46}, leakEnds, {28, -20, 90}));
        if (plane().pose().normalLps().y < 0.0)
            plane().flip();
        show({.shown = true, .opacity = 1.0f, .clipsAbove = true});
        lookAt({30, -24, 43}, glm::dvec3(0.45, 0.0, 0.35), 110.0);
    }
    /// Nothing written over them, no panels, and in the 3D view the surface alone.
    void showPicturesOnly()
    {
        ui::Workspace::ViewOptions options = workspace().viewOptions();
        options.showPatient = false;
        options.showCrosshair = false;
        workspace().setViewOptions(options);
        window().showPanels(false);
        // No matter is as dense as that.
        ui::Workspace::VolumeDisplay display = workspace().volumeDisplay();
        display.surfaceThreshold = 2500.0;
        workspace().setVolumeDisplay(display);
    }
    /// The right lateral ventricle, as ragged as a threshold gives it in noise.
    void openVentricle()
    {
        start();
        m_application->openDemonstration();
        QVERIFY(wait([this] { return workspace().session() != nullptr; }));
        QVERIFY(waitUntilDrawn());
        showPicturesOnly();
        ui::Workspace::ViewOptions options = workspace().viewOptions();
        options.showSegments = false;
        workspace().setViewOptions(options);
        apply(test::newSegment(QStringLiteral("Ventricle"), 0x4AA3FF));
        workspace().setActiveSegment(1);
        apply(core::ThresholdSegment{.segment = 1,
            .lower = -20.0,
            .upper = 18.0,
            .box = core::GrowBox{.fromLps = {-31.0, -38.0, 6.0}, .toLps = {-2.5, 63.0, 38.0}}});
        apply(core::CleanSegment{.segment = 1, .rule = core::IslandRule::FillHoles});
        const glm::dvec3 frontHorn(-7.9, -20.7, 20.5);
        apply(core::CleanSegment{
            .segment = 1, .rule = core::IslandRule::KeepClicked, .islandLps = frontHorn});
    }
    void show(const ui::CuttingPlane::Look& look) { plane().setLook(look); }
    void lookAt(const glm::dvec3& placeLps, const glm::dvec3& besideNormal, double heightMm)
    {
        ui::VolumeView& stage = window().views().volume();
        stage.flyTo(placeLps, glm::normalize(besideNormal - plane().pose().normalLps()));
        ui::Camera camera = stage.camera();
        camera.heightMm = heightMm;
        stage.setCamera(camera);
        window().views().plane().setPlace({.centreLps = placeLps, .mmPerPixel = heightMm / 620.0});
    }

private Q_SLOTS:
    void initTestCase() { wantPictures(); }
    void init() { test::failOnUnexpectedMessages(); }

    /// Figure 8: as a coloured surface, with the volume's grey values, as a wireframe, cut away
    /// above the plane, which shows the mask as a tint and the surface as a contour.
    void renderingModes()
    {
        prepare();
        std::vector<QImage> panels;
        ui::VolumeView& stage = window().views().volume();
        apply(core::MarkSurface{.mark = core::SurfaceMark::Red,
            .path = {.radiusMm = 11.0, .pointsLps = {leakBegins, leakEnds}}});
        const auto keep = [&](gpu::SurfaceStyle style, bool showsMarks, bool clips) {
            ui::Refinement::Look look = workspace().refinement().look();
            look.style = style;
            look.showMarks = showsMarks;
            workspace().refinement().setLook(look);
            show({.shown = true, .opacity = 1.0f, .clipsAbove = clips});
            ui::Workspace::ViewOptions options = workspace().viewOptions();
            options.showSegments = clips;
            workspace().setViewOptions(options);
            QVERIFY(waitUntilDrawn());
            panels.push_back(panel(stage));
        };
        keep(gpu::SurfaceStyle::Shaded, true, false);
        keep(gpu::SurfaceStyle::GreyValues, false, false);
        keep(gpu::SurfaceStyle::Wireframe, true, false);
        keep(gpu::SurfaceStyle::Shaded, true, true);
        panels.push_back(panel(window().views().plane(), 2.2));
        QVERIFY(test::keepPanels(panels, "refine-modes.png"));
    }

    /// Figure 6: a leak is looked at on the plane, marked red, scraped off in two strokes, and
    /// looked at again.
    void planeTool()
    {
        prepare();
        std::vector<QImage> panels;
        ui::VolumeView& stage = window().views().volume();
        const auto keep = [&](bool clips) {
            show({.shown = true, .opacity = 1.0f, .clipsAbove = clips});
            QVERIFY(waitUntilDrawn());
            panels.push_back(panel(stage));
        };
        keep(true);
        ui::Workspace::ViewOptions options = workspace().viewOptions();
        options.showSegments = false;
        workspace().setViewOptions(options);
        apply(core::MarkSurface{.mark = core::SurfaceMark::Red,
            .path = {.radiusMm = 11.0, .pointsLps = {leakBegins, leakEnds}}});
        keep(false);
        const glm::dvec3 outwards = glm::normalize(leakEnds - leakBegins);
        const auto scrape = [&](double alongMm) {
            apply(core::PlaneScrape{
                .path = {.radiusMm = 13.0, .pointsLps = {leakBegins + alongMm * outwards}},
                .normalLps = outwards});
        };
        scrape(7.0);
        keep(false);
        scrape(-3.0);
        keep(false);
        apply(core::WriteBack{});
        options.showSegments = true;
        workspace().setViewOptions(options);
        keep(true);
        QVERIFY(test::keepPanels(panels, "refine-scrape.png"));
    }

    /// Figure 7: contours of a lobe that is missing, three sagittal ones that end at the sound
    /// surface and three axial ones that are closed; what they make of the red region; the result
    /// on the plane.
    void templateShape()
    {
        prepare();
        const glm::dvec3 top(8, 2, 76);
        // Sagittal, through the middle of the lobe.
        QVERIFY(plane().passThrough(top, top - glm::dvec3(0, 0, 50), top - glm::dvec3(0, 20, 20)));
        if (plane().pose().normalLps().x < 0.0)
            plane().flip();
        lookAt({8, 2, 58}, glm::dvec3(0.0, -0.35, 0.45), 80.0);
        std::vector<QImage> panels;
        ui::VolumeView& stage = window().views().volume();
        ui::Workspace::ViewOptions options = workspace().viewOptions();
        options.showSegments = false;
        workspace().setViewOptions(options);
        // Around it all is right.
        for (const auto& [mark, radiusMm] :
            {std::pair(core::SurfaceMark::Green, 30.0), std::pair(core::SurfaceMark::Red, 17.0)})
            apply(core::MarkSurface{.mark = mark,
                .path = {.radiusMm = radiusMm,
                    .pointsLps = {{8, 2, 66}},
                    .rules = core::newestSurfaceRules}});
        ui::Refinement& refinement = workspace().refinement();
        refinement.setSettings({.mode = ui::Refinement::Mode::Template, .radiusMm = 11.0});
        take<ui::RefineTool>();
        // The lobe falls off by this much per square of the distance from its axis.
        constexpr double steepPerMm = 0.074;
        constexpr double reachMm = 14.4;
        const auto sagittal = [&](double offMm) {
            std::vector<glm::dvec3> line;
            const double halfMm = std::sqrt(reachMm * reachMm - offMm * offMm);
            for (int i = -8; i <= 8; ++i) {
                const double alongMm = halfMm * i / 8.0;
                const double fallMm = steepPerMm * (alongMm * alongMm + offMm * offMm);
                line.push_back(top + glm::dvec3(offMm, alongMm, -fallMm));
            }
            return line;
        };
        const auto axial = [&](double fallMm) {
            std::vector<glm::dvec3> line;
            const double radiusMm = std::sqrt(fallMm / steepPerMm);
            for (int i = 0; i <= 36; ++i) {
                const double turn = (i % 36) * M_PI / 18.0;
                line.push_back(top
                    + glm::dvec3(radiusMm * std::cos(turn), radiusMm * std::sin(turn), -fallMm));
            }
            return line;
        };
        refinement.addContour(sagittal(0.0));
        show({.shown = true, .opacity = 1.0f, .clipsAbove = false});
        QVERIFY(waitUntilDrawn());
        panels.push_back(panel(window().views().plane()));
        for (const double offMm : {-7.0, 7.0})
            refinement.addContour(sagittal(offMm));
        for (const double fallMm : {3.0, 6.5, 10.0})
            refinement.addContour(axial(fallMm));
        QVERIFY(waitUntilDrawn());
        panels.push_back(panel(stage));
        QSignalSpy moved(&refinement, &ui::Refinement::changed);
        refinement.previewTemplate();
        // A preview stays open and tells nobody that it is done: until it has come to rest.
        while (moved.wait(2000)) { }
        QVERIFY(wait([this] { return window().views().refined(); }));
        panels.push_back(panel(stage));
        refinement.takeTemplate();
        QVERIFY(waitUntilDrawn());
        panels.push_back(panel(window().views().plane()));
        QVERIFY(test::keepPanels(panels, "refine-template.png"));
    }

    /// A ragged surface, and what Smooth makes of its near half; on a slice a surface that lies
    /// too far out, and what Attract makes of it.
    void smoothAndAttract()
    {
        openVentricle();
        apply(
            core::CleanSegment{.segment = 1, .rule = core::IslandRule::RemoveSmall, .mm3 = 300.0});
        apply(core::CleanSegment{.segment = 1, .rule = core::IslandRule::FillHoles});
        const core::RowId ragged = session().history().position();
        std::vector<QImage> panels;
        ui::VolumeView& stage = window().views().volume();
        window().views().maximise(&stage);
        stage.flyTo({-13.0, 4.0, 22.0}, {-0.7, -0.8, 0.9});
        ui::Camera camera = stage.camera();
        camera.heightMm = 130.0;
        stage.setCamera(camera);
        const core::LaySurface lay{.segment = 1, .vertices = 6000};
        apply(lay);
        panels.push_back(panel(stage));
        apply(core::SmoothSurface{.path = {.radiusMm = 12.0,
                                      .pointsLps = {{-8, -30, 17}, {-8, -10, 25}, {-11, 6, 27}},
                                      .rules = core::newestSurfaceRules}});
        panels.push_back(panel(stage));

        QVERIFY(session().goTo(ragged));
        apply(core::ReshapeSegment{
            .segment = 1, .operation = core::ShapeOperation::Median, .mm = 2.0});
        apply(
            core::ReshapeSegment{.segment = 1, .operation = core::ShapeOperation::Grow, .mm = 2.0});
        apply(lay);
        const double z = 20.0;
        const glm::dvec3 frontHorn(-8.0, -21.0, z);
        ui::SliceView& axial = window().views().axial();
        window().views().maximise(&axial);
        workspace().setCrosshairLps(frontHorn);
        QCoreApplication::processEvents();
        axial.setPlace({.centreLps = frontHorn, .mmPerPixel = 0.1});
        constexpr double radiusMm = 8.0;
        workspace().refinement().setSettings(
            {.mode = ui::Refinement::Mode::Attract, .radiusMm = radiusMm});
        take<ui::RefineTool>();
        QVERIFY(waitUntilDrawn());
        QTest::mouseMove(&axial, axial.context().toPixel({-14.0, -24.0, z}).toPoint());
        QVERIFY(waitUntilDrawn());
        panels.push_back(panel(axial));
        apply(core::AttractSurface{
            .path = {.radiusMm = radiusMm,
                .pointsLps = {{-14.0, -24.0, z}, {-8.0, -34.0, z}, {-8.0, -8.0, z}},
                .rules = core::newestSurfaceRules}});
        panels.push_back(panel(axial));
        QVERIFY(test::keepPanels(panels, "refine-attract.png"));
    }
};

BURIN_WINDOW_TEST(RefinementFiguresUiTest)

} // namespace refinementFiguresUiTest

#include "RefinementFiguresUiTest.moc"
