// SPDX-License-Identifier: Apache-2.0
#include "core/morphology/planes/BetweenPlanes.h"

#include "core/edits/kinds/filling/SketchPlanes.h"
#include "core/morphology/planes/SketchedShape.h"
#include "core/volume/VolumeGeometry.h"
#include "tests/reference/filling/BetweenPlanes.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/program/TestProgram.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <random>
#include <vector>

namespace betweenPlanesTest {

namespace {

using core::DrawnPlane;
using Labels = std::vector<std::uint8_t>;
using Inside = std::function<bool(const glm::dvec3&)>; ///< of a body, by a place in LPS
using Planes = std::vector<DrawnPlane>;

const glm::dvec3 xAxis(1.0, 0.0, 0.0);
const glm::dvec3 yAxis(0.0, 1.0, 0.0);
const glm::dvec3 zAxis(0.0, 0.0, 1.0);

/// Voxels of 1 mm.
core::VolumeGeometry cube(int side)
{
    core::VolumeGeometry geometry;
    geometry.size = glm::ivec3(side);
    return geometry;
}

/// Somewhere, with its axes turned, and with voxels of any sides.
core::VolumeGeometry turnedGrid(std::mt19937& random)
{
    const auto below = [&](int limit) { return int(random() % std::uint32_t(limit)); };
    core::VolumeGeometry geometry;
    geometry.size = {12 + below(10), 12 + below(10), 10 + below(8)};
    const double angle = below(2) == 0 ? 0.0 : 0.1 * below(15);
    const double tilt = below(4) == 0 ? 0.2 : 0.0;
    const glm::dvec3 right(std::cos(angle), std::sin(angle), 0.0);
    const glm::dvec3 down(-std::sin(angle), std::cos(angle), 0.0);
    geometry.indexToWorld[0] = glm::dvec4(right * (0.5 + below(6) / 4.0), 0.0);
    geometry.indexToWorld[1] = glm::dvec4(down * (0.5 + below(6) / 4.0), 0.0);
    geometry.indexToWorld[2] = glm::dvec4((zAxis + tilt * down) * (0.5 + below(8) / 4.0), 0.0);
    geometry.indexToWorld[3] = glm::dvec4(-30.0 + below(60), 12.5, below(40), 1.0);
    return geometry;
}

template <class Visit> void forEachVoxel(const glm::ivec3& size, const Visit& visit)
{
    std::size_t at = 0;
    for (int z = 0; z < size.z; ++z) {
        for (int y = 0; y < size.y; ++y) {
            for (int x = 0; x < size.x; ++x, ++at)
                visit(glm::ivec3(x, y, z), at);
        }
    }
}

core::PlaneSketch sketchOf(const Planes& planes, const core::VolumeGeometry& geometry)
{
    return core::planeSketch(planes, geometry, QStringLiteral("planes")).value();
}

/// Draws on each plane where it cuts a body.
Labels cuts(const Inside& isIn, const core::PlaneSketch& sketch, const core::VolumeGeometry& grid)
{
    Labels labels(grid.voxelCount(), 0);
    forEachVoxel(grid.size, [&](const glm::ivec3& voxel, std::size_t at) {
        const bool isOnOne = std::any_of(
            sketch.planes.begin(), sketch.planes.end(), [&](const core::PlaneSketch::Plane& each) {
                return core::isOn(each, core::placeOf(each, voxel)[2]);
            });
        labels[at] = isOnOne && isIn(grid.toWorld(glm::dvec3(voxel))) ? 1 : 0;
    });
    return labels;
}

Labels filled(Labels labels, const core::PlaneSketch& sketch, const core::VolumeGeometry& geometry)
{
    const auto between =
        core::voxelsBetweenPlanes(labels, geometry.size, 1, sketch, core::Progress());
    for (const core::VoxelRun& run : between.value().runs())
        std::fill_n(labels.begin() + std::ptrdiff_t(run.first), run.count, std::uint8_t(1));
    return labels;
}

/// The Dice coefficient of what becomes of a body's cuts, and the body.
/// @param looked where to compare; null: everywhere
double diceOf(const Inside& body, const Planes& planes, const core::VolumeGeometry& geometry,
    const Inside& looked = {})
{
    const core::PlaneSketch sketch = sketchOf(planes, geometry);
    const Labels after = filled(cuts(body, sketch, geometry), sketch, geometry);
    double both = 0.0;
    double sum = 0.0;
    forEachVoxel(geometry.size, [&](const glm::ivec3& voxel, std::size_t at) {
        const glm::dvec3 place = geometry.toWorld(glm::dvec3(voxel));
        if (looked && !looked(place))
            return;
        const double isIn = body(place) ? 1.0 : 0.0;
        both += after[at] == 1 ? isIn : 0.0;
        sum += isIn + (after[at] == 1 ? 1.0 : 0.0);
    });
    return 2.0 * both / sum;
}

Inside ball(const glm::dvec3& middle, double radius)
{
    return [=](const glm::dvec3& place) { return glm::distance(place, middle) <= radius; };
}

/// Planes through the volume: along its axes, or not, some of them about parallel.
Planes randomPlanes(const core::VolumeGeometry& geometry, std::mt19937& random)
{
    const auto below = [&](int limit) { return int(random() % std::uint32_t(limit)); };
    Planes planes;
    for (int count = 2 + below(4); count > 0; --count) {
        glm::dvec3 normal(below(21) - 10, below(21) - 10, below(21) - 10);
        if (below(2) == 0 || glm::length(normal) < 1.0)
            normal = glm::normalize(glm::cross(glm::dvec3(geometry.indexToWorld[below(3)]),
                glm::dvec3(geometry.indexToWorld[below(3)])));
        if (!(glm::length(normal) > 0.5))
            normal = zAxis;
        if (!planes.empty() && below(4) == 0)
            normal = planes.back().normalLps + 0.01 * normal;
        const glm::dvec3 index(
            below(geometry.size.x), below(geometry.size.y), below(geometry.size.z));
        planes.push_back({geometry.toWorld(index), normal});
    }
    return planes;
}

} // namespace

class BetweenPlanesTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    /// A ball that was cut by axial, sagittal and oblique planes comes back.
    void aBallFromItsCuts()
    {
        const glm::dvec3 middle(31.3, 32.1, 30.7);
        const core::VolumeGeometry geometry = cube(64);
        const Inside body = ball(middle, 22.0);
        const Planes mixed{{middle - 10.0 * zAxis, zAxis}, {middle, zAxis},
            {middle + 10.0 * zAxis, zAxis}, {middle - 7.0 * xAxis, xAxis},
            {middle + 7.0 * xAxis, xAxis}, {middle, glm::dvec3(1.0, 1.0, 1.0)}};
        QVERIFY(diceOf(body, mixed, geometry) >= 0.95);
        const Planes twoAxialOneCoronal{
            {middle - 7.0 * zAxis, zAxis}, {middle + 7.0 * zAxis, zAxis}, {middle, yAxis}};
        QVERIFY(diceOf(body, twoAxialOneCoronal, geometry) >= 0.94);
        // About lines through the middle it is exact but for the grid.
        QVERIFY(diceOf(body, {{middle, zAxis}, {middle, xAxis}}, geometry) >= 0.98);
        QVERIFY(
            diceOf(body, {{middle, zAxis}, {middle, xAxis}, {middle, yAxis}}, geometry) >= 0.98);
        QVERIFY(
            diceOf(body, {{middle, xAxis + yAxis}, {middle, yAxis - xAxis + 0.4 * zAxis}}, geometry)
            >= 0.98);
    }

