// SPDX-License-Identifier: Apache-2.0
#include "core/refine/tools/SurfaceStroke.h"
#include "core/refine/deform/BoundaryForce.h"
#include "core/refine/mesh/SimplexDual.h"
#include "core/refine/mesh/SurfaceDelta.h"
#include "core/refine/repair/MeshRestructuring.h"
#include "core/refine/repair/SelfIntersections.h"
#include "core/refine/tools/MarkPaint.h"
#include "core/refine/voxels/GreyBox.h"
#include "tests/support/program/LongRun.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/ShapedMask.h"
#include "tests/support/scenes/SimplexShapes.h"

#include <QElapsedTimer>
#include <QTest>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <random>

namespace surfaceStrokeTest {

namespace {

using Where = std::function<bool(const glm::dvec3&)>;

void markWhere(core::SimplexMesh& mesh, core::SurfaceMark mark, const Where& where)
{
    core::SimplexMeshEdit edit(mesh);
    for (const core::VertexId id : mesh.vertexIds()) {
        if (where(mesh.position(id)))
            edit.setMark(id, mark);
    }
    edit.commit();
}

bool everywhere(const glm::dvec3& /*at*/)
{
    return true;
}

/// A ball of radius 20 around the origin, red.
core::SimplexMesh redBall(int cuts = 4)
{
    core::SimplexMesh mesh = test::simplexSphere(20.0, cuts);
    markWhere(mesh, core::SurfaceMark::Red, everywhere);
    return mesh;
}

core::SimplexMeshDelta stroke(core::SimplexMesh& mesh, const core::SurfaceTool& tool,
    const std::vector<core::SurfaceSample>& samples,
    const core::SurfaceStrokeSettings& settings = {}, const core::BoundaryForce* boundary = nullptr)
{
    core::SurfaceStroke made(mesh, boundary, tool, settings);
    for (const core::SurfaceSample& sample : samples)
        made.add(sample);
    made.settle();
    return made.commit();
}

/// Least distance of a vertex from a place.
double nearestMm(const core::SimplexMesh& mesh, const glm::dvec3& place)
{
    double least = 1e9;
    for (const core::VertexId id : mesh.vertexIds())
        least = std::min(least, glm::distance(mesh.position(id), place));
    return least;
}

double edgeMm(const core::SimplexMesh& mesh)
{
    return 0.62 * std::sqrt(core::meanFaceAreaMm2(mesh));
}

} // namespace

/// Tools on a surface, from pen down to pen up.
class SurfaceStrokeTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void aSpherePushesInwards();
    void aSpherePushesOutwards();
    void aFastStrokeLeavesNothingBehind();
    void aPlaneTakesOffWhatLiesBeyond();
    void aScrapedWayIsLevel();
    void aDraggedVertexIsWhereItWasPut();
    void aDraggedVertexCanBeDraggedAgain();
    void oneThatIsGoneIsDraggedHarder_data();
    void oneThatIsGoneIsDraggedHarder();
    void smoothingEvensAndKeepsTheVolume();
    void edgesAttract();
    void edgesAttractThroughNoise();
    void attractionReachesNoFartherThanItLooks();
    void paintedYellowGoesBackToTheMask();
    void yellowGoesBackRedStays();
    void aRolledBackStrokeLeavesNothing();
    void stormsKeepTheSurfaceWhole_data();
    void stormsKeepTheSurfaceWhole();
    void theSameForAnyNumberOfThreads();
    void stepsAreQuick();
};

void SurfaceStrokeTest::aSpherePushesInwards()
{
    core::SimplexMesh mesh = redBall();
    const core::SimplexMesh before = mesh;
    const glm::dvec3 centre(23.0, 0.0, 0.0);
    const auto delta = stroke(mesh, core::SphereTool{.radiusMm = 8.0}, {{.placeLps = centre}});
    QCOMPARE(test::eulerCharacteristics(mesh), std::vector<int>{2});
    qInfo("nearest %.9f of 8; %zu vertices, %zu before, %zu changed", nearestMm(mesh, centre),
        mesh.vertexCount(), before.vertexCount(), delta.vertices.size());
    QVERIFY(nearestMm(mesh, centre) >= 8.0 - 1e-6);
    // A dent: the lens that the two balls share is gone, and nothing else.
    const double d = 23.0, r = 8.0, R = 20.0;
    const double lens = M_PI * (R + r - d) * (R + r - d)
        * (d * d + 2 * d * r - 3 * r * r + 2 * d * R + 6 * r * R - 3 * R * R) / (12 * d);
    const double lost = core::enclosedMm3(before) - core::enclosedMm3(mesh);
    qInfo("lost %.2f of %.2f mm3", lost, lens);
    QVERIFY(std::abs(lost / lens - 1.0) < 0.08);
}

