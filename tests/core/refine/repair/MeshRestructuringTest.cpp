// SPDX-License-Identifier: Apache-2.0
#include "core/refine/repair/MeshRestructuring.h"
#include "core/refine/mesh/SimplexDual.h"
#include "core/refine/mesh/SimplexOperations.h"
#include "core/refine/repair/FaceShape.h"
#include "tests/support/program/LongRun.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/SimplexShapes.h"

#include <QTest>

#include <algorithm>
#include <cmath>

namespace meshRestructuringTest {

namespace {

/// Everything looked at, until nothing more is done.
core::Restructured settle(
    core::SimplexMesh& mesh, const core::RestructuringSettings& settings, int rounds = 20)
{
    core::Restructured all;
    core::SimplexMeshEdit edit(mesh);
    for (int round = 0; round < rounds; ++round) {
        const core::Restructured done = core::restructure(edit, mesh.vertexIds(), settings);
        all.welded += done.welded;
        all.merged += done.merged;
        all.split += done.split;
        all.swapped += done.swapped;
        if (done.empty())
            break;
    }
    edit.commit();
    return all;
}

struct Spread {
    double least = 1e300;
    double most = 0.0;
    std::size_t elongated = 0; ///< more than restructuring lets be
};
Spread spreadOf(const core::SimplexMesh& mesh)
{
    Spread spread;
    for (const core::FaceId face : mesh.faceIds()) {
        const core::FaceShape shape = core::shapeOf(mesh, face);
        spread.least = std::min(spread.least, shape.areaMm2);
        spread.most = std::max(spread.most, shape.areaMm2);
        spread.elongated +=
            shape.elongation() > core::RestructuringSettings().greatestElongation ? 1U : 0U;
    }
    return spread;
}

} // namespace

/// The structure of a mesh follows its shape.
class MeshRestructuringTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void shapesOfFaces();
    void aGoodMeshIsLeftAlone();
    void largeFacesAreSplit();
    void smallFacesAreMerged();
    void longFacesAreSplit();
    void ringsAreEvened();
    void facesThatLookAwayAreJoined();
    void greenFacesStay();
    void stormsKeepTheSurfaceWhole();
};

void MeshRestructuringTest::shapesOfFaces()
{
    // A prism over a rectangle of 4 × 2.
    auto prism = core::SimplexMesh::make(
        {{0, 0, 0}, {4, 0, 0}, {4, 2, 0}, {0, 2, 0}, {0, 0, 1}, {4, 0, 1}, {4, 2, 1}, {0, 2, 1}},
        {{3, 2, 1, 0}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}});
    QVERIFY(prism.has_value());
    const core::FaceShape top = core::shapeOf(*prism, 1);
    QCOMPARE(top.areaMm2, 8.0);
    QCOMPARE(top.middleLps, glm::dvec3(2, 1, 1));
    QVERIFY(glm::distance(top.normalLps, glm::dvec3(0, 0, 1)) < 1e-12);
    QVERIFY(std::abs(std::abs(top.longWay.x) - 1.0) < 1e-12);
    QVERIFY(std::abs(top.elongation() - 2.0) < 1e-12);
    QVERIFY(std::abs(top.lengthMm - 4.0) < 1e-12);
    QVERIFY(glm::distance(core::shapeOf(*prism, 0).normalLps, glm::dvec3(0, 0, -1)) < 1e-12);
    QCOMPARE(core::areaVectorOf(*prism, 3), glm::dvec3(2, 0, 0));
    QVERIFY(core::lookAlike({1, 0, 0}, {5, 4.9, 0}));
    QVERIFY(!core::lookAlike({1, 0, 0}, {5, 5.1, 0}));
    QVERIFY(!core::lookAlike({1, 0, 0}, {-1, 0, 0}));
}

void MeshRestructuringTest::aGoodMeshIsLeftAlone()
{
    core::SimplexMesh ball = test::simplexSphere(50.0, 4);
    const core::SimplexMesh before = ball;
    const auto done = settle(ball, {.areaMm2 = core::meanFaceAreaMm2(ball)});
    QVERIFY(done.empty());
    QVERIFY(core::identical(ball, before));
}

void MeshRestructuringTest::largeFacesAreSplit()
{
    core::SimplexMesh ball = test::simplexSphere(50.0, 3);
    const double area = core::meanFaceAreaMm2(ball) / 6.0;
    const auto done = settle(ball, {.areaMm2 = area});
    QVERIFY(done.split > 400);
    QCOMPARE(test::eulerCharacteristics(ball), std::vector<int>{2});
    QVERIFY(spreadOf(ball).most < 2.2 * area + 1e-9);
}

void MeshRestructuringTest::smallFacesAreMerged()
{
    core::SimplexMesh ball = test::simplexSphere(50.0, 4);
    const double area = 6.0 * core::meanFaceAreaMm2(ball);
    const std::size_t faces = ball.faceCount();
    const auto done = settle(ball, {.areaMm2 = area});
    QVERIFY(done.merged > 1000);
    QVERIFY(ball.faceCount() < faces / 2);
    QCOMPARE(test::eulerCharacteristics(ball), std::vector<int>{2});
    QVERIFY(core::enclosedMm3(ball) > 0.95 * 4.0 / 3.0 * M_PI * 125000.0);
}

void MeshRestructuringTest::longFacesAreSplit()
{
    core::SimplexMesh ball = test::simplexSphere(50.0, 3);
    {
        core::SimplexMeshEdit edit(ball);
        for (const core::VertexId id : ball.vertexIds())
            edit.move(id, ball.position(id) * glm::dvec3(1, 1, 4));
        edit.commit();
    }
    const Spread before = spreadOf(ball);
    QVERIFY(before.elongated > 100);
    const auto done = settle(ball, {.areaMm2 = core::meanFaceAreaMm2(ball)});
    const Spread after = spreadOf(ball);
    QVERIFY(done.split > 100);
    QVERIFY2(after.elongated < 10, qPrintable(QString::number(after.elongated)));
    QCOMPARE(test::eulerCharacteristics(ball), std::vector<int>{2});
}

