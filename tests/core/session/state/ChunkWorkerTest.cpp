// SPDX-License-Identifier: Apache-2.0
#include "core/session/state/ChunkWorker.h"

#include "core/brick/VoxelRuns.h"
#include "core/edits/kinds/chunks/DivideSegment.h"
#include "core/engine/EngineResult.h"
#include "tests/reference/ReferenceEngine.h"
#include "tests/support/program/TestProgram.h"

#include <QSemaphore>
#include <QTest>

#include <atomic>

namespace chunkWorkerTest {

using namespace core;

namespace {

constexpr glm::ivec3 size(40, 30, 24);
constexpr RowId row = 7;
constexpr int patience = 60000; ///< milliseconds, on a busy machine

VolumeGeometry geometry()
{
    VolumeGeometry made;
    made.size = size;
    return made;
}

bool isOwned(const glm::ivec3& voxel)
{
    return glm::all(glm::greaterThanEqual(voxel, glm::ivec3(10, 8, 6)))
        && glm::all(glm::lessThan(voxel, glm::ivec3(22, 20, 18)));
}

/// A block in something darker, and the edit that divides it with all around.
struct Block {
    std::vector<std::uint16_t> codes;
    DivideSegment edit{.segment = 1, .marginMm = 40.0};

    Block()
    {
        VoxelRuns runs;
        for (int z = 0; z < size.z; ++z) {
            for (int y = 0; y < size.y; ++y) {
                for (int x = 0; x < size.x; ++x) {
                    const bool isInside = isOwned({x, y, z});
                    if (isInside)
                        runs.append(codes.size(), 1);
                    codes.push_back(isInside ? 2000 : 500);
                }
            }
        }
        edit.owners = {{.label = 1, .voxels = packedRuns(runs)}};
    }
};

/// What the session does in each turn.
bool poll(reference::ReferenceEngine& engine, ChunkWorker& worker)
{
    for (const EngineResult& result : engine.collect())
        static_cast<void>(worker.take(result));
    return worker.collect();
}

} // namespace

/// How chunks come to be beside the session.
class ChunkWorkerTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    /// They are there before the chunks, have no part in the stages, and are gone after them.
    void largeBoxesHaveCoarseChunksFirst()
    {
        const Block block;
        reference::ReferenceEngine engine;
        QVERIFY(engine.openVolume(size, block.codes));
        std::atomic<int> news = 0;
        QSemaphore seen; // so that the chunks do not come at the same time
        ChunkWorker worker(
            engine, geometry(),
            [&] {
                if (++news == 2)
                    static_cast<void>(seen.tryAcquire(1, patience));
            },
            std::int64_t(size.x) * size.y * size.z);
        worker.want(row, block.edit);
        QVERIFY(!worker.coarse(row));
        QVERIFY(
            QTest::qWaitFor([&] { return poll(engine, worker) && worker.coarse(row); }, patience));
        const ChunkWorker::Coarse coarse = worker.coarse(row);
        QCOMPARE(coarse->cell, 2);
        QCOMPARE(coarse->box.minimum, glm::ivec3(0));
        QCOMPARE(coarse->box.maximum, size);
        QVERIFY(!worker.map(row));
        QVERIFY(!worker.coarse(row + 1));
        const std::optional<ChunkStage> stage = worker.stage();
        QVERIFY(stage && stage->step == ProgressStep::FetchingValues);
        seen.release();
        QVERIFY(QTest::qWaitFor([&] { return poll(engine, worker) && worker.map(row); }, patience));
        QVERIFY(!worker.coarse(row));
        worker.finish();
        QCOMPARE(news.load(), 3);
    }

    void smallBoxesHaveNone()
    {
        const Block block;
        reference::ReferenceEngine engine;
        QVERIFY(engine.openVolume(size, block.codes));
        std::atomic<int> news = 0;
        ChunkWorker worker(engine, geometry(), [&news] { ++news; });
        worker.want(row, block.edit);
        QVERIFY(QTest::qWaitFor(
            [&] {
                poll(engine, worker);
                return worker.coarse(row) || worker.map(row);
            },
            patience));
        QVERIFY(!worker.coarse(row));
        worker.finish();
        QCOMPARE(news.load(), 2); // the box is unpacked, and divided
    }

    /// Those of another division are not shown.
    void anotherDivisionBeginsAnew()
    {
        const Block block;
        reference::ReferenceEngine engine;
        QVERIFY(engine.openVolume(size, block.codes));
        std::atomic<int> news = 0;
        QSemaphore seen;
        ChunkWorker worker(
            engine, geometry(),
            [&] {
                if (++news == 2)
                    static_cast<void>(seen.tryAcquire(1, patience));
            },
            1);
        worker.want(row, block.edit);
        QVERIFY(
            QTest::qWaitFor([&] { return poll(engine, worker) && worker.coarse(row); }, patience));
        worker.want(row + 1, block.edit);
        QVERIFY(!worker.coarse(row) && !worker.coarse(row + 1));
        seen.release();
        QVERIFY(
            QTest::qWaitFor([&] { return poll(engine, worker) && worker.map(row + 1); }, patience));
        QVERIFY(!worker.coarse(row + 1));
    }
};

BURIN_TEST(ChunkWorkerTest)

} // namespace chunkWorkerTest

#include "ChunkWorkerTest.moc"
