// SPDX-License-Identifier: Apache-2.0
#include "core/edits/EditJson.h"
#include "core/edits/kinds/EditParts.h"
#include "core/edits/kinds/filling/FloodFill.h"
#include "core/edits/kinds/filling/MirrorSegment.h"
#include "core/edits/kinds/history/RevertRows.h"
#include "core/edits/kinds/imports/ImportMask.h"
#include "core/edits/kinds/parts/EditableRange.h"
#include "core/edits/kinds/parts/GrowBox.h"
#include "core/edits/kinds/segments/AddSegment.h"
#include "core/edits/kinds/segments/CombineSegments.h"
#include "core/edits/kinds/segments/FillOutline.h"
#include "core/edits/kinds/segments/InvertSegment.h"
#include "core/edits/kinds/segments/RemoveSegment.h"
#include "core/edits/kinds/segments/ReshapeSegment.h"
#include "core/edits/kinds/segments/SegmentSeen.h"
#include "core/edits/kinds/splitting/SplitSegment.h"
#include "core/edits/kinds/values/ThresholdSegment.h"
#include "core/masks/MaskOnVolume.h"
#include "core/masks/ReadImport.h"
#include "core/session/EditSession.h"
#include "core/session/questions/VoxelQuestions.h"
#include "tests/reference/ReferenceEngine.h"
#include "tests/support/cases/BoxedMasks.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/PlainEdits.h"
#include "tests/support/scenes/SmallStudy.h"
#include "tests/support/scenes/sessions/SessionBench.h"

#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QTest>

#include <algorithm>

namespace maskPlanesTest {

using namespace core;

namespace {

constexpr glm::ivec3 size(40, 36, 34); // of the small study

using Box = VoxelBox;

constexpr Box one{{2, 3, 4}, {15, 9, 8}};
constexpr Box two{{10, 3, 4}, {20, 9, 8}};
constexpr Box three{{12, 5, 5}, {14, 7, 7}}; // in both

ImportMask importOf(const std::vector<Box>& boxes)
{
    return test::importOfBoxes(boxes, size);
}

ImportMask twoPlanes()
{
    ImportMask mask = importOf({one, two});
    mask.planes = std::vector<int>{0, 1};
    return mask;
}

/// The label in the box, 0 elsewhere.
std::vector<std::uint8_t> labelsOf(const Box& box, int label)
{
    std::vector<std::uint8_t> labels;
    for (int z = 0; z < size.z; ++z) {
        for (int y = 0; y < size.y; ++y) {
            for (int x = 0; x < size.x; ++x) {
                const glm::ivec3 voxel(x, y, z);
                const bool isInside = glm::all(glm::greaterThanEqual(voxel, box.minimum))
                    && glm::all(glm::lessThan(voxel, box.maximum));
                labels.push_back(std::uint8_t(isInside ? label : 0));
            }
        }
    }
    return labels;
}

struct Bench : test::SessionBench {
    explicit Bench(const QString& file = {})
        : SessionBench(false, test::smallStudy(), file)
    {
    }
    [[nodiscard]] std::int64_t count(int plane, int label) const { return voxels(label, plane); }
    [[nodiscard]] std::int64_t voxelsOf(int label) const
    {
        return session->document().segment(label)->voxels;
    }
    [[nodiscard]] glm::dvec3 at(const glm::dvec3& voxel) const { return geometry().toWorld(voxel); }
};

} // namespace

/// Masks of one file whose segments overlap, each in a label plane of its own.
class MaskPlanesTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    void everySegmentKeepsItsVoxels()
    {
        const QTemporaryDir folder;
        const QString file = folder.filePath(QStringLiteral("a.burin"));
        const std::vector<Box> boxes{one, two, three};
        ImportMask mask = importOf(boxes);
        std::vector<MaskSegment> segments;
        for (const Box& box : boxes)
            segments.push_back(
                {.name = {}, .rgb = {}, .code = {}, .voxels = test::runsOfBox(box, size)});
        mask.planes = planesFor(core::overlapsOf(segments), segments.size());
        QCOMPARE(*mask.planes, (std::vector<int>{0, 1, 2}));
        QByteArray after;
        {
            const Bench bench(file);
            const QByteArray before = bench.session->stateHash();
            QCOMPARE(bench.tried(mask), QString());
            const auto everything = [&] {
                for (int plane = 0; plane < 3; ++plane) {
                    QCOMPARE(bench.labels(plane), labelsOf(boxes[std::size_t(plane)], plane + 1));
                    QCOMPARE(int(bench.session->document().segment(plane + 1)->plane), plane);
                }
                QCOMPARE(bench.voxelsOf(1), std::int64_t(13 * 6 * 4));
                QCOMPARE(bench.voxelsOf(2), std::int64_t(10 * 6 * 4));
                QCOMPARE(bench.voxelsOf(3), std::int64_t(2 * 2 * 2));
            };
            everything();
            after = bench.session->stateHash();
            QVERIFY(bench.session->undo());
            QVERIFY(bench.session->settle());
            QCOMPARE(bench.session->stateHash(), before);
            QVERIFY(bench.session->document().segments.empty());
            for (int plane = 0; plane < 3; ++plane)
                QCOMPARE(bench.count(plane, 0), std::int64_t(size.x) * size.y * size.z);
            QVERIFY(bench.session->redo());
            QVERIFY(bench.session->settle());
            QCOMPARE(bench.session->stateHash(), after);
            everything();
        }
        reference::ReferenceEngine engine;
        const auto opened = EditSession::open(engine, test::smallStudy(), file);
        QVERIFY(opened);
        QCOMPARE((*opened)->stateHash(), after);
        for (int plane = 0; plane < 3; ++plane)
            QCOMPARE(*(*opened)->questions().labels(std::uint8_t(plane)),
                labelsOf(boxes[std::size_t(plane)], plane + 1));
        const Bench anew;
        const Result<Edit> again =
            editFromJson(editToJson((*opened)->history().rows().front().edit));
        QVERIFY(again);
        QCOMPARE(anew.tried(*again), QString());
        QCOMPARE(anew.session->stateHash(), after);
    }

