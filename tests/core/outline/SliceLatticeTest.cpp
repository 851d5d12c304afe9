// SPDX-License-Identifier: Apache-2.0
#include "core/outline/SliceLattice.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/TestVolumes.h"

#include <QTest>

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>

namespace sliceLatticeTest {

namespace {

/// Turned, with other distances along each axis; sheared by a gantry if asked.
core::VolumeGeometry geometryOf(const glm::ivec3& size, double degrees, double shear)
{
    core::VolumeGeometry geometry;
    geometry.size = size;
    const glm::dmat3 turned(
        glm::rotate(glm::dmat4(1.0), glm::radians(degrees), glm::normalize(glm::dvec3(1, 2, 3))));
    const glm::dvec3 spacing(0.7, 0.9, 2.5);
    for (int axis = 0; axis < 3; ++axis) {
        glm::dvec3 step = spacing[axis] * turned[axis];
        if (axis == 2)
            step += shear * turned[1];
        geometry.indexToWorld[axis] = glm::dvec4(step, 0.0);
    }
    geometry.indexToWorld[3] = glm::dvec4(-31.0, 12.0, 5.0, 1.0);
    return geometry;
}

} // namespace

class SliceLatticeTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void alongTheGridPixelsAreVoxels_data()
    {
        QTest::addColumn<int>("axis");
        QTest::addColumn<double>("shear");
        for (int axis = 0; axis < 3; ++axis) {
            QTest::addRow("axis %d", axis) << axis << 0.0;
            QTest::addRow("axis %d, sheared", axis) << axis << 0.8;
        }
    }
    void alongTheGridPixelsAreVoxels()
    {
        QFETCH(const int, axis);
        QFETCH(const double, shear);
        const core::VolumeGeometry geometry = geometryOf({9, 7, 5}, 33.0, shear);
        const auto stepOf = [&geometry](
                                int along) { return glm::dvec3(geometry.indexToWorld[along]); };
        // Any pair of directions in the slice will do, in whichever sense.
        const glm::dvec3 right = -glm::normalize(stepOf((axis + 1) % 3));
        const glm::dvec3 normal =
            glm::normalize(glm::cross(stepOf((axis + 1) % 3), stepOf((axis + 2) % 3)));
        const glm::dvec3 down = glm::cross(normal, right);
        glm::dvec3 through(4.2, 2.9, 2.1);
        through[axis] = 3.3; // the slice of index 3
        const core::SliceLattice lattice =
            core::sliceLattice(geometry, geometry.toWorld(through), right, down);
        QVERIFY(lattice.box.has_value());
        QCOMPARE(lattice.box->minimum[axis], 3);
        QCOMPARE(lattice.box->maximum[axis], 4);
        glm::ivec2 pixel(0);
        for (int z = lattice.box->minimum.z; z < lattice.box->maximum.z; ++z) {
            for (int y = lattice.box->minimum.y; y < lattice.box->maximum.y; ++y) {
                for (int x = lattice.box->minimum.x; x < lattice.box->maximum.x; ++x) {
                    // Somewhere over the voxel, not in its middle.
                    const glm::dvec3 place = geometry.toWorld(
                        glm::dvec3(x, y, z) + 0.4 * glm::dvec3(axis != 0, axis != 1, axis != 2));
                    const std::optional<glm::ivec2> found = lattice.pixelAt(place);
                    QVERIFY(found && *found == pixel);
                    QVERIFY(lattice.cornerAt(place) == pixel + 1);
                    // Half a voxel before it along both axes.
                    glm::dvec3 before(x, y, z);
                    for (int other = 0; other < 3; ++other)
                        before[other] -= other == axis ? 0.0 : 0.5;
                    QVERIFY(
                        glm::distance(lattice.cornerLps(pixel), geometry.toWorld(before)) < 1e-9);
                    if (++pixel.x == lattice.size.x)
                        pixel = {0, pixel.y + 1};
                }
            }
        }
        QVERIFY(pixel == glm::ivec2(0, lattice.size.y));
        QCOMPARE(lattice.size.x * lattice.size.y, 9 * 7 * 5 / geometry.size[axis]);

        // Beside the pixels there is none, and the nearest corner is one at the border.
        const glm::dvec3 beyond = lattice.originLps - 0.6 * lattice.columnLps + lattice.rowLps;
        QVERIFY(!lattice.pixelAt(beyond));
        QVERIFY(lattice.cornerAt(beyond - 3.0 * lattice.columnLps) == glm::ivec2(0, 1)
            || lattice.cornerAt(beyond - 3.0 * lattice.columnLps) == glm::ivec2(0, 2));
        // What a point has across the slice does not count, and moving in it changes nothing.
        QVERIFY(core::sliceLattice(
            geometry, geometry.toWorld(through) + 1.7 * right - 0.4 * down, down, -right)
                    .isAt(lattice));
        through[axis] = 1.8;
        QVERIFY(
            !core::sliceLattice(geometry, geometry.toWorld(through), right, down).isAt(lattice));
        through[axis] = 9.0;
        QVERIFY(core::sliceLattice(geometry, geometry.toWorld(through), right, down).empty());
    }

