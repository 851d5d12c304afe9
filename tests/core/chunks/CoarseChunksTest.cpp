// SPDX-License-Identifier: Apache-2.0
#include "core/chunks/CoarseChunks.h"

#include "tests/support/program/TestProgram.h"

#include <QTest>

#include <algorithm>
#include <random>

namespace coarseChunksTest {

using core::ChunkSource;
using core::ChunkTree;
using core::CoarseChunks;

namespace {

constexpr glm::ivec3 size(48, 41, 36);
constexpr glm::dvec3 inOwned(15, 20, 18);
constexpr glm::dvec3 inOther(35, 20, 18);
constexpr double ownedRadius = 10.0;
constexpr double otherRadius = 8.0;

/// Two balls of the same value in something darker, with noise; one of them is owned.
struct Balls {
    std::vector<std::uint16_t> codes;
    std::vector<std::uint8_t> owners;

    Balls()
    {
        std::mt19937 random{5};
        for (int z = 0; z < size.z; ++z) {
            for (int y = 0; y < size.y; ++y) {
                for (int x = 0; x < size.x; ++x) {
                    const glm::dvec3 at(x, y, z);
                    const bool isOwned = glm::distance(at, inOwned) < ownedRadius;
                    codes.push_back(
                        std::uint16_t((isOwned || isInOther(at) ? 1600 : 1000) + random() % 40U));
                    owners.push_back(x < 2 ? ChunkSource::outside : std::uint8_t(isOwned));
                }
            }
        }
    }
    [[nodiscard]] static bool isInOther(const glm::dvec3& at)
    {
        return glm::distance(at, inOther) < otherRadius;
    }
    [[nodiscard]] ChunkSource source() const
    {
        return {.size = size, .codes = codes, .owners = owners};
    }
};

constexpr core::VoxelBox box{.minimum = {7, 3, 5}, .maximum = {7 + size.x, 3 + size.y, 5 + size.z}};

/// The middle voxel of a cell, in the box.
glm::ivec3 middleOf(const glm::ivec3& cell, int side)
{
    return glm::min(side * cell + side / 2, size - 1);
}

/// Calls @p visit(cell, its place in lists).
template <class Visit> void forEachCell(int side, const Visit& visit)
{
    const glm::ivec3 cells = (size + side - 1) / side;
    std::size_t at = 0;
    for (int z = 0; z < cells.z; ++z) {
        for (int y = 0; y < cells.y; ++y) {
            for (int x = 0; x < cells.x; ++x, ++at)
                visit(glm::ivec3(x, y, z), at);
        }
    }
}

} // namespace

/// What is shown of chunks before they are there.
class CoarseChunksTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void cellsAreNoMoreThanAskedFor_data()
    {
        QTest::addColumn<std::int64_t>("most");
        QTest::addColumn<int>("side");
        QTest::newRow("as many as there can be") << CoarseChunks::mostCells << 2;
        QTest::newRow("of two voxels") << std::int64_t(24 * 21 * 18) << 2;
        QTest::newRow("of three") << std::int64_t(24 * 21 * 18 - 1) << 3;
        QTest::newRow("of four") << std::int64_t(16 * 14 * 12 - 1) << 4;
    }
    void cellsAreNoMoreThanAskedFor()
    {
        QFETCH(std::int64_t, most);
        QFETCH(int, side);
        const auto coarse = CoarseChunks::of(Balls().source(), box, {}, most);
        QVERIFY(coarse);
        QCOMPARE(coarse->cell, side);
        QCOMPARE(coarse->box.minimum, box.minimum);
        QCOMPARE(coarse->box.maximum, box.maximum);
        const glm::ivec3 cells = (size + side - 1) / side;
        QCOMPARE(coarse->leaves->size(), std::size_t(cells.x * cells.y * cells.z));
    }

    void eachCellIsOfItsMiddlesOwner()
    {
        const Balls balls;
        const auto coarse = CoarseChunks::of(balls.source(), box, {});
        QVERIFY(coarse);
        int wrong = 0;
        forEachCell(coarse->cell, [&](const glm::ivec3& cell, std::size_t at) {
            const glm::ivec3 voxel = middleOf(cell, coarse->cell);
            const std::uint8_t owner =
                balls.owners[std::size_t((voxel.z * size.y + voxel.y) * size.x + voxel.x)];
            const int leaf = (*coarse->leaves)[at];
            wrong += leaf == 0 ? owner != ChunkSource::outside
                               : coarse->tree.owner(ChunkTree::Chunk(leaf - 1)) != owner;
        });
        QCOMPARE(wrong, 0);
    }

    /// As it is among the chunks themselves.
    void whatStandsApartIsAChunk()
    {
        const auto coarse = CoarseChunks::of(Balls().source(), box, {});
        QVERIFY(coarse);
        const auto chunks = coarse->tree.chunksOfLeaves(coarse->tree.fewest() + 1);
        int ofBall = 0;
        int ofChunk = 0;
        int ofBoth = 0;
        std::optional<ChunkTree::Chunk> wanted;
        const auto chunkAt = [&](std::size_t at) -> std::optional<ChunkTree::Chunk> {
            const int leaf = (*coarse->leaves)[at];
            return leaf == 0 ? std::nullopt : std::optional(chunks[std::size_t(leaf - 1)]);
        };
        forEachCell(coarse->cell, [&](const glm::ivec3& cell, std::size_t at) {
            if (glm::distance(glm::dvec3(middleOf(cell, coarse->cell)), inOther) < 2.0)
                wanted = chunkAt(at);
        });
        QVERIFY(wanted);
        forEachCell(coarse->cell, [&](const glm::ivec3& cell, std::size_t at) {
            const bool isBall = Balls::isInOther(glm::dvec3(middleOf(cell, coarse->cell)));
            const bool isChunk = chunkAt(at) == wanted;
            ofBall += isBall ? 1 : 0;
            ofChunk += isChunk ? 1 : 0;
            ofBoth += isBall && isChunk ? 1 : 0;
        });
        QVERIFY2(10 * ofBoth > 9 * ofBall && 10 * ofBoth > 9 * ofChunk,
            qPrintable(
                QStringLiteral("%1 of %2, %3 in the chunk").arg(ofBoth).arg(ofBall).arg(ofChunk)));
    }

    void itIsCancelled()
    {
        core::Progress progress;
        progress.cancel();
        const auto coarse = CoarseChunks::of(Balls().source(), box, progress);
        QVERIFY(!coarse && coarse.error().code == core::ErrorCode::Cancelled);
    }
};

BURIN_TEST(CoarseChunksTest)

} // namespace coarseChunksTest

#include "CoarseChunksTest.moc"
