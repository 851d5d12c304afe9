// SPDX-License-Identifier: Apache-2.0
#include "core/contour/ContourState.h"

#include "core/brick/ThreadWithoutVoxels.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/program/TestProgram.h"

#include <QTest>

#include <vector>

namespace contourStateTest {

using namespace core;

class ContourStateTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    void besideTheBoxIsNothing()
    {
        const VoxelBox box{{2, 3, 4}, {4, 5, 6}};
        const ContourState state(box, std::vector<std::uint8_t>(8, ContourGround::inside));
        QVERIFY(state.isInside({2, 3, 4}) && state.isInside({3, 4, 5}));
        QVERIFY(!state.wasInside({2, 3, 4}));
        QCOMPARE(state.gained(), std::int64_t(8));
        QCOMPARE(state.voxelCount(), std::size_t(8));
        for (const glm::ivec3& voxel :
            {glm::ivec3(1, 3, 4), glm::ivec3(4, 3, 4), glm::ivec3(2, 2, 4), glm::ivec3(2, 5, 4),
                glm::ivec3(2, 3, 3), glm::ivec3(2, 3, 6)})
            QVERIFY(!state.isInside(voxel) && !state.wasInside(voxel));
    }

    /// A thread that serves a window is found out whatever it reads; numbers are no voxels.
    void whoReadsVoxelsIsFoundOut()
    {
        ContourState state({{0, 0, 0}, {2, 2, 2}}, std::vector<std::uint8_t>(8, 0));
        const auto looks = [&](auto&& does) {
            const std::int64_t before = ThreadWithoutVoxels::looks();
            const ThreadWithoutVoxels here;
#ifdef _GLIBCXX_ASSERTIONS
            QTest::ignoreMessage(
                QtWarningMsg, "A thread that serves a window looked at the voxels of a brick.");
#endif
            does();
            return ThreadWithoutVoxels::looks() - before;
        };
        QVERIFY(looks([&] { (void)state.voxels(); }) > 0);
        QVERIFY(looks([&] { (void)state.isInside(glm::ivec3(0)); }) > 0);
        QVERIFY(looks([&] { (void)state.wasInside(glm::ivec3(0)); }) > 0);
        QVERIFY(looks([&] { state.pass(std::vector<std::uint32_t>{1, 2}); }) > 0);
        QVERIFY(looks([&] { ContourState(state.box(), {0, 0, 0, 0, 0, 0, 0, 0}); }) > 0);
        const std::int64_t before = ThreadWithoutVoxels::looks();
        const ThreadWithoutVoxels here;
        QCOMPARE(state.gained(), std::int64_t(2));
        QCOMPARE(state.lost(), std::int64_t(0));
        QCOMPARE(state.voxelCount(), std::size_t(8));
        QCOMPARE(state.box().maximum, glm::ivec3(2));
        QCOMPARE(ThreadWithoutVoxels::looks(), before);
    }
};

BURIN_TEST(ContourStateTest)

} // namespace contourStateTest

#include "ContourStateTest.moc"