    /// Two segments in one plane share what the first of them gets; the third keeps its own.
    void someOfOnePlane()
    {
        const Bench bench;
        ImportMask mask = importOf({one, two, three});
        mask.planes = std::vector<int>{0, 0, 3};
        mask.ahead = std::vector<int>{2};
        QCOMPARE(bench.tried(mask), QString());
        QCOMPARE(bench.count(0, 1), std::int64_t(8 * 6 * 4));
        QCOMPARE(bench.count(0, 2), std::int64_t(10 * 6 * 4));
        QCOMPARE(bench.labels(3), labelsOf(three, 3));
    }

    void segmentsThatAreThereKeepTheirs()
    {
        const Bench bench;
        QCOMPARE(bench.tried(twoPlanes()), QString());
        const Box wide{{0, 3, 4}, {30, 9, 8}};
        QCOMPARE(bench.tried(importOf({wide})), QString());
        QCOMPARE(bench.count(0, 3), std::int64_t((30 - 18) * 6 * 4));
        QCOMPARE(bench.labels(1), labelsOf(two, 2));
        QCOMPARE(bench.count(0, 1), std::int64_t(13 * 6 * 4));

        // Over what is not locked: the first one keeps only what the locked one has, too.
        QCOMPARE(bench.tried(test::lockSegment(2)), QString());
        ImportMask over = importOf({wide});
        over.overwriteUnlocked = true;
        QCOMPARE(bench.tried(over), QString());
        QCOMPARE(bench.count(0, 1), std::int64_t(5 * 6 * 4));
        QCOMPARE(bench.count(0, 3), std::int64_t(0));
        QCOMPARE(bench.count(0, 4), std::int64_t((30 - 10) * 6 * 4));
        QCOMPARE(bench.labels(1), labelsOf(two, 2));

        // Nothing is locked any more: all planes lose it.
        QCOMPARE(bench.tried(test::lockSegment(2, false)), QString());
        QCOMPARE(bench.tried(over), QString());
        QCOMPARE(bench.labels(0), labelsOf(wide, 5));
        QCOMPARE(bench.count(1, 0), std::int64_t(size.x) * size.y * size.z);
        QCOMPARE(bench.voxelsOf(2), std::int64_t(0));
        QVERIFY(bench.session->undo());
        QVERIFY(bench.session->settle());
        QCOMPARE(bench.labels(1), labelsOf(two, 2));
    }