void SurfaceStrokeTest::aSpherePushesOutwards()
{
    core::SimplexMesh mesh = redBall();
    const core::SimplexMesh before = mesh;
    const glm::dvec3 centre(18.0, 0.0, 0.0);
    stroke(mesh, core::SphereTool{.radiusMm = 8.0}, {{.placeLps = centre}});
    QCOMPARE(test::eulerCharacteristics(mesh), std::vector<int>{2});
    const double d = 18.0, r = 8.0, R = 20.0;
    const double lens = M_PI * (R + r - d) * (R + r - d)
        * (d * d + 2 * d * r - 3 * r * r + 2 * d * R + 6 * r * R - 3 * R * R) / (12 * d);
    const double wanted = 4.0 / 3.0 * M_PI * r * r * r - lens;
    const double gained = core::enclosedMm3(mesh) - core::enclosedMm3(before);
    double tip = 0.0;
    for (const core::VertexId id : mesh.vertexIds())
        tip = std::max(tip, mesh.position(id).x);
    qInfo("nearest %.9f of 8, tip %.3f of 26, gained %.1f of %.1f, %zu vertices",
        nearestMm(mesh, centre), tip, gained, wanted, mesh.vertexCount());
    QVERIFY(nearestMm(mesh, centre) >= 8.0 - 1e-6);
    QVERIFY(tip > 26.0 - 0.2);
    QVERIFY(std::abs(gained / wanted - 1.0) < 0.1);
}

void SurfaceStrokeTest::aFastStrokeLeavesNothingBehind()
{
    // The same way in one go and in many: nothing is left within the sphere anywhere.
    for (const int count : {1, 30}) {
        core::SimplexMesh mesh = redBall();
        std::vector<core::SurfaceSample> samples;
        for (int i = 0; i <= count; ++i)
            samples.push_back({.placeLps = {14.0 + 20.0 * i / count, 0.0, 0.0}});
        core::SurfaceStroke made(mesh, nullptr, core::SphereTool{.radiusMm = 5.0}, {});
        for (const auto& sample : samples)
            made.add(sample);
        made.settle();
        const int steps = made.steps();
        made.commit();
        QCOMPARE(test::eulerCharacteristics(mesh), std::vector<int>{2});
        double tip = 0.0;
        double deepest = 5.0;
        for (const core::VertexId id : mesh.vertexIds()) {
            const glm::dvec3 at = mesh.position(id);
            tip = std::max(tip, at.x);
            const double x = std::clamp(at.x, 14.0, 34.0);
            deepest = std::min(deepest, glm::distance(at, glm::dvec3(x, 0, 0)));
        }
        qInfo("%d samples: tip %.3f of 39, nearest to the way %.3f of 5, %zu vertices, %d steps",
            count + 1, tip, deepest, mesh.vertexCount(), steps);
        QVERIFY(tip > 39.0 - 0.2);
        QVERIFY(nearestMm(mesh, {34, 0, 0}) >= 5.0 - 1e-6);
        QVERIFY(deepest > 5.0 - 0.25 * edgeMm(mesh));
    }
}

void SurfaceStrokeTest::aPlaneTakesOffWhatLiesBeyond()
{
    const glm::dvec3 normal = glm::normalize(glm::dvec3(1.0, 2.0, 0.5));
    core::SimplexMesh mesh = redBall();
    const core::SimplexMesh before = mesh;
    const glm::dvec3 place = 15.0 * normal;
    const core::PlaneTool tool{.normalLps = 3.0 * normal, .radiusMm = 16.0, .heightMm = 10.0};
    stroke(mesh, tool, {{.placeLps = place}});
    QCOMPARE(test::eulerCharacteristics(mesh), std::vector<int>{2});
    double highest = -1e9;
    int on = 0;
    int between = 0;
    for (const core::VertexId id : mesh.vertexIds()) {
        const glm::dvec3 from = mesh.position(id) - place;
        const double height = glm::dot(from, normal);
        highest = std::max(highest, height);
        const double aside = std::sqrt(std::max(0.0, glm::dot(from, from) - height * height));
        on += std::abs(height) <= 1e-9 ? 1 : 0;
        // The cut is a disc of radius 13.2.
        if (aside < 13.2 - 1.5 * edgeMm(mesh) && height > -10.0)
            between += std::abs(height) <= 1e-9 ? 0 : 1;
    }
    const double cap = M_PI * 25.0 * (3.0 * 20.0 - 5.0) / 3.0;
    const double lost = core::enclosedMm3(before) - core::enclosedMm3(mesh);
    qInfo("highest %.3g, %d on it, %d not, lost %.1f of %.1f", highest, on, between, lost, cap);
    QVERIFY(highest <= 1e-9);
    QVERIFY(on > 100);
    QCOMPARE(between, 0);
    QVERIFY(std::abs(lost / cap - 1.0) < 0.06);
}

