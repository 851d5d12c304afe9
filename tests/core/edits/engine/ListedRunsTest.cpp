// SPDX-License-Identifier: Apache-2.0
#include "core/edits/engine/ListedRuns.h"

#include "tests/support/program/TestProgram.h"

#include <QTest>

#include <map>
#include <random>
#include <vector>

namespace listedRunsTest {

using core::RelabelListed;

/// Runs of voxels become bricks, held to voxel by voxel; runs go on over the ends of rows.
class ListedRunsTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void randomRuns_data()
    {
        QTest::addColumn<int>("x");
        QTest::addColumn<int>("y");
        QTest::addColumn<int>("z");
        QTest::addColumn<int>("percent");
        for (const int percent : {1, 50, 97}) {
            QTest::addRow("one brick, %d %%", percent) << 16 << 16 << 16 << percent;
            QTest::addRow("several, %d %%", percent) << 37 << 18 << 19 << percent;
            QTest::addRow("a column, %d %%", percent) << 1 << 3 << 40 << percent;
            QTest::addRow("a slice, %d %%", percent) << 33 << 17 << 1 << percent;
        }
    }
    void randomRuns()
    {
        QFETCH(const int, x);
        QFETCH(const int, y);
        QFETCH(const int, z);
        QFETCH(const int, percent);
        const glm::ivec3 size(x, y, z);
        const core::BrickGrid grid{size};
        std::mt19937 random(std::uint32_t(x + percent));
        core::VoxelRuns given;
        core::VoxelRuns taken;
        std::map<std::uint32_t, std::vector<std::uint8_t>> expected;
        std::uint64_t voxel = 0;
        for (int k = 0; k < size.z; ++k) {
            for (int j = 0; j < size.y; ++j) {
                for (int i = 0; i < size.x; ++i, ++voxel) {
                    if (int(random() % 100) >= percent)
                        continue;
                    const bool gives = random() % 8 != 0;
                    (gives ? given : taken).append(voxel, 1);
                    std::vector<std::uint8_t>& brick =
                        expected[std::uint32_t(grid.brickOf({i, j, k}))];
                    brick.resize(core::BrickGrid::voxelsPerBrick, 0);
                    brick[std::size_t(core::BrickGrid::offsetInBrick({i, j, k}))] =
                        gives ? RelabelListed::give : RelabelListed::take;
                }
            }
        }
        core::ListedRuns listed(size);
        listed.add(given, RelabelListed::give);
        listed.add(taken, RelabelListed::take);
        const RelabelListed relabel = listed.relabel({.plane = 3, .label = 7});
        QCOMPARE(int(relabel.target.plane), 3);
        QCOMPARE(int(relabel.target.label), 7);
        QCOMPARE(relabel.bricks.size(), expected.size());
        auto next = expected.begin();
        for (const RelabelListed::Brick& brick : relabel.bricks) {
            QCOMPARE(brick.brick, next->first);
            QVERIFY(brick.asked == next->second);
            ++next;
        }
        QVERIFY(listed.relabel({}).bricks.empty());
    }
};

BURIN_TEST(ListedRunsTest)

} // namespace listedRunsTest

#include "ListedRunsTest.moc"
