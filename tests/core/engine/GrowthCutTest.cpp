// SPDX-License-Identifier: Apache-2.0
#include "core/growth/GrowthCut.h"
#include "core/growth/NarrowestCut.h"
#include "tests/support/program/TestProgram.h"

#include <QTest>

#include <cstdlib>

using namespace core;

namespace {

/// Two rooms of 7 × 7 × 7 voxels along x, and between them a corridor of one voxel, 4 long; the
/// seeds are the whole first slice. Steps go over faces.
std::vector<std::uint8_t> roomsAndCorridor()
{
    std::vector<std::uint8_t> bytes(std::size_t(BrickGrid::voxelsPerBrick) * 4, 0xFF);
    for (int x = 0; x < 16; ++x) {
        for (int y = 0; y < 7; ++y) {
            for (int z = 0; z < 7; ++z) {
                if (x >= 6 && x < 10 && (y != 3 || z != 3))
                    continue;
                const int aside = x < 10 ? 0 : std::abs(y - 3) + std::abs(z - 3);
                const std::uint32_t word =
                    seedWord::member(std::uint32_t(x + 1 + aside), 5, x ? 0 : 31);
                const auto at = std::size_t(BrickGrid::offsetInBrick({x, y, z})) * 4;
                for (std::size_t byte = 0; byte < 4; ++byte)
                    bytes[at + byte] = std::uint8_t(word >> (8 * byte));
            }
        }
    }
    return bytes;
}

} // namespace

class GrowthCutTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void theRoomBeyondTheCorridorLeaves()
    {
        WordBricks words(BrickGrid{{16, 7, 7}}, 1);
        words.add(0, roomsAndCorridor());
        words.link();
        CutGrowth cut{.generation = 22};
        cut.voxels = {{13, 1, 5}};
        const GrowthCutOutcome outcome = cutGrowth(words, cut);
        QCOMPARE(outcome.bricks.size(), std::size_t(1));
        QCOMPARE(outcome.generation, 6u);
        const auto wordAt = [&](const glm::ivec3& place) {
            return outcome.bricks[0].words[std::size_t(BrickGrid::offsetInBrick(place))];
        };
        for (int x = 0; x < 6; ++x)
            QVERIFY(seedWord::isMember(wordAt({x, 2, 2})));
        QCOMPARE(wordAt({6, 3, 3}), seedWord::barrier);
        QCOMPARE(wordAt({6, 2, 4}), seedWord::barrier); // beside the cut
        QCOMPARE(wordAt({9, 3, 3}), seedWord::unvisited);
        QCOMPARE(wordAt({12, 0, 0}), seedWord::unvisited);
        QCOMPARE(
            int(outcome.bricks[0].leaving[std::size_t(BrickGrid::offsetInBrick({12, 0, 0}))]), 5);
    }

    void nothingLeavesWhereThereIsNoNeck()
    {
        WordBricks words(BrickGrid{{16, 7, 7}}, 1);
        words.add(0, roomsAndCorridor());
        words.link();
        CutGrowth cut{.how = CutGrowth::How::Neck, .generation = 22};
        cut.voxels = {{4, 1, 5}};
        QVERIFY(cutGrowth(words, cut).bricks.empty());
        cut.voxels = {{0, 0, 0}, {15, 6, 6}};
        cut.frozen.set(5);
        const GrowthCutOutcome outcome = cutGrowth(words, cut);
        QVERIFY(outcome.bricks.empty());
        QCOMPARE(outcome.generation, 22u);
    }

    void theCutNearestToTheSourcesIsTaken()
    {
        // 0 and 1 are sources, 6 and 7 sinks; 2 … 4 stand one behind the other, and 5 beside none.
        const std::vector<std::vector<std::uint32_t>> next{
            {2}, {2}, {0, 1, 3}, {2, 4}, {3, 6, 7}, {}, {4}, {4}};
        PassageGraph graph;
        for (const auto& neighbours : next) {
            graph.next.insert(graph.next.end(), neighbours.begin(), neighbours.end());
            graph.first.push_back(std::uint32_t(graph.next.size()));
        }
        graph.source = {true, true, false, false, false, false, false, false};
        graph.sink = {false, false, false, false, false, false, true, true};
        QCOMPARE(narrowestCut(graph), (std::vector<std::uint32_t>{2}));
    }
};

BURIN_PLAIN_TEST(GrowthCutTest)
#include "GrowthCutTest.moc"