    /// A tool acts on the segment's plane, and no other one changes by a bit.
    void aToolKeepsToItsPlane()
    {
        const Bench bench;
        QCOMPARE(bench.tried(twoPlanes()), QString());
        QCOMPARE(bench.tried(test::paintAt(2, {bench.at({5, 6, 6})}, 3.0)), QString());
        QCOMPARE(bench.labels(0), labelsOf(one, 1));
        const std::int64_t painted = bench.count(1, 2);
        QVERIFY(painted > 10 * 6 * 4);
        QCOMPARE(bench.voxelsOf(2), painted);
        // What the first one has, too, was no obstacle.
        const std::vector<std::uint8_t> plane = bench.labels(1);
        QCOMPARE(int(plane[std::size_t((6 * size.y + 6) * size.x + 5)]), 2);
        QCOMPARE(bench.tried(test::eraseAt(2, {bench.at({12, 6, 6})}, 3.0)), QString());
        QCOMPARE(bench.labels(0), labelsOf(one, 1));
        QVERIFY(bench.count(1, 2) < painted);
        const std::vector<std::uint8_t> second = bench.labels(1);
        QCOMPARE(bench.tried(test::eraseAt(1, {bench.at({12, 6, 6})}, 3.0)), QString());
        QCOMPARE(bench.labels(1), second);
        QVERIFY(bench.count(0, 1) < 13 * 6 * 4);
    }

    /// What a later step freed in a further plane does not come back beneath it.
    void nothingComesBackBeneathALaterStep()
    {
        const auto isRefused = [](const std::vector<Edit>& later) {
            const Bench bench;
            QCOMPARE(bench.tried(twoPlanes()), QString());
            QCOMPARE(bench.tried(test::paintAt(2, {bench.at({5, 6, 6})}, 3.0)), QString());
            for (const Edit& edit : later)
                QCOMPARE(bench.tried(edit), QString());
            const QByteArray before = bench.session->stateHash();
            Result<void> done = bench.session->apply(RevertRows{.rows = {2}});
            if (done)
                done = bench.session->settle();
            QVERIFY(!done);
            QCOMPARE(int(done.error().code), int(ErrorCode::StepsEntangled));
            QCOMPARE(bench.session->stateHash(), before);
        };
        isRefused({RemoveSegment{.segment = 2}});
        ImportMask over = importOf({Box{{0, 3, 4}, {30, 9, 8}}});
        over.overwriteUnlocked = true;
        isRefused({over, test::lockSegment(1), test::lockSegment(2)});
    }

    /// What an import freed in another plane comes back with it, unless a later step was there.
    void anImportIntoOneSegmentIsTakenBackAlone()
    {
        const Box wide{{0, 3, 4}, {30, 9, 8}};
        ImportMask over = importOf({wide});
        over.as = SegmentWord{.number = 1, .name = {}};
        over.overwriteUnlocked = true;
        const RevertRows undoOnly{.rows = {2}};
        const Bench bench;
        QCOMPARE(bench.tried(twoPlanes()), QString());
        QCOMPARE(bench.tried(over), QString());
        QCOMPARE(bench.labels(0), labelsOf(wide, 1));
        QCOMPARE(bench.count(1, 2), std::int64_t(0));
        // In other bricks.
        QCOMPARE(bench.tried(test::paintAt(2, {bench.at({30, 28, 26})}, 3.0)), QString());
        const std::int64_t painted = bench.count(1, 2);
        QVERIFY(painted > 0);
        QCOMPARE(bench.tried(undoOnly), QString());
        QCOMPARE(bench.labels(0), labelsOf(one, 1));
        QCOMPARE(bench.count(1, 2), painted + 10 * 6 * 4);
        QCOMPARE(bench.voxelsOf(2), bench.count(1, 2));

        const Bench beneath;
        QCOMPARE(beneath.tried(twoPlanes()), QString());
        QCOMPARE(beneath.tried(over), QString());
        QCOMPARE(beneath.tried(test::paintAt(2, {beneath.at({12, 6, 6})}, 3.0)), QString());
        const QByteArray before = beneath.session->stateHash();
        QVERIFY(beneath.tried(undoOnly).contains(QStringLiteral("the same place")));
        QCOMPARE(beneath.session->stateHash(), before);
    }

