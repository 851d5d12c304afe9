// SPDX-License-Identifier: Apache-2.0
#include "core/refine/repair/SelfIntersections.h"
#include "core/refine/mesh/SimplexDual.h"
#include "core/refine/voxels/SurfaceVoxels.h"
#include "tests/support/program/LongRun.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/SimplexShapes.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <set>

namespace selfIntersectionsTest {

namespace {

core::VolumeGeometry grid(const glm::dvec3& spacingMm = glm::dvec3(1.0))
{
    core::VolumeGeometry geometry;
    geometry.size = {100, 100, 100};
    for (int axis = 0; axis < 3; ++axis)
        geometry.indexToWorld[axis][axis] = spacingMm[axis];
    geometry.indexToWorld[3] = glm::dvec4(-50.0 * spacingMm, 1.0);
    return geometry;
}

template <typename Change> core::SimplexMesh changed(core::SimplexMesh mesh, const Change& change)
{
    core::SimplexMeshEdit edit(mesh);
    for (const core::VertexId id : mesh.vertexIds())
        edit.move(id, change(id, mesh.position(id)));
    edit.commit();
    return mesh;
}

/// Where a way meets a triangle (Möller and Trumbore 1997), in doubles.
bool meets(const glm::dvec3& from, const glm::dvec3& to, const std::array<glm::dvec3, 3>& triangle)
{
    const glm::dvec3 way = to - from;
    const glm::dvec3 u = triangle[1] - triangle[0];
    const glm::dvec3 v = triangle[2] - triangle[0];
    const glm::dvec3 p = glm::cross(way, v);
    const double determinant = glm::dot(u, p);
    if (determinant == 0.0)
        return false;
    const glm::dvec3 t = from - triangle[0];
    const double a = glm::dot(t, p) / determinant;
    const glm::dvec3 q = glm::cross(t, u);
    const double b = glm::dot(way, q) / determinant;
    const double along = glm::dot(v, q) / determinant;
    return a >= 0.0 && b >= 0.0 && a + b <= 1.0 && along > 0.0 && along < 1.0;
}

/// Every pair of triangles, slowly.
std::vector<core::CrossingFaces> everyPair(
    const core::SimplexMesh& mesh, const core::VolumeGeometry& geometry)
{
    const core::LatticeSurface surface = core::onLattice(mesh, geometry);
    const std::vector<core::FaceId> faces = core::trianglesOf(mesh).faces;
    std::set<core::CrossingFaces> found;
    const auto corners = [&](std::size_t i) {
        const glm::uvec3& at = surface.triangles[i];
        return std::array<glm::dvec3, 3>{glm::dvec3(surface.vertices[at.x]),
            glm::dvec3(surface.vertices[at.y]), glm::dvec3(surface.vertices[at.z])};
    };
    for (std::size_t i = 0; i < surface.triangles.size(); ++i) {
        for (std::size_t j = 0; j < surface.triangles.size(); ++j) {
            if (i == j)
                continue;
            const auto of = corners(i);
            const auto other = corners(j);
            const glm::uvec3& at = surface.triangles[j];
            int shared = 0;
            std::array<bool, 3> isShared{};
            for (int k = 0; k < 3; ++k) {
                const std::uint32_t point = surface.triangles[i][k];
                isShared[std::size_t(k)] = point == at.x || point == at.y || point == at.z;
                shared += isShared[std::size_t(k)] ? 1 : 0;
            }
            for (std::size_t k = 0; k < 3 && shared < 2; ++k) {
                if (!isShared[k] && !isShared[(k + 1) % 3] && meets(of[k], of[(k + 1) % 3], other))
                    found.insert({.one = std::min(faces[i], faces[j]),
                        .other = std::max(faces[i], faces[j])});
            }
        }
    }
    return {found.begin(), found.end()};
}

} // namespace

/// Surfaces that pass through themselves.
class SelfIntersectionsTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void soundSurfacesHaveNone();
    void asEveryPairTells();
    void whatTouchesDoesNotCross();
    void repairs_data();
    void repairs();
    void greenStays();
};

void SelfIntersectionsTest::soundSurfacesHaveNone()
{
    const core::SimplexMesh ball = test::simplexSphere(20.0, 3);
    QVERIFY(core::selfIntersections(ball, grid()).empty());
    QVERIFY(core::selfIntersections(ball, grid({0.7, 0.7, 5.0})).empty());
    QVERIFY(core::selfIntersections(core::SimplexMesh(), grid()).empty());
    core::SimplexMesh same = ball;
    core::SimplexMeshEdit edit(same);
    const auto repair = core::repairSelfIntersections(edit, grid());
    QCOMPARE(repair.before + repair.left, std::size_t(0));
    QVERIFY(edit.commit().empty());
}

void SelfIntersectionsTest::asEveryPairTells()
{
    auto random = test::Random(19);
    std::size_t crossings = 0;
    for (int trial = 0; trial < (test::longRun() ? 200 : 12); ++trial) {
        const double strength = 0.5 + 4.0 * test::randomUnit(random);
        const core::SimplexMesh mesh =
            changed(test::simplexMesh(test::together(test::icosphere(10.0, 1),
                        test::moved(test::torus(8.0, 3.0, 9, 5), {15, 1, 0}))),
                [&](core::VertexId, const glm::dvec3& at) {
                    return at
                        + strength
                        * (glm::dvec3{test::randomUnit(random), test::randomUnit(random),
                               test::randomUnit(random)}
                            - 0.5);
                });
        const auto found = core::selfIntersections(mesh, grid());
        QVERIFY(std::is_sorted(found.begin(), found.end()));
        const auto expected = everyPair(mesh, grid());
        QCOMPARE(found.size(), expected.size());
        QVERIFY(found == expected);
        crossings += found.size();
    }
    QVERIFY(crossings > 100);
}

