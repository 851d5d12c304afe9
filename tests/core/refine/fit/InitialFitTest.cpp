// SPDX-License-Identifier: Apache-2.0
#include "core/refine/fit/InitialFit.h"
#include "core/masks/MaskOnVolume.h"
#include "core/refine/deform/BoundaryForce.h"
#include "core/refine/mesh/SimplexDual.h"
#include "core/refine/repair/FaceShape.h"
#include "core/refine/repair/SelfIntersections.h"
#include "core/refine/voxels/SurfaceVoxels.h"
#include "core/study/StudyLoader.h"
#include "tests/support/program/LongRun.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/ShapedMask.h"
#include "tests/support/scenes/SharedData.h"
#include "tests/support/scenes/SimplexShapes.h"

#include <QDir>
#include <QElapsedTimer>
#include <QTest>

#include <algorithm>
#include <cmath>

namespace initialFitTest {

namespace {

struct RoundTrip {
    std::uint64_t voxels = 0; ///< of the mask
    double drift = 0.0; ///< of their number, on the way to the surface and back
    double differing = 0.0; ///< share of voxels that are not the same
};

RoundTrip roundTrip(const core::SimplexMesh& mesh, const core::VolumeGeometry& geometry,
    const core::VoxelRuns& voxels)
{
    const auto back = core::voxelsOf(mesh, geometry, {});
    if (!back)
        qFatal("not filled");
    const auto count = double(voxels.voxelCount());
    const auto filled = double(back->voxelCount());
    const auto both = double(core::sharedVoxels(*back, voxels));
    return {.voxels = voxels.voxelCount(),
        .drift = filled / count - 1.0,
        .differing = (count + filled - 2.0 * both) / count};
}

/// How far a place is from the smooth boundary, mm: the least along many ways.
double farFromBoundary(const core::BoundaryForce& boundary, const glm::dvec3& placeLps)
{
    double least = 1e9;
    for (int x = -1; x <= 1; ++x) {
        for (int y = -1; y <= 1; ++y) {
            for (int z = -1; z <= 1; ++z) {
                if (x == 0 && y == 0 && z == 0)
                    continue;
                const auto off =
                    boundary.alongNormalMm(placeLps, glm::normalize(glm::dvec3(x, y, z)));
                least = std::min(least, std::abs(off.value_or(1e9)));
            }
        }
    }
    return least;
}

core::SimplexMesh fitted(const core::BoxMask& mask, const core::VolumeGeometry& geometry,
    const core::InitialFitSettings& settings)
{
    auto mesh = core::initialFit(mask, geometry, settings, {});
    if (!mesh)
        qFatal("%s", qPrintable(mesh.error().arguments.value(0)));
    return *std::move(mesh);
}

} // namespace

/// From a mask to its surface.
class InitialFitTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void shapes_data();
    void shapes();
    void aBallIsSmooth();
    void smallAndThinParts();
    void roughVessels();
    void theSameTwice();
    void masksOfOthers_data();
    void masksOfOthers();
    void nothing();
};

void InitialFitTest::shapes_data()
{
    QTest::addColumn<QString>("shape");
    QTest::addColumn<double>("slices");
    QTest::addColumn<std::vector<int>>("characteristics");
    const std::vector<int> one{2};
    QTest::newRow("a ball") << QStringLiteral("ball") << 1.0 << one;
    QTest::newRow("a small ball") << QStringLiteral("small") << 1.0 << one;
    QTest::newRow("a ball on slices of 3 mm") << QStringLiteral("ball") << 3.0 << one;
    QTest::newRow("a torus") << QStringLiteral("torus") << 1.0 << std::vector<int>{0};
    QTest::newRow("an ellipsoid") << QStringLiteral("ellipsoid") << 1.0 << one;
    QTest::newRow("two balls that touch") << QStringLiteral("touching") << 1.0 << one;
    QTest::newRow("two balls apart") << QStringLiteral("apart") << 1.0 << std::vector<int>{2, 2};
    QTest::newRow("a sheet of two voxels") << QStringLiteral("sheet") << 1.0 << one;
    QTest::newRow("a tilted sheet") << QStringLiteral("tilted") << 1.0 << one;
    QTest::newRow("a box") << QStringLiteral("box") << 1.0 << one;
}

