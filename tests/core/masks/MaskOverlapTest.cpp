// SPDX-License-Identifier: Apache-2.0
#include "core/masks/MaskOverlap.h"

#include "core/edits/document/DocumentEdits.h"
#include "core/edits/engine/EngineEdits.h"
#include "core/edits/kinds/imports/ImportMask.h"
#include "core/edits/kinds/imports/ImportTargets.h"
#include "core/export/common/ExportMask.h"
#include "core/masks/MaskParts.h"
#include "core/masks/ReadImport.h"
#include "core/recipe/Recipe.h"
#include "tests/reference/sculpt/LayerWrites.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/series/LabelledSeries.h"

#include <QFile>
#include <QTest>

#include <algorithm>
#include <map>
#include <numeric>
#include <random>

namespace maskOverlapTest {

using namespace core;

namespace {

constexpr std::uint64_t voxels = 700;

/// Runs of which some are a voxel long, some touch those of other segments, and some hold others.
std::vector<MaskSegment> randomSegments(std::mt19937& random, std::size_t count)
{
    std::vector<MaskSegment> segments(count);
    for (MaskSegment& segment : segments) {
        for (std::uint64_t at = random() % 40; at < voxels;) {
            const std::uint64_t length = std::min<std::uint64_t>(1 + random() % 50, voxels - at);
            segment.voxels.append(at, length);
            at += length + 1 + random() % 60;
        }
    }
    return segments;
}

/// By voxel: the segments that have it.
std::vector<std::vector<std::size_t>> ownersOf(const std::vector<MaskSegment>& segments)
{
    std::vector<std::vector<std::size_t>> owners(voxels);
    for (std::size_t i = 0; i < segments.size(); ++i) {
        for (const VoxelRun& run : segments[i].voxels.runs()) {
            for (std::uint64_t at = run.first; at < run.first + run.count; ++at)
                owners[at].push_back(i);
        }
    }
    return owners;
}

Segment segmentOf(const char* name, int plane)
{
    Segment segment;
    segment.label = 1;
    segment.plane = std::uint8_t(plane);
    segment.name = QString::fromLatin1(name);
    segment.rgb = 0x3399ff;
    segment.code = {QStringLiteral("SCT"), QStringLiteral("10200004"), QStringLiteral("Liver")};
    return segment;
}

test::SmallSeries evenSeries()
{
    test::SmallSeries series;
    series.size = {11, 7, 6};
    series.placeEvenly({-3, 4, 5}, {0, 0, 1.5});
    return series;
}

/// 1 in the columns from … to − 1, in all slices.
std::vector<std::uint8_t> columns(const glm::ivec3& size, int from, int to)
{
    std::vector<std::uint8_t> labels;
    for (int row = 0; row < size.y * size.z; ++row) {
        for (int x = 0; x < size.x; ++x)
            labels.push_back(x >= from && x < to ? 1 : 0);
    }
    return labels;
}

/// A DICOM SEG in which two columns of voxels are both in the liver and in a vein.
struct Fixture : test::LabelledSeries {
    Fixture()
        : LabelledSeries(evenSeries(), columns({11, 7, 6}, 0, 4))
        , second(columns({11, 7, 6}, 2, 7))
    {
        planes.push_back({.plane = 1, .labels = second});
    }
    [[nodiscard]] Result<ExportReport> exported() const
    {
        return exportMask(volume,
            {.file = file,
                .segments = {segmentOf("Liver", 0), segmentOf("Vein", 1)},
                .planes = planes},
            {});
    }
    /// What an import of the segments leaves in a plane of an empty session.
    [[nodiscard]] std::vector<std::uint8_t> carriedOut(
        const ImportMask& edit, std::uint8_t plane = 0) const
    {
        const Result<LabelPlanes> listed = labelPlanes(edit, initialDocument(volume));
        if (!listed)
            return {};
        reference::DenseFields fields(volume.geometry.size);
        reference::labelPlanes({}, fields, *listed);
        return fields.labels(plane).values;
    }
    /// The label of each column, from 0 on.
    [[nodiscard]] std::vector<std::uint8_t> byColumn(
        const std::vector<std::uint8_t>& labelOfColumn) const
    {
        std::vector<std::uint8_t> all;
        for (int row = 0; row < 7 * 6; ++row)
            all.insert(all.end(), labelOfColumn.begin(), labelOfColumn.end());
        return all;
    }

