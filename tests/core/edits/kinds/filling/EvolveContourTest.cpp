// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/filling/EvolveContour.h"
#include "core/contour/ContourRule.h"
#include "core/session/EditSession.h"
#include "core/session/SegmentWork.h"
#include "core/sessionfile/SessionSalvage.h"
#include "tests/reference/filling/Contour.h"
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

namespace evolveContourTest {

using namespace core;

namespace {

using Labels = std::vector<std::uint8_t>;

/// The small study with noise: 40 ± 200 HU in the brain, around which bone begins at 800 HU.
LoadedVolume noisyStudy(std::uint32_t seed)
{
    LoadedVolume study = test::smallStudy();
    std::mt19937 random(seed);
    for (std::uint16_t& code : study.codes)
        code = std::uint16_t(std::max(0, int(code) - 200 + int(random() % 401)));
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
    [[nodiscard]] Labels expectedAfter(const EvolveContour& edit, const Labels& before) const
    {
        const Document& document = session->document();
        const std::vector<bool> inside = reference::evolvedContour(edit,
            contourRule(edit, document).value(), study, before,
            [&](int label) { return edit.overwriteUnlocked && !document.segment(label)->locked; });
        Labels after = before;
        for (std::size_t voxel = 0; voxel < after.size(); ++voxel) {
            if (inside[voxel])
                after[voxel] = std::uint8_t(edit.segment);
            else if (before[voxel] == edit.segment)
                after[voxel] = 0;
        }
        return after;
    }

    LoadedVolume study;
};

EvolveContour fromBrain()
{
    return {.segment = 1,
        .lower = -300.0,
        .upper = 400.0,
        .softness = 150.0,
        .bubbleLps = test::pointsInBrain().front(),
        .bubbleMm = 3.1,
        .generations = 5};
}

} // namespace

class EvolveContourTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    /// From a bubble, then on without one, each a row that comes back.
    void theBrainIsFound_data()
    {
        QTest::addColumn<bool>("delayed");
        QTest::addColumn<int>("edge");
        for (const int edge : {0, 60}) {
            for (const bool delayed : {false, true})
                QTest::addRow("edges %d, delayed %d", edge, int(delayed)) << delayed << edge;
        }
    }
    void theBrainIsFound()
    {
        QFETCH(const bool, delayed);
        QFETCH(const int, edge);
        Bench bench(noisyStudy(3), delayed);
        EvolveContour edit = fromBrain();
        edit.edge = edge;
        edit.edgeGradient = edge > 0 ? 300.0 : 0.0;
        const Labels before = bench.labels();
        const QByteArray hash = bench.session->stateHash();
        bench.run(edit);
        const Labels after = bench.labels();
        QVERIFY(after == bench.expectedAfter(edit, before));
        QVERIFY(std::count(after.begin(), after.end(), 1) > 150);
        QVERIFY2(bench.rows().back().name.startsWith(
                     QStringLiteral("Evolve the contour of 'Organ' from a bubble, +")),
            qPrintable(bench.rows().back().name));
        const QByteArray changed = bench.session->stateHash();
        QVERIFY(bench.session->undo() && bench.session->settle());
        QCOMPARE(bench.session->stateHash(), hash);
        QVERIFY(bench.session->redo() && bench.session->settle());
        QCOMPARE(bench.session->stateHash(), changed);
        // Going on from there is evolving further.
        edit.bubbleLps.reset();
        edit.bubbleMm = 0.0;
        edit.generations = 4;
        bench.run(edit);
        QVERIFY(bench.labels() == bench.expectedAfter(edit, after));
        EvolveContour whole = fromBrain();
        whole.edge = edge;
        whole.edgeGradient = edit.edgeGradient;
        whole.generations = 9;
        QVERIFY(bench.labels() == bench.expectedAfter(whole, before));
    }

    /// Of what rests nothing becomes a row, nor of a segment without voxels.
    void whatRestsLeavesNoRow()
    {
        Bench bench(test::smallStudy());
        EvolveContour edit{.segment = 1, .lower = -100.0, .upper = 200.0, .generations = 300};
        const std::size_t rows = bench.rows().size();
        bench.run(edit);
        QCOMPARE(bench.rows().size(), rows);
        edit.bubbleLps = test::pointsInBrain().front();
        edit.bubbleMm = 3.1;
        bench.run(edit);
        QCOMPARE(bench.rows().size(), rows + 1);
        edit.bubbleLps.reset();
        edit.bubbleMm = 0.0;
        bench.run(edit); // 300 generations are more than it needed
        QCOMPARE(bench.rows().size(), rows + 1);
    }

