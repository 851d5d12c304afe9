// SPDX-License-Identifier: Apache-2.0
#include "core/refine/fit/DoubtfulVertices.h"

#include "core/refine/voxels/BoxMask.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/SimplexShapes.h"

#include <QTest>

#include <cmath>
#include <functional>

namespace doubtfulVerticesTest {

using namespace core;

namespace {

constexpr int side = 48;
constexpr double radius = 14.0;

/// 1 mm voxels, the origin in the middle.
VolumeGeometry geometry()
{
    VolumeGeometry made;
    made.size = glm::ivec3(side);
    made.indexToWorld = glm::dmat4(1.0);
    made.indexToWorld[3] = {-23.5, -23.5, -23.5, 1.0};
    return made;
}

template <class T> std::vector<T> filled(const std::function<T(const glm::dvec3&)>& at)
{
    std::vector<T> values;
    for (int z = 0; z < side; ++z)
        for (int y = 0; y < side; ++y)
            for (int x = 0; x < side; ++x)
                values.push_back(at(geometry().toWorld(glm::dvec3(x, y, z))));
    return values;
}

SurfaceMirror mirrorOf(const SimplexMesh& mesh)
{
    SurfaceMirror mirror;
    mirror.take(wholeUpdate(mesh));
    return mirror;
}

/// A ball, green to the left of x = 6 mm, red to the right of it, yellow between.
SimplexMesh markedBall()
{
    SimplexMesh mesh = test::simplexSphere(radius, 4);
    SimplexMeshEdit edit(mesh);
    for (const VertexId id : mesh.vertexIds()) {
        if (mesh.position(id).x > 6.0)
            edit.setMark(id, SurfaceMark::Green);
        else if (mesh.position(id).x < -6.0)
            edit.setMark(id, SurfaceMark::Red);
    }
    edit.commit();
    return mesh;
}

} // namespace

class DoubtfulVerticesTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void whatStandsOffTheMask()
    {
        const SimplexMesh mesh = markedBall();
        const SurfaceMirror surface = mirrorOf(mesh);
        const VolumeGeometry volume = geometry();
        const auto ball = [](const glm::dvec3& at) {
            return std::uint8_t(glm::length(at) <= radius ? 1 : 0);
        };
        const BoxMask same = BoxMask::of(filled<std::uint8_t>(ball), 1, volume.size);
        const auto none = offTheMask(surface, BoundaryForce(same, volume, 4.0), 1.5);
        QCOMPARE(std::count(none.begin(), none.end(), true), 0);

        // The mask was grown by 4 mm to the left and above: what is green there does not follow.
        const auto grown = [&](const glm::dvec3& at) {
            return std::uint8_t(
                glm::length(at) <= (at.x > 8.0 || at.z > 9.0 ? radius + 4.0 : radius) ? 1 : 0);
        };
        const BoxMask mask = BoxMask::of(filled<std::uint8_t>(grown), 1, volume.size);
        const auto off = offTheMask(surface, BoundaryForce(mask, volume, 6.0), 1.5);
        int left = 0;
        for (const VertexId id : mesh.vertexIds()) {
            const glm::dvec3 at = mesh.position(id);
            // Yellow follows, so it is no doubt.
            if (mesh.mark(id) == SurfaceMark::Yellow)
                QVERIFY(!off[id]);
            if (at.x > 9.0) {
                QVERIFY(off[id]);
                ++left;
            }
            if (at.x < -6.0 && at.z < 7.0)
                QVERIFY(!off[id]);
        }
        QVERIFY(left > 20);
        const std::vector<MarkedRegion> regions = surface.regions(off);
        QVERIFY(!regions.empty());
        QVERIFY(regions.front().middleLps.x > 6.0);
        QVERIFY(regions.front().areaMm2 > 100.0);
    }

    void whereThereIsNoEdge()
    {
        SimplexMesh mesh = test::simplexSphere(radius, 4);
        const VolumeGeometry volume = geometry();
        // Above z = 7 mm what lies outside is as bright as the ball.
        const GreyBox grey(
            volume, glm::ivec3(0), volume.size, filled<std::uint16_t>([](const glm::dvec3& at) {
                const bool isBright = glm::length(at) <= radius || at.z > 7.0;
                return std::uint16_t(isBright ? 1200 : 900);
            }));
        const auto faint = withoutAnEdge(mirrorOf(mesh), grey, 1.5);
        int above = 0;
        for (const VertexId id : mesh.vertexIds()) {
            const double z = mesh.position(id).z;
            if (z > 11.0) {
                QVERIFY(faint[id]);
                ++above;
            }
            if (z < 4.0)
                QVERIFY(!faint[id]);
        }
        QVERIFY(above > 10);
        // What is marked has been looked at.
        SimplexMeshEdit edit(mesh);
        for (const VertexId id : mesh.vertexIds())
            edit.setMark(id, SurfaceMark::Green);
        edit.commit();
        const auto green = withoutAnEdge(mirrorOf(mesh), grey, 1.5);
        QCOMPARE(std::count(green.begin(), green.end(), true), 0);
        QVERIFY(withoutAnEdge(SurfaceMirror(), grey, 1.5).empty());
    }
};

BURIN_TEST(DoubtfulVerticesTest)

} // namespace doubtfulVerticesTest

#include "DoubtfulVerticesTest.moc"
