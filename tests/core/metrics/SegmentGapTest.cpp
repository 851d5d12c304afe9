// SPDX-License-Identifier: Apache-2.0
#include "core/metrics/SegmentGap.h"

#include "core/measure/MeasuredSize.h"
#include "core/volume/UnevenSlices.h"
#include "tests/support/program/TestProgram.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <optional>
#include <random>
#include <vector>

namespace segmentGapTest {

namespace {

using Labels = std::vector<std::uint8_t>;

core::VolumeGeometry gridOf(const glm::ivec3& size, const glm::dvec3& spacing)
{
    core::VolumeGeometry geometry;
    geometry.size = size;
    geometry.indexToWorld =
        glm::dmat4(glm::dvec4(spacing.x, 0.0, 0.0, 0.0), glm::dvec4(0.0, spacing.y, 0.0, 0.0),
            glm::dvec4(0.0, 0.0, -spacing.z, 0.0), glm::dvec4(-40.0, 13.0, 250.0, 1.0));
    return geometry;
}

std::size_t indexOf(const glm::ivec3& at, const glm::ivec3& size)
{
    return (std::size_t(at.z) * std::size_t(size.y) + std::size_t(at.y)) * std::size_t(size.x)
        + std::size_t(at.x);
}

template <class Visit> void forEachVoxel(const glm::ivec3& size, const Visit& visit)
{
    for (int z = 0; z < size.z; ++z) {
        for (int y = 0; y < size.y; ++y) {
            for (int x = 0; x < size.x; ++x)
                visit(glm::ivec3(x, y, z));
        }
    }
}

void putBall(Labels& labels, const core::VolumeGeometry& geometry, std::uint8_t label,
    const glm::dvec3& middleLps, double radiusMm)
{
    forEachVoxel(geometry.size, [&](const glm::ivec3& at) {
        if (glm::length(geometry.toWorld(glm::dvec3(at)) - middleLps) <= radiusMm)
            labels[indexOf(at, geometry.size)] = label;
    });
}

/// The distance between facing corners of cells, from each voxel of the one to each of the other.
std::optional<double> plainly(const Labels& labels, const core::VolumeGeometry& geometry)
{
    std::vector<glm::ivec3> one;
    std::vector<glm::ivec3> other;
    forEachVoxel(geometry.size, [&](const glm::ivec3& at) {
        if (labels[indexOf(at, geometry.size)] == 1)
            one.push_back(at);
        else if (labels[indexOf(at, geometry.size)] == 2)
            other.push_back(at);
    });
    std::optional<double> least;
    for (const glm::ivec3& from : one) {
        for (const glm::ivec3& to : other) {
            const glm::dvec3 half = 0.5 * glm::dvec3(glm::sign(to - from));
            const double mm =
                glm::distance(core::worldBetweenSlices(geometry, glm::dvec3(from) + half),
                    core::worldBetweenSlices(geometry, glm::dvec3(to) - half));
            least = std::min(least.value_or(mm), mm);
        }
    }
    return least;
}

core::Result<std::optional<core::SegmentGap>> gapOf(
    const Labels& labels, const core::VolumeGeometry& geometry)
{
    return core::segmentGap(labels, 1, labels, 2, geometry, core::Progress());
}

/// As it is measured: between the true places.
double lengthOf(const core::SegmentGap& gap, const core::VolumeGeometry& geometry)
{
    return glm::distance(
        core::truePlace(geometry, gap.fromLps), core::truePlace(geometry, gap.toLps));
}

/// Places slices anew: some near each other, some far apart, and perhaps beside the line on which
/// they would lie.
void makeUneven(core::VolumeGeometry& geometry, std::mt19937& random)
{
    const bool wanders = random() % 2 == 0;
    const auto step = glm::dvec3(geometry.indexToWorld[2]);
    glm::dvec3 place = geometry.originLps();
    for (int k = 0; k < geometry.size.z; ++k) {
        geometry.slicePositions.push_back(place);
        if (wanders && k > 0)
            geometry.slicePositions.back().y += 0.2 * double(random() % 8);
        place += step * (0.2 + 0.1 * double(random() % 40));
    }
    geometry.indexToWorld[2] =
        glm::dvec4((geometry.slicePositions.back() - geometry.slicePositions.front())
                / double(geometry.size.z - 1),
            0.0);
}

} // namespace

class SegmentGapTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    /// Scattered blocks and specks, over several bricks: as near as a look at each pair says, with
    /// ends on cells of either.
    void anyMatter_data()
    {
        QTest::addColumn<uint>("seed");
        QTest::addColumn<double>("tiltMm"); // from slice to slice
        QTest::addColumn<bool>("uneven");
        for (uint seed = 1; seed <= 20; ++seed)
            QTest::addRow("seed %u", seed) << seed << 0.0 << false;
        for (uint seed = 21; seed <= 35; ++seed)
            QTest::addRow("seed %u, tilted", seed) << seed << (seed % 2 == 0 ? 0.4 : -1.1) << false;
        for (uint seed = 36; seed <= 55; ++seed)
            QTest::addRow("seed %u, uneven", seed) << seed << 0.0 << true;
        for (uint seed = 56; seed <= 65; ++seed)
            QTest::addRow("seed %u, tilted and uneven", seed) << seed << 0.5 << true;
    }
    void anyMatter()
    {
        QFETCH(const uint, seed);
        QFETCH(const double, tiltMm);
        QFETCH(const bool, uneven);
        std::mt19937 random(seed);
        const glm::ivec3 size(20 + int(random() % 30), 18 + int(random() % 25), 40);
        core::VolumeGeometry geometry = gridOf(
            size, {0.5 + 0.1 * double(random() % 9), 0.8, 0.7 + 0.1 * double(random() % 30)});
        geometry.indexToWorld[2] += glm::dvec4(-0.3 * tiltMm, tiltMm, 0.0, 0.0);
        if (uneven)
            makeUneven(geometry, random);
        Labels labels(geometry.voxelCount(), 0);
        for (int speck = 0; speck < 24; ++speck) {
            const glm::ivec3 at{int(random() & 15), int(random() & 15), int(random() % 18)};
            labels[indexOf(at, size)] = 1;
            const glm::ivec3 far{size.x - 1 - int(random() & 3), int(random() & 15),
                size.z - 1 - int(random() & 15)};
            labels[indexOf(far, size)] = 2;
        }
        forEachVoxel({5, 4, 6}, [&](const glm::ivec3& at) { labels[indexOf(at, size)] = 1; });
        const auto gap = gapOf(labels, geometry);
        QVERIFY(gap && *gap);
        const std::optional<double> expected = plainly(labels, geometry);
        QVERIFY(expected);
        const double found = lengthOf(**gap, geometry);
        QVERIFY2(std::abs(found - *expected) < (uneven ? 1e-5 : 1e-9),
            qPrintable(QStringLiteral("%1, %2").arg(found).arg(*expected)));
        // Each end lies on a cell of its own segment.
        int label = 1;
        for (const glm::dvec3& place : {(*gap)->fromLps, (*gap)->toLps}) {
            const glm::dvec3 index = geometry.toIndex(place);
            bool isOnCell = false;
            forEachVoxel(size, [&](const glm::ivec3& at) {
                const glm::dvec3 off = glm::abs(glm::dvec3(at) - index);
                isOnCell = isOnCell
                    || (labels[indexOf(at, size)] == label
                        && std::max({off.x, off.y, off.z}) < 0.5 + 1e-6);
            });
            QVERIFY(isOnCell);
            ++label;
        }
    }

