// SPDX-License-Identifier: Apache-2.0
#include "core/morphology/BetweenSlices.h"

#include "core/morphology/SliceDistances.h"
#include "core/morphology/SliceParts.h"
#include "core/volume/VolumeGeometry.h"
#include "tests/reference/filling/BetweenSlices.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/program/TestProgram.h"

#include <QTest>

#include <algorithm>
#include <cstdlib>
#include <functional>
#include <limits>
#include <random>
#include <vector>

namespace betweenSlicesTest {

namespace {

using core::SliceAxis;
using Labels = std::vector<std::uint8_t>;

core::VolumeGeometry gridOf(const glm::ivec3& size, const glm::dvec3& spacing)
{
    core::VolumeGeometry geometry;
    geometry.size = size;
    for (int axis = 0; axis < 3; ++axis)
        geometry.indexToWorld[axis][axis] = spacing[axis];
    return geometry;
}

std::size_t indexIn(const core::VolumeGeometry& geometry, const glm::ivec3& at)
{
    const glm::ivec3& size = geometry.size;
    return (std::size_t(at.z) * std::size_t(size.y) + std::size_t(at.y)) * std::size_t(size.x)
        + std::size_t(at.x);
}

/// Gives label 1 to the voxels of a slice for which @p isIn(across, down) holds.
void draw(const core::VolumeGeometry& geometry, Labels& labels, SliceAxis axis, int slice,
    const std::function<bool(int, int)>& isIn)
{
    for (int down = 0; down < geometry.size[downOf(axis)]; ++down) {
        for (int across = 0; across < geometry.size[acrossOf(axis)]; ++across) {
            glm::ivec3 at;
            at[alongOf(axis)] = slice;
            at[downOf(axis)] = down;
            at[acrossOf(axis)] = across;
            if (isIn(across, down))
                labels[indexIn(geometry, at)] = 1;
        }
    }
}

std::function<bool(int, int)> block(
    const glm::ivec2& from, const glm::ivec2& to) // one beyond its last pixel
{
    return [from, to](int x, int y) { return x >= from.x && x < to.x && y >= from.y && y < to.y; };
}

Labels filled(const core::VolumeGeometry& geometry, Labels labels, SliceAxis axis)
{
    const auto drawn = core::drawnSlices(labels, geometry.size, 1);
    const auto between = core::voxelsBetween(
        labels, geometry, 1, drawn.at(std::size_t(alongOf(axis))), core::Progress());
    for (const core::VoxelRun& run : between.value().runs())
        std::fill_n(labels.begin() + std::ptrdiff_t(run.first), run.count, std::uint8_t(1));
    return labels;
}

/// Slices with blobs of random places and sizes, and specks of another label.
Labels randomSlices(const core::VolumeGeometry& geometry, SliceAxis axis, std::mt19937& random)
{
    const auto below = [&](int limit) { return int(random() % std::uint32_t(limit)); };
    Labels labels(geometry.voxelCount(), 0);
    for (int slice = below(3); slice < geometry.size[alongOf(axis)]; slice += 1 + below(5)) {
        for (int blobs = below(4); blobs > 0; --blobs) {
            const glm::ivec2 middle{
                below(geometry.size[acrossOf(axis)]), below(geometry.size[downOf(axis)])};
            const int radius = 1 + below(4);
            const bool isBlock = below(2) == 0;
            draw(geometry, labels, axis, slice, [=](int x, int y) {
                const int dx = std::abs(x - middle.x);
                const int dy = std::abs(y - middle.y);
                return isBlock ? dx < radius && dy <= radius : dx * dx + dy * dy <= radius * radius;
            });
        }
    }
    for (std::uint8_t& label : labels) {
        if (below(30) == 0)
            label = 2;
    }
    return labels;
}

} // namespace

class BetweenSlicesTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    /// Two like shapes make a straight column, whatever the axis.
    void likeShapesMakeAColumn_data()
    {
        QTest::addColumn<int>("axis");
        for (const int axis : {0, 1, 2})
            QTest::addRow("axis %d", axis) << axis;
    }
    void likeShapesMakeAColumn()
    {
        QFETCH(const int, axis);
        const core::VolumeGeometry geometry = gridOf({9, 10, 11}, {0.7, 0.8, 3.0});
        Labels labels(geometry.voxelCount(), 0);
        const auto shape = [](int x, int y) {
            return (x > 1 && x < 7 && y > 2 && y < 6) || (x == 4 && y < 8);
        };
        Labels expected = labels;
        for (const int slice : {1, 7})
            draw(geometry, labels, SliceAxis(axis), slice, shape);
        for (int slice = 1; slice <= 7; ++slice)
            draw(geometry, expected, SliceAxis(axis), slice, shape);
        const auto drawn = core::drawnSlices(labels, geometry.size, 1);
        QVERIFY(core::drawnAxis(drawn) == SliceAxis(axis));
        QVERIFY(drawn.at(std::size_t(axis)).slices == std::vector<int>({1, 7}));
        QCOMPARE(drawn.at(std::size_t(axis)).emptySlices(), 5);
        QCOMPARE(drawn.at(std::size_t(axis)).gaps(), 1);
        QVERIFY(filled(geometry, labels, SliceAxis(axis)) == expected);
    }

