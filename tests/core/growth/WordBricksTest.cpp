// SPDX-License-Identifier: Apache-2.0
#include "core/growth/WordBricks.h"

#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/TestVolumes.h"

#include <QTest>

#include <algorithm>
#include <cstdint>
#include <vector>

namespace wordBricksTest {

using namespace core;

/// Words of bricks, of which some are not there.
class WordBricksTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void theLowestDirectionIsThatOfAllThatLeadThere()
    {
        test::Random random(17);
        const BrickGrid grid{glm::ivec3(48, 32, 32)};
        WordBricks words(grid, 9);
        for (const std::uint32_t brick : {7u, 0u, 1u, 3u, 4u, 6u, 9u, 10u, 11u}) {
            std::vector<std::uint8_t> bytes(4 * BrickGrid::voxelsPerBrick, 0);
            for (std::size_t i = 0; i < bytes.size(); i += 4)
                bytes[i] = std::uint8_t(test::randomInt(random, 0, 9));
            words.add(brick, bytes);
        }
        words.link();
        const auto isRare = [](std::uint32_t word) { return word == 3; };
        int found = 0;
        for (WordBricks::Voxel voxel = 0; voxel < words.count(); ++voxel) {
            for (const std::uint32_t neighbours : {6u, 18u, 26u}) {
                std::uint32_t lowest = seedWord::directions;
                words.forNeighbours(voxel, 0, neighbours,
                    [&](WordBricks::Voxel, std::uint32_t word, std::uint32_t direction) {
                        if (isRare(word))
                            lowest = std::min(lowest, direction ^ 1u);
                    });
                QCOMPARE(words.lowestDirectionTo(voxel, neighbours, isRare), lowest);
                found += lowest < seedWord::directions ? 1 : 0;
            }
        }
        QVERIFY(found > 10'000);
    }

    /// In the file and on the GPU they are little-endian.
    void wordsAreReadFromBytes()
    {
        WordBricks words(BrickGrid{glm::ivec3(16)}, 1);
        std::vector<std::uint8_t> bytes(4 * BrickGrid::voxelsPerBrick, 0xFF);
        const std::uint32_t member = seedWord::member(70'000, 9, 4);
        const std::size_t place = 16 * 16 * 5 + 16 * 2 + 3;
        for (std::size_t byte = 0; byte < 4; ++byte)
            bytes[4 * place + byte] = std::uint8_t(member >> 8 * byte);
        words.add(0, bytes);
        words.link();
        QCOMPARE(words[words.find({3, 2, 5})], member);
        QCOMPARE(words[words.find({4, 2, 5})], seedWord::unvisited);
    }
};

BURIN_PLAIN_TEST(WordBricksTest)

} // namespace wordBricksTest

#include "WordBricksTest.moc"