/// Along a way over a bulge, with the plane turning with the way: what the cylinder passed is level
/// and nothing is drawn below.
void SurfaceStrokeTest::aScrapedWayIsLevel()
{
    core::SimplexMesh mesh = redBall();
    stroke(mesh, core::PlaneTool{.normalLps = {0, 0, 1}, .radiusMm = 4.0, .heightMm = 20.0},
        {{.placeLps = {-25, 0, 16}}, {.placeLps = {25, 0, 16}}});
    QCOMPARE(test::eulerCharacteristics(mesh), std::vector<int>{2});
    const double edge = edgeMm(mesh);
    int on = 0;
    for (const core::VertexId id : mesh.vertexIds()) {
        const glm::dvec3 at = mesh.position(id);
        // What lies beside the way may be drawn into it by less than an edge.
        if (std::abs(at.y) < 4.0 - 0.5 * edge) {
            QVERIFY2(at.z <= 16.0 + 1e-9, qPrintable(QString::number(at.z - 16.0)));
            if (std::abs(at.y) < 4.0 - edge && at.z > 0.0 && std::abs(at.x) < 12.0 - 1.5 * edge) {
                QVERIFY2(std::abs(at.z - 16.0) <= 1e-9, qPrintable(QString::number(at.z - 16.0)));
                ++on;
            }
        }
    }
    QVERIFY(on > 50);
}

void SurfaceStrokeTest::aDraggedVertexIsWhereItWasPut()
{
    for (const double far : {3.0, 15.0}) {
        core::SimplexMesh mesh = redBall();
        const core::SimplexMesh before = mesh;
        const glm::dvec3 from = mesh.position(100);
        const glm::dvec3 to = from + far * glm::normalize(from);
        stroke(mesh, core::DragTool{.radiusMm = 9.0}, {{.placeLps = from}, {.placeLps = to}});
        QCOMPARE(test::eulerCharacteristics(mesh), std::vector<int>{2});
        int green = 0;
        for (const core::VertexId id : mesh.vertexIds()) {
            if (mesh.mark(id) != core::SurfaceMark::Green)
                continue;
            ++green;
            QCOMPARE(mesh.position(id), to);
        }
        QCOMPARE(green, 1);
        // Like a sheet of rubber: vertices that were there before went their share of the way.
        int moved = 0;
        double worst = 0.0;
        for (core::VertexId id = 0; id < before.vertexSlots(); ++id) {
            const double distance = glm::distance(before.position(id), from);
            if (!mesh.hasVertex(id) || glm::distance(mesh.position(id), before.position(id)) < 1e-9)
                continue;
            if (distance > 9.0 + 2.0 * edgeMm(before)) {
                // Restructuring may have given the number to a new vertex.
                continue;
            }
            const double near = std::max(0.0, 1.0 - distance * distance / 81.0);
            const glm::dvec3 wanted = before.position(id) + near * near * (to - from);
            worst = std::max(worst, glm::distance(mesh.position(id), wanted));
            ++moved;
        }
        qInfo("dragged %.0f: %d moved, worst %.3f off, %zu of %zu vertices", far, moved, worst,
            mesh.vertexCount(), before.vertexCount());
        QVERIFY(moved > 50);
        if (far < 5.0)
            QVERIFY(worst < edgeMm(before));
    }
}

void SurfaceStrokeTest::oneThatIsGoneIsDraggedHarder_data()
{
    QTest::addColumn<bool>("isGuarded");
    QTest::newRow("of any surface") << false;
    QTest::newRow("that may not cross itself") << true;
}

