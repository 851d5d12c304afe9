// SPDX-License-Identifier: Apache-2.0
#include "core/refine/deform/BoundaryForce.h"
#include "core/refine/fit/InitialFit.h"
#include "core/refine/mesh/SurfaceUpdate.h"
#include "tests/reenactment/Corruptor.h"
#include "tests/reenactment/SurfaceRobot.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/FigurePanels.h"
#include "tests/support/scenes/SculptStage.h"

#include <QTest>

#include <algorithm>
#include <cmath>

namespace refinementTableFiguresGlTest {

using namespace reenact;

namespace {

constexpr std::uint64_t buildingSeed = 1;
constexpr int vertices = 12'000;

core::VoxelRuns runsIn(const Mask& mask)
{
    return reenact::runsOf(mask);
}

/// The surface of a mask, red where it is more than a voxel and a half off the truth's.
core::SurfaceUpdate surfaceOf(
    const Mask& mask, const Mask& truth, const core::VolumeGeometry& geometry)
{
    core::SimplexMesh mesh = *core::initialFit(
        core::BoxMask::of(runsIn(mask), geometry.size), geometry, {.vertices = vertices}, {});
    const core::BoundaryForce border(
        core::BoxMask::of(runsIn(truth), geometry.size), geometry, 4.0);
    const glm::dvec3 spacing = geometry.spacingMm();
    const double offMm = 1.5 * std::min({spacing.x, spacing.y, spacing.z});
    core::SurfaceUpdate update = core::wholeUpdate(mesh);
    for (core::SurfaceUpdate::Vertex& vertex : update.vertices) {
        const auto apart = border.alongNormalMm(vertex.positionLps, vertex.normalLps);
        if (!apart || std::abs(*apart) > offMm)
            vertex.mark = core::SurfaceMark::Red;
    }
    return update;
}

} // namespace

/// The paper's figures 1 and 9 again (seed B): an organ's mask that is wrong in one place, and what
/// the robot of its table made of it with the tools of this program. Pictures of the manual, made
/// only where they are wanted: BURIN_SCREENSHOTS names the folder; resources/help/refine-*.png.
class RefinementTableFiguresGlTest : public QObject {
    Q_OBJECT

private:
    static void draw(const char* number, bool real, const glm::dvec3& from, const char* name)
    {
        const auto& rows = tableRows();
        const auto row = std::find_if(rows.begin(), rows.end(), [number](const TableRow& each) {
            return QLatin1String(each.number) == QLatin1String(number);
        });
        QVERIFY(row != rows.end());
        const std::optional<OrganScene> scene =
            real ? realOrgans(row->organ) : organPhantom(row->organ, 0.6);
        if (!scene)
            QSKIP("no shared data");
        const core::VolumeGeometry& geometry = scene->study.volume.geometry;
        const Mask organ = scene->maskOf(row->organ);
        const auto truth = Truth::of(organ, geometry, vertices);
        QVERIFY(truth);
        const Corrupted poor = corrupted(*scene, *row, real ? 0.7 : 0.6, buildingSeed);
        RefinementBench bench(scene->study, poor.mask);
        const RobotRun run =
            runSurfaceRobot(bench, *truth, {.error = 2.7}, {.vertices = vertices}, buildingSeed);
        qInfo("%s: %.1f %% before, %.2f %% after %d actions", row->text, poor.error,
            truth->errorOf(run.mask), run.actions);
        QVERIFY(truth->errorOf(run.mask) < 0.5 * poor.error);

        test::SculptStage stage(scene->study);
        QVERIFY(stage.isReady());
        glm::dvec3 low(1e9);
        glm::dvec3 high(-1e9);
        const core::SurfaceUpdate before = surfaceOf(poor.mask, organ, geometry);
        for (const core::SurfaceUpdate::Vertex& vertex : before.vertices) {
            low = glm::min(low, vertex.positionLps);
            high = glm::max(high, vertex.positionLps);
        }
        const glm::dvec3 middle = 0.5 * (low + high);
        gpu::VolumeScene view =
            test::sceneOf(test::viewFrom(from, middle, 0.85 * glm::length(high - low)));
        view.surfaceThreshold = 1e5; // no matter: the surface alone, before a plane of grey values
        view.surface = gpu::SceneSurface{};
        view.surface->colours.rgb = 0x7FA6D8;
        // What is not marked keeps the organ's colour.
        view.surface->colours.markRgb[std::size_t(core::SurfaceMark::Yellow)] = 0x7FA6D8;
        view.plane = gpu::ScenePlane{.centreLps = middle,
            .rightLps = {1.0, 0.0, 0.0},
            .downLps = {0.0, 0.0, -1.0},
            .halfSizeMm = 0.7 * glm::dvec2(high.x - low.x, high.z - low.z),
            .window = {.centre = 50.0, .width = 400.0}};
        std::vector<QImage> panels;
        const auto show = [&](const core::SurfaceUpdate& surface) {
            stage.show(surface);
            panels.push_back(stage.draw(view, {560, 460}));
        };
        show(before);
        show(surfaceOf(run.mask, organ, geometry));
        show(surfaceOf(organ, organ, geometry));
        QVERIFY(test::keepPanels(panels, name));
    }

private Q_SLOTS:
    void initTestCase()
    {
        if (!test::panelsWanted())
            QSKIP("BURIN_SCREENSHOTS names no folder for pictures");
    }
    void init() { test::failOnUnexpectedMessages(); }

    /// Figure 1: a liver whose end is missing.
    void liver() { draw("1b", true, {-0.35, -1.0, 0.3}, "refine-liver.png"); }
    /// Figure 9: a lung that leaked into the stomach.
    void lung() { draw("7", false, {0.35, -1.0, 0.2}, "refine-lung.png"); }
};

BURIN_TEST(RefinementTableFiguresGlTest)

} // namespace refinementTableFiguresGlTest

#include "RefinementTableFiguresGlTest.moc"
