// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/filling/FloodFill.h"
#include "core/session/EditSession.h"
#include "core/session/SegmentWork.h"
#include "core/sessionfile/SessionSalvage.h"
#include "tests/reference/filling/FloodFill.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/PlainEdits.h"
#include "tests/support/scenes/SmallStudy.h"
#include "tests/support/scenes/sessions/SessionBench.h"

#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <random>
#include <vector>

namespace floodFillTest {

using namespace core;

namespace {

using Labels = std::vector<std::uint8_t>;

/// The small study, with noise of a few values in it.
LoadedVolume noisyStudy(std::uint32_t seed)
{
    LoadedVolume study = test::smallStudy();
    std::mt19937 random(seed);
    for (std::uint16_t& code : study.codes)
        code = std::uint16_t(code + 10 * (random() % 5));
    return study;
}

/// Of two slices, across an axis, so wide that a region of tissue, with holes of noise, is read in
/// several blocks.
LoadedVolume wideStudy(SliceAxis across)
{
    glm::ivec3 size(600, 150, 150);
    if (across == SliceAxis::I)
        size = glm::ivec3(150, 600, 150);
    size[alongOf(across)] = 2;
    LoadedVolume study;
    study.volume.geometry.size = size;
    study.volume.maximum = 65535.0;
    study.volume.voxelsSha256 = "not looked at here";
    std::mt19937 random(11);
    study.codes.resize(std::size_t(size.x) * std::size_t(size.y) * std::size_t(size.z));
    for (std::uint16_t& code : study.codes)
        code = random() % 4 == 0 ? 0 : 1000;
    return study;
}

struct Bench : test::SessionBench {
    explicit Bench(LoadedVolume its, bool delayed = false, const QString& file = {})
        : SessionBench(delayed, its, file)
        , study(std::move(its))
    {
        run(test::addSegment("Organ"));
    }
    /// By the oracle, voxel by voxel.
    [[nodiscard]] Labels expectedAfter(const FloodFill& edit, const Labels& before) const
    {
        Labels after = before;
        const std::vector<bool> found = reference::floodedVoxels(edit, study, before);
        for (std::size_t voxel = 0; voxel < after.size(); ++voxel) {
            if (!found[voxel])
                continue;
            const int label = before[voxel];
            if (edit.erase)
                after[voxel] = 0;
            else if (label == 0
                || (edit.overwriteUnlocked && !session->document().segment(label)->locked))
                after[voxel] = std::uint8_t(edit.segment);
        }
        return after;
    }

    LoadedVolume study;
};

glm::dvec3 inBrain()
{
    return test::pointsInBrain().front();
}

} // namespace

class FloodFillTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    /// The brain fills as a whole or in one slice; each is a row that comes back.
    void theBrainFills_data()
    {
        QTest::addColumn<int>("within"); // less than 0: in all directions
        QTest::addColumn<bool>("delayed");
        for (const int within : {-1, 0, 1, 2}) {
            for (const bool delayed : {false, true})
                QTest::addRow("%d %d", within, int(delayed)) << within << delayed;
        }
    }
    void theBrainFills()
    {
        QFETCH(const int, within);
        QFETCH(const bool, delayed);
        Bench bench(test::smallStudy(), delayed);
        FloodFill edit{.segment = 1, .placeLps = inBrain(), .tolerance = 100.0};
        if (within >= 0)
            edit.within = SliceAxis(within);
        const Labels before = bench.labels();
        const QByteArray hash = bench.session->stateHash();
        bench.run(edit);
        const Labels after = bench.labels();
        QVERIFY(after == bench.expectedAfter(edit, before));
        const std::int64_t gained = bench.voxels();
        QVERIFY(gained > 50);
        QCOMPARE(bench.session->document().segment(1)->voxels, gained);
        QVERIFY2(bench.rows().back().name.startsWith(within >= 0
                         ? QStringLiteral("Flood fill 'Organ' in a slice, +")
                         : QStringLiteral("Flood fill 'Organ' in 3D, +")),
            qPrintable(bench.rows().back().name));
        const QByteArray changed = bench.session->stateHash();
        QVERIFY(bench.session->undo() && bench.session->settle());
        QCOMPARE(bench.session->stateHash(), hash);
        QVERIFY(bench.session->redo() && bench.session->settle());
        QCOMPARE(bench.session->stateHash(), changed);
        // It is all the segment's now, so there is no row.
        const std::size_t rows = bench.rows().size();
        bench.run(edit);
        QCOMPARE(bench.rows().size(), rows);
        // And it goes as it came.
        edit.erase = true;
        edit.tolerance = 0.0;
        bench.run(edit);
        QCOMPARE(bench.voxels(), std::int64_t(0));
        QVERIFY2(bench.rows().back().name.startsWith(within >= 0
                         ? QStringLiteral("Erase a region of 'Organ' in a slice, −")
                         : QStringLiteral("Erase a region of 'Organ' in 3D, −")),
            qPrintable(bench.rows().back().name));
    }