/// Restructuring may take the dragged vertex away between two samples of the pen, of which the
/// second presses harder.
void SurfaceStrokeTest::oneThatIsGoneIsDraggedHarder()
{
    QFETCH(bool, isGuarded);
    core::VolumeGeometry geometry{.size = glm::ivec3(60), .slicePositions = {}};
    geometry.indexToWorld[3] = glm::dvec4(-30, -30, -30, 1);
    for (int i = 0; i < 40; ++i) {
        core::SimplexMesh mesh = redBall(3);
        auto random = test::Random(unsigned(i));
        const glm::dvec3 from =
            mesh.position(core::VertexId(test::randomInt(random, 0, int(mesh.vertexCount()) - 1)));
        std::vector<core::SurfaceSample> samples;
        for (int k = 0; k < 12; ++k)
            samples.push_back({.placeLps = from * (k % 2 == 0 ? 1.0 : 0.4 + 0.03 * k),
                .pressure = 0.3 + 0.05 * k});
        stroke(mesh, core::DragTool{.radiusMm = 6.0}, samples,
            {.areaMm2 = 4.0 * core::meanFaceAreaMm2(mesh),
                .apartOn = isGuarded ? &geometry : nullptr});
        QCOMPARE(test::eulerCharacteristics(mesh), std::vector<int>{2});
        if (isGuarded)
            QCOMPARE(core::selfIntersections(mesh, geometry).size(), std::size_t(0));
    }
}

void SurfaceStrokeTest::aDraggedVertexCanBeDraggedAgain()
{
    core::SimplexMesh mesh = redBall();
    const glm::dvec3 from = mesh.position(100);
    stroke(mesh, core::DragTool{.radiusMm = 8.0}, {{.placeLps = from}, {.placeLps = 1.1 * from}});
    const core::VertexId green =
        core::nearestVertex(mesh, 1.1 * from, [](core::VertexId) { return true; });
    QCOMPARE(mesh.mark(green), core::SurfaceMark::Green);
    // Not by itself …
    core::SimplexMesh other = mesh;
    stroke(other, core::DragTool{.radiusMm = 8.0},
        {{.placeLps = 1.1 * from}, {.placeLps = 1.2 * from}});
    QVERIFY(core::identical(other.vertex(green), mesh.vertex(green)));
    // … but if it is asked for.
    stroke(mesh, core::DragTool{.radiusMm = 8.0, .again = green}, {{.placeLps = 1.2 * from}});
    const core::VertexId now =
        core::nearestVertex(mesh, 1.2 * from, [](core::VertexId) { return true; });
    QCOMPARE(mesh.position(now), 1.2 * from);
    QCOMPARE(mesh.mark(now), core::SurfaceMark::Green);
    QCOMPARE(test::eulerCharacteristics(mesh), std::vector<int>{2});
}

void SurfaceStrokeTest::smoothingEvensAndKeepsTheVolume()
{
    auto random = test::Random(7);
    core::SimplexMesh mesh = redBall();
    {
        core::SimplexMeshEdit edit(mesh);
        for (const core::VertexId id : mesh.vertexIds()) {
            if (mesh.position(id).x > 10.0)
                edit.move(id, (1.0 + 0.03 * (test::randomUnit(random) - 0.5)) * mesh.position(id));
        }
        edit.commit();
    }
    const auto roughness = [](const core::SimplexMesh& of) {
        double sum = 0.0;
        int count = 0;
        for (const core::VertexId id : of.vertexIds()) {
            if (of.position(id).x < 14.0)
                continue;
            const double off = glm::length(of.position(id)) - 20.0;
            sum += off * off;
            ++count;
        }
        return std::sqrt(sum / count);
    };
    const double before = roughness(mesh);
    const double volume = core::enclosedMm3(mesh);
    std::vector<core::SurfaceSample> samples(8, {.placeLps = {20.0, 0.0, 0.0}});
    stroke(mesh, core::SmoothTool{.radiusMm = 18.0}, samples);
    const double after = roughness(mesh);
    qInfo("roughness %.4f → %.4f mm, volume %.4f %%", before, after,
        100.0 * (core::enclosedMm3(mesh) / volume - 1.0));
    QVERIFY(after < 0.4 * before);
    QVERIFY(std::abs(core::enclosedMm3(mesh) / volume - 1.0) < 0.002);
    QCOMPARE(test::eulerCharacteristics(mesh), std::vector<int>{2});
}

