// SPDX-License-Identifier: Apache-2.0
#include "core/brick/VoxelRuns.h"
#include "core/edits/EditJson.h"
#include "core/edits/document/DocumentEdits.h"
#include "core/edits/engine/EngineEdits.h"
#include "core/edits/kinds/imports/ImportMask.h"
#include "core/edits/kinds/imports/ImportTargets.h"
#include "tests/reference/sculpt/LayerWrites.h"
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

reference::DenseArray<std::uint16_t> noCodes()
{
    return {size, std::vector<std::uint16_t>(std::size_t(size.x * size.y * size.z), 0)};
}

/// A segment that was there before, with its voxels.
struct Old {
    Segment segment;
    std::set<std::uint64_t> places;
};

std::vector<Old> randomOld(std::mt19937& random)
{
    std::vector<Old> old;
    for (const int plane : {0, 2, 0}) {
        Old each{.segment = {}, .places = randomPlaces(random)};
        each.segment.label = std::uint8_t(old.size() + 1);
        each.segment.plane = std::uint8_t(plane);
        each.segment.locked = random() % 2;
        for (const Old& before : old) {
            for (const std::uint64_t place : before.places) {
                if (before.segment.plane == plane)
                    each.places.erase(place);
            }
        }
        old.push_back(std::move(each));
    }
    return old;
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
            const Result<LabelPlanes> listed = labelPlanes(edit, document);
            QVERIFY(listed);
            QVERIFY(checkSound(*listed, BrickGrid{size}));
            reference::DenseFields fields(size);
            reference::labelPlanes(noCodes(), fields, *listed);
            QCOMPARE(fields.labels(0).values, expected);
            QVERIFY(*applyToDocument(edit, document));
            QCOMPARE(document.lastLabelGiven(), 7);
            QCOMPARE(document.segments.back().name, QStringLiteral("S3"));
        }
    }

    /// Segments of a file in several planes, among segments that are there in some of them.
    void everyPlaneGetsItsLabels()
    {
        std::mt19937 random(19);
        for (int round = 0; round < 12; ++round) {
            ImportMask edit{.file = QStringLiteral("a.nii")};
            edit.size = size;
            edit.overwriteUnlocked = random() % 2;
            edit.segments.emplace();
            edit.planes.emplace();
            std::vector<std::set<std::uint64_t>> its;
            for (int number = 0; number < 4; ++number) {
                its.push_back(randomPlaces(random));
                edit.segments->push_back(segmentOf(QStringLiteral("S"), its.back()));
                edit.planes->push_back(int(random() % mostLabelPlanes));
            }
            const std::vector<Old> old = randomOld(random);
            Document document = emptyDocument();
            reference::DenseFields before(size);
            for (const Old& each : old) {
                document.segments.push_back(each.segment);
                for (const std::uint64_t place : each.places)
                    before.labels(each.segment.plane).values[place] = each.segment.label;
            }
            const auto yields = [&](std::uint8_t label) {
                return edit.overwriteUnlocked && !document.segment(label)->locked;
            };
            const Result<LabelPlanes> listed = labelPlanes(edit, document);
            QVERIFY(listed);
            QVERIFY(checkSound(*listed, BrickGrid{size}));
            reference::DenseFields after = before;
            reference::labelPlanes(noCodes(), after, *listed);
            const auto voxels = std::uint64_t(size.x * size.y * size.z);
            for (int plane = 0; plane < mostLabelPlanes; ++plane) {
                std::vector<std::uint8_t> expected = before.labels(std::uint8_t(plane)).values;
                for (std::uint64_t at = 0; at < voxels; ++at) {
                    bool isKept = false; // by a segment of another plane
                    for (int other = 0; other < mostLabelPlanes; ++other) {
                        const std::uint8_t held = before.labels(std::uint8_t(other)).values[at];
                        isKept = isKept || (other != plane && held != 0 && !yields(held));
                    }
                    std::uint8_t asked = 0;
                    bool isAskedElsewhere = false;
                    for (std::size_t i = 0; i < its.size(); ++i) {
                        if (!its[i].contains(at))
                            continue;
                        if ((*edit.planes)[i] != plane)
                            isAskedElsewhere = true;
                        else if (asked == 0)
                            asked = std::uint8_t(i + 4); // three were there before
                    }
                    std::uint8_t& label = expected[at];
                    if (isKept || (label != 0 && !yields(label)))
                        continue;
                    if (asked != 0 || isAskedElsewhere)
                        label = asked;
                }
                QCOMPARE(after.labels(std::uint8_t(plane)).values, expected);
            }
            QVERIFY(*applyToDocument(edit, document));
            for (std::size_t i = 0; i < its.size(); ++i)
                QCOMPARE(int(document.segments[i + 3].plane), (*edit.planes)[i]);
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
            const Result<LabelPlanes> listed = labelPlanes(mask, emptyDocument());
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