    /// In noise, with segments in the way: against the oracle step by step, and from scratch.
    void noiseReplays_data()
    {
        QTest::addColumn<uint>("seed");
        for (const uint seed : {1U, 2U, 3U})
            QTest::addRow("seed %u", seed) << seed;
    }
    void noiseReplays()
    {
        QFETCH(const uint, seed);
        std::mt19937 random(seed);
        const auto below = [&](int limit) { return int(random() % std::uint32_t(limit)); };
        Bench bench(noisyStudy(seed));
        bench.run(test::addSegment("Other"));
        bench.run(test::paintAt(2, {bench.geometry().toWorld({16.0, 18.0, 16.0})}, 4.0));
        std::size_t filled = 0;
        std::size_t erased = 0;
        for (int step = 0; step < 24; ++step) {
            if (step == 12)
                bench.run(test::lockSegment(2));
            const glm::dvec3 voxel{
                double(8 + below(24)), double(8 + below(20)), double(8 + below(18))};
            FloodFill edit{.segment = 1, .placeLps = bench.geometry().toWorld(voxel)};
            if (below(2) == 0)
                edit.within = SliceAxis(below(3));
            edit.corners = below(2) == 0;
            const Labels before = bench.labels();
            const auto at =
                (std::size_t(voxel.z) * std::size_t(bench.geometry().size.y) + std::size_t(voxel.y))
                    * std::size_t(bench.geometry().size.x)
                + std::size_t(voxel.x);
            edit.erase = before[at] == 1 && below(3) > 0;
            if (!edit.erase) {
                edit.tolerance = 10.0 * below(3);
                edit.overwriteUnlocked = below(3) == 0;
            }
            const std::size_t rows = bench.rows().size();
            bench.run(edit);
            const Labels after = bench.labels();
            QVERIFY(after == bench.expectedAfter(edit, before));
            QCOMPARE(bench.rows().size(), before == after ? rows : rows + 1);
            (edit.erase ? erased : filled) += before == after ? 0 : 1;
        }
        QVERIFY(filled > 5);
        QVERIFY(erased > 0);
        Bench anew(noisyStudy(seed), true);
        for (std::size_t row = 1; row < bench.rows().size(); ++row)
            anew.run(bench.rows()[row].edit);
        QCOMPARE(anew.session->stateHash(), bench.session->stateHash());
    }

