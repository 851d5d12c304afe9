// SPDX-License-Identifier: Apache-2.0
#include "core/refine/repair/CrossingGuard.h"
#include "core/refine/mesh/SimplexOperations.h"
#include "core/refine/repair/MeshRestructuring.h"
#include "core/refine/repair/SelfIntersections.h"
#include "tests/support/program/LongRun.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/SimplexShapes.h"

#include <QTest>

#include <algorithm>
#include <set>

namespace crossingGuardTest {

namespace {

core::VolumeGeometry grid()
{
    core::VolumeGeometry geometry;
    geometry.size = {100, 100, 100};
    geometry.indexToWorld[3] = glm::dvec4(-50.0, -50.0, -50.0, 1.0);
    return geometry;
}

glm::dvec3 randomWay(test::Random& random, double lengthMm)
{
    return lengthMm
        * (glm::dvec3{test::randomUnit(random), test::randomUnit(random), test::randomUnit(random)}
            - 0.5);
}

/// A ball beside a torus, close to each other.
core::SimplexMesh ballAndTorus()
{
    return test::simplexMesh(test::together(
        test::icosphere(10.0, 2), test::moved(test::torus(8.0, 3.0, 18, 9), {21.5, 1, 0})));
}

/// Two balls that pass through each other.
core::SimplexMesh crossingBalls()
{
    return test::simplexMesh(test::together(
        test::icosphere(10.0, 2), test::moved(test::icosphere(10.0, 2), {13, 0.3, 0.2})));
}

/// Which pairs may cross: those that do at first, until a change of structure parts them.
class AllowedCrossings {
public:
    AllowedCrossings(const core::SimplexMesh& mesh, const core::VolumeGeometry& geometry)
        : m_mesh(mesh)
        , m_geometry(geometry)
        , m_allowed(core::selfIntersections(mesh, geometry))
        , m_before(mesh)
    {
    }

    void beforeChange() { m_before = m_mesh; }
    void afterChange()
    {
        const auto present = core::selfIntersections(m_mesh, m_geometry);
        std::erase_if(m_allowed, [&](const core::CrossingFaces& pair) {
            return (isChanged(pair.one) || isChanged(pair.other))
                && !std::binary_search(present.begin(), present.end(), pair);
        });
    }
    [[nodiscard]] const std::vector<core::CrossingFaces>& pairs() const { return m_allowed; }
    [[nodiscard]] bool hold() const
    {
        const auto present = core::selfIntersections(m_mesh, m_geometry);
        return std::includes(m_allowed.begin(), m_allowed.end(), present.begin(), present.end());
    }

private:
    [[nodiscard]] bool isChanged(core::FaceId face) const
    {
        return !m_mesh.hasFace(face) || !m_before.hasFace(face)
            || m_mesh.ring(face) != m_before.ring(face);
    }

    const core::SimplexMesh& m_mesh;
    const core::VolumeGeometry& m_geometry;
    std::vector<core::CrossingFaces> m_allowed;
    core::SimplexMesh m_before;
};

/// Moves every vertex at random, as far as the guard allows.
void shake(core::SimplexMeshEdit& edit, core::CrossingGuard& guard, test::Random& random)
{
    const std::vector<core::VertexId> ids = edit.mesh().vertexIds();
    for (const core::VertexId id : ids)
        edit.move(id, edit.mesh().position(id) + randomWay(random, 0.5));
    guard.moved(ids);
    guard.moved(ids);
    static_cast<void>(guard.keepApart(edit));
}

} // namespace

/// A surface that is moved at random, and kept from passing through itself.
class CrossingGuardTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void theGridFindsWhatAFullSearchFinds();
    void theGridStandsFacesThatGrow();
    void movesAreShortened();
    void changesOfStructureAreRefused();
    void whatCrossedBeforeMayStay();
    void aNewFaceOfAnOldIdMayNotCross();
    void aTrialIsTakenBack();
};