    /// Every place of the volume in the plane has a pixel, and pixels show the nearest voxels.
    void anObliqueSliceShowsTheNearestVoxels()
    {
        test::Random random(31);
        for (int round = 0; round < 20; ++round) {
            const core::VolumeGeometry geometry =
                geometryOf({21, 17, 9}, 10.0 * round, round % 2 ? 0.8 : 0.0);
            const auto unit = [&random] {
                glm::dvec3 way(0.0);
                while (glm::length(way) < 0.1) {
                    for (int axis = 0; axis < 3; ++axis)
                        way[axis] = test::randomUnit(random) - 0.5;
                }
                return glm::normalize(way);
            };
            const glm::dvec3 right = unit();
            const glm::dvec3 down = glm::normalize(glm::cross(right, unit()));
            const glm::dvec3 middle = geometry.toWorld({10.3, 8.1, 4.2});
            const core::SliceLattice lattice = core::sliceLattice(geometry, middle, right, down);
            if (lattice.box)
                continue; // by chance it is along the grid
            QVERIFY(!lattice.empty());
            QVERIFY(std::abs(glm::length(lattice.columnLps) - 0.7) < 1e-9);
            QVERIFY(std::abs(glm::length(lattice.rowLps) - 0.7) < 1e-9);
            const std::vector<glm::ivec3> voxels = core::nearestVoxels(lattice, geometry);
            QCOMPARE(int(voxels.size()), lattice.size.x * lattice.size.y);
            int shown = 0;
            for (int x = -60; x <= 60; ++x) {
                for (int y = -60; y <= 60; ++y) {
                    const glm::dvec3 place = middle + 0.31 * x * right + 0.31 * y * down;
                    const glm::dvec3 index = geometry.toIndex(place);
                    const bool inVolume = glm::all(glm::greaterThan(index, glm::dvec3(-0.5)))
                        && glm::all(glm::lessThan(index, glm::dvec3(geometry.size) - 0.5));
                    const std::optional<glm::ivec2> pixel = lattice.pixelAt(place);
                    if (!inVolume)
                        continue;
                    QVERIFY(pixel);
                    ++shown;
                    // Its centre is at most half a pixel away along both directions.
                    const glm::dvec3 centre = lattice.originLps
                        + double(pixel->x) * lattice.columnLps + double(pixel->y) * lattice.rowLps;
                    QVERIFY(std::abs(glm::dot(place - centre, right)) < 0.3501);
                    QVERIFY(std::abs(glm::dot(place - centre, down)) < 0.3501);
                    QVERIFY(std::abs(glm::dot(place - centre, glm::cross(right, down))) < 1e-6);
                    const glm::ivec3 voxel =
                        voxels[std::size_t(pixel->y * lattice.size.x + pixel->x)];
                    QVERIFY(geometry.contains(voxel));
                    // The centre itself may lie a little outside.
                    const glm::dvec3 there = glm::clamp(
                        geometry.toIndex(centre), glm::dvec3(0.0), glm::dvec3(geometry.size - 1));
                    QVERIFY(glm::all(glm::lessThan(
                        glm::abs(there - glm::dvec3(voxel)), glm::dvec3(0.5 + 1e-6))));
                }
            }
            QVERIFY(shown > 100);
            QVERIFY(core::sliceLattice(geometry, middle + 3.3 * right - 1.1 * down, right, down)
                        .isAt(lattice));
            const glm::dvec3 beside = middle + 0.5 * glm::cross(right, down);
            QVERIFY(!core::sliceLattice(geometry, beside, right, down).isAt(lattice));
        }
    }

    void aLargeObliqueSliceIsCoarser()
    {
        const core::VolumeGeometry geometry = geometryOf({3000, 3000, 900}, 20.0, 0.0);
        const glm::dvec3 right = glm::normalize(glm::dvec3(1.0, 0.2, 0.4));
        const glm::dvec3 down = glm::normalize(glm::cross(right, glm::dvec3(0.1, -1.0, 0.6)));
        const core::SliceLattice lattice =
            core::sliceLattice(geometry, geometry.toWorld({1500.0, 1500.0, 450.0}), right, down);
        QVERIFY(!lattice.box);
        const std::int64_t pixels = std::int64_t(lattice.size.x) * lattice.size.y;
        QVERIFY(pixels <= core::SliceLattice::mostObliquePixels);
        QVERIFY(pixels > core::SliceLattice::mostObliquePixels / 4);
        const glm::dvec3 far = geometry.toWorld({0.0, 0.0, 0.0}) + 1e5 * glm::cross(right, down);
        QVERIFY(core::sliceLattice(geometry, far, right, down).empty());
    }
};

BURIN_TEST(SliceLatticeTest)

} // namespace sliceLatticeTest

#include "SliceLatticeTest.moc"
