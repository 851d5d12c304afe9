// SPDX-License-Identifier: Apache-2.0
#include "core/growth/front/GrownBrick.h"
#include "core/growth/SeedWord.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/TestVolumes.h"

#include <QTest>

#include <vector>

namespace grownBrickTest {

using namespace core;

class GrownBrickTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }
    void membersAreThoseThatMayGrow();
    void onlyPendingSeedsWait();
};

void GrownBrickTest::membersAreThoseThatMayGrow()
{
    test::Random random(4711);
    std::bitset<256> locked;
    locked.set(4).set(255);
    for (int round = 0; round < 40; ++round) {
        const std::uint32_t labels[]{3, 3, std::uint32_t(round % 2 == 0 ? 4 : 3), 255, 9};
        std::vector<std::uint32_t> words;
        std::bitset<256> wanted;
        for (int i = 0; i < BrickGrid::voxelsPerBrick; ++i) {
            const std::uint32_t label = labels[test::randomInt(random, 0, 4)];
            // Painted members have generation 0.
            const auto generation = std::uint32_t(test::randomInt(random, 0, 3));
            const std::uint32_t kinds[]{seedWord::unvisited, seedWord::barrier,
                seedWord::pendingSeed(label), seedWord::member(generation, label, 3),
                seedWord::member(seedWord::maxGeneration, label, seedWord::seedDirection)};
            words.push_back(kinds[test::randomInt(random, 0, 4)]);
            if (seedWord::isMember(words.back()) && !locked.test(label))
                wanted.set(label);
        }
        const GrownBrick brick = grownBrick(words, locked);
        QVERIFY(brick.labels == wanted);
        QVERIFY(brick.hasPendingSeeds);
        for (std::size_t i = 0; i < words.size(); ++i) {
            const bool isWanted =
                seedWord::isMember(words[i]) && !locked.test(seedWord::label(words[i]));
            QCOMPARE((brick.members[i / 16] >> i % 16 & 1) != 0, isWanted);
        }
    }
}

void GrownBrickTest::onlyPendingSeedsWait()
{
    std::vector<std::uint32_t> words(BrickGrid::voxelsPerBrick, seedWord::unvisited);
    words[5] = seedWord::barrier;
    words[6] = seedWord::member(2, 1, 0);
    QVERIFY(!grownBrick(words, {}).hasPendingSeeds);
    words[4000] = seedWord::pendingSeed(1);
    QVERIFY(grownBrick(words, {}).hasPendingSeeds);
}

BURIN_TEST(GrownBrickTest)

} // namespace grownBrickTest

#include "GrownBrickTest.moc"
