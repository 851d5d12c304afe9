// SPDX-License-Identifier: Apache-2.0
#include "core/metrics/CellDistances.h"

#include "core/volume/VolumeGeometry.h"
#include "tests/support/program/TestProgram.h"

#include <QTest>

#include <algorithm>
#include <limits>
#include <random>

namespace cellDistancesTest {

namespace {

using core::VoxelBox;

/// @param tiltMm from slice to slice, along the rows' direction
/// @param uneven whether every third slice lies farther above the one below it
core::VolumeGeometry gridOf(double tiltMm, bool uneven = false)
{
    core::VolumeGeometry geometry;
    geometry.size = {512, 512, 64};
    geometry.indexToWorld =
        glm::dmat4(glm::dvec4(0.7, 0.0, 0.0, 0.0), glm::dvec4(0.0, 0.6, 0.0, 0.0),
            glm::dvec4(0.0, tiltMm, 1.5, 0.0), glm::dvec4(-40.0, 13.0, 250.0, 1.0));
    const auto step = glm::dvec3(geometry.indexToWorld[2]);
    glm::dvec3 place = geometry.originLps();
    for (int k = 0; uneven && k < geometry.size.z; ++k) {
        geometry.slicePositions.push_back(place);
        place += step * (k % 3 == 0 ? 4.0 : 0.7);
    }
    if (uneven)
        geometry.indexToWorld[2] =
            glm::dvec4((geometry.slicePositions.back() - geometry.slicePositions.front())
                    / double(geometry.size.z - 1),
                0.0);
    return geometry;
}

VoxelBox boxOf(const glm::ivec3& voxel)
{
    return {.minimum = voxel, .maximum = voxel + 1};
}

template <class Visit> void forEachVoxel(const VoxelBox& box, const Visit& visit)
{
    for (int z = box.minimum.z; z < box.maximum.z; ++z) {
        for (int y = box.minimum.y; y < box.maximum.y; ++y) {
            for (int x = box.minimum.x; x < box.maximum.x; ++x)
                visit(glm::ivec3(x, y, z));
        }
    }
}

/// Of any two voxels of the boxes.
std::int64_t nearest(const core::CellDistances& distances, const VoxelBox& from, const VoxelBox& to)
{
    std::int64_t least = std::numeric_limits<std::int64_t>::max();
    forEachVoxel(from, [&](const glm::ivec3& one) {
        forEachVoxel(to, [&](const glm::ivec3& other) {
            least = std::min(least, distances.squared(one, other));
        });
    });
    return least;
}

VoxelBox randomBox(std::mt19937& random)
{
    VoxelBox box;
    box.minimum = {int(random() % 24), int(random() % 24), int(random() % 24)};
    const glm::ivec3 more{int(random() % 5), int(random() % 5), int(random() % 5)};
    box.maximum = box.minimum + 1 + more;
    return box;
}

} // namespace

class CellDistancesTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    /// No two voxels are nearer than their boxes; on an upright grid of even slices the nearest are
    /// as near.
    void boxesAreNoFartherThanVoxels_data()
    {
        QTest::addColumn<double>("tiltMm");
        QTest::addColumn<bool>("uneven");
        for (const double tiltMm : {0.0, 0.3, -0.8, 2.0}) {
            QTest::addRow("%g mm", tiltMm) << tiltMm << false;
            QTest::addRow("%g mm, uneven", tiltMm) << tiltMm << true;
        }
    }
    void boxesAreNoFartherThanVoxels()
    {
        QFETCH(const double, tiltMm);
        QFETCH(const bool, uneven);
        const core::CellDistances distances(gridOf(tiltMm, uneven));
        std::mt19937 random(3);
        for (int round = 0; round < 200; ++round) {
            const VoxelBox from = randomBox(random);
            const VoxelBox to = randomBox(random);
            const std::int64_t least = nearest(distances, from, to);
            const std::int64_t bound = distances.leastSquared(from, to);
            QVERIFY2(bound >= 0 && bound <= least,
                qPrintable(QStringLiteral("%1 > %2").arg(bound).arg(least)));
            if (tiltMm == 0.0 && !uneven)
                QCOMPARE(bound, least);
            // Of two voxels it is their distance, but for rounding, and where uneven slices lie
            // askew, since their borders wander sideways within a voxel.
            const std::int64_t squared = distances.squared(from.minimum, to.minimum);
            const std::int64_t ofVoxels =
                distances.leastSquared(boxOf(from.minimum), boxOf(to.minimum));
            QVERIFY(ofVoxels <= squared);
            if (!uneven || tiltMm == 0.0)
                QVERIFY(double(ofVoxels) >= (1.0 - 1e-4) * double(squared));
        }
    }

    /// Two plates across a tilted volume: of the thousand bricks that one has, only those that face
    /// a brick of the other may be as near as the nearest voxels.
    void fewBricksOfTiltedPlatesAreNear()
    {
        const core::VolumeGeometry geometry = gridOf(0.55); // 20°
        const core::CellDistances distances(geometry);
        constexpr int lower = 10;
        constexpr int upper = 40;
        const VoxelBox facing{.minimum = {256, 200, upper}, .maximum = {257, 312, upper + 1}};
        const std::int64_t least = nearest(distances, boxOf({256, 256, lower}), facing);
        std::vector<VoxelBox> plate;
        for (int y = 0; y < geometry.size.y; y += 16) {
            for (int x = 0; x < geometry.size.x; x += 16)
                plate.push_back({.minimum = {x, y, 0}, .maximum = {x + 16, y + 16, 1}});
        }
        int near = 0;
        for (VoxelBox one : plate) {
            one.minimum.z += lower;
            one.maximum.z += lower;
            int around = 0;
            for (VoxelBox other : plate) {
                other.minimum.z += upper;
                other.maximum.z += upper;
                around += distances.leastSquared(one, other) <= least ? 1 : 0;
            }
            QVERIFY2(around <= 12, qPrintable(QString::number(around)));
            near += around;
        }
        QVERIFY(near > 0);
    }
};

BURIN_TEST(CellDistancesTest)

} // namespace cellDistancesTest

#include "CellDistancesTest.moc"
