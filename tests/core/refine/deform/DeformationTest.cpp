// SPDX-License-Identifier: Apache-2.0
#include "core/refine/deform/Deformation.h"
#include "core/refine/deform/BoundaryForce.h"
#include "core/refine/repair/MeshRestructuring.h"
#include "tests/support/program/LongRun.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/ShapedMask.h"
#include "tests/support/scenes/SimplexShapes.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <functional>

namespace deformationTest {

namespace {

using Forces = std::vector<const core::ExternalForce*>;

/// Towards a sphere around the origin, whatever the mark.
class SphereForce final : public core::ExternalForce {
public:
    explicit SphereForce(double radius)
        : m_radius(radius)
    {
    }
    [[nodiscard]] glm::dvec3 forceMm(const core::SurfacePoint& point) const override
    {
        return (m_radius / glm::length(point.positionLps) - 1.0) * point.positionLps;
    }

private:
    double m_radius;
};

/// Pulls one vertex somewhere.
class PointForce final : public core::ExternalForce {
public:
    PointForce(core::VertexId vertex, const glm::dvec3& force)
        : m_vertex(vertex)
        , m_force(force)
    {
    }
    [[nodiscard]] glm::dvec3 forceMm(const core::SurfacePoint& point) const override
    {
        return point.vertex == m_vertex ? m_force : glm::dvec3(0.0);
    }

private:
    core::VertexId m_vertex;
    glm::dvec3 m_force;
};

void markWhere(core::SimplexMesh& mesh, core::SurfaceMark mark,
    const std::function<bool(const glm::dvec3&)>& where)
{
    core::SimplexMeshEdit edit(mesh);
    for (const core::VertexId id : mesh.vertexIds()) {
        if (where(mesh.position(id)))
            edit.setMark(id, mark);
    }
    edit.commit();
}

} // namespace

/// Surfaces in motion.
class DeformationTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void aSphereGrowsToTheBoundary();
    void aSphereUnderItsOwnForcesStays();
    void greenNeverMoves();
    void redIsFreeOfTheMask();
    void activeOnesComeAndGo();
    void onlyActiveOnesMove();
    void theSameForAnyNumberOfThreads();
    void afterRestructuring();
};

void DeformationTest::aSphereGrowsToTheBoundary()
{
    test::ShapedMask made({50, 50, 50});
    made.geometry.indexToWorld[3] = glm::dvec4(-25, -25, -25, 1);
    made.fill([](const glm::dvec3& at) { return glm::distance(at, glm::dvec3(25)) < 18.0; });
    const core::BoundaryForce boundary(made.mask(), made.geometry, 12.0);
    core::SimplexMesh mesh = test::simplexSphere(11.0, 4);
    core::SimplexMeshEdit edit(mesh);
    core::Deformation deformation({});
    deformation.activateAll(mesh);
    int steps = 0;
    while (steps < 300 && !deformation.active().empty()) {
        deformation.step(edit, Forces{&boundary});
        ++steps;
    }
    edit.commit();
    double sum = 0.0;
    double most = 0.0;
    for (const core::VertexId id : mesh.vertexIds()) {
        const double off = glm::length(mesh.position(id)) - 18.0;
        sum += off;
        most = std::max(most, std::abs(off));
    }
    qInfo("at rest after %d steps; mean %.4f voxels off, at most %.3f", steps,
        sum / double(mesh.vertexCount()), most);
    QVERIFY(steps < 300);
    QVERIFY(std::abs(sum / double(mesh.vertexCount())) < 0.08);
    QVERIFY(most < 0.6);
    QCOMPARE(test::eulerCharacteristics(mesh), std::vector<int>{2});
}

/// Even curvature is what the internal forces want: nothing shrinks.
void DeformationTest::aSphereUnderItsOwnForcesStays()
{
    core::SimplexMesh mesh = test::simplexSphere(20.0, 3);
    core::SimplexMeshEdit edit(mesh);
    core::Deformation deformation({.negligibleMm = 0.0});
    deformation.activateAll(mesh);
    for (int step = 0; step < 200; ++step)
        deformation.step(edit, {});
    double sum = 0.0;
    for (const core::VertexId id : mesh.vertexIds())
        sum += glm::length(mesh.position(id));
    const double radius = sum / double(mesh.vertexCount());
    QVERIFY2(std::abs(radius - 20.0) < 0.1, qPrintable(QString::number(radius)));
    edit.commit();
}