    /// An oblique slice has one voxel in each column along the axis that it is steepest to: it
    /// fills like a picture of these columns.
    void anObliqueSliceIsAPicture_data()
    {
        QTest::addColumn<bool>("corners");
        QTest::newRow("faces") << false;
        QTest::newRow("corners") << true;
    }
    void anObliqueSliceIsAPicture()
    {
        QFETCH(const bool, corners);
        LoadedVolume study = test::smallStudy();
        std::mt19937 random(5);
        for (std::uint16_t& code : study.codes)
            code = random() % 4 == 0 ? 0 : 1000;
        const glm::ivec3 first(20, 18, 17);
        study.codes[test::smallIndexOf(first)] = 1000;
        const glm::ivec3 size = study.volume.geometry.size;
        // By these steps it rises from column to column, of what it rises from voxel to voxel along
        // k: no voxel lies anywhere near its border.
        const auto heightOf = [&](int x, int y) {
            return int(std::lround(first.z - 0.2 * (x - first.x) - 0.4 * (y - first.y)));
        };
        std::vector<bool> found(std::size_t(size.x) * std::size_t(size.y), false);
        const auto columnOf = [&](const glm::ivec3& voxel) {
            return std::size_t(voxel.y) * std::size_t(size.x) + std::size_t(voxel.x);
        };
        std::vector<glm::ivec3> queue{first};
        found[columnOf(first)] = true;
        for (std::size_t next = 0; next < queue.size(); ++next) {
            for (int step = 0; step < 9; ++step) {
                const glm::ivec3 from = queue[next];
                const int x = from.x + step % 3 - 1;
                const int y = from.y + step / 3 - 1;
                if (x < 0 || y < 0 || x >= size.x || y >= size.y)
                    continue;
                const glm::ivec3 to(x, y, heightOf(x, y));
                const bool isBeside = x == from.x || y == from.y;
                if ((!isBeside && !corners) || std::abs(to.z - from.z) > 1 || to.z < 0
                    || to.z >= size.z || found[columnOf(to)]
                    || study.codes[test::smallIndexOf(to)] == 0)
                    continue;
                found[columnOf(to)] = true;
                queue.push_back(to);
            }
        }
        QVERIFY2(queue.size() > 300, qPrintable(QString::number(queue.size())));

        Bench bench(study);
        const FloodFill edit{.segment = 1,
            .placeLps = bench.geometry().toWorld(glm::dvec3(first)),
            .normalLps = glm::dvec3(3.0, 6.0, 10.0), // spacing 1, 1, 1.5 mm
            .corners = corners,
            .tolerance = 10.0};
        const Labels before = bench.labels();
        bench.run(edit);
        Labels expected = before;
        for (const glm::ivec3& voxel : queue)
            expected[test::smallIndexOf(voxel)] = 1;
        const Labels after = bench.labels();
        QVERIFY(after == expected);
        QVERIFY(after == bench.expectedAfter(edit, before));
        QVERIFY2(
            bench.rows().back().name.startsWith(QStringLiteral("Flood fill 'Organ' in a slice, +")),
            qPrintable(bench.rows().back().name));
    }

    /// Slices of all directions through noise, also such as lie along the grid: against the oracle,
    /// back and forth, taken away again in another slice, and from scratch.
    void obliqueSlicesReplay()
    {
        std::mt19937 random(9);
        const auto below = [&](int limit) { return int(random() % std::uint32_t(limit)); };
        Bench bench(noisyStudy(4));
        bench.run(test::addSegment("Other"));
        bench.run(test::paintAt(2, {bench.geometry().toWorld({16.0, 18.0, 16.0})}, 4.0));
        for (int step = 0; step < 12; ++step) {
            const glm::dvec3 voxel{
                double(10 + below(20)), double(9 + below(18)), double(9 + below(16))};
            const glm::dvec3 normal{
                double(below(200) - 100), double(below(200) - 100), double(below(99) + 1)};
            FloodFill edit{.segment = 1,
                .placeLps = bench.geometry().toWorld(voxel),
                .normalLps = step % 4 == 0 ? glm::dvec3(0.0, 0.0, 1.0) : normal,
                .corners = below(2) == 0,
                .tolerance = 10.0 * (1 + below(3)),
                .overwriteUnlocked = below(2) == 0};
            const Labels before = bench.labels();
            const QByteArray hash = bench.session->stateHash();
            bench.run(edit);
            const Labels after = bench.labels();
            QVERIFY(after == bench.expectedAfter(edit, before));
            const QByteArray changed = bench.session->stateHash();
            if (before != after) {
                QVERIFY(bench.session->undo() && bench.session->settle());
                QCOMPARE(bench.session->stateHash(), hash);
                QVERIFY(bench.session->redo() && bench.session->settle());
                QCOMPARE(bench.session->stateHash(), changed);
            }
            if (after[test::smallIndexOf(glm::ivec3(voxel))] != 1 || step % 3 != 0)
                continue;
            edit.erase = true;
            edit.tolerance = 0.0;
            edit.overwriteUnlocked = false;
            edit.normalLps = glm::dvec3(3.0, 7.0, -2.0);
            bench.run(edit);
            const Labels left = bench.labels();
            QVERIFY(left != after && left == bench.expectedAfter(edit, after));
        }
        QVERIFY(bench.rows().size() > 6);
        Bench anew(noisyStudy(4), true);
        for (std::size_t row = 1; row < bench.rows().size(); ++row)
            anew.run(bench.rows()[row].edit);
        QCOMPARE(anew.session->stateHash(), bench.session->stateHash());
    }