    void everyEditKeepsToItsPlane_data()
    {
        QTest::addColumn<Edit>("edit");
        const VolumeGeometry geometry = test::smallStudy().volume.geometry;
        const glm::dvec3 place = geometry.toWorld({12.0, 6.0, 6.0});
        const auto row = [](const char* name, Edit edit) { QTest::newRow(name) << edit; };
        row("invert", InvertSegment{.segment = 2});
        row("grow by a margin", ReshapeSegment{.segment = 2, .mm = 2.0});
        row("by values", ThresholdSegment{.segment = 2, .lower = 500.0});
        row("mirror", MirrorSegment{.segment = 2});
        row("what is seen",
            SegmentSeen{.target = {.segment = 2, .name = {}}, .lower = 500.0, .hidden = {}});
        row("fill",
            FloodFill{.segment = 2, .placeLps = test::pointsInBrain().front(), .tolerance = 5.0});
        row("outline",
            FillOutline{.segment = 2,
                .originLps = place,
                .polygonMm = {{-4.0, -2.0}, {4.0, -2.0}, {4.0, 2.0}, {-4.0, 2.0}}});
        row("split",
            SplitSegment{.segment = 2,
                .placeLps = geometry.toWorld({15.0, 6.0, 6.0}),
                .normalLps = {1.0, 0.0, 0.0},
                .into = {.name = QStringLiteral("Part"), .rgb = 5}});
        row("delete", RemoveSegment{.segment = 2});
    }
    void everyEditKeepsToItsPlane()
    {
        QFETCH(Edit, edit);
        const Bench bench;
        QCOMPARE(bench.tried(twoPlanes()), QString());
        QCOMPARE(bench.tried(edit), QString());
        QCOMPARE(bench.session->history().rows().size(), std::size_t(2));
        QCOMPARE(bench.labels(0), labelsOf(one, 1));
        QVERIFY(bench.labels(1) != labelsOf(two, 2));
        for (const Segment& segment : bench.session->document().segments) {
            QCOMPARE(segment.voxels, bench.count(segment.plane, segment.label));
            QCOMPARE(int(segment.plane), segment.label == 1 ? 0 : 1);
        }
        QVERIFY(bench.session->undo());
        QVERIFY(bench.session->settle());
        QCOMPARE(bench.labels(0), labelsOf(one, 1));
        QCOMPARE(bench.labels(1), labelsOf(two, 2));
    }

    /// Inside a segment is what that segment's own plane says.
    void insideASegmentOfAnotherPlane()
    {
        const Bench bench;
        QCOMPARE(bench.tried(twoPlanes()), QString());
        Edit paint = test::paintAt(2, {bench.at({2, 6, 6})}, 3.0);
        editableRangeOf(paint)->emplace().inside = std::vector<int>{1};
        QCOMPARE(bench.tried(paint), QString());
        const std::vector<std::uint8_t> first = labelsOf(one, 1);
        const std::vector<std::uint8_t> before = labelsOf(two, 2);
        const std::vector<std::uint8_t> after = bench.labels(1);
        int painted = 0;
        for (std::size_t i = 0; i < after.size(); ++i) {
            if (after[i] == before[i])
                continue;
            QCOMPARE(int(first[i]), 1);
            ++painted;
        }
        QVERIFY(painted > 20);
        QCOMPARE(bench.labels(0), first);
    }

    void whatSegmentsOfOnePlaneAloneCan()
    {
        const Bench bench;
        QCOMPARE(bench.tried(twoPlanes()), QString());
        const QByteArray before = bench.session->stateHash();
        QVERIFY(
            bench.tried(CombineSegments{.segment = 1, .with = 2, .how = CombineSegments::How::Swap})
                .contains(QStringLiteral("another label plane")));
        QCOMPARE(bench.tried(test::addSegment("Beside")), QString());
        const QByteArray added = bench.session->stateHash();
        QVERIFY(bench
                    .tried(CombineSegments{
                        .segment = 1, .with = 3, .how = CombineSegments::How::Subtract})
                    .contains(QStringLiteral("no voxel belongs to both")));
        QCOMPARE(bench.session->stateHash(), added);
        QVERIFY(bench.session->undo() && bench.session->settle());
        QCOMPARE(bench.session->stateHash(), before);
    }

