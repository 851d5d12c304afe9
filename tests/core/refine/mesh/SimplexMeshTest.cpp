// SPDX-License-Identifier: Apache-2.0
#include "core/refine/mesh/SimplexDual.h"
#include "core/refine/mesh/SimplexOperations.h"
#include "tests/support/program/LongRun.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/SimplexShapes.h"

#include <QTest>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

namespace simplexMeshTest {

namespace {

/// A ball and a ring beside it.
core::SimplexMesh ballAndRing()
{
    return test::simplexMesh(test::together(
        test::icosphere(10.0, 1), test::moved(test::torus(8.0, 3.0, 9, 5), {30, 0, 0})));
}

/// The sentence of why rings make no mesh.
QString refusal(std::size_t vertices, const std::vector<core::FaceRing>& rings)
{
    const auto mesh = core::SimplexMesh::make(std::vector<glm::dvec3>(vertices), rings);
    return mesh ? QString() : mesh.error().arguments.value(0);
}

} // namespace

/// Simplex meshes: what they are, their operations, and the way back.
class SimplexMeshTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void dualsAreClosed();
    void whatIsNone();
    void trianglesEncloseTheVolume();
    void mergeSplitAndSwap();
    void splitAndMergeAreInverse();
    void stormsKeepTheSurfaceWhole();
    void deltasLeadBackAndForth();
    void anEditThatIsLeftIsRolledBack();
    void whatIsGoneIsNotWritten();
    void whatWasWritten();
    void idsStayAndAreUsedAgain();
    void greenStays();
};

/// Who picked a vertex may still name it when it has been merged with another.
void SimplexMeshTest::whatIsGoneIsNotWritten()
{
    core::SimplexMesh mesh = test::simplexSphere(10.0, 2);
    core::SimplexMeshEdit edit(mesh);
    const core::VertexId picked = 7;
    for (const core::VertexId near : std::array(mesh.neighbours(picked))) {
        if (mesh.hasVertex(picked) && mesh.slotOf(picked, near) < 3)
            core::mergeFaces(edit, picked, near);
    }
    QVERIFY(!mesh.hasVertex(picked));
    const core::SimplexMesh before = mesh;
    edit.move(picked, {1.0, 2.0, 3.0});
    edit.setMark(picked, core::SurfaceMark::Green);
    edit.setMark(1'000'000, core::SurfaceMark::Red);
    QVERIFY(core::identical(mesh, before));
}

void SimplexMeshTest::dualsAreClosed()
{
    const core::SimplexMesh ball = test::simplexSphere(10.0, 2);
    QCOMPARE(ball.vertexCount(), std::size_t(320));
    QCOMPARE(ball.faceCount(), std::size_t(162));
    QCOMPARE(test::eulerCharacteristics(ball), std::vector<int>{2});
    QCOMPARE(test::eulerCharacteristics(ballAndRing()), (std::vector<int>{0, 2}));
    // Neighbours and faces stand around a vertex to the left, seen from outside.
    for (const core::VertexId id : ball.vertexIds()) {
        const auto& near = ball.neighbours(id);
        const glm::dvec3 at = ball.position(id);
        QVERIFY(glm::dot(at,
                    glm::cross(ball.position(near[1]) - ball.position(near[0]),
                        ball.position(near[2]) - ball.position(near[0])))
            > 0.0);
    }
}

