// SPDX-License-Identifier: Apache-2.0
#include "core/islands/VoxelIslands.h"

#include "tests/support/program/TestProgram.h"

#include <QTest>

#include <random>
#include <set>

namespace voxelIslandsTest {

namespace {

/// By flooding from each voxel that no flood has reached, in the order of the first voxels.
std::vector<std::set<std::uint64_t>> flooded(
    const std::set<std::uint64_t>& voxels, const glm::ivec3& size)
{
    std::vector<std::set<std::uint64_t>> islands;
    std::set<std::uint64_t> left = voxels;
    while (!left.empty()) {
        std::set<std::uint64_t>& island = islands.emplace_back();
        std::vector<std::uint64_t> front{*left.begin()};
        left.erase(left.begin());
        while (!front.empty()) {
            const std::uint64_t at = front.back();
            front.pop_back();
            island.insert(at);
            const int x = int(at % std::uint64_t(size.x));
            const int y = int(at / std::uint64_t(size.x) % std::uint64_t(size.y));
            const int z = int(at / std::uint64_t(size.x) / std::uint64_t(size.y));
            for (int near = 0; near < 27; ++near) {
                const glm::ivec3 to(x + near % 3 - 1, y + near / 3 % 3 - 1, z + near / 9 - 1);
                if (glm::any(glm::lessThan(to, glm::ivec3(0)))
                    || glm::any(glm::greaterThanEqual(to, size)))
                    continue;
                const auto number = std::uint64_t((to.z * size.y + to.y) * size.x + to.x);
                if (left.erase(number) > 0)
                    front.push_back(number);
            }
        }
    }
    return islands;
}

std::set<std::uint64_t> voxelsOf(const core::VoxelRuns& runs)
{
    std::set<std::uint64_t> voxels;
    for (const core::VoxelRun& run : runs.runs()) {
        for (std::uint64_t i = 0; i < run.count; ++i)
            voxels.insert(run.first + i);
    }
    return voxels;
}

} // namespace

class VoxelIslandsTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void asFlooded()
    {
        std::mt19937 random{5};
        std::size_t several = 0;
        for (int round = 0; round < 200; ++round) {
            // One after the other: in which order arguments are drawn is the compiler's.
            glm::ivec3 size(1 + int(random() % 7));
            size.y = 1 + int(random() % 6);
            size.z = 1 + int(random() % 5);
            const unsigned share = 1 + unsigned(random() % 9);
            std::set<std::uint64_t> voxels;
            core::VoxelRuns runs;
            for (std::uint64_t at = 0; at < std::uint64_t(size.x * size.y * size.z); ++at) {
                if (random() % 10 < share) {
                    voxels.insert(at);
                    runs.append(at, 1);
                }
            }
            const auto expected = flooded(voxels, size);
            const auto islands = core::islandsOf(runs, size, 1, {});
            QVERIFY(islands.has_value());
            QCOMPARE(islands->size(), expected.size());
            for (std::size_t i = 0; i < expected.size(); ++i)
                QVERIFY(voxelsOf((*islands)[i]) == expected[i]);
            several += expected.size() > 1 ? 1 : 0;

            const auto large = core::islandsOf(runs, size, 3, {});
            std::size_t count = 0;
            for (const auto& island : expected)
                count += island.size() >= 3 ? 1 : 0;
            QCOMPARE(large->size(), count);
        }
        QVERIFY2(several > 30, qPrintable(QString::number(several)));
    }

    /// Voxels that follow each other in memory, at the end of a row and at the beginning of the
    /// next one, do not touch.
    void rowsEnd()
    {
        core::VoxelRuns runs;
        runs.append(4, 2);
        const auto islands = core::islandsOf(runs, {5, 4, 1}, 1, {});
        QVERIFY(islands.has_value());
        QCOMPARE(islands->size(), std::size_t(2));
    }

    void cancelled()
    {
        core::VoxelRuns runs;
        runs.append(0, 8);
        core::Progress progress;
        progress.cancel();
        const auto islands = core::islandsOf(runs, {2, 2, 2}, 1, progress);
        QVERIFY(!islands);
        QCOMPARE(islands.error().code, core::ErrorCode::Cancelled);
        QVERIFY(core::islandsOf({}, {2, 2, 2}, 1, progress)->empty());
    }
};

BURIN_TEST(VoxelIslandsTest)

} // namespace voxelIslandsTest

#include "VoxelIslandsTest.moc"
