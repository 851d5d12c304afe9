// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/splitting/SplitIslands.h"

#include "core/brick/VoxelRuns.h"
#include "core/document/SegmentColours.h"
#include "core/edits/EditJson.h"
#include "core/edits/document/DocumentEdits.h"
#include "core/edits/kinds/segments/AddSegment.h"
#include "core/recipe/Recipe.h"
#include "core/session/EditSession.h"
#include "core/session/questions/VoxelQuestions.h"
#include "tests/support/cases/IslandTruth.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/PlainEdits.h"
#include "tests/support/scenes/PlainMasks.h"
#include "tests/support/scenes/SmallStudy.h"
#include "tests/support/scenes/sessions/SessionBench.h"

#include <QTest>

#include <algorithm>
#include <array>
#include <memory>
#include <random>

namespace splitIslandsTest {

using namespace core;

namespace {

using Labels = std::vector<std::uint8_t>;
using test::smallGrid;
using test::smallIndexOf;

constexpr double voxelMm3 = 1.5; // of the small study

void setCube(Labels& labels, const glm::ivec3& from, int side, std::uint8_t label)
{
    for (int z = from.z; z < from.z + side; ++z) {
        for (int y = from.y; y < from.y + side; ++y)
            std::fill_n(labels.begin() + std::ptrdiff_t(smallIndexOf({from.x, y, z})), side, label);
    }
}

/// Two segments, "Parts" and "Parts 1".
Edit importOf(const Labels& labels)
{
    std::array<VoxelRuns, 2> runs;
    for (std::size_t voxel = 0; voxel < labels.size(); ++voxel) {
        if (labels[voxel] > 0)
            runs.at(std::size_t(labels[voxel]) - 1).append(voxel, 1);
    }
    return test::maskImport(QStringLiteral("parts.nii"), smallGrid().size,
        {{QStringLiteral("Parts"), runs[0]}, {QStringLiteral("Parts 1"), runs[1]}});
}

/// Of "Parts" an island of 6³, two of 3³ and a speck; "Parts 1" lies between two of them.
Edit fourIslands()
{
    Labels labels(smallGrid().voxelCount(), 0);
    setCube(labels, {5, 5, 5}, 6, 1);
    setCube(labels, {18, 18, 18}, 3, 1);
    setCube(labels, {21, 18, 18}, 3, 2);
    setCube(labels, {24, 18, 18}, 3, 1);
    setCube(labels, {24, 6, 6}, 1, 1);
    return importOf(labels);
}

/// So many voxels of "Parts" that do not touch each other.
Edit specks(std::size_t count)
{
    Labels labels(smallGrid().voxelCount(), 0);
    for (std::size_t i = 0; i < count; ++i)
        labels[smallIndexOf({2 * int(i % 20), 2 * int(i / 20 % 18), 2 * int(i / 360)})] = 1;
    labels[smallIndexOf({1, 35, 33})] = 2;
    return importOf(labels);
}

/// Specks and blocks of both.
Edit anyMatter(std::mt19937& random)
{
    Labels labels(smallGrid().voxelCount(), 0);
    for (std::uint8_t& label : labels) {
        const auto dice = int(random() % 1000);
        label = dice < 20 ? std::uint8_t(1) : dice < 30 ? std::uint8_t(2) : std::uint8_t(0);
    }
    for (int block = 0; block < 12; ++block) {
        const int side = 2 + int(random() % 5);
        const glm::ivec3 from{int(random() % 30), int(random() % 28), int(random() % 26)};
        setCube(labels, from, side, std::uint8_t(1 + block % 3 / 2));
    }
    return importOf(labels);
}

struct Bench : test::SessionBench {
    Bench(bool delayed, const Edit& matter)
        : SessionBench(delayed)
    {
        run(matter);
    }
    [[nodiscard]] const Document& document() const { return session->document(); }
};

/// By flooding voxel by voxel.
Labels splitLabels(const Labels& before, int segment, std::size_t least, int firstNew)
{
    Labels after = before;
    const auto islands = test::islandsBySize(smallGrid().size, before, segment);
    for (std::size_t place = 1; place < islands.size(); ++place) {
        for (const std::size_t voxel : islands[place]) {
            if (islands[place].size() >= least)
                after[voxel] = std::uint8_t(firstNew + int(place) - 1);
        }
    }
    return after;
}

Recipe recipeOf(const std::vector<Edit>& edits)
{
    return {.path = QStringLiteral("r.json"),
        .study = {},
        .steps = {edits.begin(), edits.end()},
        .entries = {},
        .withoutSurface = {},
        .exports = {}};
}

} // namespace

class SplitIslandsTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    /// From the largest down, of equal ones the first in memory; names that are taken are passed
    /// over. All of it is one row, which says what it made.
    void everyIslandBecomesASegment()
    {
        const Bench bench(false, fourIslands());
        const Labels before = bench.labels();
        const QByteArray hash = bench.session->stateHash();
        bench.run(SplitIslands{.segment = 1});
        QCOMPARE(bench.rows().size(), std::size_t(2));
        QCOMPARE(
            bench.rows().back().name, QStringLiteral("Split 3 islands off 'Parts', −55 voxels"));
        QVERIFY(bench.labels() == splitLabels(before, 1, 1, 3));
        QCOMPARE(int(bench.labels()[smallIndexOf({18, 18, 18})]), 3);
        QCOMPARE(int(bench.labels()[smallIndexOf({24, 18, 18})]), 4);
        const std::vector<Segment>& segments = bench.document().segments;
        QCOMPARE(segments.size(), std::size_t(5));
        const std::array<std::int64_t, 5> sizes{216, 27, 27, 27, 1};
        for (std::size_t place = 0; place < segments.size(); ++place) {
            QCOMPARE(int(segments[place].label), int(place) + 1);
            QCOMPARE(segments[place].voxels, sizes.at(place));
            if (place < 2)
                continue;
            QCOMPARE(segments[place].name, QStringLiteral("Parts %1").arg(place));
            QCOMPARE(segments[place].rgb, usualSegmentColour(place));
        }
        const auto& made = bench.rows().back().edit.get<SplitIslands>();
        QVERIFY(made.into && made.into->size() == 3);
        const QByteArray changed = bench.session->stateHash();
        QVERIFY(changed != hash);
        QVERIFY(bench.session->undo() && bench.session->settle());
        QCOMPARE(bench.session->stateHash(), hash);
        QCOMPARE(bench.document().segments.size(), std::size_t(2));
        QVERIFY(bench.session->redo() && bench.session->settle());
        QCOMPARE(bench.session->stateHash(), changed);
        // Nothing is left to be split.
        bench.run(SplitIslands{.segment = 1});
        QCOMPARE(bench.rows().size(), std::size_t(2));
        QCOMPARE(bench.document().segments.size(), std::size_t(5));
    }