void InitialFitTest::shapes()
{
    QFETCH(QString, shape);
    QFETCH(double, slices);
    QFETCH(std::vector<int>, characteristics);
    const glm::dvec3 middle(40.3, 39.6, 40.1);
    test::ShapedMask made({81, 81, int(81 / slices)}, {1, 1, slices});
    const auto ball = [&](const glm::dvec3& at, double x, double radius) {
        return glm::distance(at, middle + glm::dvec3(x, 0, 0)) < radius;
    };
    made.fill([&](const glm::dvec3& at) {
        const glm::dvec3 way = at - middle;
        if (shape == QLatin1String("ball"))
            return ball(at, 0, 20);
        if (shape == QLatin1String("small"))
            return ball(at, 0, 6);
        if (shape == QLatin1String("torus"))
            return std::hypot(glm::length(glm::dvec2(way)) - 25.0, way.z) < 8.0;
        if (shape == QLatin1String("ellipsoid"))
            return glm::length(way / glm::dvec3(30, 18, 12)) < 1.0;
        if (shape == QLatin1String("touching"))
            return ball(at, -14, 14) || ball(at, 14, 14);
        if (shape == QLatin1String("apart"))
            return ball(at, -16, 14.2) || ball(at, 16, 14.2);
        if (shape == QLatin1String("sheet"))
            return std::abs(way.x) < 30 && std::abs(way.y) < 22 && std::abs(way.z) < 1.0;
        if (shape == QLatin1String("tilted"))
            return std::abs(glm::dot(way, glm::normalize(glm::dvec3(0.3, 0.5, 1.0)))) < 1.1
                && glm::length(way) < 30.0;
        return std::abs(way.x) < 15 && std::abs(way.y) < 15 && std::abs(way.z) < 15;
    });
    const core::BoxMask mask = made.mask();
    QElapsedTimer timer;
    timer.start();
    const core::SimplexMesh mesh = fitted(mask, made.geometry, {.vertices = 12'000});
    const auto ms = timer.elapsed();
    QCOMPARE(test::eulerCharacteristics(mesh), characteristics);
    QVERIFY(core::selfIntersections(mesh, made.geometry).empty());
    const RoundTrip trip = roundTrip(mesh, made.geometry, made.voxels());
    const core::BoundaryForce boundary(mask, made.geometry, 4.0);
    double farthest = 0.0;
    for (const core::VertexId id : mesh.vertexIds())
        farthest = std::max(farthest, farFromBoundary(boundary, mesh.position(id)));
    qInfo("%zu vertices for %llu voxels: drift %+.3f %%, differing %.3f %%, at most %.3f mm off, "
          "%lld ms",
        mesh.vertexCount(), static_cast<unsigned long long>(trip.voxels), 100.0 * trip.drift,
        100.0 * trip.differing, farthest, static_cast<long long>(ms));
    QVERIFY(std::abs(trip.drift) < 0.005);
    QVERIFY(trip.differing < 0.01);
    QVERIFY(farthest < 0.25);
}

/// Its normals turn with the ball; the voxels' own faces are about 33 degrees off.
void InitialFitTest::aBallIsSmooth()
{
    test::ShapedMask made({60, 60, 60});
    const glm::dvec3 middle(29.4, 29.7, 30.2);
    made.fill([&](const glm::dvec3& at) { return glm::distance(at, middle) < 24.0; });
    const core::SimplexMesh mesh = fitted(made.mask(), made.geometry, {.vertices = 12'000});
    double turned = 0.0;
    double area = 0.0;
    for (const core::FaceId face : mesh.faceIds()) {
        const glm::dvec3 vector = core::areaVectorOf(mesh, face);
        const glm::dvec3 way = glm::normalize(core::middleOf(mesh, face) - made.lps(middle));
        const double size = glm::length(vector);
        turned += size * std::acos(std::min(1.0, glm::dot(vector / size, way)));
        area += size;
    }
    const double degrees = glm::degrees(turned / area);
    qInfo("mean angle between surface and ball: %.1f degrees", degrees);
    QVERIFY(degrees < 9.0);
}

void InitialFitTest::smallAndThinParts()
{
    test::ShapedMask made({60, 60, 60});
    made.fill([&](const glm::dvec3& at) {
        const glm::ivec3 voxel(at);
        return glm::distance(at, glm::dvec3(30)) < 18.0
            || (at.x > 50.0 && voxel.x % 4 == 0 && voxel.y % 4 == 0 && voxel.z % 4 == 0);
    });
    const core::SimplexMesh mesh = fitted(made.mask(), made.geometry, {.vertices = 10'000});
    QCOMPARE(roundTrip(mesh, made.geometry, made.voxels()).differing, 0.0);
    // A voxel, a rod and a sheet of one.
    for (const glm::ivec3& size :
        {glm::ivec3(1, 1, 1), glm::ivec3(30, 1, 1), glm::ivec3(30, 20, 1)}) {
        test::ShapedMask thin({40, 40, 40});
        thin.fill([&](const glm::dvec3& at) {
            return at.x > 4 && at.x < 5 + size.x && at.y > 6 && at.y < 7 + size.y && at.z > 9
                && at.z < 10 + size.z;
        });
        const core::SimplexMesh skin = fitted(thin.mask(), thin.geometry, {.vertices = 12'000});
        const RoundTrip trip = roundTrip(skin, thin.geometry, thin.voxels());
        QVERIFY2(trip.differing < 0.005, qPrintable(QString::number(trip.differing)));
        QCOMPARE(test::eulerCharacteristics(skin), std::vector<int>{2});
    }
}

/// Thin, winding and rough: restructuring and forces do not crumple what is only voxels wide.
void InitialFitTest::roughVessels()
{
    std::uint64_t voxels = 0;
    double differing = 0.0;
    for (int seed = 1; seed <= (test::longRun() ? 40 : 4); ++seed) {
        auto random = test::Random(unsigned(seed));
        test::ShapedMask made({60, 60, 60});
        const double radius = 0.9 + 0.15 * double(seed % 5);
        made.fill([&](const glm::dvec3& at) {
            for (int i = 0; i < 60; ++i) {
                const double t = i / 59.0;
                const glm::dvec3 place(30.0 + 20.0 * std::sin(5.0 * t + seed),
                    30.0 + 18.0 * std::cos(5.2 * t + seed), 8.0 + 44.0 * t);
                if (glm::distance(at, place) < radius)
                    return true;
            }
            return false;
        });
        const std::vector<std::uint8_t> smooth = made.labels;
        for (std::size_t i = 60 * 60; i + 60 * 60 < smooth.size(); ++i) {
            const int beside = smooth[i - 1] + smooth[i + 1] + smooth[i - 60] + smooth[i + 60]
                + smooth[i - 60 * 60] + smooth[i + 60 * 60];
            if (beside > 0 && test::randomInt(random, 0, 9) == 0)
                made.labels[i] = 1;
        }
        const core::SimplexMesh mesh = fitted(made.mask(), made.geometry, {.vertices = 12'000});
        const RoundTrip trip = roundTrip(mesh, made.geometry, made.voxels());
        voxels += trip.voxels;
        differing += trip.differing * double(trip.voxels);
    }
    qInfo("%.0f of %llu voxels differ", differing, static_cast<unsigned long long>(voxels));
    QVERIFY(differing < 0.005 * double(voxels));
}

void InitialFitTest::theSameTwice()
{
    test::ShapedMask made({30, 30, 30}, {1, 1, 1.3});
    made.fill([](const glm::dvec3& at) {
        return glm::distance(at, glm::dvec3(14, 15, 19)) < 10.0 || (at.x > 20 && at.y < 9);
    });
    const core::SimplexMesh one = fitted(made.mask(), made.geometry, {.vertices = 10'000});
    const core::SimplexMesh other = fitted(made.mask(), made.geometry, {.vertices = 10'000});
    QVERIFY(core::identical(one, other));
}

void InitialFitTest::masksOfOthers_data()
{
    QTest::addColumn<QString>("study");
    QTest::addColumn<QString>("file");
    QTest::newRow("organs of a body")
        << QStringLiteral("ct_3mm.nii.gz") << QStringLiteral("ct_3mm_labels.nii.gz");
    QTest::newRow("an aorta") << QStringLiteral("aorta/ct.nii.gz")
                              << QStringLiteral("aorta/aorta.nii.gz");
    QTest::newRow("a vertebra") << QStringLiteral("aorta/ct.nii.gz")
                                << QStringLiteral("aorta/vertebrae_T12.nii.gz");
}

/// Masks that a network made: the largest ones; with BURIN_LONG=1 all that are worth a surface.
void InitialFitTest::masksOfOthers()
{
    QFETCH(QString, study);
    QFETCH(QString, file);
    const test::SharedCase shared = test::sharedCase(QStringLiteral("ct_totalseg_body_3mm"));
    if (shared.source.isEmpty())
        QSKIP("no shared test data");
    const auto scanned = core::Study::scan(QDir(shared.source).filePath(study));
    QVERIFY(scanned.has_value());
    const auto loaded = scanned->load(scanned->listing().candidates().front()->key);
    QVERIFY(loaded.has_value());
    const core::VolumeGeometry& geometry = loaded->volume.geometry;
    auto mask = core::readMask(QDir(shared.source).filePath(file), loaded->volume, {});
    QVERIFY(mask.has_value());
    std::stable_sort(mask->segments.begin(), mask->segments.end(),
        [](const auto& a, const auto& b) { return a.voxels.voxelCount() > b.voxels.voxelCount(); });
    std::size_t most = test::longRun() ? mask->segments.size() : 4;
    double worst = 0.0;
    for (const core::MaskSegment& segment : mask->segments) {
        if (most-- == 0 || segment.voxels.voxelCount() < 500)
            break;
        const core::SimplexMesh mesh = fitted(
            core::BoxMask::of(segment.voxels, geometry.size), geometry, {.vertices = 12'000});
        QVERIFY(!test::eulerCharacteristics(mesh).empty());
        const std::size_t crossings = core::selfIntersections(mesh, geometry).size();
        const RoundTrip trip = roundTrip(mesh, geometry, segment.voxels);
        worst = std::max(worst, std::abs(trip.drift));
        qInfo("%s, %llu voxels: %zu vertices, drift %+.3f %%, differing %.3f %%, "
              "%zu crossings",
            qPrintable(segment.name), static_cast<unsigned long long>(trip.voxels),
            mesh.vertexCount(), 100.0 * trip.drift, 100.0 * trip.differing, crossings);
    }
    QVERIFY2(worst < 0.005, qPrintable(QString::number(worst)));
}

void InitialFitTest::nothing()
{
    test::ShapedMask made({5, 5, 5});
    QCOMPARE(fitted(made.mask(), made.geometry, {}).vertexCount(), std::size_t(0));
    made.at(2, 2, 2) = 1;
    core::Progress progress;
    progress.cancel();
    const auto cancelled = core::initialFit(made.mask(), made.geometry, {}, progress);
    QVERIFY(!cancelled && cancelled.error().code == core::ErrorCode::Cancelled);
}

BURIN_TEST(InitialFitTest)

} // namespace initialFitTest

#include "InitialFitTest.moc"