    /// Halfway between a block of 3 × 3 and one of 11 × 11 around it lies one of 7 × 7: its border
    /// is as far from either.
    void halfwayBetweenTwoBlocks()
    {
        const core::VolumeGeometry geometry = gridOf({15, 15, 5}, {1.0, 1.0, 4.0});
        Labels labels(geometry.voxelCount(), 0);
        draw(geometry, labels, SliceAxis::K, 0, block({6, 6}, {9, 9}));
        draw(geometry, labels, SliceAxis::K, 2, block({2, 2}, {13, 13}));
        const Labels after = filled(geometry, labels, SliceAxis::K);
        // Along the axes of symmetry: at 3 from the middle, 2 outside of the small block and 3
        // inside of the large one; at 4 it is 3 and 2.
        for (int x = 0; x < 15; ++x) {
            QCOMPARE(int(after[indexIn(geometry, {x, 7, 1})]), std::abs(x - 7) <= 3 ? 1 : 0);
            QCOMPARE(int(after[indexIn(geometry, {7, x, 1})]), std::abs(x - 7) <= 3 ? 1 : 0);
        }
        for (int slice = 3; slice < 5; ++slice)
            QCOMPARE(int(after[indexIn(geometry, {7, 7, slice})]), 0);
    }

    /// A shape that has moved away is moved step by step; two of them each for itself.
    void whatDoesNotOverlapIsMoved()
    {
        const core::VolumeGeometry geometry = gridOf({40, 20, 6}, {1.0, 1.0, 1.0});
        Labels labels(geometry.voxelCount(), 0);
        Labels expected = labels;
        for (const int slice : {0, 4}) {
            draw(geometry, labels, SliceAxis::K, slice,
                block({2 + 2 * slice, 2}, {5 + 2 * slice, 6}));
            draw(geometry, labels, SliceAxis::K, slice,
                block({36 - slice, 8 + slice}, {39 - slice, 11 + slice}));
        }
        for (int slice = 0; slice <= 4; ++slice) {
            draw(geometry, expected, SliceAxis::K, slice,
                block({2 + 2 * slice, 2}, {5 + 2 * slice, 6}));
            draw(geometry, expected, SliceAxis::K, slice,
                block({36 - slice, 8 + slice}, {39 - slice, 11 + slice}));
        }
        QVERIFY(filled(geometry, labels, SliceAxis::K) == expected);
    }