    /// Of a cylinder in any direction, from two cuts across it; nothing beyond them.
    void aTiltedCylinderFromTwoCuts()
    {
        const glm::dvec3 middle(31.3, 32.1, 30.7);
        const glm::dvec3 along = glm::normalize(glm::dvec3(1.0, 0.5, 2.0));
        const core::VolumeGeometry geometry = cube(64);
        const auto heightOf = [=](const glm::dvec3& place) {
            return glm::dot(place - middle, along);
        };
        const Inside cylinder = [=](const glm::dvec3& place) {
            return glm::length(place - middle - heightOf(place) * along) <= 9.0;
        };
        const Planes planes{{middle - 15.0 * along, along}, {middle + 15.0 * along, -along}};
        const Inside between = [=](const glm::dvec3& place) {
            return std::abs(heightOf(place)) <= 15.0;
        };
        QVERIFY(diceOf(cylinder, planes, geometry, between) >= 0.97);
        const core::PlaneSketch sketch = sketchOf(planes, geometry);
        const Labels after = filled(cuts(cylinder, sketch, geometry), sketch, geometry);
        forEachVoxel(geometry.size, [&](const glm::ivec3& voxel, std::size_t at) {
            if (std::abs(heightOf(geometry.toWorld(glm::dvec3(voxel)))) > 16.0)
                QCOMPARE(int(after[at]), 0);
        });
    }