    /// From bubbles that overlap, hang apart and reach over the volume's border, on a straight grid
    /// and on a sheared one; then erasing, from two of them.
    void severalBubbles_data()
    {
        QTest::addColumn<bool>("delayed");
        QTest::addColumn<bool>("sheared");
        for (const bool sheared : {false, true}) {
            for (const bool delayed : {false, true})
                QTest::addRow("sheared %d, delayed %d", int(sheared), int(delayed))
                    << delayed << sheared;
        }
    }
    void severalBubbles()
    {
        QFETCH(const bool, delayed);
        QFETCH(const bool, sheared);
        LoadedVolume study = noisyStudy(5);
        if (sheared)
            study.volume.geometry.indexToWorld[2] += glm::dvec4(0.0, 0.31, 0.0, 0.0);
        Bench bench(study, delayed);
        const auto at = [&](const glm::dvec3& index) { return bench.geometry().toWorld(index); };
        EvolveContour edit = fromBrain();
        edit.bubbleLps = at({16.0, 18.0, 16.0});
        edit.furtherBubblesLps = {
            at({18.0, 18.0, 16.0}), at({24.0, 14.0, 12.0}), at({0.0, 0.0, 0.0})};
        const Labels before = bench.labels();
        const QByteArray hash = bench.session->stateHash();
        bench.run(edit);
        const Labels after = bench.labels();
        QVERIFY(after == bench.expectedAfter(edit, before));
        EvolveContour first = edit;
        first.furtherBubblesLps.reset();
        QVERIFY(after != bench.expectedAfter(first, before));
        QVERIFY2(bench.rows().back().name.startsWith(
                     QStringLiteral("Evolve the contour of 'Organ' from 4 bubbles, +")),
            qPrintable(bench.rows().back().name));
        const QByteArray changed = bench.session->stateHash();
        QVERIFY(bench.session->undo() && bench.session->settle());
        QCOMPARE(bench.session->stateHash(), hash);
        QVERIFY(bench.session->redo() && bench.session->settle());
        QCOMPARE(bench.session->stateHash(), changed);

        EvolveContour erasing = edit;
        erasing.furtherBubblesLps = {at({24.0, 14.0, 12.0})};
        erasing.bubbleMm = 1.7;
        erasing.erase = true;
        erasing.generations = 2;
        bench.run(erasing);
        QVERIFY(bench.labels() != after);
        QVERIFY(bench.labels() == bench.expectedAfter(erasing, after));
        QVERIFY2(bench.rows().back().name.startsWith(
                     QStringLiteral("Erase 'Organ' by a contour from 2 bubbles, ")),
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
        std::size_t changes = 0;
        for (int step = 0; step < 8; ++step) {
            if (step == 5)
                bench.run(test::lockSegment(2));
            EvolveContour edit{.segment = 1,
                .lower = -300.0 + below(300),
                .upper = 100.0 + below(900),
                .softness = double(below(150)),
                .region = 40 + below(61),
                .smoothness = below(80),
                .generations = 1 + below(4),
                .overwriteUnlocked = below(2) == 0};
            if (below(2) == 0) {
                edit.edge = 1 + below(100);
                edit.edgeGradient = 50.0 + below(300);
            }
            if (step % 2 == 0) {
                edit.bubbleLps = bench.geometry().toWorld(
                    {double(12 + below(16)), double(12 + below(12)), double(10 + below(14))});
                edit.bubbleMm = 2.6 + below(3); // no distance between two voxels
                if (step % 4 == 0)
                    edit.furtherBubblesLps = {bench.geometry().toWorld(
                        {double(12 + below(16)), double(12 + below(12)), double(10 + below(14))})};
            }
            if (step % 4 >= 2) { // from a bubble, then from all around
                edit.erase = true;
                edit.overwriteUnlocked = false;
            }
            const Labels before = bench.labels();
            const std::size_t rows = bench.rows().size();
            bench.run(edit);
            const Labels after = bench.labels();
            QVERIFY(after == bench.expectedAfter(edit, before));
            QCOMPARE(bench.rows().size(), before == after ? rows : rows + 1);
            changes += before == after ? 0 : 1;
        }
        QVERIFY(changes > 3);
        Bench anew(noisyStudy(seed), true);
        for (std::size_t row = 1; row < bench.rows().size(); ++row)
            anew.run(bench.rows()[row].edit);
        QCOMPARE(anew.session->stateHash(), bench.session->stateHash());
    }

    /// Where nothing stops it, all of the segment goes, up to its border, and nothing beside it.
    void itErasesUpToTheBorder_data()
    {
        QTest::addColumn<bool>("bubble");
        QTest::addColumn<int>("smoothness");
        for (const bool bubble : {false, true}) {
            for (const int smoothness : {0, 50, 80})
                QTest::addRow("bubble %d, smoothness %d", int(bubble), smoothness)
                    << bubble << smoothness;
        }
    }
    void itErasesUpToTheBorder()
    {
        QFETCH(const bool, bubble);
        QFETCH(const int, smoothness);
        Bench bench(test::smallStudy());
        bench.run(test::addSegment("Other"));
        bench.run(test::paintAt(1, {bench.geometry().toWorld({16.0, 18.0, 16.0})}, 5.0));
        bench.run(test::paintAt(2, {bench.geometry().toWorld({24.0, 18.0, 16.0})}, 3.0));
        EvolveContour edit{.segment = 1,
            .smoothness = smoothness,
            .generations = 60,
            .round = true,
            .erase = true};
        if (bubble) {
            edit.bubbleLps = bench.geometry().toWorld({16.0, 18.0, 16.0});
            edit.bubbleMm = 2.6;
        }
        const Labels before = bench.labels();
        const auto others = std::count(before.begin(), before.end(), 2);
        QVERIFY(others > 20 && std::count(before.begin(), before.end(), 1) > 100);
        bench.run(edit);
        const Labels after = bench.labels();
        QVERIFY(after == bench.expectedAfter(edit, before));
        QCOMPARE(std::count(after.begin(), after.end(), 1), std::ptrdiff_t(0));
        QCOMPARE(std::count(after.begin(), after.end(), 2), others);
        const QString name = bench.rows().back().name;
        QVERIFY2(
            name.startsWith(bubble ? QStringLiteral("Erase 'Organ' by a contour from a bubble, ")
                                   : QStringLiteral("Erase 'Organ' by a contour from outside, ")),
            qPrintable(name));
    }

    /// A part that is cut off from the bubble by other values stays, as does the border elsewhere.
    void fromABubbleItErasesOnlyWhatHangsTogether()
    {
        Bench bench(test::smallStudy());
        for (const double column : {12.0, 26.0})
            bench.run(test::paintAt(1, {bench.geometry().toWorld({column, 18.0, 16.0})}, 3.0));
        const Labels before = bench.labels();
        const EvolveContour edit{.segment = 1,
            .bubbleLps = bench.geometry().toWorld({12.0, 18.0, 16.0}),
            .bubbleMm = 1.6,
            .generations = 40,
            .round = true,
            .erase = true};
        bench.run(edit);
        const Labels after = bench.labels();
        QVERIFY(after == bench.expectedAfter(edit, before));
        const auto has = [&](const glm::ivec3& voxel) {
            const glm::ivec3& size = bench.geometry().size;
            return after[std::size_t((voxel.z * size.y + voxel.y) * size.x + voxel.x)] == 1;
        };
        QVERIFY(!has({12, 18, 16}) && has({26, 18, 16}));
        const std::ptrdiff_t left = std::count(after.begin(), after.end(), 1);
        QCOMPARE(2 * left, std::count(before.begin(), before.end(), 1));
        // Where the segment has nothing, there is no row.
        const std::size_t rows = bench.rows().size();
        bench.run(edit);
        QCOMPARE(bench.rows().size(), rows);
    }

    void whatCannotBe()
    {
        Bench bench(test::smallStudy());
        const std::size_t rows = bench.rows().size();
        const auto refused = [&](const EvolveContour& edit, const char* field) {
            const QString why = bench.tried(edit);
            QVERIFY2(why.contains(QStringLiteral("evolveContour.%1").arg(QLatin1String(field))),
                qPrintable(why));
        };
        refused({.segment = 1, .lower = 2.0, .upper = 1.0}, "upper");
        refused({.segment = 1, .softness = -1.0}, "softness");
        refused({.segment = 1, .edge = 50}, "edgeGradient");
        refused({.segment = 1, .generations = 0}, "generations");
        refused({.segment = 1, .generations = mostContourGenerations + 1}, "generations");
        refused({.segment = 1, .bubbleLps = glm::dvec3(1e4), .bubbleMm = 3.0}, "bubbleLps");
        refused({.segment = 1, .bubbleLps = test::pointsInBrain().front()}, "bubbleMm");
        EvolveContour beyond = fromBrain();
        beyond.furtherBubblesLps = {test::pointsInBrain().front(), glm::dvec3(1e4)};
        refused(beyond, "furtherBubblesLps");
        QVERIFY(!bench.tried(EvolveContour{.segment = 9}).isEmpty());
        QCOMPARE(bench.rows().size(), rows);
        bench.run(test::lockSegment(1));
        const Result<void> locked = bench.session->apply(fromBrain());
        QVERIFY(!locked);
        QVERIFY(locked.error().code == ErrorCode::SegmentLocked);
    }

    void abortedBeforeItsEnd()
    {
        const QTemporaryDir folder;
        const QString file = folder.filePath(QStringLiteral("a.burin"));
        Bench bench(test::smallStudy(), false, file);
        const std::size_t rows = bench.rows().size();
        const QByteArray before = bench.session->stateHash();
        QVERIFY(bench.session->apply(fromBrain()));
        QCOMPARE(bench.session->segmentWork().percent(), std::optional<int>(0));
        bench.session->segmentWork().abort();
        const Result<void> settled = bench.session->settle();
        QVERIFY(!settled);
        QVERIFY(settled.error().code == ErrorCode::Cancelled);
        QCOMPARE(bench.rows().size(), rows);
        QCOMPARE(bench.session->stateHash(), before);
        // Whoever closes a study does not wait, neither for the running one nor for what waits.
        QVERIFY(bench.session->apply(fromBrain()));
        QVERIFY(bench.session->apply(fromBrain()));
        bench.session.reset();
        const auto contents = checkSession(file);
        QVERIFY(contents && contents->isWhole());
        QCOMPARE(contents->rows.size(), rows);
    }
};

BURIN_TEST(EvolveContourTest)

} // namespace evolveContourTest

#include "EvolveContourTest.moc"