void CrossingGuardTest::theGridFindsWhatAFullSearchFinds()
{
    const core::VolumeGeometry geometry = grid();
    auto random = test::Random(3);
    core::SimplexMesh mesh = ballAndTorus();
    core::FaceGrid faces(mesh, geometry);
    std::size_t crossings = 0;
    for (int round = 0; round < (test::longRun() ? 300 : 20); ++round) {
        // A few vertices move, some of them far.
        std::vector<core::FaceId> changed;
        core::SimplexMeshEdit edit(mesh);
        for (int i = 0; i < 12; ++i) {
            const auto id = core::VertexId(test::randomInt(random, 0, int(mesh.vertexSlots()) - 1));
            edit.move(id, mesh.position(id) + randomWay(random, i == 0 ? 20.0 : 3.0));
            changed.insert(changed.end(), mesh.facesAt(id).begin(), mesh.facesAt(id).end());
        }
        edit.commit();
        std::sort(changed.begin(), changed.end());
        changed.erase(std::unique(changed.begin(), changed.end()), changed.end());
        faces.refresh(changed);
        const auto expected = core::selfIntersections(mesh, geometry);
        QVERIFY(faces.crossingsOf(mesh.faceIds()) == expected);
        auto ofChanged = expected;
        std::erase_if(ofChanged, [&](const core::CrossingFaces& pair) {
            return !std::binary_search(changed.begin(), changed.end(), pair.one)
                && !std::binary_search(changed.begin(), changed.end(), pair.other);
        });
        QVERIFY(faces.crossingsOf(changed) == ofChanged);
        crossings += expected.size();
    }
    QVERIFY(crossings > 100);
}

void CrossingGuardTest::theGridStandsFacesThatGrow()
{
    const core::VolumeGeometry geometry = grid();
    auto random = test::Random(8);
    core::SimplexMesh mesh = ballAndTorus();
    core::FaceGrid faces(mesh, geometry);
    std::size_t crossings = 0;
    for (int round = 0; round < 10; ++round) {
        core::SimplexMeshEdit edit(mesh);
        for (const core::VertexId id : mesh.vertexIds())
            edit.move(id, 1.4 * mesh.position(id) + randomWay(random, 5.0));
        edit.commit();
        faces.refresh(mesh.faceIds());
        const auto expected = core::selfIntersections(mesh, geometry);
        QVERIFY(faces.crossingsOf(mesh.faceIds()) == expected);
        crossings += expected.size();
    }
    QVERIFY(crossings > 0);
}

void CrossingGuardTest::movesAreShortened()
{
    const core::VolumeGeometry geometry = grid();
    auto random = test::Random(4);
    core::SimplexMesh mesh = ballAndTorus();
    QVERIFY(core::selfIntersections(mesh, geometry).empty());
    core::CrossingGuard guard(mesh, geometry);
    core::SimplexMeshEdit edit(mesh);
    std::size_t shortened = 0;
    std::size_t whole = 0;
    for (int round = 0; round < (test::longRun() ? 1000 : 60); ++round) {
        std::vector<core::VertexId> ids = mesh.vertexIds();
        std::erase_if(ids, [&](core::VertexId) { return test::randomInt(random, 0, 3) != 0; });
        const core::SimplexMesh before = mesh;
        for (const core::VertexId id : ids)
            edit.move(id, mesh.position(id) + randomWay(random, 2.0));
        const core::SimplexMesh wanted = mesh;
        guard.moved(ids);
        QVERIFY(guard.movedMm() > 0.0);
        const auto stopped = guard.keepApart(edit);
        QCOMPARE(guard.movedMm(), 0.0);
        QVERIFY(core::selfIntersections(mesh, geometry).empty());
        for (const core::VertexId id : ids) {
            const bool isStopped = std::binary_search(stopped.begin(), stopped.end(), id);
            QCOMPARE(mesh.position(id) == wanted.position(id), !isStopped);
            const double way = glm::distance(before.position(id), wanted.position(id));
            QVERIFY(glm::distance(before.position(id), mesh.position(id))
                <= (isStopped ? 0.51 : 1.01) * way);
        }
        shortened += stopped.size();
        whole += ids.size() - stopped.size();
    }
    qInfo("%zu moves shortened, %zu not", shortened, whole);
    QVERIFY(shortened > 0 && whole > 0);
}

void CrossingGuardTest::changesOfStructureAreRefused()
{
    const core::VolumeGeometry geometry = grid();
    auto random = test::Random(5);
    core::SimplexMesh mesh = ballAndTorus();
    const std::vector<int> parts = test::eulerCharacteristics(mesh);
    core::CrossingGuard guard(mesh, geometry);
    core::SimplexMeshEdit edit(mesh);
    int refused = 0;
    int carriedOut = 0;
    for (int round = 0; round < (test::longRun() ? 400 : 40); ++round) {
        std::vector<core::VertexId> ids = mesh.vertexIds();
        for (const core::VertexId id : ids)
            edit.move(id, mesh.position(id) + randomWay(random, 1.0));
        guard.moved(ids);
        static_cast<void>(guard.keepApart(edit));
        for (int i = 0; i < 30; ++i) {
            const core::SimplexMesh before = mesh;
            const bool isDone =
                guard.attempt(edit, [&] { return test::randomOperation(edit, random); });
            (isDone ? carriedOut : refused) += 1;
            QCOMPARE(core::identical(mesh, before), !isDone);
        }
        core::restructure(edit, mesh.vertexIds(), {.areaMm2 = core::meanFaceAreaMm2(mesh)}, &guard);
        QVERIFY(core::selfIntersections(mesh, geometry).empty());
        QCOMPARE(test::eulerCharacteristics(mesh), parts);
    }
    qInfo("%d changes carried out, %d refused", carriedOut, refused);
    QVERIFY(carriedOut > 0 && refused > 0);
}