    /// Two balls of millimetres on slices that are thick: to a voxel what their radii say.
    void balls()
    {
        const core::VolumeGeometry geometry = gridOf({80, 40, 40}, {1.0, 1.0, 2.0});
        Labels labels(geometry.voxelCount(), 0);
        const glm::dvec3 one = geometry.toWorld({20.0, 20.0, 20.0});
        const glm::dvec3 other = geometry.toWorld({60.0, 20.0, 20.0});
        putBall(labels, geometry, 1, one, 10.0);
        putBall(labels, geometry, 2, other, 12.0);
        const auto gap = gapOf(labels, geometry);
        QVERIFY(gap && *gap);
        // Voxel centres lie just on both spheres there, and cells reach half a voxel farther.
        QCOMPARE(lengthOf(**gap, geometry), 40.0 - 10.0 - 12.0 - 1.0);
        QCOMPARE((*gap)->fromLps, one + glm::dvec3(10.5, 0.0, 0.0));
        QCOMPARE((*gap)->toLps, other - glm::dvec3(12.5, 0.0, 0.0));
    }

    /// Plates across a tilted volume, of as many voxels each as a slice has: they are as near as
    /// the voxels about the middle say, and of equal pairs the lowest counts.
    void tiltedPlates()
    {
        core::VolumeGeometry geometry = gridOf({128, 128, 24}, {0.7, 0.7, 1.0});
        geometry.indexToWorld[2].y = 0.5;
        Labels labels(geometry.voxelCount(), 0);
        forEachVoxel(geometry.size, [&](const glm::ivec3& at) {
            if (at.z == 3 || at.z == 20)
                labels[indexOf(at, geometry.size)] = at.z == 3 ? 1 : 2;
        });
        Labels few(geometry.voxelCount(), 0);
        few[indexOf({64, 64, 3}, geometry.size)] = 1;
        for (int y = 40; y < 88; ++y)
            few[indexOf({64, y, 20}, geometry.size)] = 2;
        const std::optional<double> expected = plainly(few, geometry);
        const auto gap = gapOf(labels, geometry);
        QVERIFY(gap && *gap && expected);
        const double found = lengthOf(**gap, geometry);
        QVERIFY2(std::abs(found - *expected) < 1e-9,
            qPrintable(QStringLiteral("%1, %2").arg(found).arg(*expected)));
        const glm::dvec3 from = geometry.toIndex((*gap)->fromLps);
        QVERIFY(glm::distance(from, glm::dvec3(0.0, 11.5, 3.5)) < 1e-6);
    }