void SurfaceStrokeTest::edgesAttract()
{
    // Grey values that fall off at a radius of 22 from the middle.
    test::ShapedMask made({61, 61, 61});
    made.geometry.indexToWorld[3] = glm::dvec4(-30, -30, -30, 1);
    std::vector<std::uint16_t> codes;
    for (int z = 0; z < 61; ++z) {
        for (int y = 0; y < 61; ++y) {
            for (int x = 0; x < 61; ++x) {
                const double off = 22.0 - glm::distance(glm::dvec3(x, y, z), glm::dvec3(30));
                codes.push_back(
                    std::uint16_t(std::lround(500.0 + 400.0 * off / std::sqrt(1.0 + off * off))));
            }
        }
    }
    const core::GreyBox grey(made.geometry, glm::ivec3(0), glm::ivec3(61), codes);
    QCOMPARE(grey.at({0, 0, 0}), 900.0);
    QCOMPARE(grey.at({22, 0, 0}), 500.0);
    QCOMPARE(grey.at({22.5, 0, 0}), 0.5 * (500.0 + 217.0));
    QVERIFY(std::abs(*grey.profileAlong({20, 0, 0}, {1, 0, 0}, 5.0).edgeMm() - 2.0) < 0.25);
    QVERIFY(std::abs(*grey.profileAlong({24, 0, 0}, {1, 0, 0}, 5.0).edgeMm() + 2.0) < 0.25);
    QVERIFY(!grey.profileAlong({100, 0, 0}, {1, 0, 0}, 5.0).edgeMm());
    core::SimplexMesh mesh = redBall();
    stroke(mesh, core::AttractTool{.radiusMm = 12.0, .reachMm = 5.0, .grey = &grey},
        {{.placeLps = {20, 0, 0}}});
    double worst = 0.0;
    for (const core::VertexId id : mesh.vertexIds()) {
        if (glm::distance(mesh.position(id), glm::dvec3(22, 0, 0)) < 9.0)
            worst = std::max(worst, std::abs(glm::length(mesh.position(id)) - 22.0));
    }
    qInfo("worst %.3f mm off the edge", worst);
    QVERIFY(worst < 0.3);
    QCOMPARE(test::eulerCharacteristics(mesh), std::vector<int>{2});
}

/// A step of 60 under noise of 30, and a surface that runs up and down by up to 2 mm about it.
void SurfaceStrokeTest::edgesAttractThroughNoise()
{
    constexpr int side = 61;
    test::ShapedMask made({side, side, side});
    made.geometry.indexToWorld[3] = glm::dvec4(-30, -30, -30, 1);
    std::vector<std::uint16_t> codes;
    std::mt19937 random(11);
    for (int z = 0; z < side; ++z) {
        for (int y = 0; y < side; ++y) {
            for (int x = 0; x < side; ++x) {
                const double off = 21.0 - glm::distance(glm::dvec3(x, y, z), glm::dvec3(30));
                // The sum of twelve such is about normal.
                double noise = -6.0;
                for (int i = 0; i < 12; ++i)
                    noise += double(random()) / double(std::mt19937::max());
                codes.push_back(std::uint16_t(
                    std::lround(500.0 + 60.0 * std::clamp(0.5 + off, 0.0, 1.0) + 30.0 * noise)));
            }
        }
    }
    const core::GreyBox grey(made.geometry, glm::ivec3(0), glm::ivec3(side), codes);
    core::SimplexMesh mesh = redBall();
    {
        core::SimplexMeshEdit edit(mesh);
        for (const core::VertexId id : mesh.vertexIds()) {
            const glm::dvec3 out = glm::normalize(mesh.position(id));
            const double wave = std::sin(9.0 * out.y) * std::sin(9.0 * out.z);
            edit.move(id, (21.0 + 2.0 * wave) * out);
        }
        edit.commit();
    }
    const auto looksOver = [&](const glm::dvec3& place) { return place.x > 15.0; };
    const auto offEdge = [&] {
        double sum = 0.0;
        int count = 0;
        for (const core::VertexId id : mesh.vertexIds()) {
            if (!looksOver(mesh.position(id)))
                continue;
            sum += std::abs(glm::length(mesh.position(id)) - 21.0);
            ++count;
        }
        return sum / count;
    };
    const double before = offEdge();
    std::vector<core::SurfaceSample> samples;
    for (int i = 0; i < 24; ++i) {
        const double turn = 0.7 * i;
        const double wide = 0.5 * i;
        samples.push_back({.placeLps = {18.0, wide * std::cos(turn), wide * std::sin(turn)}});
    }
    stroke(mesh, core::AttractTool{.radiusMm = 7.0, .reachMm = 5.0, .grey = &grey}, samples);
    double worst = 0.0;
    for (const core::VertexId id : mesh.vertexIds()) {
        if (looksOver(mesh.position(id)))
            worst = std::max(worst, std::abs(glm::length(mesh.position(id)) - 21.0));
    }
    qInfo("%.2f mm off the edge in the mean before, %.2f after, %.2f at worst", before, offEdge(),
        worst);
    QVERIFY(offEdge() < 0.4 * before);
    QVERIFY(worst < 2.0);
    QVERIFY(core::selfIntersections(mesh, made.geometry).empty());

    // However long it goes on, and wherever: what lies over the edge stays there.
    samples.clear();
    for (int i = 0; i < 150; ++i) {
        const double height = 19.0 * std::cos(0.063 * i);
        const double wide = std::sqrt(441.0 - height * height);
        samples.push_back(
            {.placeLps = {wide * std::cos(0.9 * i), wide * std::sin(0.9 * i), height}});
    }
    stroke(mesh, core::AttractTool{.radiusMm = 7.0, .reachMm = 5.0, .grey = &grey}, samples);
    const double share =
        core::enclosedMm3(mesh) / (4.0 / 3.0 * std::numbers::pi * 21.0 * 21.0 * 21.0);
    qInfo("%.3f of the body, %zu vertices", share, mesh.vertexCount());
    QVERIFY(std::abs(share - 1.0) < 0.03);
}