    /// Union, difference and intersection of what overlaps, voxel by voxel; the other one stays.
    void setOperations_data()
    {
        QTest::addColumn<int>("how");
        QTest::addColumn<bool>("locked"); // the other, which is only read
        for (const auto& [name, how] : {std::pair{"union", CombineSegments::How::Union},
                 std::pair{"subtract", CombineSegments::How::Subtract},
                 std::pair{"intersect", CombineSegments::How::Intersect}}) {
            QTest::newRow(name) << int(how) << false;
            QTest::addRow("%s with a locked one", name) << int(how) << true;
        }
    }
    void setOperations()
    {
        QFETCH(int, how);
        QFETCH(bool, locked);
        const Bench bench;
        // A third one beside the second takes a part of what the first has.
        ImportMask mask = importOf({one, two, {{2, 3, 4}, {6, 9, 8}}});
        mask.planes = std::vector<int>{0, 1, 1};
        QCOMPARE(bench.tried(mask), QString());
        if (locked)
            QCOMPARE(bench.tried(test::lockSegment(1)), QString());
        const std::vector<std::uint8_t> first = bench.labels(0);
        const std::vector<std::uint8_t> before = bench.labels(1);
        const CombineSegments edit{.segment = 2, .with = 1, .how = CombineSegments::How(how)};
        QCOMPARE(bench.tried(edit), QString());
        const std::vector<std::uint8_t> after = bench.labels(1);
        int changed = 0;
        for (std::size_t i = 0; i < after.size(); ++i) {
            const bool inOther = first[i] == 1;
            int expected = before[i];
            if (edit.how == CombineSegments::How::Union && before[i] == 0 && inOther)
                expected = 2;
            if (edit.how == CombineSegments::How::Subtract && before[i] == 2 && inOther)
                expected = 0;
            if (edit.how == CombineSegments::How::Intersect && before[i] == 2 && !inOther)
                expected = 0;
            QCOMPARE(int(after[i]), expected);
            changed += after[i] != before[i] ? 1 : 0;
        }
        QVERIFY(changed > 0);
        QCOMPARE(bench.labels(0), first);
        const QByteArray hash = bench.session->stateHash();
        QVERIFY(bench.session->undo() && bench.session->settle());
        QCOMPARE(bench.labels(1), before);
        QVERIFY(bench.session->redo() && bench.session->settle());
        QCOMPARE(bench.session->stateHash(), hash);
        const QJsonObject text = editToJson(Edit(edit));
        QVERIFY(editFromJson(text) && editToJson(*editFromJson(text)) == text);
    }

    /// A range is kept as well, but for one that asks the same.
    void setOperationsKeepToTheEditableRange()
    {
        const Bench bench;
        QCOMPARE(bench.tried(twoPlanes()), QString());
        CombineSegments subtract{
            .segment = 2, .with = 1, .how = CombineSegments::How::Subtract, .editable = {}};
        subtract.editable.emplace().box =
            GrowBox{bench.at({10.0, 3.0, 4.0}), bench.at({11.0, 8.0, 7.0})};
        QCOMPARE(bench.tried(subtract), QString());
        QCOMPARE(bench.count(1, 2), std::int64_t(10 * 6 * 4 - 2 * 6 * 4));
        subtract.editable = EditableRange{.inside = std::vector<int>{1}};
        QVERIFY(bench.tried(subtract).contains(QStringLiteral("cannot be asked as well")));
        CombineSegments intersect{
            .segment = 2, .with = 1, .how = CombineSegments::How::Intersect, .editable = {}};
        intersect.editable.emplace().inside = std::vector<int>{2};
        QCOMPARE(bench.tried(intersect), QString());
        QCOMPARE(bench.count(1, 2), std::int64_t(3 * 6 * 4));
    }

    /// Later steps that change what was read keep "undo only" from taking it back.
    void whatASetOperationReadIsADependency()
    {
        const Bench bench;
        QCOMPARE(bench.tried(twoPlanes()), QString());
        QCOMPARE(bench.tried(test::paintAt(1, {bench.at({17, 6, 6})}, 2.0)), QString());
        const RowId painted = bench.session->history().position();
        QCOMPARE(bench.tried(CombineSegments{
                     .segment = 2, .with = 1, .how = CombineSegments::How::Subtract}),
            QString());
        QVERIFY(bench.tried(RevertRows{{painted}}).contains(QStringLiteral("the same place")));
    }

