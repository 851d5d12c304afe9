// SPDX-License-Identifier: Apache-2.0
#include "core/refine/mesh/InternalForces.h"
#include "core/refine/mesh/SimplexMeshEdit.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/SimplexShapes.h"

#include <QTest>

#include <cmath>

namespace internalForcesTest {

/// Internal forces against closed forms.
class InternalForcesTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void onASphere();
    void insideOut();
    void onAPlane();
    void aDodecahedronIsAtRest();
    void wantedCurvatures();
    void neighboursInALine();
};

/// Four points of a sphere have its curvature, and the force slides the vertex along it.
void InternalForcesTest::onASphere()
{
    for (const double radius : {0.5, 10.0, 250.0}) {
        auto random = test::Random(3);
        core::SimplexMesh ball = test::simplexSphere(radius, 2);
        {
            core::SimplexMeshEdit edit(ball);
            for (const core::VertexId id : ball.vertexIds()) {
                const glm::dvec3 aside = 0.03 * radius
                    * glm::dvec3{test::randomUnit(random), test::randomUnit(random),
                        test::randomUnit(random)};
                edit.move(id, radius * glm::normalize(ball.position(id) + aside));
            }
            edit.commit();
        }
        for (const core::VertexId id : ball.vertexIds()) {
            const core::SimplexFrame frame = core::frameAt(ball, id);
            QVERIFY(std::abs(frame.curvaturePerMm * radius - 1.0) < 1e-9);
            QVERIFY(std::abs(glm::length(frame.normalLps) - 1.0) < 1e-12);
            QVERIFY(glm::dot(frame.normalLps, glm::normalize(ball.position(id))) > 0.9);
            const glm::dvec3 force = core::internalForceMm(ball, id, frame.curvaturePerMm);
            const double there = glm::length(ball.position(id) + force);
            QVERIFY2(std::abs(there / radius - 1.0) < 1e-9, qPrintable(QString::number(there)));
            // … to where it lies above the middle of its neighbours.
            const auto& near = ball.neighbours(id);
            const glm::dvec3 middle =
                (ball.position(near[0]) + ball.position(near[1]) + ball.position(near[2])) / 3.0;
            const glm::dvec3 above = ball.position(id) + force - middle;
            QVERIFY(glm::length(glm::cross(above, frame.normalLps)) < 1e-9 * radius);
        }
    }
}

void InternalForcesTest::insideOut()
{
    auto surface = test::icosphere(7.0, 1);
    for (glm::uvec3& triangle : surface.triangles)
        std::swap(triangle.y, triangle.z);
    core::SimplexMesh cave = test::simplexMesh(surface);
    core::SimplexMeshEdit edit(cave);
    for (const core::VertexId id : cave.vertexIds())
        edit.move(id, 7.0 * glm::normalize(cave.position(id)));
    for (const core::VertexId id : cave.vertexIds()) {
        const core::SimplexFrame frame = core::frameAt(cave, id);
        QVERIFY(std::abs(frame.curvaturePerMm + 1.0 / 7.0) < 1e-9);
        const glm::dvec3 force = core::internalForceMm(cave, id, frame.curvaturePerMm);
        QVERIFY(std::abs(glm::length(cave.position(id) + force) - 7.0) < 1e-8);
    }
    edit.commit();
}

void InternalForcesTest::onAPlane()
{
    core::SimplexMesh ball = test::simplexSphere(10.0, 1);
    const core::VertexId id = 5;
    const auto& near = ball.neighbours(id);
    const glm::dvec3 middle =
        (ball.position(near[0]) + ball.position(near[1]) + ball.position(near[2])) / 3.0;
    const glm::dvec3 aside = 0.4 * (ball.position(near[0]) - middle);
    core::SimplexMeshEdit edit(ball);
    edit.move(id, middle + aside);
    QVERIFY(std::abs(core::frameAt(ball, id).curvaturePerMm) < 1e-12);
    QVERIFY(glm::distance(core::internalForceMm(ball, id, 0.0), -aside) < 1e-12);
    // Below their plane the surface is bent the other way.
    edit.move(id, middle - 0.5 * core::frameAt(ball, id).normalLps);
    QVERIFY(core::frameAt(ball, id).curvaturePerMm < 0.0);
    edit.commit();
}

void InternalForcesTest::aDodecahedronIsAtRest()
{
    const core::SimplexMesh regular = test::simplexSphere(3.0, 0);
    QCOMPARE(regular.vertexCount(), std::size_t(20));
    for (const core::VertexId id : regular.vertexIds()) {
        const core::SimplexFrame frame = core::frameAt(regular, id);
        QVERIFY(std::abs(frame.curvaturePerMm - 1.0 / 3.0) < 1e-12);
        QVERIFY(glm::length(core::internalForceMm(regular, id, frame.curvaturePerMm)) < 1e-12);
    }
}

/// The height above the neighbours is that of a sphere of the wanted curvature through them.
void InternalForcesTest::wantedCurvatures()
{
    core::SimplexMesh ball = test::simplexSphere(10.0, 1);
    core::SimplexMeshEdit edit(ball);
    const core::VertexId id = 11;
    for (const double wanted : {-0.2, -0.05, 0.0, 0.01, 0.1, 0.25}) {
        edit.move(id, ball.position(id) + core::internalForceMm(ball, id, wanted));
        const double is = core::frameAt(ball, id).curvaturePerMm;
        QVERIFY2(std::abs(is - wanted) < 1e-9, qPrintable(QString::number(is)));
    }
    // No sphere through them is smaller than their circle.
    edit.move(id, ball.position(id) + core::internalForceMm(ball, id, 1e6));
    const double most = core::frameAt(ball, id).curvaturePerMm;
    QVERIFY2(most > 0.25 && most < 1.0, qPrintable(QString::number(most)));
    edit.commit();
}

void InternalForcesTest::neighboursInALine()
{
    core::SimplexMesh ball = test::simplexSphere(10.0, 1);
    core::SimplexMeshEdit edit(ball);
    const core::VertexId id = 2;
    const auto near = ball.neighbours(id);
    edit.move(near[0], {1, 0, 0});
    edit.move(near[1], {2, 0, 0});
    edit.move(near[2], {6, 0, 0});
    edit.move(id, {0, 4, 0});
    QCOMPARE(core::frameAt(ball, id).normalLps, glm::dvec3(0.0));
    QCOMPARE(core::frameAt(ball, id).curvaturePerMm, 0.0);
    QCOMPARE(core::internalForceMm(ball, id, 0.3), glm::dvec3(3, -4, 0));
    edit.move(near[2], {1, 0, 0});
    edit.move(near[1], {1, 0, 0});
    QCOMPARE(core::internalForceMm(ball, id, 0.3), glm::dvec3(1, -4, 0));
    edit.commit();
}

BURIN_TEST(InternalForcesTest)

} // namespace internalForcesTest

#include "InternalForcesTest.moc"