/// Behind each edge lies one that is four times as steep, within reach of the first, but not of
/// where the surface was.
void SurfaceStrokeTest::attractionReachesNoFartherThanItLooks()
{
    test::ShapedMask made({81, 81, 81});
    made.geometry.indexToWorld[3] = glm::dvec4(-40, -40, -40, 1);
    std::vector<std::uint16_t> codes;
    for (int z = 0; z < 81; ++z) {
        for (int y = 0; y < 81; ++y) {
            for (int x = 0; x < 81; ++x) {
                const double from = glm::distance(glm::dvec3(x, y, z), glm::dvec3(40));
                double value = 10.0;
                double rise = 50.0;
                for (const double edge : {22.5, 26.0, 29.5, 33.0}) {
                    const double off = from - edge;
                    value += rise * (0.5 + 0.5 * off / std::sqrt(0.25 + off * off));
                    rise *= 4.0;
                }
                codes.push_back(std::uint16_t(std::lround(value)));
            }
        }
    }
    const core::GreyBox grey(made.geometry, glm::ivec3(0), glm::ivec3(81), codes);
    core::SimplexMesh mesh = redBall();
    const std::vector<core::SurfaceSample> samples(10, {.placeLps = {20, 0, 0}});
    stroke(mesh, core::AttractTool{.radiusMm = 14.0, .reachMm = 4.0, .grey = &grey}, samples);
    double worst = 0.0;
    for (const core::VertexId id : mesh.vertexIds()) {
        const double from = glm::length(mesh.position(id));
        if (mesh.position(id).x > 0.93 * from)
            worst = std::max(worst, std::abs(from - 22.5));
    }
    qInfo("worst %.3f mm off the nearest edge", worst);
    QVERIFY2(worst < 0.5, qPrintable(QString::number(worst)));
}

namespace {

/// A ball of radius 20 around the origin as voxels.
struct BallMask {
    test::ShapedMask made{{51, 51, 51}};
    BallMask()
    {
        made.geometry.indexToWorld[3] = glm::dvec4(-25, -25, -25, 1);
        made.fill([](const glm::dvec3& at) { return glm::distance(at, glm::dvec3(25)) < 20.0; });
    }
};

} // namespace

void SurfaceStrokeTest::paintedYellowGoesBackToTheMask()
{
    const BallMask ball;
    const core::BoundaryForce boundary(ball.made.mask(), ball.made.geometry, 12.0);
    core::SimplexMesh mesh = redBall();
    const glm::dvec3 centre(23.0, 0.0, 0.0);
    stroke(mesh, core::SphereTool{.radiusMm = 8.0}, {{.placeLps = centre}}, {}, &boundary);
    QVERIFY(nearestMm(mesh, centre) > 8.0 - 1e-6);
    stroke(mesh, core::MarkBrush{.mark = core::SurfaceMark::Yellow, .radiusMm = 14.0},
        {{.placeLps = {15, 0, 0}}}, {}, &boundary);
    double worst = 0.0;
    for (const core::VertexId id : mesh.vertexIds())
        worst = std::max(worst, std::abs(glm::length(mesh.position(id)) - 20.0));
    qInfo("worst %.3f mm off the mask", worst);
    QVERIFY(worst < 1.0);
    QCOMPARE(test::eulerCharacteristics(mesh), std::vector<int>{2});
}