    /// One that is just as large as the minimum becomes a segment.
    void smallOnesStay()
    {
        const Bench bench(false, fourIslands());
        bench.run(SplitIslands{.segment = 1, .mm3 = 27 * voxelMm3 + 0.1});
        QCOMPARE(bench.rows().size(), std::size_t(1));
        QCOMPARE(bench.document().segments.size(), std::size_t(2));
        bench.run(SplitIslands{.segment = 1, .mm3 = 27 * voxelMm3});
        QCOMPARE(bench.document().segments.size(), std::size_t(4));
        QCOMPARE(bench.voxels(1), std::int64_t(217));
        QCOMPARE(int(bench.labels()[smallIndexOf({24, 6, 6})]), 1);
    }

    /// Where it says which segments it makes, it makes these.
    void namedOnes()
    {
        const Bench bench(false, fourIslands());
        const SplitPart first{.name = QStringLiteral("First"), .rgb = 0x102030};
        bench.run(SplitIslands{.segment = 1, .into = std::vector{first}});
        QCOMPARE(
            bench.rows().back().name, QStringLiteral("Split 1 island off 'Parts', −27 voxels"));
        QCOMPARE(bench.document().segments.size(), std::size_t(3));
        QCOMPARE(bench.document().segments.back().name, first.name);
        QCOMPARE(bench.document().segments.back().rgb, first.rgb);
        QCOMPARE(bench.voxels(1), std::int64_t(216 + 27 + 1));
        QCOMPARE(bench.voxels(3), std::int64_t(27));
        const Result<void> many =
            bench.carriedOut(SplitIslands{.segment = 1, .into = std::vector(3, first)});
        QVERIFY(!many && many.error().code == ErrorCode::InvalidField);
        QCOMPARE(many.error().arguments.front(), QStringLiteral("splitIslands.into"));
        QCOMPARE(bench.document().segments.size(), std::size_t(3));
        QCOMPARE(bench.rows().size(), std::size_t(2));
    }

