// SPDX-License-Identifier: Apache-2.0
#include "core/growth/SeedWord.h"
#include "gpu/fields/bricks/BarrierBricks.h"
#include "tests/support/fixtures/frames/FrameTest.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/TestVolumes.h"

#include <QTest>

#include <vector>

namespace barrierBricksGlTest {

using namespace gpu;

/// Kernel and processor find the same bricks.
class BarrierBricksGlTest : public test::FrameTest {
    Q_OBJECT

private Q_SLOTS:
    void bothFindTheBricksThatHoldABarrier()
    {
        const glm::ivec3 size(70, 33, 20);
        m_fixture->open(test::centredGeometry(size), [](const glm::dvec3&) { return 1000.0; });
        const core::BrickGrid grid{size};
        BarrierBricks byKernel(m_fixture->fieldPrograms, grid, WorkBy::Kernels);
        BarrierBricks byProcessor(m_fixture->fieldPrograms, grid, WorkBy::Processor);
        test::Random random(31);
        reference::DenseFields state(size);
        for (int round = 0; round < 12; ++round) {
            std::vector<std::uint32_t> changed;
            for (int i = 0; i < 5; ++i) {
                const glm::ivec3 voxel(test::randomInt(random, 0, size.x - 1),
                    test::randomInt(random, 0, size.y - 1), test::randomInt(random, 0, size.z - 1));
                const std::uint32_t kinds[]{core::seedWord::barrier, core::seedWord::unvisited,
                    core::seedWord::member(2, 1, 0)};
                state.seedWords(0).at(voxel) = kinds[test::randomInt(random, 0, 2)];
                changed.push_back(std::uint32_t(grid.brickOf(voxel)));
            }
            m_fixture->put(state);
            BrickField& words = m_fixture->edits.fields->seedWords(0);
            for (BarrierBricks* const each : {&byKernel, &byProcessor})
                each->noteAll(changed);
            const std::vector<std::uint32_t> before = byKernel.bricks(words);
            QCOMPARE(byProcessor.bricks(words), before);
            const core::VoxelBox one = byKernel.update(words);
            const core::VoxelBox other = byProcessor.update(words);
            QCOMPARE(one.minimum, other.minimum);
            QCOMPARE(one.maximum, other.maximum);

            std::vector<std::uint8_t> wanted(std::size_t(grid.brickCount()), 0);
            for (int z = 0; z < size.z; ++z)
                for (int y = 0; y < size.y; ++y)
                    for (int x = 0; x < size.x; ++x)
                        if (state.seedWords(0).at({x, y, z}) == core::seedWord::barrier)
                            wanted[std::size_t(grid.brickOf({x, y, z}))] = 1;
            std::vector<std::uint32_t> held;
            for (std::uint32_t brick = 0; brick < wanted.size(); ++brick) {
                if (wanted[brick] != 0)
                    held.push_back(brick);
            }
            QCOMPARE(before, held); // though those that changed had not been looked through
            QCOMPARE(byKernel.bricks(words), held);
            for (const BarrierBricks* const each : {&byKernel, &byProcessor}) {
                std::vector<std::uint8_t> texels(wanted.size(), 0);
                if (each->texture())
                    each->texture().read(glm::ivec3(0), grid.bricks(),
                        std::as_writable_bytes(std::span<std::uint8_t>(texels)));
                QCOMPARE(texels, wanted);
            }
        }
        QVERIFY(byProcessor.any());
    }
};

BURIN_TEST(BarrierBricksGlTest)

} // namespace barrierBricksGlTest

#include "BarrierBricksGlTest.moc"