void DeformationTest::greenNeverMoves()
{
    auto random = test::Random(21);
    core::SimplexMesh mesh = test::simplexSphere(15.0, 2);
    markWhere(mesh, core::SurfaceMark::Green,
        [](const glm::dvec3& at) { return at.z > 6.0 || at.x < -10.0; });
    const core::SimplexMesh before = mesh;
    std::vector<core::VertexId> green;
    for (const core::VertexId id : mesh.vertexIds()) {
        if (mesh.mark(id) == core::SurfaceMark::Green)
            green.push_back(id);
    }
    QVERIFY(green.size() > 50);
    core::SimplexMeshEdit edit(mesh);
    core::Deformation deformation({});
    core::RestructuringSettings structure{.areaMm2 = core::meanFaceAreaMm2(mesh)};
    for (int step = 0; step < (test::longRun() ? 10000 : 1000); ++step) {
        const SphereForce sphere(8.0 + 14.0 * test::randomUnit(random));
        const PointForce point(green[std::size_t(step) % green.size()], {5, 5, 5});
        if (step % 20 == 0)
            deformation.activateAll(mesh);
        deformation.step(edit, Forces{&sphere, &point});
        if (step % 5 == 4) {
            const auto done = core::restructure(edit, deformation.active(), structure);
            deformation.restructured(mesh, done.vertices);
        }
        for (const core::VertexId id : green)
            QVERIFY(core::identical(mesh.vertex(id), before.vertex(id)));
    }
    QCOMPARE(test::eulerCharacteristics(mesh), std::vector<int>{2});
    for (const core::VertexId id : deformation.active())
        QVERIFY(mesh.mark(id) != core::SurfaceMark::Green);
    const core::SimplexMeshDelta delta = edit.commit();
    QVERIFY(!delta.vertices.empty());
    core::SimplexMesh back = mesh;
    delta.undo(back);
    QVERIFY(core::identical(back, before));
    delta.redo(back);
    QVERIFY(core::identical(back, mesh));
}

void DeformationTest::redIsFreeOfTheMask()
{
    test::ShapedMask made({40, 40, 40});
    made.geometry.indexToWorld[3] = glm::dvec4(-20, -20, -20, 1);
    made.fill([](const glm::dvec3& at) { return glm::distance(at, glm::dvec3(20)) < 14.0; });
    const core::BoundaryForce boundary(made.mask(), made.geometry, 8.0);
    core::SimplexMesh mesh = test::simplexSphere(10.0, 3);
    markWhere(mesh, core::SurfaceMark::Red, [](const glm::dvec3& at) { return at.z < -5.0; });
    core::SimplexMeshEdit edit(mesh);
    core::Deformation deformation({});
    deformation.activateAll(mesh);
    for (int step = 0; step < 60; ++step)
        deformation.step(edit, Forces{&boundary});
    edit.commit();
    double lowest = 0.0;
    double highest = 0.0;
    for (const core::VertexId id : mesh.vertexIds()) {
        lowest = std::min(lowest, mesh.position(id).z);
        highest = std::max(highest, mesh.position(id).z);
    }
    QVERIFY2(highest > 13.5 && lowest > -12.5, qPrintable(QString::number(lowest)));
}

