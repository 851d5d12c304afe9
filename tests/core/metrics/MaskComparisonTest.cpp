// SPDX-License-Identifier: Apache-2.0
#include "core/metrics/MaskComparison.h"

#include "core/metrics/SegmentPairs.h"
#include "core/volume/UnevenSlices.h"
#include "tests/support/program/TestProgram.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>

namespace maskComparisonTest {

namespace {

using core::MaskComparison;
using core::SegmentPair;
using core::VoxelRuns;
using Inside = std::function<bool(const glm::ivec3&)>;

/// Each voxel of a grid, x fastest.
void forEach(const glm::ivec3& size, const std::function<void(const glm::ivec3&)>& visit)
{
    for (int z = 0; z < size.z; ++z) {
        for (int y = 0; y < size.y; ++y) {
            for (int x = 0; x < size.x; ++x)
                visit({x, y, z});
        }
    }
}

VoxelRuns runsOf(const glm::ivec3& size, const Inside& inside)
{
    VoxelRuns runs;
    std::uint64_t place = 0;
    forEach(size, [&](const glm::ivec3& voxel) {
        if (inside(voxel))
            runs.append(place, 1);
        ++place;
    });
    return runs;
}

core::VolumeGeometry grid(const glm::ivec3& size, const glm::dvec3& spacing)
{
    core::VolumeGeometry geometry;
    geometry.size = size;
    for (int axis = 0; axis < 3; ++axis)
        geometry.indexToWorld[axis][axis] = spacing[axis];
    return geometry;
}

MaskComparison compared(
    const VoxelRuns& mask, const VoxelRuns& reference, const core::VolumeGeometry& geometry)
{
    const auto comparison = core::compareMasks(mask, reference, geometry, {});
    if (!comparison)
        qFatal("not compared");
    return *comparison;
}

/// The same by definition: every voxel asks its neighbours, every surface voxel every other.
std::vector<glm::dvec3> surfaceOf(const Inside& inside, const core::VolumeGeometry& geometry)
{
    std::vector<glm::dvec3> places;
    const auto within = [&](const glm::ivec3& voxel) {
        return geometry.contains(voxel) && inside(voxel);
    };
    forEach(geometry.size, [&](const glm::ivec3& voxel) {
        if (!inside(voxel))
            return;
        for (int axis = 0; axis < 3; ++axis) {
            glm::ivec3 step(0);
            step[axis] = 1;
            if (!within(voxel - step) || !within(voxel + step)) {
                places.push_back(core::worldBetweenSlices(geometry, glm::dvec3(voxel)));
                return;
            }
        }
    });
    return places;
}

std::vector<double> nearest(
    const std::vector<glm::dvec3>& places, const std::vector<glm::dvec3>& others)
{
    std::vector<double> distances;
    for (const glm::dvec3& place : places) {
        double least = 1e300;
        for (const glm::dvec3& other : others)
            least = std::min(least, glm::length(place - other));
        distances.push_back(least);
    }
    std::sort(distances.begin(), distances.end());
    return distances;
}

bool near(double a, double b)
{
    return std::abs(a - b) < 1e-9;
}

core::MaskSegment named(const char* name)
{
    core::MaskSegment segment;
    segment.name = QString::fromUtf8(name);
    return segment;
}

} // namespace

class MaskComparisonTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void shiftedBoxes()
    {
        const glm::ivec3 size(20, 12, 10);
        const auto geometry = grid(size, {0.5, 1.0, 2.0});
        const auto box = [](int shift) {
            return [shift](const glm::ivec3& voxel) {
                return voxel.x >= 4 + shift && voxel.x < 10 + shift && voxel.y >= 3 && voxel.y < 8
                    && voxel.z >= 2 && voxel.z < 6;
            };
        };
        const MaskComparison shifted =
            compared(runsOf(size, box(2)), runsOf(size, box(0)), geometry);
        QCOMPARE(shifted.voxels, std::uint64_t(120));
        QCOMPARE(shifted.sharedVoxels, std::uint64_t(80));
        QCOMPARE(shifted.relativeVolumeError.value_or(-1.0), 80.0 / 120.0);
        QCOMPARE(shifted.dice, 160.0 / 240.0);
        QVERIFY(near(shifted.distances->hausdorffMm, 1.0));
        QVERIFY(near(shifted.distances->hausdorff95Mm, 1.0));
        QVERIFY(shifted.distances->meanMm > 0.0 && shifted.distances->meanMm < 1.0);

        const MaskComparison same = compared(runsOf(size, box(1)), runsOf(size, box(1)), geometry);
        QCOMPARE(same.relativeVolumeError.value_or(-1.0), 0.0);
        QCOMPARE(same.dice, 1.0);
        QVERIFY(same.distances == core::SurfaceDistances());
    }

    /// Volume error is relative to the reference, so the two are not alike.
    void theReferenceIsTheSecond()
    {
        const glm::ivec3 size(8, 1, 1);
        const auto first = [](int count) {
            return [count](const glm::ivec3& voxel) { return voxel.x < count; };
        };
        const auto geometry = grid(size, glm::dvec3(1.0));
        QCOMPARE(compared(runsOf(size, first(6)), runsOf(size, first(2)), geometry)
                     .relativeVolumeError.value_or(-1.0),
            2.0);
        QCOMPARE(compared(runsOf(size, first(2)), runsOf(size, first(6)), geometry)
                     .relativeVolumeError.value_or(-1.0),
            4.0 / 6.0);
    }

