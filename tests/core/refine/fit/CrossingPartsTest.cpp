// SPDX-License-Identifier: Apache-2.0
#include "core/refine/fit/CrossingParts.h"
#include "core/brick/VoxelRunSets.h"
#include "core/refine/deform/RefineSurface.h"
#include "core/refine/mesh/SimplexDual.h"
#include "core/refine/repair/SelfIntersections.h"
#include "core/refine/voxels/SurfaceVoxels.h"
#include "tests/support/program/LongRun.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/SimplexShapes.h"

#include <QTest>

#include <cmath>
#include <utility>

namespace crossingPartsTest {

using namespace core;

namespace {

VolumeGeometry grid()
{
    VolumeGeometry geometry;
    geometry.size = {100, 100, 100};
    geometry.indexToWorld[3] = glm::dvec4(-50.0, -50.0, -50.0, 1.0);
    return geometry;
}

/// Seen from within.
test::TriangleSurface turnedOver(test::TriangleSurface surface)
{
    for (glm::uvec3& triangle : surface.triangles)
        std::swap(triangle.y, triangle.z);
    return surface;
}

/// Two balls deep in each other, and one that lies by itself: the last third of the vertices.
SimplexMesh threeBalls()
{
    const test::TriangleSurface ball = test::icosphere(10.0, 3);
    return test::simplexMesh(test::together(
        test::together(ball, test::moved(ball, {16.0, 0.3, 0.2})), test::moved(ball, {0, 30, 0})));
}

void markAll(SimplexMesh& mesh, SurfaceMark mark)
{
    SimplexMeshEdit edit(mesh);
    for (const VertexId id : mesh.vertexIds())
        edit.setMark(id, mark);
    edit.commit();
}

VoxelRuns enclosed(const SimplexMesh& mesh)
{
    return voxelsOf(mesh, grid(), Progress()).value();
}

/// Those of the voxels that a mesh encloses.
std::vector<int> characteristicsOfVoxels(const SimplexMesh& mesh)
{
    const BoxMask mask = BoxMask::of(enclosed(mesh), grid().size);
    return test::eulerCharacteristics(refineSurfaceOf(mask, grid(), 1, Progress()).value());
}

/// The share of the voxels within the one that the other does not have, or the reverse.
double differingShare(const SimplexMesh& one, const SimplexMesh& other)
{
    const VoxelRuns voxels = enclosed(one);
    return double(differing(voxels, enclosed(other)).voxelCount()) / double(voxels.voxelCount());
}

} // namespace

/// The last resort where a surface passes through itself.
class CrossingPartsTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void whatNoRepairMoves();
    void whatDoesNotCrossStays();
    void aHollowIsLaidWithWhatItIsIn();
    void ballsAtRandom();
    void whatEnclosesNoVoxelIsRefused();
    void itIsAborted();
};

void CrossingPartsTest::whatNoRepairMoves()
{
    SimplexMesh mesh = threeBalls();
    markAll(mesh, SurfaceMark::Green);
    const SimplexMesh before = mesh;
    {
        // Green vertices stay, so nothing is repaired, whatever the number of rounds.
        SimplexMeshEdit edit(mesh);
        const IntersectionRepair repair = repairSelfIntersections(edit, grid());
        QVERIFY(repair.before > 0);
        QCOMPARE(repair.left, repair.before);
        QVERIFY(edit.commit().empty());
    }
    SimplexMeshEdit edit(mesh);
    const Result<LaidAnew> laid = layCrossingsAnew(edit, grid(), Progress());
    QVERIFY(laid.has_value());
    const SimplexMeshDelta delta = edit.commit();
    QVERIFY(laid->before > 0);
    QCOMPARE(laid->left, std::size_t(0));
    QCOMPARE(laid->parts, std::size_t(2));
    QVERIFY(selfIntersections(mesh, grid()).empty());
    // The two are one part now, as their voxels are.
    QCOMPARE(test::eulerCharacteristics(mesh).size(), std::size_t(2));
    QCOMPARE(test::eulerCharacteristics(mesh), characteristicsOfVoxels(before));
    const double share = differingShare(before, mesh);
    qInfo("%zu pairs, %zu vertices before and %zu after, %.3f %% of the voxels differ",
        laid->before, before.vertexCount(), mesh.vertexCount(), 100.0 * share);
    QVERIFY(share < 0.04);
    // What was signed off is so still.
    for (const VertexId id : mesh.vertexIds())
        QCOMPARE(mesh.mark(id), SurfaceMark::Green);
    // To the bit.
    const SimplexMesh after = mesh;
    delta.undo(mesh);
    QVERIFY(identical(mesh, before));
    delta.redo(mesh);
    QVERIFY(identical(mesh, after));
    SimplexMesh again = before;
    SimplexMeshEdit other(again);
    QVERIFY(layCrossingsAnew(other, grid(), Progress()).has_value());
    other.commit();
    QVERIFY(identical(again, after));
}