    /// Islands are those of the whole segment. Of each its voxels that may change become a segment;
    /// one that has none stays, and is not counted.
    void withinLimits()
    {
        const LoadedVolume study = test::smallStudy();
        const auto valueAt = [&study](const glm::ivec3& voxel) {
            return study.codes[smallIndexOf(voxel)] - 1024.0;
        };
        const VolumeGeometry& geometry = study.volume.geometry;
        const auto box = [&geometry](const glm::dvec3& from, const glm::dvec3& to) {
            return EditableRange{.box = GrowBox{geometry.toWorld(from), geometry.toWorld(to)}};
        };
        const std::vector<EditableRange> ranges{box({24, 0, 0}, {39, 35, 33}),
            box({19, 19, 0}, {25, 35, 33}), box({0, 0, 0}, {12, 12, 12}),
            {.lower = valueAt({24, 6, 6}), .upper = valueAt({24, 6, 6})},
            {.upper = valueAt({19, 19, 19}) - 1.0}, {.outside = std::vector<int>{2}},
            {.inside = std::vector<int>{3}}, {.inside = std::vector<int>{1, 3}},
            {.lower = valueAt({24, 18, 18}), .inside = std::vector<int>{3}},
            {.inside = std::vector<int>()}, {}};
        std::size_t fewest = 3;
        std::size_t most = 0;
        for (const EditableRange& range : ranges) {
            const Bench bench(true, fourIslands());
            // In another plane, over half of one island.
            bench.run(AddSegment{.name = QStringLiteral("Over"), .rgb = 5, .plane = 1});
            bench.run(test::paintAt(3, {geometry.toWorld({25.0, 19.0, 18.0})}, 1.3));
            const Labels before = bench.labels();
            const Labels over = bench.labels(1);
            const QByteArray hash = bench.session->stateHash();
            const auto mayChange = [&](std::size_t voxel) {
                const glm::ivec3 at(int(voxel % std::size_t(smallGrid().size.x)),
                    int(voxel / std::size_t(smallGrid().size.x) % std::size_t(smallGrid().size.y)),
                    int(voxel / std::size_t(smallGrid().size.x) / std::size_t(smallGrid().size.y)));
                const auto is = [&](int label) {
                    return before[voxel] == label || over[voxel] == label;
                };
                const auto any = [&](const std::vector<int>& labels) {
                    return std::any_of(labels.begin(), labels.end(), is);
                };
                bool may = valueAt(at) >= range.lower.value_or(-1e9)
                    && valueAt(at) <= range.upper.value_or(1e9);
                if (range.box) {
                    const glm::dvec3 from = geometry.toIndex(range.box->fromLps) - 0.1;
                    const glm::dvec3 to = geometry.toIndex(range.box->toLps) + 0.1;
                    may = may && glm::all(glm::greaterThan(glm::dvec3(at), from))
                        && glm::all(glm::lessThan(glm::dvec3(at), to));
                }
                return may && (!range.inside || any(*range.inside))
                    && !(range.outside && any(*range.outside));
            };
            Labels meant = before;
            int next = 4;
            const auto islands = test::islandsBySize(smallGrid().size, before, 1);
            for (std::size_t place = 1; place < islands.size(); ++place) {
                bool changed = false;
                for (const std::size_t voxel : islands[place]) {
                    if (!mayChange(voxel))
                        continue;
                    meant[voxel] = std::uint8_t(next);
                    changed = true;
                }
                next += changed ? 1 : 0;
            }
            const auto made = std::size_t(next - 4);
            fewest = std::min(fewest, made);
            most = std::max(most, made);
            const std::size_t rows = bench.rows().size();
            const SplitIslands edit{.segment = 1, .editable = range};
            bench.run(edit);
            QVERIFY(bench.labels() == meant);
            QCOMPARE(bench.document().segments.size(), 3 + made);
            QCOMPARE(bench.rows().size(), rows + (made > 0 ? 1 : 0));
            // No more can be named than there are.
            const std::vector named(made + 1, SplitPart{.name = QStringLiteral("More"), .rgb = 7});
            if (made > 0) {
                const HistoryRow row = bench.rows().back();
                const QByteArray changed = bench.session->stateHash();
                QCOMPARE(row.edit.get<SplitIslands>().into.value().size(), made);
                QCOMPARE(
                    row.name.contains(QStringLiteral("within limits")), range != EditableRange());
                QVERIFY(bench.session->undo() && bench.session->settle());
                QCOMPARE(bench.session->stateHash(), hash);
                const Result<Edit> told = editFromJson(editToJson(row.edit));
                QVERIFY(told);
                bench.run(*told);
                QCOMPARE(bench.session->stateHash(), changed);
                QVERIFY(bench.session->undo() && bench.session->settle());
            }
            SplitIslands tooMany = edit;
            tooMany.into = named;
            const Result<void> refused = bench.carriedOut(tooMany);
            QVERIFY(!refused && refused.error().code == ErrorCode::InvalidField);
            QCOMPARE(bench.session->stateHash(), hash);
        }
        QCOMPARE(fewest, std::size_t(0));
        QCOMPARE(most, std::size_t(3));
    }