void CrossingGuardTest::whatCrossedBeforeMayStay()
{
    const core::VolumeGeometry geometry = grid();
    core::SimplexMesh mesh = crossingBalls();
    AllowedCrossings allowed(mesh, geometry);
    QVERIFY(!allowed.pairs().empty());
    core::CrossingGuard guard(mesh, geometry);
    core::SimplexMeshEdit edit(mesh);
    auto random = test::Random(6);
    int changes = 0;
    for (int round = 0; round < (test::longRun() ? 200 : 20); ++round) {
        shake(edit, guard, random);
        QVERIFY(allowed.hold());
        allowed.beforeChange();
        const core::Restructured done = core::restructure(
            edit, mesh.vertexIds(), {.areaMm2 = core::meanFaceAreaMm2(mesh)}, &guard);
        changes += done.welded + done.merged + done.split + done.swapped;
        allowed.afterChange();
        QVERIFY(allowed.hold());
    }
    QVERIFY(changes > 0);
}

void CrossingGuardTest::aNewFaceOfAnOldIdMayNotCross()
{
    const core::VolumeGeometry geometry = grid();
    core::SimplexMesh mesh = crossingBalls();
    AllowedCrossings allowed(mesh, geometry);
    core::CrossingGuard guard(mesh, geometry);
    core::SimplexMeshEdit edit(mesh);
    auto random = test::Random(9);
    shake(edit, guard, random);
    const auto attempt = [&](const auto& change) {
        allowed.beforeChange();
        const bool isDone = guard.attempt(edit, change);
        if (isDone)
            allowed.afterChange();
        return isDone;
    };
    // Two faces become one, which is divided again: the second part has the id of the face that is
    // gone, and may lie where that crossed.
    int merged = 0;
    int refused = 0;
    const auto mergeAndSplit = [&](core::VertexId from, core::VertexId to) {
        const core::FaceId left = core::surroundingsOf(mesh, from, to).left;
        if (!attempt([&] { return core::mergeFaces(edit, from, to); }))
            return false;
        ++merged;
        const std::size_t corners = mesh.ring(left).size();
        for (std::size_t k = 0; k < corners; ++k) {
            if (attempt([&] {
                    return core::splitFace(edit, left, k, (k + corners / 2) % corners).has_value();
                }))
                break;
            ++refused;
        }
        return true;
    };
    std::set<core::FaceId> crossing;
    for (const core::CrossingFaces& pair : allowed.pairs())
        crossing.insert({pair.one, pair.other});
    for (const core::FaceId face : crossing) {
        for (std::size_t i = 0; mesh.hasFace(face) && i < mesh.ring(face).size(); ++i) {
            const core::FaceRing ring = mesh.ring(face);
            if (!mergeAndSplit(ring[i], ring[(i + 1) % ring.size()]))
                continue;
            QVERIFY(allowed.hold());
            break;
        }
    }
    qInfo("%d merged, %d splits refused", merged, refused);
    QVERIFY(merged > 0 && refused > 0);
}

void CrossingGuardTest::aTrialIsTakenBack()
{
    auto random = test::Random(7);
    core::SimplexMesh mesh = ballAndTorus();
    const core::SimplexMesh first = mesh;
    core::SimplexMeshEdit edit(mesh);
    int taken = 0;
    for (int i = 0; i < 400; ++i) {
        const core::SimplexMesh before = mesh;
        edit.beginTrial();
        const bool isDone = test::randomOperation(edit, random);
        if (i % 2 == 0) {
            edit.revertTrial();
            QVERIFY(core::identical(mesh, before));
            taken += isDone ? 1 : 0;
        } else {
            QCOMPARE(edit.trialFaces().empty(), !isDone);
            edit.keepTrial();
        }
    }
    QVERIFY(taken > 10);
    const core::SimplexMeshDelta delta = edit.commit();
    core::SimplexMesh back = mesh;
    delta.undo(back);
    QVERIFY(core::identical(back, first));
}

BURIN_TEST(CrossingGuardTest)

} // namespace crossingGuardTest

#include "CrossingGuardTest.moc"