void SimplexMeshTest::whatIsNone()
{
    const std::vector<core::FaceRing> tetrahedron{{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}};
    QCOMPARE(refusal(4, tetrahedron), QString());
    auto open = tetrahedron;
    open.pop_back();
    QVERIFY(refusal(4, open).contains(QLatin1String("fewer than three faces")));
    QVERIFY(refusal(5, tetrahedron).contains(QLatin1String("fewer than three faces")));
    auto twice = tetrahedron;
    twice.push_back({0, 1, 2});
    QVERIFY(refusal(4, twice).contains(QLatin1String("more than three faces")));
    auto turned = tetrahedron;
    turned[1] = {0, 1, 3};
    QVERIFY(refusal(4, turned).contains(QLatin1String("do not close")));
    QVERIFY(refusal(4, {{0, 1}}).contains(QLatin1String("fewer than three vertices")));
    QVERIFY(refusal(3, tetrahedron).contains(QLatin1String("not there")));
    // A cushion of two triangles: three faces of two vertices each.
    const std::vector<glm::dvec3> corners{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    const std::vector<glm::uvec3> cushion{{0, 1, 2}, {0, 2, 1}};
    QVERIFY(!core::dualOf(corners, cushion));
    // Two faces that share two edges: a necklace of two squares and two slices between.
    QVERIFY(refusal(4, {{0, 1, 2, 3}, {3, 2, 1, 0}}).contains(QLatin1String("fewer than three")));
    const std::vector<core::FaceRing> necklace{
        {0, 1, 2, 4, 5, 6}, {0, 6, 7, 4, 3, 2}, {0, 2, 1}, {4, 6, 5}};
    QVERIFY(!refusal(8, necklace).isEmpty());
    auto nowhere = std::vector<glm::dvec3>(4);
    nowhere[2].y = std::nan("");
    const auto lost = core::SimplexMesh::make(nowhere, tetrahedron);
    QVERIFY(!lost && lost.error().arguments.value(0).contains(QLatin1String("nowhere")));
    // Two tetrahedra of triangles that share a corner: its triangles are two fans.
    const std::vector<glm::uvec3> pinched{
        {0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}, {0, 5, 4}, {0, 4, 6}, {4, 5, 6}, {0, 6, 5}};
    const auto dual = core::dualOf(std::vector<glm::dvec3>(7), pinched);
    QVERIFY(!dual && dual.error().arguments.value(0).contains(QLatin1String("point 0")));
}

void SimplexMeshTest::trianglesEncloseTheVolume()
{
    const core::SimplexMesh ball = test::simplexSphere(10.0, 4);
    const double whole = 4.0 / 3.0 * M_PI * 1000.0;
    QVERIFY(std::abs(core::enclosedMm3(ball) / whole - 1.0) < 0.01);
    const core::SimplexTriangles surface = core::trianglesOf(ball);
    QCOMPARE(surface.triangles.size(), 3 * ball.vertexCount());
    QCOMPARE(surface.faces.size(), surface.triangles.size());
    // Closed: each edge once in both directions.
    std::set<std::pair<std::uint32_t, std::uint32_t>> edges;
    for (const glm::uvec3& triangle : surface.triangles) {
        for (int i = 0; i < 3; ++i)
            QVERIFY(edges.insert({triangle[i], triangle[(i + 1) % 3]}).second);
    }
    for (const auto& [from, to] : edges)
        QVERIFY(edges.count({to, from}) == 1);
}

void SimplexMeshTest::mergeSplitAndSwap()
{
    core::SimplexMesh mesh = test::simplexSphere(10.0, 1);
    const core::VertexId from = 7;
    const core::VertexId to = mesh.neighbours(from)[1];
    const auto around = core::surroundingsOf(mesh, from, to);
    const auto size = [&](core::FaceId face) { return mesh.ring(face).size(); };
    const std::size_t left = size(around.left);
    const std::size_t right = size(around.right);
    const std::size_t ahead = size(around.ahead);
    const std::size_t behind = size(around.behind);
    {
        core::SimplexMeshEdit edit(mesh);
        QVERIFY(core::swapEdge(edit, from, to));
        QCOMPARE(size(around.left), left - 1);
        QCOMPARE(size(around.right), right - 1);
        QCOMPARE(size(around.ahead), ahead + 1);
        QCOMPARE(size(around.behind), behind + 1);
        QCOMPARE(test::eulerCharacteristics(mesh), std::vector<int>{2});
        QVERIFY(!core::swapEdge(edit, from, to) || size(around.left) == left);
    }
    {
        core::SimplexMeshEdit edit(mesh);
        QVERIFY(core::mergeFaces(edit, from, to));
        QCOMPARE(size(around.left), left + right - 4);
        QCOMPARE(size(around.behind), behind - 1);
        QCOMPARE(mesh.vertexCount(), std::size_t(78));
        QCOMPARE(mesh.faceCount(), std::size_t(41));
        QCOMPARE(test::eulerCharacteristics(mesh), std::vector<int>{2});
    }
    {
        core::SimplexMeshEdit edit(mesh);
        const auto added = core::splitFace(edit, around.left, 1, 3);
        QVERIFY(added.has_value());
        QCOMPARE(mesh.vertexCount(), std::size_t(82));
        QCOMPARE(mesh.faceCount(), std::size_t(43));
        QCOMPARE(size(around.left), left);
        QCOMPARE(size(core::FaceId(42)), std::size_t(4));
        QCOMPARE(test::eulerCharacteristics(mesh), std::vector<int>{2});
        QVERIFY(!core::splitFace(edit, around.left, 2, 2));
    }
    // A tetrahedron is the least there is.
    auto least = core::SimplexMesh::make(
        {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}});
    QVERIFY(least.has_value());
    core::SimplexMeshEdit edit(*least);
    for (const core::VertexId other : {1U, 2U, 3U}) {
        QVERIFY(!core::mergeFaces(edit, 0, other));
        QVERIFY(!core::swapEdge(edit, 0, other));
    }
}