    /// One thing that divides into two stays whole for a while; a third part that has no
    /// counterpart dwindles, and is not joined with what lies far away.
    void whatDividesAndWhatEnds()
    {
        const core::VolumeGeometry geometry = gridOf({30, 15, 9}, {1.0, 1.0, 1.0});
        Labels labels(geometry.voxelCount(), 0);
        draw(geometry, labels, SliceAxis::K, 0, block({2, 2}, {15, 7}));
        draw(geometry, labels, SliceAxis::K, 0, block({22, 9}, {27, 14}));
        draw(geometry, labels, SliceAxis::K, 8, block({2, 2}, {6, 7}));
        draw(geometry, labels, SliceAxis::K, 8, block({11, 2}, {15, 7}));
        const core::SliceSteps steps = core::sliceSteps(geometry, SliceAxis::K);
        const auto maskAt = [&](int slice) {
            core::SliceMask mask{.size = {30, 15}};
            for (std::size_t at = 0; at < 450; ++at)
                mask.pixels.push_back(labels[std::size_t(slice) * 450 + at]);
            return mask;
        };
        const core::SliceParts lower = core::sliceParts(maskAt(0), steps);
        const core::SliceParts upper = core::sliceParts(maskAt(8), steps);
        QCOMPARE(lower.parts.size(), std::size_t(2));
        QCOMPARE(upper.parts.size(), std::size_t(2));
        QCOMPARE(lower.parts[1].centroid.x, 24);
        QCOMPARE(lower.parts[1].centroid.y, 11);
        const std::vector<core::MatchedParts> matched = core::matchedParts(lower, upper, steps);
        QCOMPARE(matched.size(), std::size_t(2));
        QVERIFY(matched[0].overlap && matched[0].lower == std::vector<int>({0})
            && matched[0].upper == std::vector<int>({0, 1}));
        QVERIFY(!matched[1].overlap && matched[1].lower == std::vector<int>({1})
            && matched[1].upper.empty());

        const Labels after = filled(geometry, labels, SliceAxis::K);
        // Where the thing divides: near the lower slice there is no gap, near the upper one there
        // is.
        QCOMPARE(int(after[indexIn(geometry, {8, 4, 1})]), 1);
        QCOMPARE(int(after[indexIn(geometry, {8, 4, 7})]), 0);
        QCOMPARE(int(after[indexIn(geometry, {3, 4, 4})]), 1);
        std::int64_t before = 25;
        for (int slice = 1; slice < 8; ++slice) {
            std::int64_t count = 0;
            for (int y = 8; y < 15; ++y) {
                for (int x = 18; x < 30; ++x)
                    count += after[indexIn(geometry, {x, y, slice})] == 1 ? 1 : 0;
            }
            QVERIFY(count <= before && count > 0);
            before = count;
        }
        QCOMPARE(before, std::int64_t(1));
        QCOMPARE(int(after[indexIn(geometry, {24, 11, 7})]), 1);
    }

    /// The axis is the one whose slices are drawn most sparsely, though two blobs of one slice have
    /// a gap between them, too.
    void theSparsestAxisIsFound()
    {
        const core::VolumeGeometry geometry = gridOf({20, 20, 20}, {1.0, 1.0, 1.0});
        Labels labels(geometry.voxelCount(), 0);
        QVERIFY(!core::drawnAxis(core::drawnSlices(labels, geometry.size, 1)));
        draw(geometry, labels, SliceAxis::J, 3, block({1, 1}, {8, 8}));
        QVERIFY(!core::drawnAxis(core::drawnSlices(labels, geometry.size, 1)));
        draw(geometry, labels, SliceAxis::J, 3, block({11, 11}, {19, 19}));
        draw(geometry, labels, SliceAxis::J, 9, block({1, 1}, {8, 8}));
        const auto drawn = core::drawnSlices(labels, geometry.size, 1);
        QCOMPARE(drawn[0].gaps(), 1);
        QCOMPARE(drawn[2].gaps(), 1);
        QVERIFY(core::drawnAxis(drawn) == SliceAxis::J);
        QVERIFY(!core::drawnAxis(core::drawnSlices(labels, geometry.size, 2)));
    }