    /// Names stay such as a row may hold, however long the segment's is, and whatever stands in it.
    void longNames()
    {
        for (const int letters : {200, 238, 239, 240, 254}) {
            const Bench bench(false, fourIslands());
            const QString clef = QString::fromUtf8("\xF0\x9D\x84\x9E"); // of two code units
            const QString name = QString(letters, u'a') + clef;
            bench.run(test::renameSegment(1, name));
            bench.run(SplitIslands{.segment = 1});
            QCOMPARE(bench.document().segments.size(), std::size_t(5));
            const QString made = bench.document().segments.back().name;
            QVERIFY(made.isValidUtf16() && made.size() <= 256);
            QVERIFY(made.endsWith(QStringLiteral(" 3")));
            QCOMPARE(made.contains(clef), letters <= 238);
            QVERIFY(editFromJson(editToJson(bench.rows().back().edit)));
        }
        const Bench bench(false, fourIslands());
        bench.run(test::renameSegment(1, QStringLiteral("100 %2")));
        bench.run(SplitIslands{.segment = 1});
        QCOMPARE(bench.document().segments.back().name, QStringLiteral("100 %2 3"));
    }

    /// As many as there are labels for; one more is refused, with how many there are and can be.
    void tooManyAreRefused()
    {
        const Bench full(false, specks(254));
        full.run(SplitIslands{.segment = 1});
        QCOMPARE(full.document().segments.size(), std::size_t(255));
        QCOMPARE(full.document().segments.back().voxels, std::int64_t(1));
        QCOMPARE(full.voxels(255), std::int64_t(1));
        QVERIFY(!full.session->apply(test::addSegment("Another")));

        const Bench bench(false, specks(255));
        const QByteArray hash = bench.session->stateHash();
        const Result<void> refused = bench.carriedOut(SplitIslands{.segment = 1});
        QVERIFY(!refused && refused.error().code == ErrorCode::TooManyIslands);
        QCOMPARE(refused.error().arguments,
            (QStringList{QStringLiteral("Parts"), QStringLiteral("254"), QStringLiteral("253")}));
        QCOMPARE(bench.session->stateHash(), hash);
        QCOMPARE(bench.rows().size(), std::size_t(1));
        // What the message says helps.
        bench.run(SplitIslands{.segment = 1, .mm3 = 2 * voxelMm3});
        QCOMPARE(bench.rows().size(), std::size_t(1));
    }

