// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/values/ThresholdSegment.h"
#include "core/session/EditSession.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/fixtures/EditEngineFixture.h"
#include "tests/support/program/LongRun.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/PlainEdits.h"
#include "tests/support/scenes/TestVolumes.h"

#include <QElapsedTimer>
#include <QtTest>

#include <algorithm>
#include <set>

namespace thresholdGlTest {

using namespace core;

/// A threshold of a volume of more bricks than one slice of work has: it changes the bricks that
/// hold such values alone, and is taken back on the way.
class ThresholdGlTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { QVERIFY2(m_gpu.isReady(), m_gpu.why()); }
    void init() { test::failOnUnexpectedMessages(); }
    void cleanup() { QCOMPARE(m_gpu.newErrors(), 0); }
    void itsBricksAlone_data();
    void itsBricksAlone();

private:
    test::EditEngineFixture m_gpu;
};

void ThresholdGlTest::itsBricksAlone_data()
{
    QTest::addColumn<int>("side");
    QTest::newRow("176") << 176; // 1331 bricks
    if (test::longRun())
        QTest::newRow("512") << 512;
}

void ThresholdGlTest::itsBricksAlone()
{
    QFETCH(const int, side);
    const glm::ivec3 size(side);
    // One ball in a corner, and one voxel far away.
    test::Codes codes = test::constantVolume(size, 100);
    const auto placeOf = [&size](const glm::ivec3& voxel) {
        return std::size_t((voxel.z * size.y + voxel.y) * size.x + voxel.x);
    };
    constexpr int radius = 20;
    const glm::ivec3 middle(30, 40, 50);
    for (int z = -radius; z <= radius; ++z) {
        for (int y = -radius; y <= radius; ++y) {
            for (int x = -radius; x <= radius; ++x) {
                if (x * x + y * y + z * z <= radius * radius)
                    codes.values[placeOf(middle + glm::ivec3(x, y, z))] = 900;
            }
        }
    }
    codes.values[placeOf(size - 1)] = 900;
    const BrickGrid grid{size};
    std::set<int> bricks;
    for (int z = 0; z < side; ++z) {
        for (int y = 0; y < side; ++y) {
            for (int x = 0; x < side; ++x) {
                if (codes.values[placeOf({x, y, z})] == 900)
                    bricks.insert(grid.brickOf({x, y, z}));
            }
        }
    }
    LoadedVolume volume{.volume = {}, .codes = codes.values};
    volume.volume.geometry.size = size;
    volume.volume.maximum = 65535.0;
    volume.volume.voxelsSha256 = "not looked at here";
    const auto session = EditSession::create(m_gpu.engine(), volume, {});
    QVERIFY(session);
    EditSession& known = **session;
    QVERIFY(known.apply(test::newSegment(QStringLiteral("Ball"))) && known.settle());
    const QByteArray before = known.stateHash();

    // Everything, which is given up before it can be there.
    QElapsedTimer clock;
    clock.start();
    QVERIFY(known.begin(ThresholdSegment{.segment = 1}));
    known.end(Ending::Rollback);
    QVERIFY(known.settle());
    const double givenUp = double(clock.nsecsElapsed()) / 1e6;
    QCOMPARE(known.stateHash(), before);
    QCOMPARE(known.history().rows().size(), std::size_t(1));

    const ThresholdSegment ball{.segment = 1, .lower = 900.0};
    clock.restart();
    QVERIFY(known.begin(ball));
    known.end(Ending::Commit);
    QVERIFY(known.settle());
    const double taken = double(clock.nsecsElapsed()) / 1e6;
    const HistoryRow& row = known.history().rows().back();
    QCOMPARE(row.statistics.bricks, int(bricks.size()));
    QCOMPARE(known.document().segment(1)->voxels,
        std::int64_t(std::count(codes.values.begin(), codes.values.end(), 900)));
    qInfo("%d³: given up in %.1f ms, a ball in %zu bricks taken in %.1f ms", side, givenUp,
        bricks.size(), taken);

    // Each way back: what it had, what it becomes, what is taken from it.
    const QByteArray held = known.stateHash();
    QVERIFY(known.apply(
        ThresholdSegment{.segment = 1, .lower = 900.0, .mode = ThresholdSegment::Mode::Subtract}));
    QVERIFY(known.settle());
    QCOMPARE(known.document().segment(1)->voxels, std::int64_t(0));
    QCOMPARE(known.stateHash(), before);
    QCOMPARE(known.history().rows().back().statistics.bricks, int(bricks.size()));
    QVERIFY(known.undo() && known.settle());
    QCOMPARE(known.stateHash(), held);
    QVERIFY(known.apply(ThresholdSegment{.segment = 1, .upper = 100.0}) && known.settle());
    QCOMPARE(known.document().segment(1)->voxels,
        std::int64_t(std::count(codes.values.begin(), codes.values.end(), 100)));
    QVERIFY(known.undo() && known.settle());
    QCOMPARE(known.stateHash(), held);
}

BURIN_TEST(ThresholdGlTest)

} // namespace thresholdGlTest

#include "ThresholdGlTest.moc"
