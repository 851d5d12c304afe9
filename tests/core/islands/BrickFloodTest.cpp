// SPDX-License-Identifier: Apache-2.0
#include "core/islands/BrickFlood.h"

#include "tests/support/faults/FailingLog.h"
#include "tests/support/program/TestProgram.h"

#include <QTest>

#include <algorithm>
#include <cstdlib>
#include <optional>
#include <random>
#include <vector>

namespace brickFloodTest {

namespace {

using core::BrickBits;
using core::BrickFlood;
using core::BrickGrid;
using core::SliceAxis;

std::size_t indexIn(const glm::ivec3& size, const glm::ivec3& at)
{
    return (std::size_t(at.z) * std::size_t(size.y) + std::size_t(at.y)) * std::size_t(size.x)
        + std::size_t(at.x);
}

BrickBits bitsOf(const BrickGrid& grid, std::uint32_t brick, const std::vector<bool>& possible)
{
    BrickBits bits;
    const core::VoxelBox box = grid.boxOf(int(brick));
    for (int z = box.minimum.z; z < box.maximum.z; ++z) {
        for (int y = box.minimum.y; y < box.maximum.y; ++y) {
            for (int x = box.minimum.x; x < box.maximum.x; ++x) {
                if (possible[indexIn(grid.volumeSize, {x, y, z})])
                    bits.add(std::size_t(BrickGrid::offsetInBrick({x, y, z})));
            }
        }
    }
    return bits;
}

std::vector<bool> foundBy(const BrickFlood& flood, const BrickGrid& grid)
{
    const glm::ivec3 size = grid.volumeSize;
    std::vector<bool> all(std::size_t(size.x) * std::size_t(size.y) * std::size_t(size.z), false);
    for (const auto& [brick, bits] : flood.found()) {
        const core::VoxelBox box = grid.boxOf(int(brick));
        bits.forEach([&, low = box.minimum](std::size_t voxel) {
            const glm::ivec3 at =
                low + glm::ivec3(int(voxel % 16), int(voxel / 16 % 16), int(voxel / 256));
            all.at(indexIn(size, at)) = true;
        });
    }
    return all;
}

/// By a queue over the whole volume.
std::vector<bool> expected(const glm::ivec3& size, const glm::ivec3& first,
    const BrickFlood::Rule& rule, const std::vector<bool>& possible)
{
    std::vector<bool> found(possible.size(), false);
    std::vector<glm::ivec3> queue;
    if (possible[indexIn(size, first)]) {
        found[indexIn(size, first)] = true;
        queue.push_back(first);
    }
    for (std::size_t next = 0; next < queue.size(); ++next) {
        for (int step = 0; step < 27; ++step) {
            const glm::ivec3 by(step % 3 - 1, step / 3 % 3 - 1, step / 9 - 1);
            const glm::ivec3 at = queue[next] + by;
            const int sides = std::abs(by.x) + std::abs(by.y) + std::abs(by.z);
            const int inPlane = rule.across ? sides - std::abs(by[*rule.across]) : sides;
            if (sides == 0 || (inPlane > 1 && !rule.corners)
                || (rule.within && by[alongOf(*rule.within)] != 0))
                continue;
            if (at.x < 0 || at.y < 0 || at.z < 0 || at.x >= size.x || at.y >= size.y
                || at.z >= size.z)
                continue;
            if (!possible[indexIn(size, at)] || found[indexIn(size, at)])
                continue;
            found[indexIn(size, at)] = true;
            queue.push_back(at);
        }
    }
    return found;
}

} // namespace

class BrickFloodTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    /// Bricks come one by one, all that are wanted, or more than that: the region is the same.
    void equalsAQueueOverTheVolume()
    {
        std::size_t several = 0;
        for (std::uint32_t seed = 1; seed <= 60; ++seed) {
            std::mt19937 random(seed);
            const auto below = [&](int limit) { return int(random() % std::uint32_t(limit)); };
            const glm::ivec3 size{10 + below(45), 10 + below(45), 10 + below(30)};
            const BrickGrid grid{size};
            std::vector<bool> possible(
                std::size_t(size.x) * std::size_t(size.y) * std::size_t(size.z));
            const int share = 25 + below(70); // around where regions begin to hang together
            for (std::size_t voxel = 0; voxel < possible.size(); ++voxel)
                possible[voxel] = below(100) < share;
            BrickFlood::Rule rule{.corners = below(2) == 0};
            if (below(2) == 0)
                rule.within = SliceAxis(below(3));
            else if (below(2) == 0)
                rule.across = below(3);
            const glm::ivec3 first{below(size.x), below(size.y), below(size.z)};
            if (seed % 10 != 0)
                possible[indexIn(size, first)] = true;
            BrickFlood flood(size, first, rule);
            QCOMPARE(flood.wanted().size(), std::size_t(1));
            const int manner = int(seed % 3);
            while (!flood.wanted().empty()) {
                std::vector<std::uint32_t> given(flood.wanted().begin(), flood.wanted().end());
                if (manner == 0)
                    given = {given[std::size_t(below(int(given.size())))]};
                if (manner == 2) {
                    const auto other = std::uint32_t(below(grid.brickCount()));
                    if (std::find(given.begin(), given.end(), other) == given.end()
                        && !flood.wasGiven(other))
                        given.push_back(other);
                }
                for (const std::uint32_t brick : given) {
                    QVERIFY(!flood.wasGiven(brick));
                    flood.give(brick, bitsOf(grid, brick, possible));
                    QVERIFY(flood.wasGiven(brick));
                }
                QVERIFY(flood.spread(core::Progress()));
            }
            QVERIFY2(foundBy(flood, grid) == expected(size, first, rule, possible),
                qPrintable(QStringLiteral("seed %1").arg(seed)));
            several += flood.found().size() > 1 ? 1 : 0;
        }
        QVERIFY(several > 10);
    }

    /// A region that ends in its brick asks for its neighbours only where it touches them.
    void asksForWhatItReaches()
    {
        const glm::ivec3 size(64, 64, 64);
        const BrickGrid grid{size};
        std::vector<bool> possible(std::size_t(64 * 64 * 64), false);
        for (int x = 20; x < 40; ++x) // a rod, from brick 1 into brick 2
            possible[indexIn(size, {x, 21, 22})] = true;
        BrickFlood flood(size, {25, 21, 22}, {});
        std::vector<std::uint32_t> asked;
        while (!flood.wanted().empty()) {
            const std::uint32_t brick = *flood.wanted().begin();
            asked.push_back(brick);
            flood.give(brick, bitsOf(grid, brick, possible));
            QVERIFY(flood.spread(core::Progress()));
        }
        QVERIFY(asked
            == std::vector<std::uint32_t>({std::uint32_t(grid.brickOf({25, 21, 22})),
                std::uint32_t(grid.brickOf({33, 21, 22}))}));
        QCOMPARE(flood.found().size(), std::size_t(2));
    }

    void cancelled()
    {
        BrickFlood flood({20, 20, 20}, {3, 3, 3}, {});
        BrickBits all;
        for (std::size_t voxel = 0; voxel < std::size_t(BrickGrid::voxelsPerBrick); ++voxel)
            all.add(voxel);
        flood.give(0, all);
        core::Progress stopped;
        stopped.cancel();
        QVERIFY(!flood.spread(stopped));
        QVERIFY(flood.spread(core::Progress()));
        QVERIFY(!flood.wanted().empty());
    }
};

BURIN_TEST(BrickFloodTest)

} // namespace brickFloodTest

#include "BrickFloodTest.moc"