    std::vector<std::uint8_t> second;
    QString file = folder.filePath(QStringLiteral("seg.dcm"));
    static constexpr std::uint64_t shared = 2 * 7 * 6;
};

} // namespace

class MaskOverlapTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void everyVoxelIsCountedOnce()
    {
        std::mt19937 random(17);
        for (int round = 0; round < 60; ++round) {
            const auto segments = randomSegments(random, random() % 7);
            std::map<std::vector<std::size_t>, std::uint64_t> expected;
            for (const auto& owners : ownersOf(segments)) {
                if (owners.size() > 1)
                    ++expected[owners];
            }
            const std::vector<MaskOverlap> overlaps = overlapsOf(segments);
            QCOMPARE(overlaps.size(), expected.size());
            auto wanted = expected.begin();
            std::uint64_t all = 0;
            for (const MaskOverlap& overlap : overlaps) {
                QCOMPARE(overlap.segments, wanted->first);
                QCOMPARE(overlap.voxels, wanted->second);
                all += overlap.voxels;
                ++wanted;
            }
            QCOMPARE(voxelsOf(overlaps), all);
        }
    }

    void theFirstInOrderGetsTheVoxel()
    {
        std::mt19937 random(18);
        for (int round = 0; round < 60; ++round) {
            const auto segments = randomSegments(random, 2 + random() % 5);
            std::vector<std::size_t> order(segments.size());
            std::iota(order.begin(), order.end(), std::size_t(0));
            std::shuffle(order.begin(), order.end(), random);
            std::map<std::pair<std::size_t, std::size_t>, std::uint64_t> expected;
            for (const auto& owners : ownersOf(segments)) {
                const auto first = std::find_if(order.begin(), order.end(), [&](std::size_t one) {
                    return std::find(owners.begin(), owners.end(), one) != owners.end();
                });
                for (const std::size_t owner : owners) {
                    if (owner != *first)
                        ++expected[{*first, owner}];
                }
            }
            const std::vector<OverlapGiven> given = givenAway(overlapsOf(segments), order);
            QCOMPARE(given.size(), expected.size());
            std::uint64_t before = voxels;
            for (const OverlapGiven& each : given) {
                QCOMPARE(each.voxels, (expected[{each.to, each.from}]));
                QVERIFY(each.voxels <= before);
                before = each.voxels;
            }
        }
    }

    void whoGoesBeforeWhom()
    {
        using Order = std::vector<std::size_t>;
        QCOMPARE(segmentsByPrecedence({}, 3), (Order{0, 1, 2}));
        QCOMPARE(segmentsByPrecedence(std::vector<int>{3}, 3), (Order{2, 0, 1}));
        QCOMPARE(segmentsByPrecedence(std::vector<int>{2, 1, 3}, 3), (Order{1, 0, 2}));
        QCOMPARE(segmentsByPrecedence(std::vector<int>{9, 2, 0, 2}, 3), (Order{1, 0, 2}));
        QVERIFY(segmentsByPrecedence({}, 0).empty());
    }

    /// No two of one plane share a voxel, and each has met one in every plane before its own.
    void asFewPlanesAsTheyNeedInTurn()
    {
        QCOMPARE(planesFor({}, 3), (std::vector<int>{0, 0, 0}));
        QVERIFY(planesFor({}, 0).empty());
        std::mt19937 random(20);
        for (int round = 0; round < 60; ++round) {
            const auto segments = randomSegments(random, 1 + random() % 6);
            const std::vector<int> planes = planesFor(overlapsOf(segments), segments.size());
            QCOMPARE(planes.size(), segments.size());
            for (std::size_t i = 0; i < segments.size(); ++i) {
                std::vector<bool> met(segments.size() + 1, false);
                for (std::size_t j = 0; j < i; ++j) {
                    const bool shares = sharedVoxels(segments[i].voxels, segments[j].voxels) > 0;
                    met[std::size_t(planes[j])] = met[std::size_t(planes[j])] || shares;
                }
                const auto first = std::find(met.begin(), met.end(), false);
                QCOMPARE(planes[i], int(first - met.begin()));
            }
        }
    }

