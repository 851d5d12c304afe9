// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/filling/FillBetweenSlices.h"
#include "core/edits/kinds/filling/SketchPlanes.h"
#include "core/session/EditSession.h"
#include "core/session/SegmentWork.h"
#include "core/sessionfile/SessionSalvage.h"
#include "tests/reference/filling/BetweenPlanes.h"
#include "tests/reference/filling/BetweenSlices.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/PlainEdits.h"
#include "tests/support/scenes/SmallStudy.h"
#include "tests/support/scenes/sessions/SessionBench.h"

#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <optional>
#include <random>
#include <vector>

namespace fillBetweenSlicesTest {

using namespace core;

namespace {

using Labels = std::vector<std::uint8_t>;
using test::smallGrid;

/// A disc on one slice across an axis.
Edit discAt(int segment, SliceAxis axis, const glm::dvec3& voxel, double radiusMm)
{
    return test::paintDiscAt(
        segment, smallGrid().toWorld(voxel), smallGrid().direction()[alongOf(axis)], radiusMm);
}

struct Bench : test::SessionBench {
    explicit Bench(bool delayed = false, const QString& file = {})
        : SessionBench(delayed, test::smallStudy(), file)
    {
        run(test::addSegment("Organ"));
        run(discAt(1, SliceAxis::K, {20.0, 18.0, 8.0}, 6.0));
        run(discAt(1, SliceAxis::K, {22.0, 18.0, 16.0}, 3.0));
    }
};

Labels expectedAfter(const FillBetweenSlices& edit, const Labels& before)
{
    Labels after = before;
    const std::vector<bool> between =
        reference::voxelsBetween(before, smallGrid(), std::uint8_t(edit.segment), edit.axis);
    for (std::size_t voxel = 0; voxel < after.size(); ++voxel) {
        if (between[voxel] && before[voxel] == 0)
            after[voxel] = std::uint8_t(edit.segment);
    }
    return after;
}

} // namespace

class FillBetweenSlicesTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    /// One row, which says how much it gave, and undo.
    void aRowThatComesBack_data()
    {
        QTest::addColumn<bool>("delayed");
        QTest::newRow("at once") << false;
        QTest::newRow("late") << true;
    }
    void aRowThatComesBack()
    {
        QFETCH(const bool, delayed);
        Bench bench(delayed);
        const Labels before = bench.labels();
        const std::int64_t drawn = bench.voxels(1);
        QVERIFY(drawn > 0);
        const QByteArray hash = bench.session->stateHash();
        const FillBetweenSlices edit{.segment = 1};
        bench.run(edit);
        const Labels after = bench.labels();
        QVERIFY(after == expectedAfter(edit, before));
        const std::int64_t gained = bench.voxels(1) - drawn;
        QVERIFY(gained > 7 * 30); // seven slices of discs of more than 3 mm
        QCOMPARE(bench.session->document().segment(1)->voxels, drawn + gained);
        QCOMPARE(bench.rows().back().name,
            QStringLiteral("Fill 'Organ' between slices, +%1 voxels").arg(gained));
        const QByteArray changed = bench.session->stateHash();
        QVERIFY(bench.session->undo() && bench.session->settle());
        QCOMPARE(bench.session->stateHash(), hash);
        QVERIFY(bench.session->redo() && bench.session->settle());
        QCOMPARE(bench.session->stateHash(), changed);
        // There is nothing left to fill, and so no row.
        const std::size_t rows = bench.rows().size();
        bench.run(edit);
        QCOMPARE(bench.rows().size(), rows);
    }

    /// Drawn on axial, coronal and oblique slices: a row that comes back, as the oracle has it.
    void planesOfSeveralDirections()
    {
        Bench bench;
        const glm::dvec3 middle = smallGrid().toWorld({20.0, 18.0, 12.0});
        const glm::dvec3 oblique(1.0, 1.0, 0.7);
        bench.run(discAt(1, SliceAxis::J, {20.0, 18.0, 12.0}, 5.0));
        bench.run(test::paintDiscAt(1, middle, oblique, 5.0));
        const FillBetweenSlices edit{.segment = 1,
            .planes = std::vector<DrawnPlane>{
                {smallGrid().toWorld({0.0, 0.0, 8.0}), smallGrid().direction()[2]},
                {smallGrid().toWorld({0.0, 0.0, 16.0}), smallGrid().direction()[2]},
                {middle, smallGrid().direction()[1]}, {middle, oblique}}};
        const Labels before = bench.labels();
        const QByteArray hash = bench.session->stateHash();
        bench.run(edit);
        const auto& carriedOut = bench.rows().back().edit.get<FillBetweenSlices>();
        QCOMPARE(carriedOut.planes->size(), std::size_t(4));
        const PlaneSketch sketch =
            planeSketch(*carriedOut.planes, smallGrid(), QStringLiteral("planes")).value();
        const std::vector<bool> between =
            reference::voxelsBetweenPlanes(before, smallGrid().size, 1, sketch);
        Labels expected = before;
        std::int64_t gained = 0;
        for (std::size_t voxel = 0; voxel < before.size(); ++voxel) {
            if (!between[voxel] || before[voxel] != 0)
                continue;
            expected[voxel] = 1;
            ++gained;
        }
        QVERIFY(gained > 200);
        QVERIFY(bench.labels() == expected);
        const QByteArray changed = bench.session->stateHash();
        QVERIFY(bench.session->undo() && bench.session->settle());
        QCOMPARE(bench.session->stateHash(), hash);
        QVERIFY(bench.session->redo() && bench.session->settle());
        QCOMPARE(bench.session->stateHash(), changed);
        Bench anew(true);
        for (std::size_t row = 3; row < bench.rows().size(); ++row)
            anew.run(bench.rows()[row].edit);
        QCOMPARE(anew.session->stateHash(), changed);
        // There is nothing left to fill, and so no row.
        const std::size_t rows = bench.rows().size();
        bench.run(edit);
        QCOMPARE(bench.rows().size(), rows);
        // A plane that misses the volume is refused.
        FillBetweenSlices beside = edit;
        beside.planes->front().placeLps += 1000.0 * smallGrid().direction()[2];
        const Result<void> refused = bench.session->apply(beside);
        QVERIFY(!refused);
        QVERIFY(refused.error().code == ErrorCode::InvalidField);
    }

