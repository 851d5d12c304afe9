// SPDX-License-Identifier: Apache-2.0
#include "core/session/operations/segments/CodeSlabs.h"

#include "tests/support/faults/FailingLog.h"
#include "tests/support/program/TestProgram.h"

#include <QTest>

#include <vector>

namespace codeSlabsTest {

using namespace core;

class CodeSlabsTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    void partsFollowEachOther_data()
    {
        QTest::addColumn<int>("width");
        QTest::addColumn<int>("height");
        QTest::addColumn<int>("depth");
        QTest::addColumn<std::vector<int>>("slices");
        QTest::newRow("all at once") << 64 << 32 << 16 << std::vector<int>{16};
        QTest::newRow("exactly 4 MiB") << 512 << 512 << 8 << std::vector<int>{8};
        QTest::newRow("one slice more") << 512 << 512 << 9 << std::vector<int>{8, 1};
        QTest::newRow("several parts") << 512 << 512 << 20 << std::vector<int>{8, 8, 4};
        QTest::newRow("large slices") << 2048 << 1025 << 3 << std::vector<int>{1, 1, 1};
        QTest::newRow("slices beyond 2^31 voxels") << 65536 << 65536 << 2 << std::vector<int>{1, 1};
        QTest::newRow("an empty box") << 512 << 0 << 20 << std::vector<int>{};
    }
    void partsFollowEachOther()
    {
        QFETCH(const int, width);
        QFETCH(const int, height);
        QFETCH(const int, depth);
        QFETCH(const std::vector<int>, slices);
        const glm::ivec3 begin(7, 5, 3);
        const VoxelBox box{begin, begin + glm::ivec3(width, height, depth)};
        CodeSlabs slabs(box);
        int next = box.minimum.z;
        for (const int thickness : slices) {
            const std::optional<VoxelBox> slab = slabs.take();
            QVERIFY(slab);
            QCOMPARE(slab->minimum, glm::ivec3(7, 5, next));
            QCOMPARE(slab->maximum, glm::ivec3(7 + width, 5 + height, next + thickness));
            next += thickness;
        }
        QVERIFY(!slabs.take());
        QVERIFY(!slabs.take());
    }

    void nothingOfNoBox() { QVERIFY(!CodeSlabs().take()); }
};

BURIN_TEST(CodeSlabsTest)

} // namespace codeSlabsTest

#include "CodeSlabsTest.moc"