void SelfIntersectionsTest::whatTouchesDoesNotCross()
{
    // Two tetrahedra, one of which stands with a corner on a face of the other.
    const auto pair = [](double gap) {
        const std::vector<glm::dvec3> points{{0, 0, 0}, {9, 0, 0}, {0, 9, 0}, {0, 0, -9},
            {2, 3, gap}, {2, 9, 8 + gap}, {9, 3, 8 + gap}, {-5, -5, 8 + gap}};
        const std::vector<core::FaceRing> rings{
            {0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}, {4, 5, 6}, {4, 6, 7}, {4, 7, 5}, {5, 7, 6}};
        return *core::SimplexMesh::make(points, rings);
    };
    QVERIFY(core::selfIntersections(pair(0.0), grid()).empty());
    QVERIFY(core::selfIntersections(pair(1.0 / 16384), grid()).empty());
    const auto crossings = core::selfIntersections(pair(-1.0 / 16384), grid());
    QCOMPARE(crossings.size(), std::size_t(3));
    for (const core::CrossingFaces& crossing : crossings)
        QCOMPARE(crossing.one, core::FaceId(0));
    // Less than the lattice tells apart.
    QVERIFY(core::selfIntersections(pair(-1e-6), grid()).empty());
}

void SelfIntersectionsTest::repairs_data()
{
    QTest::addColumn<QString>("shape");
    QTest::newRow("two balls in each other") << QStringLiteral("balls");
    QTest::newRow("two balls deep in each other") << QStringLiteral("deep");
    QTest::newRow("a thin sheet dented through") << QStringLiteral("sheet");
    QTest::newRow("vertices pulled through the other side") << QStringLiteral("spikes");
}

void SelfIntersectionsTest::repairs()
{
    QFETCH(QString, shape);
    core::SimplexMesh mesh;
    if (shape == QLatin1String("sheet"))
        mesh = changed(test::simplexSphere(20.0, 4), [](core::VertexId, glm::dvec3 at) {
            at.z *= 0.05;
            if (at.z > 0.0 && glm::length(glm::dvec2(at)) < 8.0)
                at.z -= 2.0;
            return at;
        });
    else if (shape == QLatin1String("spikes"))
        mesh = changed(test::simplexSphere(20.0, 3),
            [](core::VertexId id, const glm::dvec3& at) { return id % 301 == 5 ? -1.3 * at : at; });
    else
        mesh = test::simplexMesh(test::together(test::icosphere(10.0, 3),
            test::moved(test::icosphere(10.0, 3),
                {shape == QLatin1String("deep") ? 16.0 : 19.0, 0.3, 0.2})));
    const core::SimplexMesh before = mesh;
    const double enclosed = core::enclosedMm3(mesh);
    core::SimplexMeshEdit edit(mesh);
    const auto repair = core::repairSelfIntersections(edit, grid());
    const core::SimplexMeshDelta delta = edit.commit();
    qInfo("%zu pairs before, %zu left after %d rounds, %zu of %zu vertices moved", repair.before,
        repair.left, repair.rounds, delta.vertices.size(), mesh.vertexCount());
    QVERIFY(repair.before > 0);
    QCOMPARE(repair.left, std::size_t(0));
    QVERIFY(core::selfIntersections(mesh, grid()).empty());
    QVERIFY(!test::eulerCharacteristics(mesh).empty());
    QVERIFY(delta.faces.empty());
    QVERIFY(delta.vertices.size() < mesh.vertexCount());
    if (shape != QLatin1String("spikes"))
        QVERIFY(std::abs(core::enclosedMm3(mesh) / enclosed - 1.0) < 0.1);
    core::SimplexMesh again = before;
    core::SimplexMeshEdit other(again);
    core::repairSelfIntersections(other, grid());
    other.commit();
    QVERIFY(core::identical(mesh, again));
}

void SelfIntersectionsTest::greenStays()
{
    core::SimplexMesh mesh = test::simplexMesh(test::together(
        test::icosphere(10.0, 3), test::moved(test::icosphere(10.0, 3), {19, 0.3, 0.2})));
    {
        core::SimplexMeshEdit edit(mesh);
        for (const core::VertexId id : mesh.vertexIds()) {
            if (id < mesh.vertexSlots() / 2)
                edit.setMark(id, core::SurfaceMark::Green);
        }
        edit.commit();
    }
    const core::SimplexMesh before = mesh;
    core::SimplexMeshEdit edit(mesh);
    const auto repair = core::repairSelfIntersections(edit, grid());
    edit.commit();
    QVERIFY(repair.before > 0);
    QCOMPARE(repair.left, std::size_t(0));
    for (const core::VertexId id : mesh.vertexIds()) {
        if (mesh.mark(id) == core::SurfaceMark::Green)
            QVERIFY(core::identical(mesh.vertex(id), before.vertex(id)));
    }
}

BURIN_TEST(SelfIntersectionsTest)

} // namespace selfIntersectionsTest

#include "SelfIntersectionsTest.moc"
