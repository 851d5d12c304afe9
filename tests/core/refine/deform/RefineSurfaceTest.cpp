// SPDX-License-Identifier: Apache-2.0
#include "core/refine/deform/RefineSurface.h"
#include "core/refine/mesh/SimplexDual.h"
#include "core/refine/mesh/SimplexMeshEdit.h"
#include "core/refine/repair/FaceThinning.h"
#include "core/refine/repair/SelfIntersections.h"
#include "tests/support/program/LongRun.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/ShapedMask.h"
#include "tests/support/scenes/SimplexShapes.h"

#include <QTest>

#include <cmath>

namespace refineSurfaceTest {

namespace {

core::SimplexMesh surfaceOf(const test::ShapedMask& shape, int vertices)
{
    auto mesh = core::refineSurfaceOf(shape.mask(), shape.geometry, vertices, {});
    if (!mesh)
        qFatal("%s", qPrintable(mesh.error().arguments.value(0)));
    return *std::move(mesh);
}

} // namespace

/// The first simplex mesh around a mask.
class RefineSurfaceTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void masksAsBits();
    void shapes_data();
    void shapes();
    void anyNumberOfVertices();
    void turnedAndMirroredGrids();
    void noiseIsClosed();
    void bordersCrossNowhere();
    void nothing();
    void thinningStopsAtGreenAndAtEdges();
};

void RefineSurfaceTest::masksAsBits()
{
    auto random = test::Random(1);
    test::ShapedMask shape({9, 8, 7});
    for (auto& label : shape.labels)
        label = test::randomInt(random, 0, 9) == 0 ? 1 : 3;
    const core::BoxMask mask = shape.mask();
    std::uint64_t count = 0;
    std::uint64_t faces = 0;
    for (int z = -2; z < 10; ++z) {
        for (int y = -2; y < 10; ++y) {
            for (int x = -2; x < 11; ++x) {
                const glm::ivec3 voxel(x, y, z);
                const bool isIn = shape.geometry.contains(voxel) && shape.at(x, y, z) == 1;
                QCOMPARE(mask.contains(voxel), isIn);
                count += isIn ? 1U : 0U;
                if (!shape.geometry.contains(voxel + glm::ivec3(1, 0, 0)))
                    continue;
                const bool isNext = shape.at(x + 1, y, z < 0 ? 0 : z) == 1;
                faces += shape.geometry.contains(voxel) && isIn != isNext ? 1U : 0U;
            }
        }
    }
    QCOMPARE(mask.voxelCount(), count);
    for (int z = 0; z < 7; ++z) {
        for (int y = 0; y < 8; ++y)
            faces += (shape.at(0, y, z) == 1 ? 1U : 0U) + (shape.at(8, y, z) == 1 ? 1U : 0U);
    }
    QCOMPARE(mask.borderFaces().x, faces);
    QVERIFY(core::BoxMask::of(core::VoxelRuns(), {3, 3, 3}).empty());
}

void RefineSurfaceTest::shapes_data()
{
    QTest::addColumn<QString>("shape");
    QTest::addColumn<std::vector<int>>("characteristics");
    QTest::newRow("a ball") << QStringLiteral("ball") << std::vector<int>{2};
    QTest::newRow("a ring") << QStringLiteral("ring") << std::vector<int>{0};
    QTest::newRow("a hollow ball") << QStringLiteral("hollow") << std::vector<int>{2, 2};
    QTest::newRow("a ball and a voxel") << QStringLiteral("voxel") << std::vector<int>{2, 2};
    QTest::newRow("two that touch at an edge") << QStringLiteral("edge") << std::vector<int>{2, 2};
    QTest::newRow("two that touch at a corner")
        << QStringLiteral("corner") << std::vector<int>{2, 2};
    QTest::newRow("a sheet of one voxel with a hole")
        << QStringLiteral("sheet") << std::vector<int>{0};
}

