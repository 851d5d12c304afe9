// SPDX-License-Identifier: Apache-2.0
#include "core/session/past/LabelReader.h"

#include "core/engine/EngineCommands.h"
#include "core/engine/EngineResult.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/program/TestProgram.h"

#include <QTest>

#include <algorithm>
#include <cstdlib>
#include <random>
#include <vector>

namespace labelReaderTest {

using namespace core;

namespace {

constexpr glm::ivec3 size{40, 20, 18}; ///< 3 × 2 × 2 bricks, those at the end not full

struct Labelled {
    glm::ivec3 voxel{0};
    std::uint8_t label = 1;
};

/// A reader that has read these voxels, as an engine answers.
LabelReader readerOf(const std::vector<Labelled>& voxels)
{
    LabelReader reader(size, 0);
    const BrickGrid grid{size};
    while (const std::optional<ReadBricks> portion = reader.next()) {
        EngineResult answer;
        for (const BrickKey& key : portion->keys) {
            std::vector<std::uint8_t> bytes(BrickGrid::voxelsPerBrick);
            bool any = false;
            for (const Labelled& each : voxels) {
                if (grid.brickOf(each.voxel) != int(key.brick))
                    continue;
                bytes[std::size_t(BrickGrid::offsetInBrick(each.voxel))] = each.label;
                any = true;
            }
            if (any)
                answer.changes.push_back(
                    {.key = key, .before = {}, .after = BrickBytes(std::move(bytes))});
        }
        if (!reader.take(answer))
            qFatal("the reader refuses a brick");
    }
    return reader;
}

/// Twice the distance from the middle of a box, along each axis, squared and summed.
std::int64_t apart(const glm::ivec3& voxel, const VoxelBox& box)
{
    std::int64_t sum = 0;
    for (int axis = 0; axis < 3; ++axis) {
        const std::int64_t away = 2 * voxel[axis] - (box.minimum[axis] + box.maximum[axis] - 1);
        sum += away * away;
    }
    return sum;
}

} // namespace

class LabelReaderTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    void aLabelWithoutVoxelsIsNowhere()
    {
        QVERIFY(!readerOf({}).placeOf(1));
        QVERIFY(!readerOf({{{3, 4, 5}, 2}}).placeOf(1));
    }

    void voxelsAreCountedByLabel()
    {
        const LabelReader reader =
            readerOf({{{3, 4, 5}, 2}, {{39, 19, 17}, 2}, {{3, 4, 6}, 1}, {{16, 0, 0}, 2}});
        QCOMPARE(reader.voxelsOf(1), std::int64_t(1));
        QCOMPARE(reader.voxelsOf(2), std::int64_t(3));
        QCOMPARE(reader.voxelsOf(3), std::int64_t(0));
        QCOMPARE(readerOf({}).voxelsOf(1), std::int64_t(0));
    }

    /// Cells reach over the borders of bricks, and the last ones are cut off.
    void cellsHaveTheLabelsOfTheirMiddles()
    {
        std::vector<Labelled> voxels;
        for (int x = 0; x < size.x; ++x)
            voxels.push_back({{x, x / 2, 17 - x / 3}, std::uint8_t(x + 1)});
        const CoarseGrid grid{.volumeSize = size, .cell = {3, 2, 4}};
        const std::vector<std::uint8_t> sampled = readerOf(voxels).sampled(grid);
        QCOMPARE(sampled.size(), grid.cellCount());
        std::vector<std::uint8_t> wanted(grid.cellCount());
        for (const Labelled& each : voxels) {
            if (grid.sampleOf(each.voxel / grid.cell) == each.voxel)
                wanted[grid.numberOf(each.voxel / grid.cell)] = each.label;
        }
        QVERIFY(std::count(wanted.begin(), wanted.end(), 0) < std::ptrdiff_t(wanted.size()) - 1);
        QCOMPARE(sampled, wanted);
        QVERIFY(readerOf({}).sampled(grid).empty());
    }

