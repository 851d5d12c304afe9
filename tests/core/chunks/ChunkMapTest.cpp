// SPDX-License-Identifier: Apache-2.0
#include "core/chunks/ChunkMap.h"
#include "tests/support/program/TestProgram.h"

#include <QTest>

namespace chunkMapTest {

namespace {

using core::ChunkMap;
using core::ChunkTree;
using core::VoxelBox;

/// A volume with a segment of two blocks of different values, and what lies around it.
struct TwoBlocks {
    core::VolumeGeometry geometry;
    std::vector<std::uint16_t> codes;
    std::vector<std::uint8_t> labels;

    TwoBlocks()
    {
        geometry.size = {40, 30, 20};
        geometry.indexToWorld[2][2] = 2.0;
        for (int z = 0; z < 20; ++z) {
            for (int y = 0; y < 30; ++y) {
                for (int x = 0; x < 40; ++x) {
                    const bool inside = y >= 10 && y < 20 && z >= 5 && z < 15;
                    const bool left = inside && x >= 8 && x < 18;
                    const bool right = inside && x >= 18 && x < 26;
                    codes.push_back(left ? 2000 : right ? 3000 : 500);
                    labels.push_back(left || right ? 1 : 0);
                }
            }
        }
    }
    [[nodiscard]] std::size_t at(const glm::ivec3& voxel) const
    {
        return std::size_t((voxel.z * 30 + voxel.y) * 40 + voxel.x);
    }
    [[nodiscard]] ChunkMap map(const VoxelBox& box) const
    {
        std::vector<std::uint16_t> boxCodes;
        std::vector<std::uint8_t> owners;
        for (int z = box.minimum.z; z < box.maximum.z; ++z) {
            for (int y = box.minimum.y; y < box.maximum.y; ++y) {
                for (int x = box.minimum.x; x < box.maximum.x; ++x) {
                    boxCodes.push_back(codes[at({x, y, z})]);
                    owners.push_back(labels[at({x, y, z})]);
                }
            }
        }
        auto tree = ChunkTree::of(
            {.size = box.maximum - box.minimum, .codes = boxCodes, .owners = owners}, {});
        if (!tree)
            qFatal("not divided");
        return {geometry.size, box, std::move(*tree)};
    }
};

} // namespace

class ChunkMapTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    /// A liver in CT, a kidney, a cyst, and a liver in voxels so fine that the box would be huge.
    void theMarginSuitsTheSegment()
    {
        core::VolumeGeometry geometry;
        geometry.size = {512, 512, 300};
        const auto marginFor = [&](double millilitres, const glm::dvec3& spacingMm) {
            for (int axis = 0; axis < 3; ++axis)
                geometry.indexToWorld[axis][axis] = spacingMm[axis];
            const double voxelMl = spacingMm.x * spacingMm.y * spacingMm.z / 1000.0;
            return core::ChunkMap::suitableMarginMm(std::int64_t(millilitres / voxelMl), geometry);
        };
        QCOMPARE(marginFor(1500.0, {0.8, 0.8, 1.5}), 45.0);
        QCOMPARE(marginFor(160.0, {0.8, 0.8, 1.5}), 20.0);
        QCOMPARE(marginFor(1.0, {0.8, 0.8, 1.5}), 10.0);
        QCOMPARE(marginFor(1500.0, {0.4, 0.4, 0.4}), 10.0);
        QCOMPARE(marginFor(9000.0, {2.0, 2.0, 3.0}), 60.0);
    }

    void theBoxAroundASegment()
    {
        const TwoBlocks blocks;
        const auto box = ChunkMap::boxAround(blocks.labels, 1, blocks.geometry, 5.0);
        QVERIFY(box.has_value());
        QCOMPARE(box->minimum, glm::ivec3(3, 5, 2));
        QCOMPARE(box->maximum, glm::ivec3(31, 25, 18));
        const auto wide = ChunkMap::boxAround(blocks.labels, 1, blocks.geometry, 500.0);
        QCOMPARE(wide->minimum, glm::ivec3(0));
        QCOMPARE(wide->maximum, blocks.geometry.size);
        QVERIFY(!ChunkMap::boxAround(blocks.labels, 2, blocks.geometry, 5.0));
    }

    void clicksGiveAndTake()
    {
        TwoBlocks blocks;
        const ChunkMap map =
            blocks.map(*ChunkMap::boxAround(blocks.labels, 1, blocks.geometry, 5.0));
        // What is around is one, the segment's blocks are two.
        const int three = 3;
        QCOMPARE(map.tree().division(three).size(), std::size_t(three));
        const glm::ivec3 left(12, 15, 10);
        const glm::ivec3 right(22, 15, 10);
        QVERIFY(map.chunkAt(left, three) != map.chunkAt(right, three));
        QVERIFY(!map.chunkAt({0, 0, 0}, three));

        const core::ChunkChange away =
            map.toggled({right, right, {20, 12, 7}, {0, 0, 0}}, three, blocks.labels, 1);
        QVERIFY(away.given.empty());
        QCOMPARE(away.taken.voxelCount(), std::uint64_t(8 * 10 * 10));
        for (const core::VoxelRun& run : away.taken.runs()) {
            for (std::uint64_t i = 0; i < run.count; ++i) {
                QCOMPARE(blocks.codes[std::size_t(run.first + i)], std::uint16_t(3000));
                blocks.labels[std::size_t(run.first + i)] = 0;
            }
        }
        // It is not the segment's any more: the same click brings it back, another one goes.
        const core::ChunkChange back = map.toggled({left, right}, three, blocks.labels, 1);
        QVERIFY(back.given == away.taken);
        QCOMPARE(back.taken.voxelCount(), std::uint64_t(10 * 10 * 10));
        QVERIFY(map.toggled({}, three, blocks.labels, 1) == core::ChunkChange());
    }
};

BURIN_TEST(ChunkMapTest)

} // namespace chunkMapTest

#include "ChunkMapTest.moc"
