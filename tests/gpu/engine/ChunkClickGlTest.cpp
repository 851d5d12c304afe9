// SPDX-License-Identifier: Apache-2.0
#include "core/brick/VoxelRuns.h"
#include "core/chunks/ChunkMap.h"
#include "core/edits/kinds/chunks/ChunkToggle.h"
#include "core/edits/kinds/chunks/DivideSegment.h"
#include "core/session/EditSession.h"
#include "core/session/SessionChunks.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/fixtures/EditEngineFixture.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/PlainMasks.h"
#include "tests/support/scenes/TestVolumes.h"

#include <QElapsedTimer>
#include <QtTest>

#include <algorithm>

namespace chunkClickGlTest {

using namespace core;

/// How long a click on a chunk takes, with the chunks there (seed B, section 4.2: at once).
class ChunkClickGlTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { QVERIFY2(m_gpu.isReady(), m_gpu.why()); }
    void init() { test::failOnUnexpectedMessages(); }
    void cleanup() { QCOMPARE(m_gpu.newErrors(), 0); }
    void manyClicks_data();
    void manyClicks();

private:
    test::EditEngineFixture m_gpu;
};

void ChunkClickGlTest::manyClicks_data()
{
    QTest::addColumn<int>("chunks");
    QTest::newRow("coarse") << 20;
    QTest::newRow("fine") << 5000;
}

void ChunkClickGlTest::manyClicks()
{
    QFETCH(int, chunks);
    constexpr glm::ivec3 size(112, 96, 88);
    constexpr int side = 80; // 512 000 voxels
    test::Random random(8);
    const test::Codes codes = test::balls(size, 12, random);
    LoadedVolume volume{.volume = {}, .codes = codes.values};
    volume.volume.geometry.size = size;
    volume.volume.maximum = 65535.0;
    volume.volume.voxelsSha256 = "not looked at here";
    // A segment whose surroundings are that box.
    VoxelRuns runs;
    for (int z = 30; z < 60; ++z) {
        for (int y = 30; y < 60; ++y)
            runs.append(std::uint64_t((z * size.y + y) * size.x + 33), 30);
    }
    const auto session = EditSession::create(m_gpu.engine(), volume, {});
    QVERIFY(session);
    const auto carryOut = [&session, this](const Edit& edit) {
        const Result<void> applied = (*session)->apply(edit);
        while (applied && !(*session)->idle()) {
            m_gpu.engine().finish();
            (*session)->poll();
        }
        return bool(applied);
    };
    QVERIFY(carryOut(
        test::maskImport(QStringLiteral("a.nii"), size, {{QStringLiteral("S"), runs, 5}})));
    QElapsedTimer clock;
    clock.start();
    QVERIFY(carryOut(DivideSegment{.segment = 1, .marginMm = 25.0}));
    const qint64 divided = clock.restart();
    std::shared_ptr<const ChunkMap> map = (*session)->chunks().map();
    while (!map) {
        m_gpu.engine().finish();
        (*session)->poll();
        QThread::msleep(1);
        map = (*session)->chunks().map();
    }
    const qint64 workedOut = clock.elapsed();
    QCOMPARE(map->box().maximum - map->box().minimum, glm::ivec3(side));

    std::vector<double> milliseconds;
    for (int i = 0; i < 40; ++i) {
        const glm::ivec3 voxel = map->box().minimum + test::randomVoxel(random, glm::ivec3(side));
        ChunkToggle click{.segment = 1, .chunks = chunks, .pointsLps = {glm::dvec3(voxel)}};
        const std::int64_t before = (*session)->document().segment(1)->voxels;
        clock.restart();
        QVERIFY(carryOut(click));
        milliseconds.push_back(double(clock.nsecsElapsed()) / 1e6);
        QVERIFY((*session)->document().segment(1)->voxels != before);
    }
    std::sort(milliseconds.begin(), milliseconds.end());
    qInfo("%d chunks of %d voxels: dividing %lld ms, chunks worked out beside it %lld ms; a click "
          "%.1f ms, at most %.1f ms",
        chunks, side * side * side, divided, workedOut, milliseconds[milliseconds.size() / 2],
        milliseconds.back());
    QVERIFY((*session)->settle());
}

BURIN_TEST(ChunkClickGlTest)

} // namespace chunkClickGlTest

#include "ChunkClickGlTest.moc"