void RefineSurfaceTest::shapes()
{
    QFETCH(QString, shape);
    QFETCH(std::vector<int>, characteristics);
    test::ShapedMask made({34, 33, 32});
    const glm::dvec3 middle(16, 16.5, 15.5);
    made.fill([&](const glm::dvec3& at) {
        const double radius = glm::distance(at, middle);
        const double ring = glm::length(glm::dvec2(at - middle)) - 9.0;
        if (shape == QLatin1String("ball"))
            return radius < 12.0;
        if (shape == QLatin1String("ring"))
            return std::hypot(ring, at.z - middle.z) < 4.0;
        if (shape == QLatin1String("hollow"))
            return radius < 12.0 && radius > 6.0;
        if (shape == QLatin1String("voxel"))
            return radius < 8.0 || at == glm::dvec3(28, 28, 28);
        if (shape == QLatin1String("sheet"))
            return at.z == 15.0 && std::abs(at.x - 16.0) < 12.0 && std::abs(at.y - 16.0) < 12.0
                && (std::abs(at.x - 16.0) > 3.0 || std::abs(at.y - 16.0) > 3.0);
        const bool isLow = at.x < 13.0 && at.y < 13.0 && at.z < 13.0;
        const bool isHigh = at.x >= 13.0 && at.y >= 13.0
            && (shape == QLatin1String("edge") ? at.z < 13.0 : at.z >= 13.0) && at.x < 20.0
            && at.y < 20.0 && at.z < 20.0;
        return isLow || isHigh;
    });
    for (const int vertices : {600, 6000}) {
        const core::SimplexMesh mesh = surfaceOf(made, vertices);
        QCOMPARE(test::eulerCharacteristics(mesh), characteristics);
        const double voxels = double(made.voxels().voxelCount());
        const double enclosed = core::enclosedMm3(mesh);
        QVERIFY2(enclosed > 0.6 * voxels && enclosed < 1.05 * voxels,
            qPrintable(QStringLiteral("%1 of %2").arg(enclosed).arg(voxels)));
    }
}

