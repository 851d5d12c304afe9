// SPDX-License-Identifier: Apache-2.0
#include "core/growth/cut/GrowthCut.h"
#include "core/growth/cut/NarrowestCut.h"
#include "tests/support/program/TestProgram.h"

#include <QTest>

#include <cstdlib>

namespace growthCutTest {

using namespace core;

namespace {

/// Two rooms of 7 × 7 voxels along x, and between them a corridor of one voxel; the seeds are the
/// whole first slice. Steps go over faces.
std::vector<std::uint8_t> roomsAndCorridor(int from = 6, int to = 10)
{
    std::vector<std::uint8_t> bytes(std::size_t(BrickGrid::voxelsPerBrick) * 4, 0xFF);
    for (int x = 0; x < 16; ++x) {
        for (int y = 0; y < 7; ++y) {
            for (int z = 0; z < 7; ++z) {
                if (x >= from && x < to && (y != 3 || z != 3))
                    continue;
                const int aside = x < to ? 0 : std::abs(y - 3) + std::abs(z - 3);
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

/// Words along x, one brick.
WordBricks rowOf(const std::vector<std::uint32_t>& row)
{
    std::vector<std::uint8_t> bytes(std::size_t(BrickGrid::voxelsPerBrick) * 4, 0xFF);
    for (std::size_t x = 0; x < row.size(); ++x) {
        for (std::size_t byte = 0; byte < 4; ++byte)
            bytes[4 * x + byte] = std::uint8_t(row[x] >> (8 * byte));
    }
    WordBricks words(BrickGrid{{16, 1, 1}}, 1);
    words.add(0, bytes);
    words.link();
    return words;
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
        cut.voxels = {{10, 3, 3}};
        const auto cutOff = cutGrowth(words, cut);
        QVERIFY(cutOff);
        const GrowthCutOutcome& outcome = *cutOff;
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
        const auto outcome = cutGrowth(words, cut);
        QVERIFY(outcome && outcome->bricks.empty());
        QCOMPARE(outcome->generation, 22u);
    }

    void seedsAndEmptyPlacesAreRefused()
    {
        WordBricks words(BrickGrid{{16, 7, 7}}, 1);
        words.add(0, roomsAndCorridor());
        words.link();
        using How = CutGrowth::How;
        for (const How how : {How::Subtree, How::Neck, How::Here}) {
            CutGrowth cut{.how = how, .generation = 22};
            // Two seeds, one of them twice, beside others.
            cut.voxels = {{12, 3, 3}, {0, 0, 0}, {0, 5, 5}, {0, 0, 0}};
            const auto seeds = cutGrowth(words, cut);
            QVERIFY(!seeds);
            QCOMPARE(seeds.error().code, ErrorCode::SeedsStay);
            QCOMPARE(seeds.error().arguments, QStringList{QStringLiteral("2")});
            QVERIFY(!leavingVoxels(words, cut));

            cut.voxels = {{7, 0, 0}}; // beside the corridor
            QCOMPARE(cutGrowth(words, cut).error().code, ErrorCode::NothingGrown);
            cut.voxels = {{0, 0, 0}, {15, 6, 6}};
            cut.lockedLabels.set(5);
            QCOMPARE(cutGrowth(words, cut).error().code, ErrorCode::NothingGrown);
        }
    }

    /// A stroke that only in part lies beyond the corridor: no neck parts it from the seeds.
    void allThatIsSketchedLeaves()
    {
        WordBricks words(BrickGrid{{16, 7, 7}}, 1);
        words.add(0, roomsAndCorridor());
        words.link();
        CutGrowth cut{.generation = 22};
        for (int x = 2; x < 14; ++x)
            cut.voxels.emplace_back(x, 3, 3);
        const auto outcome = cutGrowth(words, cut);
        QVERIFY(outcome);
        const auto gone = [&](const glm::ivec3& place) {
            return !seedWord::isMember(
                outcome->bricks[0].words[std::size_t(BrickGrid::offsetInBrick(place))]);
        };
        for (const glm::ivec3& place : cut.voxels)
            QVERIFY(gone(place));
        QVERIFY(gone({14, 1, 5})); // it hung on the corridor, which was sketched
        for (int y = 0; y < 7; ++y)
            QVERIFY(!gone({0, y, 3}));
        QVERIFY(!gone({3, 2, 2}));
    }

    /// The corridor is nearer to the seeds than to the sketch: beyond it, what is nearer to them
    /// stays, too.
    void whatIsNearerToTheSeedsStays()
    {
        WordBricks words(BrickGrid{{16, 7, 7}}, 1);
        words.add(0, roomsAndCorridor(3, 4));
        words.link();
        CutGrowth cut{.generation = 22};
        cut.voxels = {{15, 3, 3}};
        const auto outcome = cutGrowth(words, cut);
        QVERIFY(outcome);
        for (int x = 0; x < 16; ++x) {
            const std::uint32_t word =
                outcome->bricks[0].words[std::size_t(BrickGrid::offsetInBrick({x, 3, 4}))];
            QCOMPARE(seedWord::isMember(word), x != 3 && x < 8);
        }
        // A plug asks only what lies beyond.
        cut.how = CutGrowth::How::Neck;
        const auto plugged = cutGrowth(words, cut);
        QVERIFY(plugged);
        QCOMPARE(plugged->generation, 3u);
    }

    /// Two seeds of two bursts; the sketch cuts off what came from the first, but the second
    /// reaches it over members that came later: it stays, and is told later generations.
    void whoHasAnotherWayToASeedComesLater()
    {
        std::vector<std::uint32_t> line(12, seedWord::unvisited);
        for (std::uint32_t x = 0; x < 8; ++x)
            line[x] = seedWord::member(x + 1, 5, x == 0 ? 31 : 0);
        line[9] = seedWord::member(9, 5, 31); // and from there to the left
        line[8] = seedWord::member(10, 5, 1);
        const WordBricks words = rowOf(line);
        CutGrowth cut{.barrier = false, .generation = 10};
        cut.voxels = {{4, 0, 0}};
        for (const auto how : {CutGrowth::How::Subtree, CutGrowth::How::Here}) {
            cut.how = how;
            const auto outcome = cutGrowth(words, cut);
            QVERIFY(outcome);
            const std::vector<std::uint32_t>& now = outcome->bricks[0].words;
            QCOMPARE(now[3], line[3]);
            QCOMPARE(now[4], seedWord::unvisited);
            // 5, 6 and 7 hung on 4. 5 and 6 are no nearer to the second seed than to the sketch.
            const bool here = how == CutGrowth::How::Here;
            QCOMPARE(now[5], here ? seedWord::member(13, 5, 1) : seedWord::unvisited);
            QCOMPARE(now[6], here ? seedWord::member(12, 5, 1) : seedWord::unvisited);
            QCOMPARE(now[7], seedWord::member(11, 5, 1));
            QCOMPARE(now[8], line[8]);
            QCOMPARE(outcome->generation, here ? 13u : 11u);
        }
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

} // namespace growthCutTest

#include "GrowthCutTest.moc"
