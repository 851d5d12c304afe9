// SPDX-License-Identifier: Apache-2.0
#include "core/brick/VoxelRuns.h"
#include "core/edits/EditJson.h"
#include "core/edits/document/DocumentEdits.h"
#include "core/edits/engine/EngineEdits.h"
#include "core/edits/kinds/segments/ImportMask.h"
#include "core/edits/kinds/segments/ImportTargets.h"
#include "tests/reference/LayerWrites.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/PlainEdits.h"

#include <QTest>

#include <random>
#include <set>

namespace maskEditsTest {

using namespace core;

namespace {

constexpr glm::ivec3 size(37, 21, 19); // no multiple of a brick along any axis

Document emptyDocument()
{
    Volume volume;
    volume.geometry.size = size;
    return initialDocument(std::move(volume));
}

std::set<std::uint64_t> randomPlaces(std::mt19937& random)
{
    std::set<std::uint64_t> places;
    const auto voxels = std::uint64_t(size.x) * std::uint64_t(size.y) * std::uint64_t(size.z);
    for (int run = 0; run < 60; ++run) {
        const std::uint64_t first = random() % voxels;
        for (std::uint64_t at = first; at < std::min(voxels, first + random() % 90); ++at)
            places.insert(at);
    }
    return places;
}

ImportedSegment segmentOf(const QString& name, const std::set<std::uint64_t>& places)
{
    VoxelRuns runs;
    for (const std::uint64_t place : places)
        runs.append(place, 1);
    return {.name = name, .rgb = 5, .code = {}, .voxels = packedRuns(runs)};
}

} // namespace

/// importMask on its way from runs to labels in bricks.
class MaskEditsTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void everyVoxelGetsItsLabel()
    {
        std::mt19937 random(9);
        for (int round = 0; round < 30; ++round) {
            ImportMask edit{.file = QStringLiteral("a.nii")};
            edit.size = size;
            edit.segments.emplace();
            std::vector<std::uint8_t> expected(std::size_t(size.x * size.y * size.z), 0);
            for (int number = 1; number <= 3; ++number) {
                const std::set<std::uint64_t> places = randomPlaces(random);
                edit.segments->push_back(segmentOf(QStringLiteral("S%1").arg(number), places));
                for (const std::uint64_t place : places) {
                    if (expected[place] == 0)
                        expected[place] = std::uint8_t(number + 4); // four were there before
                }
            }
            Document document = emptyDocument();
            for (int label = 1; label < 5; ++label)
                QVERIFY(applyToDocument(test::newSegment(QStringLiteral("Old")), document));
            const Result<LabelListed> listed = labelListed(edit, document);
            QVERIFY(listed);
            QVERIFY(checkSound(*listed, BrickGrid{size}));
            reference::DenseFields fields(size);
            reference::labelListed(fields, *listed);
            QCOMPARE(fields.labels(0).values, expected);
            QVERIFY(*applyToDocument(edit, document));
            QCOMPARE(document.lastLabelGiven(), 7);
            QCOMPARE(document.segments.back().name, QStringLiteral("S3"));
        }
    }

    void whereItGoes()
    {
        std::mt19937 random(10);
        ImportMask edit{.file = QStringLiteral("a.nii")};
        edit.size = size;
        edit.segments = {segmentOf(QStringLiteral("A"), randomPlaces(random)),
            segmentOf(QStringLiteral("B"), randomPlaces(random))};
        Document document = emptyDocument();
        QVERIFY(applyToDocument(test::newSegment(QStringLiteral("Old")), document));
        const auto labels = [&](const std::optional<SegmentWord>& as) {
            edit.as = as;
            std::vector<int> result;
            if (const Result<ImportTargets> where = importTargets(edit, document)) {
                for (const LabelTarget& target : where->targets)
                    result.push_back(target.label);
            }
            return result;
        };
        QCOMPARE(labels({}), (std::vector<int>{2, 3}));
        QCOMPARE(labels(SegmentWord{.number = 1, .name = {}}), (std::vector<int>{1, 1}));
        QCOMPARE(labels(SegmentWord{.number = {}, .name = QStringLiteral("Old")}),
            (std::vector<int>{1, 1}));
        QCOMPARE(labels(SegmentWord{.number = {}, .name = QStringLiteral("New")}),
            (std::vector<int>{2, 2}));
        QCOMPARE(labels(SegmentWord{.number = 2, .name = {}}), std::vector<int>());
        edit.as.reset();
        edit.overwriteUnlocked = true;
        QVERIFY(importTargets(edit, document)->targets.front().overwritable.test(1));
        QVERIFY(applyToDocument(test::lockSegment(1), document));
        QVERIFY(importTargets(edit, document)->targets.front().overwritable.none());
        QCOMPARE(labels(SegmentWord{.number = 1, .name = {}}), std::vector<int>());
        // Room for 255 labels, those deleted included.
        document.greatestRemovedLabel = 254;
        QCOMPARE(labels({}), std::vector<int>());
        QCOMPARE(labels(SegmentWord{.number = {}, .name = QStringLiteral("New")}),
            (std::vector<int>{255, 255}));
    }

    void whatIsRefused()
    {
        std::mt19937 random(11);
        ImportMask edit{.file = QStringLiteral("a.nii")};
        const auto why = [&](const ImportMask& mask) {
            const Result<LabelListed> listed = labelListed(mask, emptyDocument());
            return listed ? QString() : listed.error().arguments.join(u' ');
        };
        QVERIFY(why(edit).contains(QStringLiteral("its file has not been read")));
        edit.size = size;
        edit.segments = {segmentOf(QStringLiteral("A"), randomPlaces(random))};
        QCOMPARE(why(edit), QString());
        ImportMask other = edit;
        other.size = size + 1;
        QVERIFY(why(other).contains(QStringLiteral("importMask.size")));
        ImportMask damaged = edit;
        damaged.segments->front().voxels.chop(2);
        QVERIFY(why(damaged).contains(QStringLiteral("its voxels are damaged")));
        ImportMask beyond = edit;
        VoxelRuns far;
        far.append(std::uint64_t(size.x * size.y * size.z) - 1, 2);
        beyond.segments->front().voxels = packedRuns(far);
        QVERIFY(why(beyond).contains(QStringLiteral("its voxels are damaged")));
    }

    void writtenAndReadAgain()
    {
        std::mt19937 random(12);
        ImportMask edit{.file = QString::fromUtf8("Leber \xc3\xa4.nii.gz")};
        edit.as = SegmentWord{.number = {}, .name = QStringLiteral("All")};
        edit.size = size;
        edit.segments = {segmentOf(QStringLiteral("A"), randomPlaces(random))};
        const Result<Edit> again = editFromJson(editToJson(edit));
        QVERIFY(again);
        QCOMPARE(editToJson(*again), editToJson(edit));
        QCOMPARE(again->get<ImportMask>().segments->front().voxels, edit.segments->front().voxels);
    }
};

BURIN_TEST(MaskEditsTest)

} // namespace maskEditsTest

#include "MaskEditsTest.moc"
