// SPDX-License-Identifier: Apache-2.0
#include "core/refine/mesh/SurfaceMirror.h"

#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/SimplexShapes.h"

#include <QTest>

#include <cmath>

namespace surfaceMirrorTest {

using namespace core;

namespace {

/// A ball of radius 10 mm around the origin.
SimplexMesh ball()
{
    return test::simplexSphere(10.0, 3);
}

} // namespace

/// What a thread knows of a surface that it was told of by updates.
class SurfaceMirrorTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void raysMeetTheFront()
    {
        SurfaceMirror mirror;
        mirror.take(wholeUpdate(ball()));
        const std::optional<MeshHit> hit = mirror.hit({3.0, 2.0, 50.0}, glm::dvec3(0.0, 0.0, -1.0));
        QVERIFY(hit);
        // Faces lie within the ball by less than a twentieth of a millimetre.
        QVERIFY(std::abs(glm::length(hit->placeLps) - 10.0) < 0.2);
        QCOMPARE(hit->placeLps.x, 3.0);
        QVERIFY(hit->placeLps.z > 0.0);
        QVERIFY(glm::distance(hit->normalLps, glm::normalize(hit->placeLps)) < 0.1);
        QVERIFY(std::abs(hit->distanceMm - (50.0 - hit->placeLps.z)) < 1e-9);
        QVERIFY(glm::distance(mirror.vertex(hit->vertex).positionLps, hit->placeLps) < 2.0);
        // From inside the surface is met from behind, which nobody points at.
        QVERIFY(!mirror.hit(glm::dvec3(0.0), glm::dvec3(0.0, 0.0, 1.0)));
        QVERIFY(!mirror.hit({11.0, 0.0, 50.0}, glm::dvec3(0.0, 0.0, -1.0)));
        QVERIFY(!mirror.hit({0.0, 0.0, 50.0}, glm::dvec3(0.0, 0.0, 1.0)));
    }

    /// Where a part of the surface is hidden one sees its inside.
    void raysMeetTheInsideWhereTheyAreAskedTo()
    {
        SurfaceMirror mirror;
        mirror.take(wholeUpdate(ball()));
        const glm::dvec3 upwards(0.0, 0.0, 1.0);
        const std::optional<MeshHit> hit = mirror.hit({3.0, 2.0, 0.0}, upwards, FaceSides::Both);
        QVERIFY(hit);
        QVERIFY(std::abs(glm::length(hit->placeLps) - 10.0) < 0.2);
        QVERIFY(hit->placeLps.z > 0.0);
        QVERIFY(hit->normalLps.z > 0.5); // outwards all the same
        // From outside it is the same face as ever.
        const glm::dvec3 above(3.0, 2.0, 50.0);
        const std::optional<MeshHit> outer = mirror.hit(above, -upwards);
        const std::optional<MeshHit> both = mirror.hit(above, -upwards, FaceSides::Both);
        QVERIFY(outer && both);
        QCOMPARE(both->placeLps, outer->placeLps);
    }

    void partsAreTakenIn()
    {
        SimplexMesh mesh = ball();
        SurfaceMirror mirror;
        mirror.take(wholeUpdate(mesh));
        SimplexMeshEdit edit(mesh);
        test::Random random(7);
        for (int i = 0; i < 300; ++i) {
            test::randomOperation(edit, random);
            const VertexId moved = mesh.vertexIds()[random() % mesh.vertexCount()];
            edit.move(moved, mesh.position(moved) * 1.01);
            mirror.take(updateOf(mesh, edit.takeWritten()));
        }
        SurfaceMirror anew;
        anew.take(wholeUpdate(mesh));
        QCOMPARE(mirror.vertexCount(), mesh.vertexCount());
        QCOMPARE(mirror.faceCount(), mesh.faceCount());
        for (int i = 0; i < 200; ++i) {
            const glm::dvec3 from = 30.0
                * glm::normalize(glm::dvec3{test::randomUnit(random) - 0.5,
                    test::randomUnit(random) - 0.5, test::randomUnit(random) - 0.5});
            const auto one = mirror.hit(from, -glm::normalize(from));
            const auto other = anew.hit(from, -glm::normalize(from));
            QCOMPARE(one.has_value(), other.has_value());
            if (one) {
                QCOMPARE(one->placeLps, other->placeLps);
                QCOMPARE(one->normalLps, other->normalLps);
            }
        }
        mirror.take({.isWhole = true});
        QVERIFY(mirror.empty());
        QVERIFY(!mirror.hit({3.0, 2.0, 50.0}, glm::dvec3(0.0, 0.0, -1.0)));
        QCOMPARE(mirror.nearestVertex({}), noId);
    }

    void regionsByArea()
    {
        SimplexMesh mesh = ball();
        SimplexMeshEdit edit(mesh);
        for (const VertexId id : mesh.vertexIds()) {
            const glm::dvec3 at = mesh.position(id);
            if (at.z > 6.0)
                edit.setMark(id, SurfaceMark::Red);
            else if (at.z < -8.0)
                edit.setMark(id, SurfaceMark::Red);
            else if (at.x > 9.0)
                edit.setMark(id, SurfaceMark::Green);
        }
        edit.commit();
        SurfaceMirror mirror;
        mirror.take(wholeUpdate(mesh));
        const std::vector<MarkedRegion> red = mirror.regions(SurfaceMark::Red);
        QCOMPARE(red.size(), std::size_t(2));
        // Caps of a ball: 2 π r h, of height 4 and 2.
        QVERIFY(std::abs(red[0].areaMm2 / 251.3 - 1.0) < 0.15);
        QVERIFY(std::abs(red[1].areaMm2 / 125.7 - 1.0) < 0.2);
        QVERIFY(red[0].normalLps.z > 0.99);
        QVERIFY(red[1].normalLps.z < -0.99);
        QVERIFY(red[0].middleLps.z > 6.0);
        QCOMPARE(mirror.regions(SurfaceMark::Green).size(), std::size_t(1));
        const std::array<std::size_t, 3> counts = mirror.markCounts();
        QCOMPARE(counts[std::size_t(SurfaceMark::Red)], red[0].vertices + red[1].vertices);
        QCOMPARE(counts[0] + counts[1] + counts[2], mesh.vertexCount());
    }
};

BURIN_TEST(SurfaceMirrorTest)

} // namespace surfaceMirrorTest

#include "SurfaceMirrorTest.moc"