    /// Between cuts across a bent tube lies the bent tube, although the planes meet beside it; and
    /// nothing lies beyond either of them.
    void aBentTubeFromTwoCuts()
    {
        const core::VolumeGeometry geometry = cube(64);
        const glm::dvec3 axis(5.0, 32.0, 30.0);
        const auto angleOf = [=](const glm::dvec3& place) {
            return std::atan2(place.z - axis.z, place.x - axis.x);
        };
        const Inside tube = [=](const glm::dvec3& place) {
            return std::hypot(
                       std::hypot(place.x - axis.x, place.z - axis.z) - 35.0, place.y - axis.y)
                <= 8.0;
        };
        const auto across = [=](double angle) {
            return DrawnPlane{axis, {-std::sin(angle), 0.0, std::cos(angle)}};
        };
        const Planes planes{across(-0.6), across(0.6)};
        const Inside between = [=](const glm::dvec3& place) {
            return std::abs(angleOf(place)) <= 0.6;
        };
        const core::PlaneSketch sketch = sketchOf(planes, geometry);
        Labels drawn = cuts(tube, sketch, geometry);
        forEachVoxel(geometry.size, [&](const glm::ivec3& voxel, std::size_t at) {
            if (geometry.toWorld(glm::dvec3(voxel)).x < axis.x + 10.0)
                drawn[at] = 0; // the other side of the ring
        });
        const Labels after = filled(drawn, sketch, geometry);
        std::int64_t wrong = 0;
        std::int64_t all = 0;
        forEachVoxel(geometry.size, [&](const glm::ivec3& voxel, std::size_t at) {
            const glm::dvec3 place = geometry.toWorld(glm::dvec3(voxel));
            if (std::abs(angleOf(place)) > 0.65)
                QCOMPARE(int(after[at]), 0);
            if (!between(place))
                return;
            all += tube(place) ? 1 : 0;
            wrong += tube(place) != (after[at] == 1) ? 1 : 0;
        });
        QVERIFY(all > 5000 && wrong * 20 < all);
    }

    /// What was drawn on planes through one thing cuts no other one, and joins none with it.
    void thingsThatLieApart()
    {
        const core::VolumeGeometry geometry = cube(64);
        const glm::dvec3 one(16.2, 15.9, 16.4);
        const glm::dvec3 other(48.1, 38.8, 20.4);
        const Inside both = [=](const glm::dvec3& place) {
            return glm::distance(place, one) <= 8.0 || glm::distance(place, other) <= 7.0;
        };
        // The last plane cuts both; the second thing has a coronal cut of its own.
        const Planes planes{
            {one, zAxis}, {one, xAxis}, {other, yAxis}, {other, glm::cross(other - one, zAxis)}};
        QVERIFY(diceOf(both, planes, geometry) >= 0.95);
    }

    /// Between like shapes on parallel slices there is a straight column, voxel by voxel; also
    /// where the planes are named twice, and in any order.
    void likeShapesMakeAColumn()
    {
        core::VolumeGeometry geometry = cube(16);
        geometry.indexToWorld[2][2] = 3.0;
        const auto isBlock = [](const glm::ivec3& voxel) {
            return voxel.x >= 4 && voxel.x < 9 && voxel.y >= 3 && voxel.y < 12;
        };
        Labels labels(geometry.voxelCount(), 0);
        Labels expected = labels;
        forEachVoxel(geometry.size, [&](const glm::ivec3& voxel, std::size_t at) {
            labels[at] = isBlock(voxel) && (voxel.z == 3 || voxel.z == 11) ? 1 : 0;
            expected[at] = isBlock(voxel) && voxel.z >= 3 && voxel.z <= 11 ? 1 : 0;
        });
        const DrawnPlane low{{0.0, 0.0, 9.2}, zAxis};
        const DrawnPlane lowToo{{50.0, 0.0, 8.9}, {0.001, 0.0, -1.0}};
        const DrawnPlane high{{3.0, 4.0, 33.0}, -zAxis};
        const DrawnPlane empty{{3.0, 4.0, 21.0}, zAxis};
        QVERIFY(filled(labels, sketchOf({low, high}, geometry), geometry) == expected);
        QVERIFY(filled(labels, sketchOf({high, low, lowToo}, geometry), geometry) == expected);
        QVERIFY(filled(labels, sketchOf({high, empty, low}, geometry), geometry) == expected);
        QCOMPARE(sketchOf({high, low, lowToo}, geometry).planes.size(), std::size_t(2));
        // One plane encloses nothing.
        QVERIFY(filled(labels, sketchOf({high, empty}, geometry), geometry) == labels);
        QVERIFY(filled(labels, sketchOf({low, lowToo}, geometry), geometry) == labels);
        QVERIFY(core::drawnAsWhole(labels, geometry.size, 1, sketchOf({high, empty, low}, geometry))
            == std::vector<bool>({true, false, true}));
    }