void SimplexMeshTest::splitAndMergeAreInverse()
{
    core::SimplexMesh mesh = ballAndRing();
    const core::VertexId vertices = mesh.vertexSlots();
    const std::size_t faces = mesh.faceCount();
    auto random = test::Random(3);
    for (int trial = 0; trial < 50; ++trial) {
        const auto face = core::FaceId(test::randomInt(random, 0, int(mesh.faceSlots()) - 1));
        const auto first = std::size_t(test::randomInt(random, 0, int(mesh.ring(face).size()) - 2));
        const auto added = [&] {
            core::SimplexMeshEdit edit(mesh);
            const auto made = core::splitFace(edit, face, first, mesh.ring(face).size() - 1);
            edit.commit();
            return made;
        }();
        QVERIFY(added.has_value());
        core::SimplexMeshEdit edit(mesh);
        QVERIFY(core::mergeFaces(edit, added->at(0), added->at(1)));
        edit.commit();
    }
    QCOMPARE(mesh.vertexSlots(), vertices);
    QCOMPARE(mesh.faceCount(), faces);
    QCOMPARE(test::eulerCharacteristics(mesh), (std::vector<int>{0, 2}));
}

void SimplexMeshTest::stormsKeepTheSurfaceWhole()
{
    auto random = test::Random(11);
    core::SimplexMesh mesh = ballAndRing();
    const int steps = test::longRun() ? 10000 : 1000;
    int done = 0;
    core::SimplexMeshEdit edit(mesh);
    for (int step = 0; step < steps; ++step) {
        done += test::randomOperation(edit, random) ? 1 : 0;
        QCOMPARE(test::eulerCharacteristics(mesh), (std::vector<int>{0, 2}));
    }
    QVERIFY(done > steps / 4);
    edit.commit();
}

void SimplexMeshTest::deltasLeadBackAndForth()
{
    auto random = test::Random(5);
    core::SimplexMesh mesh = ballAndRing();
    std::vector<core::SimplexMesh> states{mesh};
    std::vector<core::SimplexMeshDelta> deltas;
    for (int entry = 0; entry < (test::longRun() ? 500 : 60); ++entry) {
        core::SimplexMeshEdit edit(mesh);
        for (int i = test::randomInt(random, 0, 12); i > 0; --i) {
            test::randomOperation(edit, random);
            const auto ids = mesh.vertexIds();
            const core::VertexId id =
                ids[std::size_t(test::randomInt(random, 0, int(ids.size()) - 1))];
            edit.move(id, mesh.position(id) + glm::dvec3(test::randomUnit(random), -0.0, 1e-300));
            edit.setMark(id, i % 2 == 0 ? core::SurfaceMark::Red : core::SurfaceMark::Yellow);
        }
        deltas.push_back(edit.commit());
        states.push_back(mesh);
    }
    for (std::size_t i = deltas.size(); i-- > 0;) {
        deltas[i].undo(mesh);
        QVERIFY(core::identical(mesh, states[i]));
        QCOMPARE(mesh.vertexCount(), states[i].vertexCount());
        QCOMPARE(mesh.faceCount(), states[i].faceCount());
    }
    for (std::size_t i = 0; i < deltas.size(); ++i) {
        deltas[i].redo(mesh);
        QVERIFY(core::identical(mesh, states[i + 1]));
    }
    // What comes after going back is what came after the first time: free ids are part of it.
    deltas.back().undo(mesh);
    auto one = test::Random(9);
    auto other = test::Random(9);
    core::SimplexMesh before = states[states.size() - 2];
    core::SimplexMeshEdit edit(mesh);
    core::SimplexMeshEdit again(before);
    for (int i = 0; i < 50; ++i)
        QCOMPARE(test::randomOperation(edit, one), test::randomOperation(again, other));
    edit.commit();
    again.commit();
    QVERIFY(core::identical(mesh, before));
}

void SimplexMeshTest::anEditThatIsLeftIsRolledBack()
{
    auto random = test::Random(6);
    core::SimplexMesh mesh = ballAndRing();
    const core::SimplexMesh before = mesh;
    {
        core::SimplexMeshEdit edit(mesh);
        for (int i = 0; i < 100; ++i)
            test::randomOperation(edit, random);
        QVERIFY(!core::identical(mesh, before));
    }
    QVERIFY(core::identical(mesh, before));
    // What is moved and moved back is no change; another zero is one.
    core::SimplexMeshEdit edit(mesh);
    edit.move(3, {1, 2, 3});
    edit.move(3, before.position(3));
    edit.setMark(4, core::SurfaceMark::Red);
    edit.setMark(4, core::SurfaceMark::Yellow);
    QVERIFY(edit.commit().empty());
    core::SimplexMeshEdit zero(mesh);
    zero.move(3, {0.0, 0.0, 0.0});
    QCOMPARE(zero.commit().vertices.size(), std::size_t(1));
    core::SimplexMeshEdit minus(mesh);
    minus.move(3, {-0.0, 0.0, 0.0});
    QCOMPARE(minus.commit().vertices.size(), std::size_t(1));
}