    /// A segment that is added by hand in a further plane is painted over others, which stay.
    void aSegmentIsAddedInAFurtherPlane()
    {
        const Bench bench;
        QCOMPARE(bench.tried(importOf({one})), QString());
        AddSegment add{.name = QStringLiteral("Over"), .rgb = 9};
        // What names no plane says what it always said.
        QVERIFY(!editToJson(Edit(add)).contains(QStringLiteral("plane")));
        add.plane = 2;
        const QJsonObject text = editToJson(Edit(add));
        QCOMPARE(text[QStringLiteral("plane")].toInt(), 2);
        QVERIFY(editFromJson(text) && editFromJson(text)->get<AddSegment>().plane == 2);
        QCOMPARE(bench.tried(add), QString());
        QCOMPARE(int(bench.session->document().segment(2)->plane), 2);
        const QByteArray added = bench.session->stateHash();
        QCOMPARE(bench.tried(test::paintAt(2, {bench.at({14, 6, 6})}, 3.0)), QString());
        QCOMPARE(bench.labels(0), labelsOf(one, 1));
        const std::vector<std::uint8_t> painted = bench.labels(2);
        QCOMPARE(int(painted[std::size_t((6 * size.y + 6) * size.x + 13)]), 2);
        QCOMPARE(int(painted[std::size_t((6 * size.y + 6) * size.x + 16)]), 2);
        QCOMPARE(bench.voxelsOf(2), bench.count(2, 2));
        QVERIFY(bench.session->undo() && bench.session->settle());
        QCOMPARE(bench.session->stateHash(), added);
        for (const char* wrong :
            {"{\"edit\":\"addSegment\",\"name\":\"A\",\"color\":\"#102030\",\"plane\":4}",
                "{\"edit\":\"addSegment\",\"name\":\"A\",\"color\":\"#102030\",\"plane\":-1}"})
            QVERIFY2(!editFromJson(QJsonDocument::fromJson(wrong).object()), wrong);
    }

    void whatIsRefused()
    {
        const Bench bench;
        ImportMask few = twoPlanes();
        few.planes = std::vector<int>{1};
        QVERIFY(bench.tried(few).contains(QStringLiteral("importMask.planes")));
        ImportMask joined = twoPlanes();
        joined.as = SegmentWord{.number = {}, .name = QStringLiteral("All")};
        QVERIFY(bench.tried(joined).contains(QStringLiteral("importMask.planes")));
        QVERIFY(bench.session->history().rows().empty());
        for (const char* wrong : {"{\"edit\":\"importMask\",\"file\":\"a\",\"planes\":[]}",
                 "{\"edit\":\"importMask\",\"file\":\"a\",\"planes\":[0,4]}",
                 "{\"edit\":\"importMask\",\"file\":\"a\",\"planes\":[-1]}",
                 "{\"edit\":\"importMask\",\"file\":\"a\",\"planes\":1}"})
            QVERIFY2(!editFromJson(QJsonDocument::fromJson(wrong).object()), wrong);
        // Without the field a row is what it always was.
        QVERIFY(!editToJson(Edit(importOf({one, two}))).contains(QStringLiteral("planes")));
    }

    void morePlanesThanThereCanBe()
    {
        std::vector<MaskSegment> segments;
        for (int i = 0; i < 5; ++i)
            segments.push_back(
                {.name = {}, .rgb = {}, .code = {}, .voxels = test::runsOfBox(three, size)});
        ReadImport read{.edit = importOf({one, two}), .notes = {}};
        read.overlaps = core::overlapsOf(segments);
        read.planes = planesFor(read.overlaps, segments.size());
        QCOMPARE(read.planes, (std::vector<int>{0, 1, 2, 3, 4}));
        const Result<void> refused = checkOverlaps(read);
        QVERIFY(!refused);
        QVERIFY(refused.error().arguments.value(1).contains(
            QStringLiteral("need 5 label planes, and there are at most 4")));
        read.edit.ahead = std::vector<int>{1};
        QVERIFY(checkOverlaps(read));
    }
};

BURIN_TEST(MaskPlanesTest)

} // namespace maskPlanesTest

#include "MaskPlanesTest.moc"