void MeshRestructuringTest::ringsAreEvened()
{
    auto random = test::Random(14);
    core::SimplexMesh ball = test::simplexSphere(50.0, 3);
    const auto unevenness = [&] {
        int sum = 0;
        for (const core::FaceId face : ball.faceIds()) {
            const int off = int(ball.ring(face).size()) - 6;
            sum += off * off;
        }
        return sum;
    };
    {
        core::SimplexMeshEdit edit(ball);
        for (int i = 0; i < 300; ++i) {
            const auto ids = ball.vertexIds();
            const core::VertexId id =
                ids[std::size_t(test::randomInt(random, 0, int(ids.size()) - 1))];
            core::swapEdge(edit, id, ball.neighbours(id)[0]);
        }
        edit.commit();
    }
    const int before = unevenness();
    core::RestructuringSettings settings{.areaMm2 = core::meanFaceAreaMm2(ball),
        .leastShare = 0.0,
        .greatestShare = 100.0,
        .greatestElongation = 1e9};
    const auto done = settle(ball, settings);
    QVERIFY(done.swapped > 20);
    QCOMPARE(done.split + done.merged, 0);
    QVERIFY2(unevenness() < before - 2 * done.swapped,
        qPrintable(QStringLiteral("%1 → %2").arg(before).arg(unevenness())));
    QCOMPARE(test::eulerCharacteristics(ball), std::vector<int>{2});
}

void MeshRestructuringTest::facesThatLookAwayAreJoined()
{
    core::SimplexMesh ball = test::simplexSphere(50.0, 3);
    const double area = core::meanFaceAreaMm2(ball);
    const core::FaceId face = 40;
    {
        // A face turned over: mirrored, it looks inwards.
        core::SimplexMeshEdit edit(ball);
        const core::FaceShape shape = core::shapeOf(ball, face);
        for (const core::VertexId id : ball.ring(face)) {
            const double along = glm::dot(ball.position(id) - shape.middleLps, shape.longWay);
            edit.move(id, ball.position(id) - 2.0 * along * shape.longWay);
        }
        edit.commit();
    }
    const auto done = settle(ball, {.areaMm2 = 2.0 * area});
    QVERIFY(done.welded > 0);
    QCOMPARE(test::eulerCharacteristics(ball), std::vector<int>{2});
}

void MeshRestructuringTest::greenFacesStay()
{
    core::SimplexMesh ball = test::simplexSphere(50.0, 3);
    std::vector<core::VertexId> green;
    {
        core::SimplexMeshEdit edit(ball);
        for (const core::VertexId id : ball.vertexIds()) {
            if (ball.position(id).z > 20.0) {
                edit.setMark(id, core::SurfaceMark::Green);
                green.push_back(id);
            }
        }
        edit.commit();
    }
    const core::SimplexMesh before = ball;
    for (const double share : {0.1, 8.0}) {
        const auto done = settle(ball, {.areaMm2 = share * core::meanFaceAreaMm2(ball)});
        QVERIFY(!done.empty());
        for (const core::VertexId id : green) {
            QVERIFY(core::identical(ball.vertex(id), before.vertex(id)));
            for (const core::FaceId face : ball.facesAt(id))
                QCOMPARE(ball.ring(face), before.ring(face));
        }
    }
    QCOMPARE(test::eulerCharacteristics(ball), std::vector<int>{2});
}

/// Whatever shape it is pulled into, and whatever is asked for.
void MeshRestructuringTest::stormsKeepTheSurfaceWhole()
{
    auto random = test::Random(77);
    core::SimplexMesh mesh = test::simplexMesh(test::together(
        test::icosphere(10.0, 1), test::moved(test::torus(8.0, 3.0, 9, 5), {30, 0, 0})));
    const core::SimplexMesh first = mesh;
    const double area = core::meanFaceAreaMm2(mesh);
    std::vector<core::SimplexMeshDelta> deltas;
    for (int step = 0; step < (test::longRun() ? 10000 : 500); ++step) {
        core::SimplexMeshEdit edit(mesh);
        std::vector<core::VertexId> some;
        for (const core::VertexId id : mesh.vertexIds()) {
            if (test::randomInt(random, 0, 9) > 0)
                continue;
            some.push_back(id);
            const glm::dvec3 aside = glm::dvec3{test::randomUnit(random), test::randomUnit(random),
                                         test::randomUnit(random)}
                - 0.5;
            edit.move(id, mesh.position(id) + 4.0 * aside);
        }
        const double share = mesh.vertexCount() > 2000 ? 8.0 : 0.3 + 2.0 * test::randomUnit(random);
        const auto done = core::restructure(edit, some, {.areaMm2 = share * area});
        for (const core::VertexId id : done.vertices)
            QVERIFY(mesh.hasVertex(id));
        QCOMPARE(test::eulerCharacteristics(mesh), (std::vector<int>{0, 2}));
        deltas.push_back(edit.commit());
    }
    const core::SimplexMesh last = mesh;
    for (std::size_t i = deltas.size(); i-- > 0;)
        deltas[i].undo(mesh);
    QVERIFY(core::identical(mesh, first));
    for (const core::SimplexMeshDelta& delta : deltas)
        delta.redo(mesh);
    QVERIFY(core::identical(mesh, last));
}

BURIN_TEST(MeshRestructuringTest)

} // namespace meshRestructuringTest

#include "MeshRestructuringTest.moc"