void SurfaceStrokeTest::yellowGoesBackRedStays()
{
    const BallMask ball;
    const core::BoundaryForce boundary(ball.made.mask(), ball.made.geometry, 12.0);
    core::SimplexMesh mesh = test::simplexSphere(20.0, 4);
    markWhere(mesh, core::SurfaceMark::Red, [](const glm::dvec3& at) { return at.x > 0.0; });
    for (const bool reddens : {false, true}) {
        for (const double x : {21.0, -21.0}) {
            core::SimplexMesh other = mesh;
            stroke(other, core::SphereTool{.radiusMm = 6.0}, {{.placeLps = {x, 0, 0}}},
                {.reddens = reddens}, &boundary);
            const double near = nearestMm(other, {x, 0, 0});
            if (x > 0.0 || reddens)
                QVERIFY2(near >= 6.0 - 1e-6, qPrintable(QString::number(near)));
            else
                QVERIFY2(near < 2.5, qPrintable(QString::number(near)));
        }
    }
}

void SurfaceStrokeTest::aRolledBackStrokeLeavesNothing()
{
    core::SimplexMesh mesh = redBall();
    const core::SimplexMesh before = mesh;
    {
        core::SurfaceStroke made(mesh, nullptr, core::SphereTool{.radiusMm = 8.0}, {});
        made.add({.placeLps = {23, 0, 0}});
        QVERIFY(!made.takeWritten().vertices.empty());
        QVERIFY(!core::identical(mesh, before));
        made.rollback();
    }
    QVERIFY(core::identical(mesh, before));
    {
        core::SurfaceStroke left(mesh, nullptr, core::SphereTool{.radiusMm = 8.0}, {});
        left.add({.placeLps = {23, 0, 0}});
    }
    QVERIFY(core::identical(mesh, before));
    // What reaches nothing changes nothing.
    QVERIFY(stroke(mesh, core::SphereTool{.radiusMm = 3.0}, {{.placeLps = {40, 0, 0}}}).empty());
    core::SimplexMesh nothing;
    for (const core::SurfaceTool& tool : {core::SurfaceTool(core::SphereTool{}),
             core::SurfaceTool(core::DragTool{}), core::SurfaceTool(core::MarkBrush{})})
        QVERIFY(stroke(nothing, tool, {{.placeLps = {0, 0, 0}}}).empty());
}

namespace {

core::SurfaceTool randomTool(test::Random& random, const core::GreyBox* grey)
{
    const double radius = 2.0 + 6.0 * test::randomUnit(random);
    switch (test::randomInt(random, 0, 6)) {
    case 0:
        return core::MarkBrush{
            .mark = core::SurfaceMark(test::randomInt(random, 0, 2)), .radiusMm = radius};
    case 1:
        return core::PlaneTool{.normalLps = {test::randomUnit(random) - 0.5,
                                   test::randomUnit(random) - 0.5, test::randomUnit(random) - 0.4},
            .radiusMm = radius,
            .heightMm = 6.0};
    case 2:
        return core::DragTool{.radiusMm = radius};
    case 3:
        return core::SmoothTool{.radiusMm = radius};
    case 4:
        return core::AttractTool{.radiusMm = radius, .reachMm = 4.0, .grey = grey};
    default:
        return core::SphereTool{.radiusMm = radius};
    }
}

} // namespace

void SurfaceStrokeTest::stormsKeepTheSurfaceWhole_data()
{
    QTest::addColumn<bool>("isTorus");
    QTest::newRow("ball") << false;
    QTest::newRow("torus") << true;
}

