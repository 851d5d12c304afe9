// SPDX-License-Identifier: Apache-2.0
#include "core/chunks/ChunkColours.h"
#include "core/chunks/BoxWalk.h"
#include "tests/support/program/TestProgram.h"

#include <QTest>

#include <random>

namespace chunkColoursTest {

using core::ChunkColours;
using core::ChunkTree;

/// Colours that chunks are drawn in.
class ChunkColoursTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void neighboursDiffer_data()
    {
        QTest::addColumn<int>("seed");
        for (int seed = 0; seed < 4; ++seed)
            QTest::addRow("random %d", seed) << seed;
    }
    void neighboursDiffer()
    {
        QFETCH(int, seed);
        std::mt19937 random{std::uint32_t(seed)};
        const glm::ivec3 size(48 - seed, 40, 36 + seed);
        std::vector<std::uint16_t> codes;
        std::vector<std::uint8_t> owners;
        const core::BoxWalk walk(size);
        for (std::size_t voxel = 0; voxel < walk.voxels(); ++voxel) {
            const glm::ivec3 place = walk.placeOf(voxel);
            const glm::ivec3 block = place / (5 + seed);
            codes.push_back(std::uint16_t(1000
                + (block.x * 7 + block.y * 13 + block.z * 29) % 11 * 90 + int(random() % 120)));
            owners.push_back(random() % 60 == 0 ? core::ChunkSource::outside
                                                : std::uint8_t(place.x > 20 && place.y > 9));
        }
        const auto tree = ChunkTree::of({.size = size, .codes = codes, .owners = owners}, {});
        QVERIFY(tree);
        const ChunkColours colours(*tree, size);
        std::vector<std::uint8_t> before;
        for (const int count : {tree->fewest(), 30, 300, 301, tree->finest()}) {
            const std::vector<std::uint8_t> chosen = colours.of(*tree, count);
            QCOMPARE(chosen.size(), std::size_t(tree->finest()));
            const std::vector<ChunkTree::Chunk> chunks = tree->chunksOfLeaves(count);
            int touching = 0;
            walk.forEachPair([&](std::size_t voxel, std::size_t neighbour) {
                const auto one = tree->leafAt(voxel);
                const auto other = tree->leafAt(neighbour);
                if (!one || !other)
                    return;
                const bool same = tree->chunkAt(voxel, count) == tree->chunkAt(neighbour, count);
                if (same != (chunks[*one] == chunks[*other])
                    || same != (chosen[*one] == chosen[*other]))
                    QFAIL("a colour too many, or one too few");
                touching += same ? 0 : 1;
            });
            QVERIFY(count == tree->fewest() || touching > 100);
            for (const std::uint8_t colour : chosen)
                QVERIFY(colour < ChunkColours::colours);
            if (count == 301) {
                // One chunk more leaves most colours as they were.
                int changed = 0;
                for (std::size_t leaf = 0; leaf < chosen.size(); ++leaf)
                    changed += chosen[leaf] != before[leaf] ? 1 : 0;
                QVERIFY2(4 * changed < int(chosen.size()), qPrintable(QString::number(changed)));
            }
            before = chosen;
        }
    }
};

BURIN_TEST(ChunkColoursTest)

} // namespace chunkColoursTest

#include "ChunkColoursTest.moc"