    /// What is nearest in the picture need not be: slices lie near each other below, and far apart
    /// above.
    void betweenUnevenSlices()
    {
        core::VolumeGeometry geometry = gridOf({24, 8, 12}, {1.0, 1.0, 1.0});
        double z = 0.0;
        for (int k = 0; k < geometry.size.z; ++k) {
            geometry.slicePositions.emplace_back(0.0, 0.0, z);
            z += k < 8 ? 0.5 : 8.0;
        }
        const double last = geometry.slicePositions.back().z;
        geometry.indexToWorld = glm::dmat4(1.0);
        geometry.indexToWorld[2].z = last / double(geometry.size.z - 1);
        Labels labels(geometry.voxelCount(), 0);
        labels[indexOf({4, 4, 9}, geometry.size)] = 1; // 8 mm below the next one
        labels[indexOf({4, 4, 11}, geometry.size)] = 2;
        labels[indexOf({14, 4, 1}, geometry.size)] = 1; // six slices of half a millimetre
        labels[indexOf({14, 4, 7}, geometry.size)] = 2;
        const auto gap = gapOf(labels, geometry);
        QVERIFY(gap && *gap);
        QVERIFY(
            glm::distance(geometry.toIndex((*gap)->fromLps), glm::dvec3(14.0, 4.0, 1.5)) < 1e-9);
        QVERIFY(glm::distance(geometry.toIndex((*gap)->toLps), glm::dvec3(14.0, 4.0, 6.5)) < 1e-9);
        QVERIFY(std::abs(lengthOf(**gap, geometry) - 2.5) < 1e-9);
    }

    /// What touches, even by a corner, is one place; so is what shares a voxel.
    void touching()
    {
        const core::VolumeGeometry geometry = gridOf({20, 20, 20}, {1.0, 1.0, 1.5});
        Labels labels(geometry.voxelCount(), 0);
        labels[indexOf({5, 5, 5}, geometry.size)] = 1;
        labels[indexOf({6, 6, 4}, geometry.size)] = 2;
        const auto corner = gapOf(labels, geometry);
        QVERIFY(corner && *corner);
        QCOMPARE((*corner)->fromLps, geometry.toWorld({5.5, 5.5, 4.5}));
        QCOMPARE((*corner)->toLps, (*corner)->fromLps);
        Labels others(geometry.voxelCount(), 0);
        others[indexOf({5, 5, 5}, geometry.size)] = 3;
        const auto shared = core::segmentGap(labels, 1, others, 3, geometry, core::Progress());
        QVERIFY(shared && *shared);
        QCOMPARE((*shared)->fromLps, geometry.toWorld({5.0, 5.0, 5.0}));
        QCOMPARE((*shared)->toLps, (*shared)->fromLps);
    }

    void nothingAndCancelled()
    {
        const core::VolumeGeometry geometry = gridOf({20, 20, 20}, {1.0, 1.0, 1.5});
        Labels labels(geometry.voxelCount(), 0);
        labels[indexOf({5, 5, 5}, geometry.size)] = 1;
        const auto none = gapOf(labels, geometry);
        QVERIFY(none && !*none);
        labels[indexOf({15, 5, 5}, geometry.size)] = 2;
        core::Progress stopped;
        stopped.cancel();
        const auto given = core::segmentGap(labels, 1, labels, 2, geometry, stopped);
        QVERIFY(!given);
        QVERIFY(given.error().code == core::ErrorCode::Cancelled);
    }
};

BURIN_TEST(SegmentGapTest)

} // namespace segmentGapTest

#include "SegmentGapTest.moc"