void CrossingPartsTest::whatDoesNotCrossStays()
{
    SimplexMesh mesh = threeBalls();
    const SimplexMesh before = mesh;
    SimplexMeshEdit edit(mesh);
    QVERIFY(layCrossingsAnew(edit, grid(), Progress()).has_value());
    edit.commit();
    std::size_t stayed = 0;
    for (const VertexId id : before.vertexIds()) {
        if (before.position(id).y < 15.0)
            continue;
        QVERIFY(mesh.hasVertex(id) && identical(mesh.vertex(id), before.vertex(id)));
        ++stayed;
    }
    QCOMPARE(stayed, before.vertexCount() / 3);
    // And where nothing crosses nothing is written.
    const SimplexMesh sound = mesh;
    SimplexMeshEdit nothing(mesh);
    const Result<LaidAnew> laid = layCrossingsAnew(nothing, grid(), Progress());
    QVERIFY(laid.has_value());
    QCOMPARE(laid->before + laid->parts, std::size_t(0));
    QVERIFY(nothing.commit().empty());
    QVERIFY(identical(mesh, sound));
}

void CrossingPartsTest::aHollowIsLaidWithWhatItIsIn()
{
    // A small ball stands in the wall of a hollow.
    SimplexMesh mesh = test::simplexMesh(test::together(
        test::together(test::icosphere(20.0, 3), turnedOver(test::icosphere(9.0, 3))),
        test::moved(test::icosphere(4.0, 2), {8.5, 0.2, 0.1})));
    const SimplexMesh before = mesh;
    SimplexMeshEdit edit(mesh);
    const Result<LaidAnew> laid = layCrossingsAnew(edit, grid(), Progress());
    QVERIFY(laid.has_value());
    edit.commit();
    QVERIFY(laid->before > 0);
    QCOMPARE(laid->left, std::size_t(0));
    QCOMPARE(laid->parts, std::size_t(3));
    QVERIFY(selfIntersections(mesh, grid()).empty());
    QCOMPARE(test::eulerCharacteristics(mesh).size(), std::size_t(2));
    QCOMPARE(test::eulerCharacteristics(mesh), characteristicsOfVoxels(before));
    const double share = differingShare(before, mesh);
    qInfo("%.3f %% of the voxels differ", 100.0 * share);
    QVERIFY(share < 0.05);
}

/// Balls of any size anywhere: what crosses is laid, and what that meets.
void CrossingPartsTest::ballsAtRandom()
{
    auto random = test::Random(11);
    std::size_t crossings = 0;
    for (int trial = 0; trial < (test::longRun() ? 100 : 5); ++trial) {
        test::TriangleSurface balls;
        for (int i = 0; i < 6; ++i) {
            const glm::dvec3 middle{
                test::randomUnit(random), test::randomUnit(random), test::randomUnit(random)};
            balls = test::together(balls,
                test::moved(test::icosphere(1.5 + 5.0 * test::randomUnit(random), 2),
                    24.0 * (middle - 0.5)));
        }
        SimplexMesh mesh = test::simplexMesh(balls);
        const SimplexMesh before = mesh;
        SimplexMeshEdit edit(mesh);
        const Result<LaidAnew> laid = layCrossingsAnew(edit, grid(), Progress());
        QVERIFY(laid.has_value());
        const SimplexMeshDelta delta = edit.commit();
        QCOMPARE(laid->left, std::size_t(0));
        QVERIFY(selfIntersections(mesh, grid()).empty());
        QVERIFY(checkSimplexMesh(mesh));
        QVERIFY(differingShare(before, mesh) < 0.25);
        crossings += laid->before;
        SimplexMesh back = mesh;
        delta.undo(back);
        QVERIFY(identical(back, before));
    }
    QVERIFY(crossings > 0);
}

void CrossingPartsTest::whatEnclosesNoVoxelIsRefused()
{
    const test::TriangleSurface ball = test::icosphere(0.2, 1);
    SimplexMesh mesh = test::simplexMesh(
        test::together(test::moved(ball, {0.5, 0.5, 0.5}), test::moved(ball, {0.7, 0.52, 0.51})));
    const SimplexMesh before = mesh;
    QVERIFY(!selfIntersections(mesh, grid()).empty());
    SimplexMeshEdit edit(mesh);
    const Result<LaidAnew> laid = layCrossingsAnew(edit, grid(), Progress());
    QVERIFY(!laid && laid.error().code == ErrorCode::InvalidField);
    QVERIFY(edit.commit().empty());
    QVERIFY(identical(mesh, before));
}

void CrossingPartsTest::itIsAborted()
{
    SimplexMesh mesh = threeBalls();
    const SimplexMesh before = mesh;
    Progress progress;
    progress.cancel();
    SimplexMeshEdit edit(mesh);
    const Result<LaidAnew> laid = layCrossingsAnew(edit, grid(), progress);
    QVERIFY(!laid && laid.error().code == ErrorCode::Cancelled);
    QVERIFY(edit.commit().empty());
    QVERIFY(identical(mesh, before));
}

BURIN_TEST(CrossingPartsTest)

} // namespace crossingPartsTest

#include "CrossingPartsTest.moc"