    /// In the last brick, of which most lies outside.
    void oneVoxelIsItsOwnMiddle()
    {
        const auto place = readerOf({{size - 1, 7}}).placeOf(7);
        QVERIFY(place);
        QVERIFY(place->middle == size - 1);
        QVERIFY(place->box.minimum == size - 1);
        QVERIFY(place->box.maximum == size);
    }

    /// The middle of the box is empty: what is nearest to it counts, and another label does not.
    void theMiddleIsOneOfItsVoxels()
    {
        std::vector<Labelled> voxels{{{3, 4, 5}, 1}, {{33, 4, 5}, 1}, {{18, 4, 5}, 2}};
        const auto ends = readerOf(voxels).placeOf(1);
        QVERIFY(ends);
        QVERIFY(ends->box.minimum == glm::ivec3(3, 4, 5));
        QVERIFY(ends->box.maximum == glm::ivec3(34, 5, 6));
        QVERIFY(ends->middle == glm::ivec3(3, 4, 5) || ends->middle == glm::ivec3(33, 4, 5));
        voxels.push_back({{22, 4, 5}, 1});
        const auto nearer = readerOf(voxels).placeOf(1);
        QVERIFY(nearer);
        QVERIFY(nearer->middle == glm::ivec3(22, 4, 5));
        QVERIFY(nearer->box.maximum == ends->box.maximum);
    }

    /// Every brick once and in order, in larger portions where little is found and in smaller ones
    /// again where much is.
    void portionsFollowWhatIsFound()
    {
        constexpr int bricks = 100'000;
        constexpr int denseFrom = 40'000;
        constexpr int denseTo = 60'000;
        LabelReader reader(glm::ivec3(bricks, 1, 1) * BrickGrid::side, 0);
        const BrickBytes full(std::vector<std::uint8_t>(BrickGrid::voxelsPerBrick, 1));
        std::uint32_t next = 0;
        int portions = 0;
        std::size_t largest = 0;
        for (; const std::optional<ReadBricks> portion = reader.next(); ++portions) {
            EngineResult answer;
            for (const BrickKey& key : portion->keys) {
                QCOMPARE(key.brick, next++);
                if (int(key.brick) >= denseFrom && int(key.brick) < denseTo)
                    answer.changes.push_back({.key = key, .before = {}, .after = full});
            }
            largest = std::max(largest, portion->keys.size());
            if (int(next) > denseFrom + int(largest) && int(next) <= denseTo)
                QCOMPARE(portion->keys.size(), std::size_t(1024));
            QVERIFY(reader.take(answer));
        }
        QCOMPARE(int(next), bricks);
        QCOMPARE(largest, std::size_t(8192));
        QVERIFY2(portions < 40, qPrintable(QString::number(portions)));
    }

    void agreesWithALookAtEveryVoxel()
    {
        std::mt19937 random(11);
        const auto below = [&random](int bound) { return int(random() % unsigned(bound)); };
        for (int round = 0; round < 40; ++round) {
            std::vector<Labelled> voxels;
            for (int i = 0; i < 1 + below(60); ++i)
                voxels.push_back({{below(size.x), below(size.y), below(size.z)}, 1});
            const auto place = readerOf(voxels).placeOf(1);
            QVERIFY(place);
            VoxelBox box;
            for (const Labelled& each : voxels)
                box = box.united({each.voxel, each.voxel + 1});
            QVERIFY(place->box.minimum == box.minimum && place->box.maximum == box.maximum);
            bool isMember = false;
            for (const Labelled& each : voxels) {
                isMember = isMember || each.voxel == place->middle;
                QVERIFY(apart(each.voxel, box) >= apart(place->middle, box));
            }
            QVERIFY(isMember);
        }
    }
};

BURIN_TEST(LabelReaderTest)

} // namespace labelReaderTest

#include "LabelReaderTest.moc"
