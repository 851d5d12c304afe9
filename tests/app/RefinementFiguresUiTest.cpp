// SPDX-License-Identifier: Apache-2.0
#include "tests/support/FailingLog.h"
#include "tests/support/FigurePanels.h"
#include "tests/support/ManualWindow.h"
#include "ui/CuttingPlane.h"
#include "ui/Refinement.h"
#include "ui/views/ViewGrid.h"

#include <QPainter>
#include <QtTest>

namespace {

constexpr QSize panelSize(430, 400);
const glm::dvec3 leakBegins(40, -33, 42);
const glm::dvec3 leakEnds(50, -44, 44);

} // namespace

/// The paper's figures of refinement again (seed B, figures 6, 7 and 8), in the real window on a
/// lesion of the demonstration study. It takes a minute, so it only runs where somebody wants the
/// pictures: BURIN_SCREENSHOTS names the folder; resources/help/refine-*.png.
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
        ui::Workspace::ViewOptions options = workspace().viewOptions();
        options.showPatient = false;
        options.showCrosshair = false;
        workspace().setViewOptions(options);
        window().showPanels(false);
        window().views().arrange(ui::ViewGrid::Layout::PenAndStage);
        QVERIFY(plane().passThrough({10, 4, 46}, leakEnds, {28, -20, 90}));
        if (plane().pose().normalLps().y < 0.0)
            plane().flip();
        show({.shown = true, .opacity = 1.0f, .clipsAbove = true});
        lookAt({30, -24, 43}, glm::dvec3(0.45, 0.0, 0.35), 110.0);
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
        // Through the plane, which leaves only what lies below it.
        ui::CuttingPlane::Look below{.shown = true, .opacity = 1.0f, .clipsAbove = false};
        const auto keep = [&](gpu::SurfaceStyle style, bool clips, double opacity) {
            ui::Refinement::Look look = workspace().refinement().look();
            look.style = style;
            workspace().refinement().setLook(look);
            below.clipsAbove = clips;
            below.opacity = float(opacity);
            show(below);
            QVERIFY(waitUntilDrawn());
            panels.push_back(panel(stage));
        };
        // Only the lesion: no matter is as dense as that.
        ui::Workspace::VolumeDisplay display = workspace().volumeDisplay();
        display.surfaceThreshold = 2500.0;
        workspace().setVolumeDisplay(display);
        keep(gpu::SurfaceStyle::Shaded, false, 1.0);
        keep(gpu::SurfaceStyle::GreyValues, false, 1.0);
        keep(gpu::SurfaceStyle::Wireframe, false, 1.0);
        keep(gpu::SurfaceStyle::Shaded, true, 1.0);
        panels.push_back(panel(window().views().plane(), 2.2));
        QVERIFY(test::keepPanels(panels, "refine-modes.png"));
    }
};

QTEST_MAIN(RefinementFiguresUiTest)
#include "RefinementFiguresUiTest.moc"