void SurfaceStrokeTest::stormsKeepTheSurfaceWhole()
{
    QFETCH(bool, isTorus);
    const int steps = test::longRun() ? 10'000 : 400;
    auto random = test::Random(isTorus ? 77 : 78);
    std::vector<std::uint16_t> codes(64);
    for (std::uint16_t& code : codes)
        code = std::uint16_t(test::randomInt(random, 0, 1000));
    test::ShapedMask small({4, 4, 4}, glm::dvec3(10.0));
    small.geometry.indexToWorld[3] = glm::dvec4(-15, -15, -15, 1);
    const core::GreyBox grey(small.geometry, glm::ivec3(0), glm::ivec3(4), codes);
    const BallMask ball;
    const core::BoundaryForce boundary(ball.made.mask(), ball.made.geometry, 8.0);
    core::SimplexMesh mesh =
        isTorus ? test::simplexMesh(test::torus(14.0, 5.0, 40, 16)) : test::simplexSphere(18.0, 3);
    markWhere(mesh, core::SurfaceMark::Red, [](const glm::dvec3& at) { return at.x > -8.0; });
    const std::vector<int> whole = test::eulerCharacteristics(mesh);
    const double area = core::meanFaceAreaMm2(mesh);
    const std::size_t first = mesh.vertexCount();
    std::size_t most = 0;
    int done = 0;
    int strokes = 0;
    while (done < steps) {
        const core::SimplexMesh before = mesh;
        const core::SurfaceTool tool = randomTool(random, &grey);
        const auto ids = mesh.vertexIds();
        glm::dvec3 place =
            mesh.position(ids[std::size_t(test::randomInt(random, 0, int(ids.size()) - 1))]);
        const core::SurfaceStrokeSettings settings{
            .areaMm2 = area, .reddens = test::randomInt(random, 0, 3) == 0};
        core::SimplexMesh again = mesh;
        core::SurfaceStroke made(mesh, &boundary, tool, settings);
        core::SurfaceStroke twice(again, &boundary, tool, settings);
        for (int i = test::randomInt(random, 1, 4); i > 0; --i) {
            const core::SurfaceSample sample{
                .placeLps = place, .pressure = 0.5 + 0.5 * test::randomUnit(random)};
            made.add(sample);
            twice.add(sample);
            place += glm::dvec3{test::randomUnit(random) - 0.5, test::randomUnit(random) - 0.5,
                         test::randomUnit(random) - 0.5}
                * 8.0;
        }
        made.settle();
        done += std::max(1, made.steps());
        ++strokes;
        const core::SimplexMeshDelta delta = made.commit();
        const core::SimplexMeshDelta deltaAgain = twice.commit();
        QVERIFY(core::identical(mesh, again));
        QCOMPARE(core::packed(delta), core::packed(deltaAgain));
        QCOMPARE(test::eulerCharacteristics(mesh), whole);
        // Green stays as it is, but for the brush.
        if (!std::holds_alternative<core::MarkBrush>(tool)) {
            for (const core::VertexId id : before.vertexIds()) {
                if (before.mark(id) == core::SurfaceMark::Green)
                    QVERIFY(core::identical(mesh.vertex(id), before.vertex(id)));
            }
        }
        core::SimplexMesh back = mesh;
        delta.undo(back);
        QVERIFY(core::identical(back, before));
        delta.redo(back);
        QVERIFY(core::identical(back, mesh));
        most = std::max(most, mesh.vertexCount());
        for (const core::VertexId id : mesh.vertexIds())
            QVERIFY(glm::length(mesh.position(id)) < 200.0);
        // Now and then all is free again.
        if (strokes % 15 == 0)
            markWhere(mesh, core::SurfaceMark::Red, everywhere);
    }
    qInfo("%d strokes, %d steps, %zu vertices at first, at most %zu, %zu in the end", strokes, done,
        first, most, mesh.vertexCount());
    QVERIFY(most < 12 * first);
}

void SurfaceStrokeTest::theSameForAnyNumberOfThreads()
{
    std::vector<core::SimplexMesh> results;
    for (const int shares : {1, 2, 5, 0}) {
        core::SimplexMesh mesh = redBall(5);
        core::SurfaceStroke made(
            mesh, nullptr, core::SphereTool{.radiusMm = 8.0}, {.shares = shares});
        made.add({.placeLps = {23, 0, 0}});
        made.add({.placeLps = {20, 9, 0}});
        made.commit();
        core::SurfaceStroke drag(
            mesh, nullptr, core::DragTool{.radiusMm = 12.0}, {.shares = shares});
        drag.add({.placeLps = {-20, 0, 0}});
        drag.add({.placeLps = {-26, 3, 0}});
        drag.commit();
        results.push_back(mesh);
    }
    for (const core::SimplexMesh& other : results)
        QVERIFY(core::identical(other, results.front()));
}

/// Prints; nothing is decided by time.
void SurfaceStrokeTest::stepsAreQuick()
{
    core::SimplexMesh mesh = redBall(5);
    core::SurfaceStroke made(mesh, nullptr, core::SphereTool{.radiusMm = 13.0}, {});
    QElapsedTimer timer;
    timer.start();
    std::size_t active = 0;
    for (int i = 0; i < 6; ++i) {
        made.add({.placeLps = {24.0 - i, 0, 0}});
        active = std::max(active, made.activeVertices());
    }
    qInfo("%d steps in %lld ms, %zu vertices of %zu active", made.steps(),
        static_cast<long long>(timer.elapsed()), active, mesh.vertexCount());
    QVERIFY(made.steps() >= 6);
}

BURIN_TEST(SurfaceStrokeTest)

} // namespace surfaceStrokeTest

#include "SurfaceStrokeTest.moc"