    /// Every voxel of random drawings on random planes of random grids.
    void equalsTheOracle_data()
    {
        QTest::addColumn<uint>("first");
        for (const uint first : {1U, 13U, 25U, 37U})
            QTest::addRow("seeds from %u", first) << first;
    }
    void equalsTheOracle()
    {
        QFETCH(const uint, first);
        std::size_t given = 0;
        for (uint seed = first; seed < first + 12; ++seed) {
            std::mt19937 random(seed);
            const auto below = [&](int limit) { return int(random() % std::uint32_t(limit)); };
            const core::VolumeGeometry geometry = turnedGrid(random);
            const core::PlaneSketch sketch = sketchOf(randomPlanes(geometry, random), geometry);
            const glm::dvec3 middle = geometry.toWorld(glm::dvec3(geometry.size - 1) / 2.0);
            const double side = glm::distance(middle, geometry.toWorld(glm::dvec3(0.0)));
            const Inside large = ball(middle, side * (0.3 + 0.1 * below(5)));
            const Inside small =
                ball(middle + glm::dvec3(below(9) - 4, below(9) - 4, below(9) - 4), 2.0 + below(4));
            Labels labels = cuts(
                [&](const glm::dvec3& place) {
                    return seed % 2 == 0 ? large(place) : small(place);
                },
                sketch, geometry);
            for (std::uint8_t& label : labels) {
                if (below(40) == 0)
                    label = std::uint8_t(below(3));
            }
            const Labels after = filled(labels, sketch, geometry);
            const std::vector<bool> between =
                reference::voxelsBetweenPlanes(labels, geometry.size, 1, sketch);
            Labels expected = labels;
            for (std::size_t voxel = 0; voxel < labels.size(); ++voxel) {
                if (!between[voxel] || labels[voxel] != 0)
                    continue;
                expected[voxel] = 1;
                ++given;
            }
            QVERIFY2(after == expected, qPrintable(QStringLiteral("seed %1").arg(seed)));
        }
        QVERIFY(given > 500);
    }

    void whatIsNoSketch()
    {
        const core::VolumeGeometry geometry = cube(16);
        const DrawnPlane middle{{8.0, 8.0, 8.0}, zAxis};
        const auto errorOf = [&](const Planes& planes) {
            return core::planeSketch(planes, geometry, QStringLiteral("planes")).error().code;
        };
        QVERIFY(errorOf({middle}) == core::ErrorCode::InvalidField);
        QVERIFY(errorOf(Planes(129, middle)) == core::ErrorCode::InvalidField);
        QVERIFY(
            errorOf({middle, {{8.0, 8.0, 8.0}, glm::dvec3(0.0)}}) == core::ErrorCode::InvalidField);
        QVERIFY(errorOf({middle, {{8.0, 8.0, 17.0}, zAxis}}) == core::ErrorCode::InvalidField);
    }

    /// Told of in order and to the end; when it is cancelled, nothing comes of it.
    void progressAndCancelling()
    {
        const glm::dvec3 middle(15.0);
        const core::VolumeGeometry geometry = cube(30);
        const core::PlaneSketch sketch = sketchOf({{middle, zAxis}, {middle, xAxis}}, geometry);
        const Labels labels = cuts(ball(middle, 9.0), sketch, geometry);
        int last = 0;
        const core::Progress progress([&](core::ProgressStep step, int done, int total) {
            QVERIFY(step == core::ProgressStep::ReshapingSegment && done > last && done <= total);
            last = done == total ? -1 : done;
        });
        QVERIFY(core::voxelsBetweenPlanes(labels, geometry.size, 1, sketch, progress));
        QCOMPARE(last, -1);
        core::Progress stopped;
        stopped.cancel();
        const auto given = core::voxelsBetweenPlanes(labels, geometry.size, 1, sketch, stopped);
        QVERIFY(!given);
        QVERIFY(given.error().code == core::ErrorCode::Cancelled);
    }
};

BURIN_TEST(BetweenPlanesTest)

} // namespace betweenPlanesTest

#include "BetweenPlanesTest.moc"