    /// Held to flooding voxel by voxel; the rows come to the same from scratch, as JSON too, and on
    /// an engine that delivers late.
    void anyMatterIsSplit_data()
    {
        QTest::addColumn<uint>("seed");
        for (uint seed = 1; seed <= 4; ++seed)
            QTest::addRow("seed %u", seed) << seed;
    }
    void anyMatterIsSplit()
    {
        QFETCH(const uint, seed);
        std::mt19937 random(seed);
        const Edit matter = anyMatter(random);
        const Bench bench(false, matter);
        for (const int segment : {1, 2}) {
            const Labels before = bench.labels();
            const int firstNew = bench.document().lastLabelGiven() + 1;
            const std::size_t least = 4 + random() % 4;
            bench.run(SplitIslands{.segment = segment, .mm3 = double(least) * voxelMm3});
            QVERIFY(bench.labels() == splitLabels(before, segment, least, firstNew));
            QVERIFY(bench.labels() != before);
        }
        QCOMPARE(bench.rows().size(), std::size_t(3));
        const Bench anew(true, matter);
        for (std::size_t row = 1; row < bench.rows().size(); ++row) {
            const Result<Edit> told = editFromJson(editToJson(bench.rows()[row].edit));
            QVERIFY(told);
            anew.run(*told);
        }
        QCOMPARE(anew.session->stateHash(), bench.session->stateHash());
        for (std::size_t row = 0; row < bench.rows().size(); ++row)
            QCOMPARE(anew.rows()[row].name, bench.rows()[row].name);
    }

    /// What is asked for before the islands have been counted waits, and is checked then.
    void othersWaitForIt()
    {
        const Bench bench(true, fourIslands());
        QVERIFY(bench.session->apply(SplitIslands{.segment = 1}));
        QVERIFY(bench.session->apply(test::renameSegment(4, QStringLiteral("Second"))));
        QVERIFY(bench.session->settle());
        QCOMPARE(bench.document().segment(4)->name, QStringLiteral("Second"));
        QVERIFY(bench.session->apply(SplitIslands{.segment = 2}));
        QVERIFY(bench.session->apply(test::renameSegment(9, QStringLiteral("None"))));
        const Result<void> settled = bench.session->settle();
        QVERIFY(!settled && settled.error().code == ErrorCode::UnknownSegment);
    }

    /// A recipe may go on with segments that nobody knows before it is carried out, and with those
    /// that it names it is checked as ever.
    void recipesAreCheckedAsFarAsIsKnown()
    {
        const Document document = initialDocument(test::smallStudy().volume);
        const Edit parts = test::addSegment("Parts");
        const Edit rename = test::renameSegment(3, QStringLiteral("Third"));
        const SplitPart first{.name = QStringLiteral("First"), .rgb = 1};
        QVERIFY(!checkRecipe(recipeOf({parts, rename}), document, false));
        QVERIFY(
            checkRecipe(recipeOf({parts, SplitIslands{.segment = 1}, rename}), document, false));
        QVERIFY(!checkRecipe(recipeOf({parts, SplitIslands{.segment = 2}}), document, false));
        const SplitIslands one{.segment = 1, .into = std::vector{first}};
        const SplitIslands two{.segment = 1, .into = std::vector(2, first)};
        QVERIFY(!checkRecipe(recipeOf({parts, one, rename}), document, false));
        QVERIFY(checkRecipe(recipeOf({parts, two, rename}), document, false));
    }

    void whatCannotBe()
    {
        const Bench bench(false, fourIslands());
        const Result<void> unknown = bench.carriedOut(SplitIslands{.segment = 7});
        QVERIFY(!unknown && unknown.error().code == ErrorCode::UnknownSegment);
        bench.run(test::lockSegment(1));
        const Result<void> locked = bench.carriedOut(SplitIslands{.segment = 1});
        QVERIFY(!locked && locked.error().code == ErrorCode::SegmentLocked);
    }
};

BURIN_TEST(SplitIslandsTest)

} // namespace splitIslandsTest

#include "SplitIslandsTest.moc"
