// SPDX-License-Identifier: Apache-2.0
#include "core/refine/tools/SurfaceStroke.h"
#include "core/refine/BoundaryForce.h"
#include "core/refine/MeshRestructuring.h"
#include "core/refine/SimplexDual.h"
#include "core/refine/SurfaceDelta.h"
#include "core/refine/tools/MarkPaint.h"
#include "tests/support/EngineCases.h"
#include "tests/support/ShapedMask.h"
#include "tests/support/SimplexShapes.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <functional>

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

QTEST_GUILESS_MAIN(SurfaceStrokeTest)
#include "SurfaceStrokeTest.moc"