    /// In a slice, what lies beyond the block around the place, too.
    void readsOn_data()
    {
        QTest::addColumn<int>("within");
        for (const int within : {0, 1, 2})
            QTest::addRow("%d", within) << within;
    }
    void readsOn()
    {
        QFETCH(const int, within);
        const LoadedVolume study = wideStudy(SliceAxis(within));
        const glm::ivec3 size = study.volume.geometry.size;
        Bench bench(study);
        glm::ivec3 place = size / 2;
        const auto codeAt = [&](const glm::ivec3& at) {
            return study.codes[(std::size_t(at.z) * std::size_t(size.y) + std::size_t(at.y))
                    * std::size_t(size.x)
                + std::size_t(at.x)];
        };
        while (codeAt(place) == 0)
            ++place[within == 0 ? 1 : 0];
        FloodFill edit{.segment = 1,
            .placeLps = bench.geometry().toWorld(glm::dvec3(place)),
            .within = SliceAxis(within),
            .tolerance = 10.0};
        const Labels before = bench.labels();
        bench.run(edit);
        const Labels after = bench.labels();
        QVERIFY(after == bench.expectedAfter(edit, before));
        QVERIFY2(bench.voxels() > 50'000, qPrintable(QString::number(bench.voxels())));
        edit.erase = true;
        bench.run(edit);
        QCOMPARE(bench.voxels(), std::int64_t(0));
    }

    void whatCannotBe()
    {
        Bench bench(test::smallStudy());
        const std::size_t rows = bench.rows().size();
        const FloodFill outside{.segment = 1, .placeLps = glm::dvec3(1e4), .tolerance = 1.0};
        QVERIFY(bench.tried(outside).startsWith(QStringLiteral("floodFill.placeLps: ")));
        const FloodFill negative{.segment = 1, .placeLps = inBrain(), .tolerance = -1.0};
        QVERIFY(bench.tried(negative).startsWith(QStringLiteral("floodFill.tolerance: ")));
        FloodFill oblique{.segment = 1, .placeLps = inBrain(), .normalLps = glm::dvec3(0.0)};
        QVERIFY(bench.tried(oblique).startsWith(QStringLiteral("floodFill.normalLps: ")));
        oblique.normalLps = glm::dvec3(1.0, 2.0, 3.0);
        oblique.within = SliceAxis::K;
        QVERIFY(bench.tried(oblique).startsWith(QStringLiteral("floodFill.normalLps: ")));
        oblique.within.reset();
        oblique.placeLps = glm::dvec3(1e4);
        QVERIFY(bench.tried(oblique).startsWith(QStringLiteral("floodFill.placeLps: ")));
        // There is nothing of the segment where something is to be taken away.
        const Result<void> asked =
            bench.session->apply(FloodFill{.segment = 1, .placeLps = inBrain(), .erase = true});
        QVERIFY(asked);
        const Result<void> settled = bench.session->settle();
        QVERIFY(!settled);
        QVERIFY(settled.error().code == ErrorCode::NoIslandThere);
        QCOMPARE(bench.rows().size(), rows);
        bench.run(test::lockSegment(1));
        for (const bool erase : {false, true}) {
            const Result<void> locked = bench.session->apply(
                FloodFill{.segment = 1, .placeLps = inBrain(), .erase = erase});
            QVERIFY(!locked);
            QVERIFY(locked.error().code == ErrorCode::SegmentLocked);
        }
    }

    void abortedBeforeItsEnd()
    {
        const QTemporaryDir folder;
        const QString file = folder.filePath(QStringLiteral("a.burin"));
        Bench bench(test::smallStudy(), false, file);
        const std::size_t rows = bench.rows().size();
        const QByteArray before = bench.session->stateHash();
        const FloodFill edit{.segment = 1, .placeLps = inBrain(), .tolerance = 100.0};
        QVERIFY(bench.session->apply(edit));
        QCOMPARE(bench.session->segmentWork().percent(), std::optional<int>(0));
        bench.session->segmentWork().abort();
        const Result<void> settled = bench.session->settle();
        QVERIFY(!settled);
        QVERIFY(settled.error().code == ErrorCode::Cancelled);
        QCOMPARE(bench.rows().size(), rows);
        QCOMPARE(bench.session->stateHash(), before);
        // Whoever closes a study does not wait, neither for the running one nor for what waits.
        QVERIFY(bench.session->apply(edit));
        QVERIFY(bench.session->apply(edit));
        bench.session.reset();
        const auto contents = checkSession(file);
        QVERIFY(contents && contents->isWhole());
        QCOMPARE(contents->rows.size(), rows);
    }
};

BURIN_TEST(FloodFillTest)

} // namespace floodFillTest

#include "FloodFillTest.moc"