    /// Against all pairs of pixels, with spacings that differ.
    void distancesAreExact()
    {
        std::mt19937 random(11);
        for (int round = 0; round < 40; ++round) {
            const core::SliceSteps steps{.xx = 1 + int(random() % 9), .yy = 1 + int(random() % 9)};
            core::SliceMask mask{.size = {4 + int(random() % 14), 4 + int(random() % 14)}};
            mask.pixels.assign(std::size_t(mask.size.x) * std::size_t(mask.size.y), 0);
            mask.pixels[mask.indexOf({1, 2})] = 1;
            for (int y = 1; y + 1 < mask.size.y; ++y) {
                for (int x = 1; x + 1 < mask.size.x; ++x) {
                    if (int(random() % 10) < round % 10)
                        mask.pixels[mask.indexOf({x, y})] = 1;
                }
            }
            const std::vector<std::int64_t> squares = core::signedSquares(mask, steps);
            for (int y = 0; y < mask.size.y; ++y) {
                for (int x = 0; x < mask.size.x; ++x) {
                    const std::uint8_t own = mask.pixels[mask.indexOf({x, y})];
                    std::int64_t least = std::numeric_limits<std::int64_t>::max();
                    for (int v = 0; v < mask.size.y; ++v) {
                        for (int u = 0; u < mask.size.x; ++u) {
                            if (mask.pixels[mask.indexOf({u, v})] != own)
                                least = std::min(least, steps.squared({u - x, v - y}));
                        }
                    }
                    QCOMPARE(squares[mask.indexOf({x, y})], own != 0 ? least : -least);
                }
            }
        }
    }

    /// With spacings and axes of all kinds, and where no axis is told.
    void equalsTheOracle()
    {
        std::size_t given = 0;
        for (std::uint32_t seed = 1; seed <= 40; ++seed) {
            std::mt19937 random(seed);
            const auto below = [&](int limit) { return int(random() % std::uint32_t(limit)); };
            const glm::ivec3 size{8 + below(10), 8 + below(10), 8 + below(8)};
            const glm::dvec3 spacing{
                0.5 + below(8) / 4.0, 0.5 + below(8) / 4.0, 0.5 + below(8) / 3.0};
            const core::VolumeGeometry geometry = gridOf(size, spacing);
            const Labels labels = randomSlices(geometry, SliceAxis(seed % 3), random);
            const auto drawn = core::drawnSlices(labels, geometry.size, 1);
            for (const int chosen : {0, 1, 2, 3}) {
                const std::optional<SliceAxis> asked =
                    chosen < 3 ? std::optional(SliceAxis(chosen)) : std::nullopt;
                const std::optional<SliceAxis> axis = asked ? asked : core::drawnAxis(drawn);
                const Labels after = axis ? filled(geometry, labels, *axis) : labels;
                const std::vector<bool> between =
                    reference::voxelsBetween(labels, geometry, 1, asked);
                Labels expected = labels;
                for (std::size_t voxel = 0; voxel < labels.size(); ++voxel) {
                    if (!between[voxel] || labels[voxel] != 0)
                        continue;
                    expected[voxel] = 1;
                    ++given;
                }
                QVERIFY2(after == expected,
                    qPrintable(QStringLiteral("seed %1, %2").arg(seed).arg(chosen)));
            }
        }
        QVERIFY(given > 2000);
    }

    /// Told of in order and to the end; when it is cancelled on the way, nothing comes of it.
    void progressAndCancelling()
    {
        const core::VolumeGeometry geometry = gridOf({20, 20, 12}, {1.0, 1.0, 1.0});
        Labels labels(geometry.voxelCount(), 0);
        for (const int slice : {0, 3, 6, 11})
            draw(geometry, labels, SliceAxis::K, slice, block({3, 3}, {9 + slice, 15}));
        const auto drawn = core::drawnSlices(labels, geometry.size, 1);
        int last = 0;
        const core::Progress progress([&](core::ProgressStep step, int done, int total) {
            QVERIFY(step == core::ProgressStep::ReshapingSegment && done > last && done <= total);
            last = done == total ? -1 : done;
        });
        QVERIFY(core::voxelsBetween(labels, geometry, 1, drawn[2], progress));
        QCOMPARE(last, -1);

        core::Progress stopped;
        stopped.cancel();
        const auto given = core::voxelsBetween(labels, geometry, 1, drawn[2], stopped);
        QVERIFY(!given);
        QVERIFY(given.error().code == core::ErrorCode::Cancelled);
        // Nothing to be done is nothing to be cancelled.
        const auto none = core::voxelsBetween(
            labels, geometry, 2, core::drawnSlices(labels, geometry.size, 2)[2], core::Progress());
        QVERIFY(none && none->empty());
    }
};

BURIN_TEST(BetweenSlicesTest)

} // namespace betweenSlicesTest

#include "BetweenSlicesTest.moc"