void RefineSurfaceTest::anyNumberOfVertices()
{
    test::ShapedMask made({60, 60, 60});
    made.fill([](const glm::dvec3& at) { return glm::distance(at, glm::dvec3(30)) < 25.0; });
    for (const int vertices : {2'000, 10'000, 50'000}) {
        const std::size_t count = surfaceOf(made, vertices).vertexCount();
        QVERIFY2(count <= std::size_t(vertices) && count + 2 >= std::size_t(vertices),
            qPrintable(QString::number(count)));
    }
    // Three cells to a voxel are the finest.
    test::ShapedMask one({3, 3, 3});
    one.at(1, 1, 1) = 1;
    QCOMPARE(surfaceOf(one, 10'000).vertexCount(), std::size_t(6 * 9 * 2));
    // Voxels that are long are cut along their length first.
    test::ShapedMask tall({3, 3, 3}, {1, 1, 4});
    tall.at(1, 1, 1) = 1;
    QCOMPARE(surfaceOf(tall, 12).vertexCount(), std::size_t(12));
    QCOMPARE(surfaceOf(tall, 28).vertexCount(), std::size_t(28));
}

void RefineSurfaceTest::turnedAndMirroredGrids()
{
    test::ShapedMask made({30, 30, 12}, {1, 1, 2.5});
    made.fill([](const glm::dvec3& at) { return glm::distance(at, {14, 15, 13}) < 9.0; });
    const double whole = double(made.voxels().voxelCount()) * 2.5;
    for (const double sign : {1.0, -1.0}) {
        made.geometry.indexToWorld[0] = sign * glm::dvec4(0.6, 0.8, 0.0, 0.0);
        made.geometry.indexToWorld[1] = glm::dvec4(-0.8, 0.6, 0.0, 0.0);
        const double enclosed = core::enclosedMm3(surfaceOf(made, 4000));
        QVERIFY2(std::abs(enclosed / whole - 1.0) < 0.06, qPrintable(QString::number(enclosed)));
    }
}

void RefineSurfaceTest::noiseIsClosed()
{
    auto random = test::Random(4);
    for (int trial = 0; trial < (test::longRun() ? 300 : 20); ++trial) {
        test::ShapedMask made({test::randomInt(random, 1, 9), test::randomInt(random, 1, 8),
            test::randomInt(random, 1, 7)});
        const int share = test::randomInt(random, 5, 95);
        for (auto& label : made.labels)
            label = test::randomInt(random, 0, 99) < share ? 1 : 0;
        const core::SimplexMesh all = surfaceOf(made, 1);
        const core::SimplexMesh fine = surfaceOf(made, 4000);
        QCOMPARE(test::eulerCharacteristics(all), test::eulerCharacteristics(fine));
        QCOMPARE(all.vertexCount() == 0, made.voxels().empty());
    }
}

/// Whatever voxels it runs between, as it is laid and thinned out.
void RefineSurfaceTest::bordersCrossNowhere()
{
    const auto laidAround = [](const test::ShapedMask& made, int vertices) {
        return *core::borderSurfaceOf(made.mask(), made.geometry, vertices, {});
    };
    // Every corner of eight voxels, by itself and within others.
    for (int configuration = 1; configuration < 256; ++configuration) {
        for (const std::uint8_t around : {0, 1}) {
            test::ShapedMask made({4, 4, 4}, {1.0, 0.7, 2.5});
            made.labels.assign(made.labels.size(), around);
            for (int voxel = 0; voxel < 8; ++voxel)
                made.at(1 + (voxel & 1), 1 + ((voxel >> 1) & 1), 1 + (voxel >> 2)) =
                    std::uint8_t((configuration >> voxel) & 1);
            const core::SimplexMesh mesh = laidAround(made, 10'000);
            QVERIFY2(core::selfIntersections(mesh, made.geometry).empty(),
                qPrintable(QStringLiteral("corner %1").arg(configuration)));
            QVERIFY(!test::eulerCharacteristics(mesh).empty());
        }
    }
    auto random = test::Random(5);
    std::size_t thinner = 0;
    for (int trial = 0; trial < (test::longRun() ? 300 : 20); ++trial) {
        test::ShapedMask made({test::randomInt(random, 2, 9), test::randomInt(random, 2, 8),
                                  test::randomInt(random, 2, 7)},
            {1.0, 1.0, 0.5 * test::randomInt(random, 1, 6)});
        const int share = test::randomInt(random, 5, 95);
        for (auto& label : made.labels)
            label = test::randomInt(random, 0, 99) < share ? 1 : 0;
        const core::SimplexMesh all = laidAround(made, 100'000);
        const core::SimplexMesh few = laidAround(made, 1);
        for (const core::SimplexMesh& mesh : {all, few})
            QVERIFY2(core::selfIntersections(mesh, made.geometry).empty(),
                qPrintable(QStringLiteral("trial %1").arg(trial)));
        QCOMPARE(test::eulerCharacteristics(all), test::eulerCharacteristics(surfaceOf(made, 1)));
        QCOMPARE(test::eulerCharacteristics(few), test::eulerCharacteristics(all));
        const glm::u64vec3 faces = made.mask().borderFaces();
        QVERIFY(all.vertexCount() >= 2 * std::size_t(faces.x + faces.y + faces.z));
        thinner += all.vertexCount() - few.vertexCount();
    }
    QVERIFY(thinner > 0);
    QCOMPARE(laidAround(test::ShapedMask({3, 3, 3}), 100).vertexCount(), std::size_t(0));
}

void RefineSurfaceTest::nothing()
{
    QCOMPARE(surfaceOf(test::ShapedMask({3, 3, 3}), 10'000).vertexCount(), std::size_t(0));
    core::Progress progress;
    progress.cancel();
    test::ShapedMask made({4, 4, 4});
    made.at(1, 1, 1) = 1;
    const auto cancelled = core::refineSurfaceOf(made.mask(), made.geometry, 100, progress);
    QVERIFY(!cancelled && cancelled.error().code == core::ErrorCode::Cancelled);
}

void RefineSurfaceTest::thinningStopsAtGreenAndAtEdges()
{
    core::SimplexMesh ball = test::simplexSphere(10.0, 3);
    {
        core::SimplexMeshEdit edit(ball);
        for (const core::VertexId id : ball.vertexIds()) {
            if (ball.position(id).z > 0.0)
                edit.setMark(id, core::SurfaceMark::Green);
        }
        edit.commit();
    }
    std::vector<glm::dvec3> green;
    for (const core::VertexId id : ball.vertexIds()) {
        if (ball.mark(id) == core::SurfaceMark::Green)
            green.push_back(ball.position(id));
    }
    const auto thin = core::thinnedOut(ball, 100, {});
    QVERIFY(thin.has_value());
    QCOMPARE(test::eulerCharacteristics(*thin), std::vector<int>{2});
    QCOMPARE(std::size_t(thin->vertexSlots()), thin->vertexCount());
    QVERIFY(thin->vertexCount() < ball.vertexCount() * 2 / 3);
    std::vector<glm::dvec3> kept;
    for (const core::VertexId id : thin->vertexIds()) {
        if (thin->mark(id) == core::SurfaceMark::Green)
            kept.push_back(thin->position(id));
    }
    QVERIFY(kept == green);
    // A cube stays one with few.
    test::ShapedMask cube({12, 12, 12});
    cube.fill([](const glm::dvec3& at) { return at.x > 1 && at.y > 1 && at.z > 1; });
    const core::SimplexMesh least = surfaceOf(cube, 100);
    QVERIFY(core::enclosedMm3(least) > 900.0);
}

BURIN_TEST(RefineSurfaceTest)

} // namespace refineSurfaceTest

#include "RefineSurfaceTest.moc"