    /// Several axes and segments, step by step against the oracle; the rows come to the same from
    /// scratch.
    void randomSlicesReplay_data()
    {
        QTest::addColumn<uint>("seed");
        for (const uint seed : {1U, 2U, 3U})
            QTest::addRow("seed %u", seed) << seed;
    }
    void randomSlicesReplay()
    {
        QFETCH(const uint, seed);
        std::mt19937 random(seed);
        const auto below = [&](int limit) { return int(random() % std::uint32_t(limit)); };
        Bench bench;
        bench.run(test::addSegment("Other"));
        std::size_t filled = 0;
        for (int step = 0; step < 10; ++step) {
            for (int discs = 1 + below(2); discs > 0; --discs) {
                const glm::dvec3 voxel{
                    double(4 + below(32)), double(4 + below(28)), double(2 + below(30))};
                bench.run(discAt(1 + below(2), SliceAxis(below(3)), voxel, 1.0 + below(5)));
            }
            FillBetweenSlices edit{.segment = 1 + below(2)};
            if (below(3) > 0)
                edit.axis = SliceAxis(below(3));
            const Labels before = bench.labels();
            const std::size_t rows = bench.rows().size();
            bench.run(edit);
            const Labels after = bench.labels();
            QVERIFY(after == expectedAfter(edit, before));
            QCOMPARE(bench.rows().size(), before == after ? rows : rows + 1);
            filled += before == after ? 0 : 1;
        }
        QVERIFY(filled > 0);
        Bench anew(true);
        for (std::size_t row = 3; row < bench.rows().size(); ++row)
            anew.run(bench.rows()[row].edit);
        QCOMPARE(anew.session->stateHash(), bench.session->stateHash());
    }

    /// Nothing is taken from a segment that is there already, locked or not; and a locked one is
    /// not filled.
    void locksAndOthers()
    {
        Bench bench;
        bench.run(test::addSegment("Other"));
        bench.run(discAt(2, SliceAxis::K, {21.0, 18.0, 12.0}, 2.5));
        const std::int64_t others = bench.voxels(2);
        const std::int64_t drawn = bench.voxels(1);
        QVERIFY(others > 4);
        bench.run(FillBetweenSlices{.segment = 1, .axis = SliceAxis::K});
        QCOMPARE(bench.voxels(2), others);
        QVERIFY(bench.voxels(1) > drawn);
        QVERIFY(bench.session->undo() && bench.session->settle());
        bench.run(test::lockSegment(1));
        const Result<void> locked = bench.session->apply(FillBetweenSlices{.segment = 1});
        QVERIFY(!locked);
        QVERIFY(locked.error().code == ErrorCode::SegmentLocked);
        const Result<void> unknown = bench.session->apply(FillBetweenSlices{.segment = 9});
        QVERIFY(!unknown);
        QVERIFY(unknown.error().code == ErrorCode::UnknownSegment);
        QCOMPARE(bench.voxels(1), drawn);
    }

    /// Where nothing is drawn, or nothing is empty between, there is no row.
    void nothingToFill()
    {
        Bench bench;
        bench.run(test::addSegment("Empty"));
        const std::size_t rows = bench.rows().size();
        bench.run(FillBetweenSlices{.segment = 2});
        bench.run(FillBetweenSlices{.segment = 2, .axis = SliceAxis::I});
        bench.run(FillBetweenSlices{.segment = 1, .axis = SliceAxis::J}); // a solid disc
        QCOMPARE(bench.rows().size(), rows);
    }

    void abortedBeforeItsEnd()
    {
        const QTemporaryDir folder;
        const QString file = folder.filePath(QStringLiteral("a.burin"));
        Bench bench(false, file);
        const std::size_t rows = bench.rows().size();
        const QByteArray before = bench.session->stateHash();
        QVERIFY(bench.session->apply(FillBetweenSlices{.segment = 1}));
        QCOMPARE(bench.session->segmentWork().percent(), std::optional<int>(0));
        bench.session->segmentWork().abort();
        const Result<void> settled = bench.session->settle();
        QVERIFY(!settled);
        QVERIFY(settled.error().code == ErrorCode::Cancelled);
        QCOMPARE(bench.rows().size(), rows);
        QCOMPARE(bench.session->stateHash(), before);
        // Whoever closes a study does not wait for it either.
        QVERIFY(bench.session->apply(FillBetweenSlices{.segment = 1}));
        bench.session.reset();
        const auto contents = checkSession(file);
        QVERIFY(contents && contents->isWhole());
        QCOMPARE(contents->rows.size(), rows);
    }
};

BURIN_TEST(FillBetweenSlicesTest)

} // namespace fillBetweenSlicesTest

#include "FillBetweenSlicesTest.moc"
