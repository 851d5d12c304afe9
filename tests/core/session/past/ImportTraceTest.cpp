// SPDX-License-Identifier: Apache-2.0
#include "core/session/past/ImportTrace.h"

#include "core/edits/kinds/imports/ImportMask.h"
#include "tests/support/cases/BoxedMasks.h"
#include "tests/support/program/TestProgram.h"

#include <QTest>

namespace importTraceTest {

using namespace core;

namespace {

using Bricks = std::optional<std::set<std::uint32_t>>;

constexpr glm::ivec3 size(40, 36, 34);

Bricks bricksIn(const std::vector<VoxelBox>& boxes)
{
    const BrickGrid grid{size};
    std::set<std::uint32_t> bricks;
    for (const VoxelBox& box : boxes) {
        for (int z = box.minimum.z; z < box.maximum.z; ++z) {
            for (int y = box.minimum.y; y < box.maximum.y; ++y) {
                for (int x = box.minimum.x; x < box.maximum.x; ++x)
                    bricks.insert(std::uint32_t(grid.brickOf({x, y, z})));
            }
        }
    }
    return bricks;
}

} // namespace

/// Where imports have voxels, from what their rows hold.
class ImportTraceTest : public QObject {
    Q_OBJECT

    const VoxelBox m_low{{2, 2, 2}, {12, 12, 12}};
    const VoxelBox m_long{{15, 0, 30}, {33, 1, 34}};
    const VoxelBox m_whole{{0, 0, 0}, size};
    const VoxelBox m_last{size - 1, size};

private Q_SLOTS:
    void findsTheBricks()
    {
        ImportTrace trace;
        QVERIFY(trace.empty());
        trace.note(5, test::importOfBoxes({m_low, m_long}, size));
        trace.note(7, test::importOfBoxes({m_whole}, size)); // one run through all bricks
        trace.note(9, test::importOfBoxes({m_last}, size));
        trace.note(11, ImportMask{.file = QStringLiteral("never read")});
        QVERIFY(!trace.empty());
        QVERIFY(!trace.bricksOf(5));
        int reported = 0;
        int last = 0;
        trace.workOut(size, Progress([&](ProgressStep, int done, int total) {
            ++reported;
            last = done;
            QCOMPARE(total, 4);
        }));
        QCOMPARE(reported, 4);
        QCOMPARE(last, 3);
        QVERIFY(!trace.empty());
        QVERIFY(trace.bricksOf(5) == bricksIn({m_low, m_long}));
        QVERIFY(trace.bricksOf(7) == bricksIn({m_whole}));
        QVERIFY(trace.bricksOf(9) == bricksIn({m_last}));
        QVERIFY(trace.bricksOf(11) == bricksIn({}));
        QVERIFY(!trace.bricksOf(6));
    }

    void damagedVoxelsAreNowhere()
    {
        ImportMask mask = test::importOfBoxes({m_low, m_long}, size);
        mask.segments->front().voxels.chop(3);
        ImportTrace trace;
        trace.note(1, mask);
        trace.workOut(size, Progress());
        QVERIFY(trace.bricksOf(1) == bricksIn({m_long}));
    }

    void stopsWhereItIsAborted()
    {
        Progress progress;
        progress.cancel();
        ImportTrace trace;
        trace.note(1, test::importOfBoxes({m_low}, size));
        trace.workOut(size, progress);
        QVERIFY(!trace.bricksOf(1));
    }
};

BURIN_TEST(ImportTraceTest)

} // namespace importTraceTest

#include "ImportTraceTest.moc"