    /// A DICOM SEG whose segments overlap: what is said, and what becomes of the voxels.
    void aSegThatOverlaps()
    {
        const Fixture on;
        QVERIFY(on.exported());
        Result<ReadImport> read = readImport(ImportMask{.file = on.file}, on.volume, 0, {});
        QVERIFY(read);
        QCOMPARE(read->overlaps,
            (std::vector<MaskOverlap>{{.segments = {0, 1}, .voxels = Fixture::shared}}));
        const MaskNote all{.code = MaskNote::Code::SegmentsOverlap, .some = Fixture::shared};
        QCOMPARE(std::count(read->notes.begin(), read->notes.end(), all), 1);
        const auto notes = [&] {
            return notesOnOverlaps(read->overlaps, read->edit, on.volume.geometry);
        };
        // Both keep what they share, in two planes.
        QCOMPARE(*read->edit.planes, (std::vector<int>{0, 1}));
        QCOMPARE(
            notes(), (std::vector<MaskNote>{{.code = MaskNote::Code::OverlapsKept, .some = 2}}));
        QCOMPARE(on.carriedOut(read->edit), on.byColumn({1, 1, 1, 1, 0, 0, 0, 0, 0, 0, 0}));
        QCOMPARE(on.carriedOut(read->edit, 1), on.byColumn({0, 0, 2, 2, 2, 2, 2, 0, 0, 0, 0}));

        // In one plane a voxel has one of them.
        read->edit.planes.reset();
        MaskNote expected{.code = MaskNote::Code::GoesBefore,
            .names = {QStringLiteral("Liver"), QStringLiteral("Vein")},
            .some = Fixture::shared,
            .hereMl = millilitres(Fixture::shared, on.volume.geometry)};
        QVERIFY(expected.hereMl > 0.0);
        QCOMPARE(notes(), std::vector<MaskNote>{expected});
        QCOMPARE(on.carriedOut(read->edit), on.byColumn({1, 1, 1, 1, 2, 2, 2, 0, 0, 0, 0}));
        // The edit holds all that the file does, whoever gets it.
        QCOMPARE(unpackedRuns(read->edit.segments->back().voxels, on.volume.geometry.voxelCount())
                     ->voxelCount(),
            std::uint64_t(5 * 7 * 6));

        read->edit.ahead = std::vector<int>{2};
        std::swap(expected.names[0], expected.names[1]);
        QCOMPARE(notes(), std::vector<MaskNote>{expected});
        QCOMPARE(on.carriedOut(read->edit), on.byColumn({1, 1, 2, 2, 2, 2, 2, 0, 0, 0, 0}));
        read->edit.ahead = std::vector<int>{3};
        QVERIFY(on.carriedOut(read->edit).empty());
    }

    /// Contours may lie over each other.
    void anRtStructThatOverlaps()
    {
        const Fixture on;
        QVERIFY(exportMask(on.volume,
            {.format = ExportFormat::RtStruct,
                .file = on.file,
                .segments = {segmentOf("Liver", 0), segmentOf("Vein", 1)},
                .planes = on.planes},
            {}));
        const Result<ReadImport> read = readImport(ImportMask{.file = on.file}, on.volume, 0, {});
        QVERIFY(read);
        QCOMPARE(read->overlaps,
            (std::vector<MaskOverlap>{{.segments = {0, 1}, .voxels = Fixture::shared}}));
        QCOMPARE(on.carriedOut(read->edit), on.byColumn({1, 1, 1, 1, 0, 0, 0, 0, 0, 0, 0}));
        QCOMPARE(on.carriedOut(read->edit, 1), on.byColumn({0, 0, 2, 2, 2, 2, 2, 0, 0, 0, 0}));
    }

    /// `burin run` says it of the files that a recipe names.
    void recipesTellIt()
    {
        const Fixture on;
        QVERIFY(on.exported());
        const QString path = on.folder.filePath(QStringLiteral("recipe.json"));
        QFile file(path);
        QVERIFY(file.open(QIODevice::WriteOnly)
            && file.write(R"({"edits": [{"edit": "importMask", "file": "seg.dcm", "ahead": [2]},
                             {"edit": "importMask", "file": "seg.dcm"},
                             {"edit": "importMask", "file": "seg.dcm", "as": "All"}]})")
                > 0);
        file.close();
        Result<Recipe> recipe = readRecipe(path);
        QVERIFY(recipe);
        const auto notes = readMasks(*recipe, on.volume);
        QVERIFY(notes);
        std::vector<QStringList> pairs;
        for (const RecipeMaskNote& each : *notes) {
            if (each.note.code == MaskNote::Code::GoesBefore) {
                pairs.push_back(each.note.names);
                QCOMPARE(each.file, QStringLiteral("seg.dcm"));
                QCOMPARE(each.note.some, Fixture::shared);
            }
        }
        QCOMPARE(
            pairs, (std::vector<QStringList>{{QStringLiteral("Vein"), QStringLiteral("Liver")}}));
        const auto mask = [&](std::size_t step) {
            return std::get<Edit>(recipe->steps[step]).get<ImportMask>();
        };
        QCOMPARE(*mask(0).ahead, std::vector<int>{2});
        QVERIFY(!mask(0).planes);
        QCOMPARE(*mask(1).planes, (std::vector<int>{0, 1}));
        QVERIFY(!mask(2).planes);
    }

    /// Where all of a file becomes one segment, nobody goes before anybody.
    void intoOneSegment()
    {
        const Fixture on;
        QVERIFY(on.exported());
        ImportMask edit{.file = on.file};
        edit.as = SegmentWord{.number = {}, .name = QStringLiteral("All")};
        const Result<ReadImport> read = readImport(edit, on.volume, 0, {});
        QVERIFY(read);
        QVERIFY(read->overlaps.empty());
        QVERIFY(!read->edit.planes);
        QVERIFY(notesOnOverlaps({{.segments = {0, 1}, .voxels = 5}}, read->edit, {}).empty());
        QCOMPARE(on.carriedOut(read->edit), on.byColumn({1, 1, 1, 1, 1, 1, 1, 0, 0, 0, 0}));
    }
};

BURIN_TEST(MaskOverlapTest)

} // namespace maskOverlapTest

#include "MaskOverlapTest.moc"