void DeformationTest::activeOnesComeAndGo()
{
    core::SimplexMesh mesh = test::simplexSphere(20.0, 3);
    markWhere(mesh, core::SurfaceMark::Green, [](const glm::dvec3& at) { return at.z < -15.0; });
    core::SimplexMeshEdit edit(mesh);
    core::Deformation deformation({.internal = 0.1});
    QCOMPARE(deformation.step(edit, {}).active, std::size_t(0));
    // A strong pull wakes the neighbours, and theirs when it moves them.
    const core::VertexId id = 100;
    deformation.activate(mesh, std::vector<core::VertexId>{id, id, 99999});
    QCOMPARE(deformation.active(), std::vector<core::VertexId>{id});
    const PointForce pull(id, 3.0 * glm::normalize(mesh.position(id)));
    QCOMPARE(deformation.step(edit, Forces{&pull}).active, std::size_t(1));
    QCOMPARE(deformation.active().size(), std::size_t(4));
    for (int step = 0; step < 5; ++step)
        deformation.step(edit, Forces{&pull});
    QVERIFY(deformation.active().size() >= 4);
    QVERIFY(deformation.active().size() < 100);
    QVERIFY(std::is_sorted(deformation.active().begin(), deformation.active().end()));
    // Without it they come to rest.
    for (int step = 0; step < 500 && !deformation.active().empty(); ++step)
        deformation.step(edit, {});
    QVERIFY(deformation.active().empty());
    // Green ones do not become active; painted green, they rest.
    deformation.activateAll(mesh);
    QVERIFY(deformation.active().size() < mesh.vertexCount());
    edit.setMark(id, core::SurfaceMark::Green);
    deformation.step(edit, {});
    QVERIFY(!std::binary_search(deformation.active().begin(), deformation.active().end(), id));
    deformation.rest(std::vector<core::VertexId>{deformation.active().front()});
    deformation.restAll();
    QVERIFY(deformation.active().empty());
    edit.commit();
}

void DeformationTest::onlyActiveOnesMove()
{
    core::SimplexMesh mesh = test::simplexSphere(20.0, 3);
    core::SimplexMeshEdit edit(mesh);
    core::Deformation deformation({.stirringMm = 1e9});
    std::vector<core::VertexId> some;
    for (core::VertexId id = 10; id < 40; ++id)
        some.push_back(id);
    deformation.activate(mesh, some);
    const SphereForce sphere(22.0);
    for (int step = 0; step < 10; ++step)
        QCOMPARE(deformation.step(edit, Forces{&sphere}).active, std::size_t(30));
    const core::SimplexMeshDelta delta = edit.commit();
    QCOMPARE(delta.vertices.size(), std::size_t(30));
    QCOMPARE(delta.vertices.front().id, core::VertexId(10));
    QVERIFY(delta.faces.empty());
}

void DeformationTest::theSameForAnyNumberOfThreads()
{
    test::ShapedMask made({50, 50, 50}, {1, 1, 0.9});
    made.geometry.indexToWorld[3] = glm::dvec4(-25, -25, -22, 1);
    made.fill([](const glm::dvec3& at) {
        return glm::distance(at, glm::dvec3(25, 25, 22)) < 17.0 || at.x > 40.0;
    });
    const core::BoundaryForce boundary(made.mask(), made.geometry, 12.0);
    std::vector<core::SimplexMesh> results;
    for (const int shares : {1, 1, 2, 7, 0}) {
        core::SimplexMesh mesh = test::simplexSphere(12.0, 4);
        core::SimplexMeshEdit edit(mesh);
        core::Deformation deformation({.shares = shares});
        core::RestructuringSettings structure{.areaMm2 = core::meanFaceAreaMm2(mesh)};
        deformation.activateAll(mesh);
        for (int step = 0; step < 20; ++step) {
            deformation.step(edit, Forces{&boundary});
            if (step % 5 == 4) {
                const auto done = core::restructure(edit, deformation.active(), structure);
                deformation.restructured(mesh, done.vertices);
            }
        }
        edit.commit();
        results.push_back(mesh);
    }
    for (const core::SimplexMesh& other : results)
        QVERIFY(core::identical(other, results.front()));
}

void DeformationTest::afterRestructuring()
{
    auto random = test::Random(2);
    core::SimplexMesh mesh = test::simplexSphere(20.0, 2);
    core::SimplexMeshEdit edit(mesh);
    core::Deformation deformation({});
    const SphereForce sphere(22.0);
    for (int round = 0; round < 100; ++round) {
        deformation.activateAll(mesh);
        deformation.step(edit, Forces{&sphere});
        for (int i = 0; i < 10; ++i)
            test::randomOperation(edit, random);
        const std::vector<core::VertexId> some{0, 5, 9};
        deformation.restructured(mesh, some);
        for (const core::VertexId id : deformation.active())
            QVERIFY(mesh.hasVertex(id));
        deformation.step(edit, Forces{&sphere});
    }
    QCOMPARE(test::eulerCharacteristics(mesh), std::vector<int>{2});
    edit.commit();
}

BURIN_TEST(DeformationTest)

} // namespace deformationTest

#include "DeformationTest.moc"