void SimplexMeshTest::whatWasWritten()
{
    auto random = test::Random(12);
    core::SimplexMesh mesh = ballAndRing();
    core::SimplexMesh drawn = mesh;
    core::SimplexMeshEdit edit(mesh);
    QVERIFY(edit.takeWritten().vertices.empty());
    for (int round = 0; round < 30; ++round) {
        for (int i = 0; i < 5; ++i)
            test::randomOperation(edit, random);
        edit.move(mesh.vertexIds().back(), {round, 1, 2});
        const core::WrittenParts written = edit.takeWritten();
        QVERIFY(std::is_sorted(written.vertices.begin(), written.vertices.end()));
        // Nothing else is other than it was drawn.
        for (core::VertexId id = 0; id < std::max(mesh.vertexSlots(), drawn.vertexSlots()); ++id) {
            if (std::binary_search(written.vertices.begin(), written.vertices.end(), id))
                continue;
            QCOMPARE(mesh.hasVertex(id), drawn.hasVertex(id));
            QVERIFY(!mesh.hasVertex(id) || core::identical(mesh.vertex(id), drawn.vertex(id)));
        }
        for (core::FaceId id = 0; id < std::max(mesh.faceSlots(), drawn.faceSlots()); ++id) {
            if (std::binary_search(written.faces.begin(), written.faces.end(), id))
                continue;
            QCOMPARE(mesh.hasFace(id), drawn.hasFace(id));
            QVERIFY(!mesh.hasFace(id) || mesh.ring(id) == drawn.ring(id));
        }
        QVERIFY(written.vertices.size() < 60);
        QVERIFY(edit.takeWritten().faces.empty());
        drawn = mesh;
    }
    edit.commit();
}

void SimplexMeshTest::idsStayAndAreUsedAgain()
{
    core::SimplexMesh mesh = test::simplexSphere(10.0, 1);
    const core::SimplexMesh before = mesh;
    core::SimplexMeshEdit edit(mesh);
    const core::VertexId from = 20;
    const core::VertexId to = mesh.neighbours(from)[0];
    const core::FaceId gone = core::surroundingsOf(mesh, from, to).right;
    QVERIFY(core::mergeFaces(edit, from, to));
    QVERIFY(!mesh.hasVertex(from) && !mesh.hasVertex(to) && !mesh.hasFace(gone));
    QCOMPARE(mesh.vertexCount(), before.vertexCount() - 2);
    for (const core::VertexId id : mesh.vertexIds())
        QCOMPARE(mesh.position(id), before.position(id));
    const auto added = core::splitFace(edit, mesh.faceIds().front(), 0, 2);
    QVERIFY(added.has_value());
    QCOMPARE(added->at(0), std::min(from, to));
    QCOMPARE(added->at(1), std::max(from, to));
    QVERIFY(mesh.hasFace(gone));
    edit.commit();
}

void SimplexMeshTest::greenStays()
{
    auto random = test::Random(8);
    core::SimplexMesh mesh = ballAndRing();
    std::vector<core::VertexId> green;
    {
        core::SimplexMeshEdit edit(mesh);
        for (const core::VertexId id : mesh.vertexIds()) {
            if (mesh.position(id).z > 2.0) {
                edit.setMark(id, core::SurfaceMark::Green);
                green.push_back(id);
            }
        }
        edit.commit();
    }
    QVERIFY(green.size() > 30);
    const core::SimplexMesh before = mesh;
    core::SimplexMeshEdit edit(mesh);
    int done = 0;
    for (int step = 0; step < (test::longRun() ? 10000 : 1000); ++step) {
        done += test::randomOperation(edit, random) ? 1 : 0;
        const core::VertexId id = green[std::size_t(step) % green.size()];
        edit.move(id, {1, 2, 3});
        for (const core::VertexId locked : green) {
            QVERIFY(mesh.hasVertex(locked));
            QVERIFY(core::identical(mesh.vertex(locked), before.vertex(locked)));
            for (const core::FaceId face : mesh.facesAt(locked))
                QCOMPARE(mesh.ring(face), before.ring(face));
        }
    }
    QVERIFY(done > 50);
    edit.commit();
}

BURIN_TEST(SimplexMeshTest)

} // namespace simplexMeshTest

#include "SimplexMeshTest.moc"