    void emptyMasks()
    {
        const glm::ivec3 size(4, 4, 4);
        const auto geometry = grid(size, glm::dvec3(1.0));
        const VoxelRuns full = runsOf(size, [](const glm::ivec3&) { return true; });
        const MaskComparison none = compared({}, {}, geometry);
        QCOMPARE(none.dice, 1.0);
        QCOMPARE(none.relativeVolumeError.value_or(-1.0), 0.0);
        QVERIFY(none.distances == core::SurfaceDistances());
        const MaskComparison missed = compared({}, full, geometry);
        QCOMPARE(missed.dice, 0.0);
        QCOMPARE(missed.relativeVolumeError.value_or(-1.0), 1.0);
        QVERIFY(!missed.distances);
        const MaskComparison invented = compared(full, {}, geometry);
        QCOMPARE(invented.dice, 0.0);
        QVERIFY(!invented.relativeVolumeError && !invented.distances);
    }

    /// Tilted, and with slices that lie unevenly.
    void asByDefinition_data()
    {
        QTest::addColumn<int>("seed");
        for (int seed = 0; seed < 24; ++seed)
            QTest::addRow("random %d", seed) << seed;
    }
    void asByDefinition()
    {
        QFETCH(int, seed);
        std::mt19937 random{std::uint32_t(seed)};
        const auto below = [&random](int count) { return int(random() % std::uint32_t(count)); };
        const glm::ivec3 size(3 + below(12), 3 + below(12), 1 + below(12));
        auto geometry = grid(size, {0.4 + below(10) / 8.0, 0.4 + below(10) / 8.0, 1.7});
        if (seed % 3 > 0)
            geometry.indexToWorld[2][1] = 0.6;
        if (seed % 3 > 1) {
            glm::dvec3 place(3.0, -5.0, 7.0);
            for (int k = 0; k < size.z; ++k) {
                geometry.slicePositions.push_back(place);
                place += glm::dvec3(0.0, 0.6, 1.7) * (0.5 + below(5));
            }
        }
        const auto ball = [&]() -> Inside {
            const glm::dvec3 centre(below(size.x), below(size.y), below(size.z));
            const double radius = 1.0 + below(40) / 8.0;
            const std::uint32_t noise = random();
            return [=](const glm::ivec3& voxel) {
                const std::uint32_t mixed =
                    (std::uint32_t(voxel.x) * 73856093U ^ std::uint32_t(voxel.y) * 19349663U
                        ^ std::uint32_t(voxel.z) * 83492791U)
                    * (noise | 1U);
                return glm::length(glm::dvec3(voxel) - centre) <= radius && mixed % 7U > 0;
            };
        };
        const Inside mask = ball();
        const Inside reference = ball();
        const VoxelRuns maskRuns = runsOf(size, mask);
        const VoxelRuns referenceRuns = runsOf(size, reference);
        if (maskRuns.empty() || referenceRuns.empty())
            QSKIP("one of these two holds nothing: see emptyMasks");
        const MaskComparison found = compared(maskRuns, referenceRuns, geometry);

        const auto places = surfaceOf(mask, geometry);
        const auto others = surfaceOf(reference, geometry);
        const auto there = nearest(places, others);
        const auto back = nearest(others, places);
        QVERIFY(near(found.distances->hausdorffMm, std::max(there.back(), back.back())));
        double sum = 0.0;
        for (const auto* distances : {&there, &back}) {
            for (const double distance : *distances)
                sum += distance;
        }
        QVERIFY(near(found.distances->meanMm, sum / double(there.size() + back.size())));
        const auto percentile = [](const std::vector<double>& distances) {
            const double rank = 0.95 * double(distances.size() - 1);
            const double low = distances[std::size_t(std::floor(rank))];
            const double high = distances[std::size_t(std::ceil(rank))];
            return low + (high - low) * (rank - std::floor(rank));
        };
        QVERIFY(
            near(found.distances->hausdorff95Mm, std::max(percentile(there), percentile(back))));
    }

    void whatBelongsTogether()
    {
        using Pairs = std::vector<SegmentPair>;
        const std::vector<core::MaskSegment> organs{named("Liver"), named("Spleen")};
        const std::vector<core::MaskSegment> others{named("spleen"), named("Kidney")};
        const std::vector<core::MaskSegment> numbers{named("1"), named("2")};
        const std::vector<core::MaskSegment> one{named("Segment")};
        QVERIFY(core::segmentPairs(organs, others, {}) == Pairs({{1, 0}}));
        QVERIFY(core::segmentPairs(numbers, organs, {}) == Pairs({{0, 0}, {1, 1}}));
        QVERIFY(core::segmentPairs(one, organs, {}).empty());
        const std::vector<core::MaskSegment> files{named("1"), named("2"), named("1")};
        QVERIFY(core::segmentPairs(files, files, {}) == Pairs({{0, 0}, {1, 1}, {2, 2}}));
        QVERIFY(core::segmentPairs(numbers, files, {}) == Pairs({{0, 0}, {1, 1}}));
        const QString liver = QStringLiteral("Liver");
        const QString kidney = QStringLiteral("Kidney");
        QVERIFY(core::segmentPairs(organs, one, {.segment = liver, .reference = {}})
            == Pairs({{0, 0}}));
        QVERIFY(core::segmentPairs(one, organs, {.segment = {}, .reference = liver})
            == Pairs({{0, 0}}));
        QVERIFY(core::segmentPairs(organs, others, {.segment = liver, .reference = kidney})
            == Pairs({{0, 1}}));
        QVERIFY(core::segmentPairs(organs, others, {.segment = liver, .reference = {}}).empty());
        QVERIFY(core::segmentPairs(organs, others, {.segment = {}, .reference = liver}).empty());
    }
};

BURIN_TEST(MaskComparisonTest)

} // namespace maskComparisonTest

#include "MaskComparisonTest.moc"
