// SPDX-License-Identifier: Apache-2.0
#include "core/edits/engine/EditableRanges.h"
#include "core/edits/EditJson.h"
#include "core/edits/kinds/EditParts.h"
#include "core/edits/kinds/chunks/ChunkToggle.h"
#include "core/edits/kinds/chunks/DivideSegment.h"
#include "core/edits/kinds/filling/EvolveContour.h"
#include "core/edits/kinds/filling/FillBetweenSlices.h"
#include "core/edits/kinds/filling/FloodFill.h"
#include "core/edits/kinds/filling/MirrorSegment.h"
#include "core/edits/kinds/filling/SegmentScissors.h"
#include "core/edits/kinds/parts/BrushPath.h"
#include "core/edits/kinds/segments/CleanSegment.h"
#include "core/edits/kinds/segments/CombineSegments.h"
#include "core/edits/kinds/segments/FillOutline.h"
#include "core/edits/kinds/segments/InvertSegment.h"
#include "core/edits/kinds/segments/LayerToSegment.h"
#include "core/edits/kinds/segments/ReshapeSegment.h"
#include "core/edits/kinds/segments/SegmentSeen.h"
#include "core/edits/kinds/splitting/SplitByCurve.h"
#include "core/edits/kinds/splitting/SplitIslands.h"
#include "core/edits/kinds/splitting/SplitSegment.h"
#include "core/edits/kinds/values/ThresholdSegment.h"
#include "core/session/EditSession.h"
#include "core/session/past/RowDependencies.h"
#include "core/session/questions/VoxelQuestions.h"
#include "tests/reference/DelayedEngine.h"
#include "tests/reference/ReferenceEngine.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/PlainEdits.h"
#include "tests/support/scenes/SmallStudy.h"

#include <QJsonObject>
#include <QTest>

#include <algorithm>
#include <utility>

namespace editableRangesTest {

using namespace core;

namespace {

/// A session with three segments that overlap bone, brain and air: One and Two are balls that
/// touch, One has an island and a hole, Three was drawn on two slices.
struct Bench {
    Bench()
        : late(inner, 11)
        , session(*EditSession::create(late, test::smallStudy(), {.file = {}}))
    {
        for (const char* name : {"One", "Two", "Three"})
            run(test::addSegment(name));
        run(test::paintAt(1, {at({19.0, 17.0, 16.0})}, 9.0));
        run(test::eraseAt(1, {at({17.0, 17.0, 16.0})}, 2.5));
        run(test::paintAt(1, {at({4.0, 4.0, 4.0})}, 2.0));
        run(test::paintAt(2, {at({31.0, 17.0, 16.0})}, 6.0));
        run(outline(3, 25.0));
        run(outline(3, 30.0));
        run(test::carveAt({at({8.0, 17.0, 16.0}), at({19.0, 30.0, 16.0})}, 6.0));
        run(DivideSegment{.segment = 1, .marginMm = 3.0});
    }
    void run(const Edit& edit)
    {
        const Result<void> applied = session->apply(edit);
        QVERIFY2(applied, qPrintable(applied ? QString() : applied.error().arguments.join(u' ')));
        QVERIFY(session->settle());
    }
    [[nodiscard]] ErrorCode refusal(const Edit& edit)
    {
        const Result<void> applied = session->apply(edit);
        return applied ? ErrorCode::Internal : applied.error().code;
    }
    [[nodiscard]] std::vector<std::uint8_t> labels() { return *session->questions().labels(0); }
    /// What an edit makes of the labels; then it is taken back.
    [[nodiscard]] std::vector<std::uint8_t> labelsAfter(const Edit& edit)
    {
        const RowId before = session->history().position();
        run(edit);
        const std::vector<std::uint8_t> found = labels();
        if (session->history().position() != before) {
            const Result<void> undone = session->undo();
            const Result<void> settled = session->settle();
            if (!undone || !settled)
                return {};
        }
        return found;
    }
    [[nodiscard]] const VolumeGeometry& geometry() const
    {
        return session->document().volumes.front().geometry;
    }
    [[nodiscard]] glm::dvec3 at(const glm::dvec3& index) const { return geometry().toWorld(index); }
    /// A square around the middle of a slice.
    [[nodiscard]] FillOutline outline(int segment, double slice) const
    {
        FillOutline edit{.segment = segment, .originLps = at({19.0, 17.0, slice})};
        edit.polygonMm = {{-9.0, -9.0}, {9.0, -9.0}, {9.0, 9.0}, {-9.0, 9.0}};
        return edit;
    }

    reference::ReferenceEngine inner;
    reference::DelayedEngine late;
    std::unique_ptr<EditSession> session;
};

/// Every kind of edit that keeps to a range, each of which changes something in that session.
std::vector<Edit> someEdits(const Bench& bench)
{
    std::vector<Edit> edits;
    edits.push_back(test::paintAt(3, {bench.at({20.0, 3.0, 16.0}), bench.at({20.0, 30.0, 16.0})}));
    edits.push_back(
        test::paintOverAt(2, {bench.at({3.0, 17.0, 16.0}), bench.at({37.0, 17.0, 16.0})}));
    edits.push_back(test::eraseAt(1, {bench.at({3.0, 3.0, 3.0}), bench.at({30.0, 20.0, 16.0})}));
    FillOutline outline = bench.outline(2, 16.0);
    outline.overwriteUnlocked = true;
    edits.push_back(outline);
    outline.segment = 1;
    outline.erase = true;
    edits.push_back(outline);
    edits.push_back(FillBetweenSlices{.segment = 3});
    edits.push_back(FloodFill{.segment = 3,
        .placeLps = bench.at({19.0, 17.0, 16.0}),
        .tolerance = 1000.0,
        .overwriteUnlocked = true});
    edits.push_back(FloodFill{
        .segment = 1, .placeLps = bench.at({20.0, 20.0, 16.0}), .erase = true, .tolerance = 0.0});
    edits.push_back(CleanSegment{.segment = 1, .rule = IslandRule::FillHoles});
    edits.push_back(CleanSegment{.segment = 1, .rule = IslandRule::KeepLargest});
    edits.push_back(ReshapeSegment{.segment = 1, .operation = ShapeOperation::Grow, .mm = 3.0});
    edits.push_back(ReshapeSegment{.segment = 2, .operation = ShapeOperation::Shrink, .mm = 2.0});
    edits.push_back(CombineSegments{.segment = 1, .with = 2, .how = CombineSegments::How::Swap});
    edits.push_back(CombineSegments{.segment = 1, .with = 3, .how = CombineSegments::How::Merge});
    edits.push_back(InvertSegment{.segment = 2});
    edits.push_back(ThresholdSegment{.segment = 1, .lower = 0.0, .upper = 100.0});
    edits.push_back(ThresholdSegment{.segment = 2,
        .lower = 500.0,
        .mode = ThresholdSegment::Mode::Add,
        .overwriteUnlocked = true});
    edits.push_back(LayerToSegment{
        .layer = 1, .target = {.segment = 3, .name = {}}, .overwriteUnlocked = true});
    edits.push_back(
        SegmentSeen{.target = {.segment = 2, .name = {}}, .lower = 0.0, .overwriteUnlocked = true});
    SegmentScissors scissors{.segment = 1,
        .view = {.eyeLps = bench.at({19.0, -200.0, 16.0}),
            .targetLps = bench.at({19.0, 17.0, 16.0}),
            .up = {0.0, 0.0, 1.0},
            .heightMm = 80.0},
        .polygonMm = {{-7.0, -6.0}, {20.0, -6.0}, {20.0, 6.0}, {-7.0, 6.0}},
        .erase = true,
        .others = std::vector<int>{2}};
    edits.push_back(scissors);
    scissors.erase = false;
    scissors.others.reset();
    scissors.depthMm = 12.0;
    scissors.overwriteUnlocked = true;
    edits.push_back(scissors);
    edits.push_back(MirrorSegment{.segment = 2});
    edits.push_back(SplitSegment{.segment = 1,
        .placeLps = bench.at({19.0, 17.0, 16.0}),
        .normalLps = {1.0, 0.5, 0.25},
        .into = {.name = QStringLiteral("Beyond"), .rgb = 7}});
    edits.push_back(SplitIslands{.segment = 1});
    edits.push_back(ChunkToggle{.segment = 1,
        .chunks = 6,
        .mode = ChunkToggle::Mode::Remove,
        .pointsLps = {bench.at({14.0, 17.0, 16.0}), bench.at({25.0, 17.0, 16.0})}});
    edits.push_back(SplitByCurve{.segment = 1,
        .view = scissors.view,
        .open = true,
        .curveMm = {{-2.0, -6.0}, {1.0, 6.0}},
        .side = SplitByCurve::Side::Larger,
        .into = {.name = QStringLiteral("Larger"), .rgb = 7}});
    edits.push_back(EvolveContour{.segment = 2,
        .lower = -200.0,
        .upper = 400.0,
        .softness = 50.0,
        .generations = 4,
        .overwriteUnlocked = true});
    return edits;
}

std::vector<EditableRange> someRanges(const Bench& bench)
{
    const GrowBox box{bench.at({30.0, 10.0, 10.0}), bench.at({8.0, 20.0, 28.0})};
    std::vector<EditableRange> ranges;
    ranges.push_back({.lower = 0.0});
    ranges.push_back({.upper = 39.5});
    ranges.push_back({.lower = 40.0, .upper = 40.0});
    ranges.push_back({.box = box});
    ranges.push_back({.inside = std::vector<int>{1}});
    ranges.push_back({.inside = std::vector<int>{2, 3}});
    ranges.push_back({.outside = std::vector<int>{1}});
    ranges.push_back({.outside = std::vector<int>{1, 2, 3}});
    ranges.push_back({.upper = 500.0,
        .box = box,
        .inside = std::vector<int>{1, 2},
        .outside = std::vector<int>{2}});
    ranges.push_back({.inside = std::vector<int>()});
    ranges.push_back({});
    return ranges;
}

bool lists(const std::vector<int>& segments, int label)
{
    return std::find(segments.begin(), segments.end(), label) != segments.end();
}

/// The rule as a user would say it.
bool mayChange(const EditableRange& range, double value, const glm::dvec3& index,
    const VolumeGeometry& geometry, int label)
{
    if ((range.lower && value < *range.lower) || (range.upper && value > *range.upper))
        return false;
    if (range.box) {
        const glm::dvec3 a = geometry.toIndex(range.box->fromLps);
        const glm::dvec3 b = geometry.toIndex(range.box->toLps);
        for (int axis = 0; axis < 3; ++axis) {
            if (index[axis] < std::min(a[axis], b[axis]) - 0.4
                || index[axis] > std::max(a[axis], b[axis]) + 0.4)
                return false;
        }
    }
    if (range.inside && !lists(*range.inside, label))
        return false;
    return !range.outside || !lists(*range.outside, label);
}

} // namespace

class EditableRangesTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    /// With a range an edit does what it does without, wherever the range allows it, and nothing
    /// elsewhere.
    void everyEditKeepsToIt()
    {
        Bench bench;
        const LoadedVolume study = test::smallStudy();
        const std::vector<std::uint8_t> start = bench.labels();
        const glm::ivec3& size = bench.geometry().size;
        int number = 0;
        for (const Edit& plain : someEdits(bench)) {
            const std::vector<std::uint8_t> freely = bench.labelsAfter(plain);
            QVERIFY2(freely != start, qPrintable(QString::number(number)));
            int allowed = 0;
            int prevented = 0;
            for (const EditableRange& range : someRanges(bench)) {
                Edit edit = plain;
                *editableRangeOf(edit) = range;
                const std::vector<std::uint8_t> found = bench.labelsAfter(edit);
                QCOMPARE(found.size(), start.size());
                std::vector<std::uint8_t> meant = start;
                std::size_t at = 0;
                for (int z = 0; z < size.z; ++z)
                    for (int y = 0; y < size.y; ++y)
                        for (int x = 0; x < size.x; ++x, ++at) {
                            const double value = study.codes[at] - 1024.0;
                            const bool may = mayChange(
                                range, value, glm::dvec3(x, y, z), bench.geometry(), start[at]);
                            if (may)
                                meant[at] = freely[at];
                            if (freely[at] != start[at])
                                ++(may ? allowed : prevented);
                        }
                QVERIFY2(found == meant,
                    qPrintable(QStringLiteral("edit %1: %2").arg(number).arg(editName(edit))));
            }
            QVERIFY(allowed > 0 && prevented > 0);
            ++number;
        }
        QCOMPARE(bench.labels(), start);
    }

    /// A brush that comes to a place again asks what is there by then; nothing more may come of it.
    void aBrushThatComesAgain()
    {
        Bench bench;
        Edit once = test::paintOverAt(3, {bench.at({25.0, 17.0, 16.0})}, 7.0);
        *editableRangeOf(once) = EditableRange{.inside = std::vector<int>{1, 2}};
        Edit often = once;
        std::vector<glm::dvec3>& points = brushPathOf(often)->pointsLps;
        const glm::dvec3 place = points.front();
        points.insert(points.end(), {place + glm::dvec3(0.5, 0.0, 0.0), place, place});
        Edit wide = once;
        brushPathOf(wide)->pointsLps = {place, place + glm::dvec3(0.5, 0.0, 0.0)};
        QCOMPARE(bench.labelsAfter(often), bench.labelsAfter(wide));
        QVERIFY(bench.labelsAfter(once) != bench.labels());
    }

    void itIsPartOfTheRecipe()
    {
        const Bench bench;
        for (const Edit& plain : someEdits(bench)) {
            QVERIFY(!editToJson(plain).contains(QStringLiteral("editable")));
            for (const EditableRange& range : someRanges(bench)) {
                Edit edit = plain;
                *editableRangeOf(edit) = range;
                const QJsonObject json = editToJson(edit);
                QVERIFY(json.value(QStringLiteral("editable")).isObject());
                const Result<Edit> back = editFromJson(json);
                QVERIFY2(back, qPrintable(back ? QString() : back.error().arguments.join(u' ')));
                QCOMPARE(editToJson(*back), json);
                QVERIFY(*editableRangeOf(*back) == *editableRangeOf(std::as_const(edit)));
            }
        }
        Edit seed = test::seedInBrain(1);
        QVERIFY(!editableRangeOf(seed)); // it changes no voxel
    }

    /// What was done comes to the same state again, from its rows alone.
    void replaysToTheSameState()
    {
        Bench bench;
        const std::vector<Edit> edits = someEdits(bench);
        const std::vector<EditableRange> ranges = someRanges(bench);
        for (std::size_t i = 0; i < edits.size(); ++i) {
            Edit edit = edits[i];
            *editableRangeOf(edit) = ranges[i % 8];
            // What it is about may be gone by now.
            if (bench.session->apply(edit))
                static_cast<void>(bench.session->settle());
        }
        QVERIFY(bench.session->history().rows().size() > std::size_t(16));
        reference::ReferenceEngine engine;
        const auto again = *EditSession::create(engine, test::smallStudy(), {.file = {}});
        for (const HistoryRow& row : bench.session->history().rows()) {
            const Result<Edit> told = editFromJson(editToJson(row.edit));
            QVERIFY(told);
            QVERIFY(again->apply(*told));
            QVERIFY(again->settle());
        }
        QCOMPARE(again->history().rows().size(), bench.session->history().rows().size());
        QCOMPARE(again->stateHash(), bench.session->stateHash());
    }

    void whatIsRefused()
    {
        Bench bench;
        const auto refusalOf = [&bench](const EditableRange& range) {
            Edit edit = test::paintAt(3, {bench.at({20.0, 3.0, 16.0})});
            *editableRangeOf(edit) = range;
            return bench.refusal(edit);
        };
        QCOMPARE(refusalOf({.inside = std::vector<int>{9}}), ErrorCode::UnknownSegment);
        QCOMPARE(refusalOf({.outside = std::vector<int>{1, 9}}), ErrorCode::UnknownSegment);
        QCOMPARE(refusalOf({.lower = 10.0, .upper = 9.0}), ErrorCode::InvalidField);
        QCOMPARE(refusalOf({.box = GrowBox{bench.at({60, 0, 0}), bench.at({70, 9, 9})}}),
            ErrorCode::InvalidField);
        QCOMPARE(refusalOf({.inside = std::vector<int>{2, 1}}), ErrorCode::InvalidField);
        for (const Edit& plain : someEdits(bench)) {
            Edit edit = plain;
            *editableRangeOf(edit) = EditableRange{.inside = std::vector<int>{9}};
            QCOMPARE(bench.refusal(edit), ErrorCode::UnknownSegment);
        }
        QJsonObject json = editToJson(test::paintAt(3, {bench.at({20.0, 3.0, 16.0})}));
        for (const QJsonValue& wrong :
            {QJsonValue(3), QJsonValue(QJsonObject{{QStringLiteral("lowest"), 3}}),
                QJsonValue(QJsonObject{{QStringLiteral("inside"), 3}})}) {
            json.insert(QStringLiteral("editable"), wrong);
            const Result<Edit> read = editFromJson(json);
            QVERIFY(!read && read.error().code == ErrorCode::InvalidField);
            QVERIFY(read.error().arguments.front().startsWith(QLatin1String("paint.editable")));
        }
    }

    /// In integers, and by the plane in which a segment lies.
    void forAnEngine()
    {
        Bench bench;
        Document document = bench.session->document();
        document.segments[1].plane = 1;
        const auto none = editableVoxels(std::nullopt, document, "paint");
        QVERIFY(none && !*none);
        const EditableRange range{.lower = -0.5,
            .upper = 40.5,
            .box = GrowBox{bench.at({9, 8, 7}), bench.at({3, 4, 99})},
            .inside = std::vector<int>{1, 2, 3},
            .outside = std::vector<int>{2}};
        const auto voxels = editableVoxels(range, document, "paint");
        QVERIFY(voxels && *voxels);
        QCOMPARE((*voxels)->lowCode, 1024);
        QCOMPARE((*voxels)->highCode, 1064);
        QVERIFY((*voxels)->box->minimum == glm::ivec3(3, 4, 7));
        QVERIFY((*voxels)->box->maximum == glm::ivec3(10, 9, 34));
        QCOMPARE((*voxels)->inside->size(), std::size_t(2));
        QCOMPARE(int((*voxels)->inside->front().plane), 0);
        QCOMPARE((*voxels)->inside->front().labels.to_ulong(), 0b1010ul);
        QCOMPARE(int((*voxels)->inside->back().plane), 1);
        QCOMPARE((*voxels)->inside->back().labels.to_ulong(), 0b100ul);
        QCOMPARE((*voxels)->outside.size(), std::size_t(1));
        QCOMPARE(int((*voxels)->outside.front().plane), 1);
        EditableVoxels twice;
        twice.outside = {{.plane = 1}, {.plane = 1}};
        QVERIFY(!checkSound(std::optional(twice)));
    }

    /// Before what was changed, and only where there is a range that limits anything.
    void rowsSaySo()
    {
        Bench bench;
        const auto nameOf = [&bench](const Edit& edit) {
            bench.run(edit);
            const HistoryRow& row = bench.session->history().rows().back();
            return row.title && canonicalName(*row.title) == row.name ? row.name : QString();
        };
        Edit edit = test::paintAt(3, {bench.at({4.0, 30.0, 4.0})}, 2.0);
        const QString plain = nameOf(edit);
        QVERIFY(plain.contains(QStringLiteral(", +")));
        QVERIFY(!plain.contains(QStringLiteral("limits")));
        const qsizetype figures = plain.lastIndexOf(QStringLiteral(", "));
        QVERIFY(bench.session->undo() && bench.session->settle());
        *editableRangeOf(edit) = EditableRange{};
        QCOMPARE(nameOf(edit), plain);
        QVERIFY(bench.session->undo() && bench.session->settle());
        *editableRangeOf(edit) = EditableRange{.outside = std::vector<int>{1}};
        const QString limited =
            plain.left(figures) + QStringLiteral(", within limits") + plain.mid(figures);
        QCOMPARE(nameOf(edit), limited);
        // Rows that quote it say it, too.
        const RowTitle quoted = headlineOf(*bench.session->history().rows().back().title);
        QCOMPARE(canonicalName(quoted), plain.left(figures) + QStringLiteral(", within limits"));
    }

    /// What the named segments hold decides, on their own plane too.
    void dependsOnTheNamedSegments()
    {
        Bench bench;
        Document document = bench.session->document();
        document.segments[1].plane = 1;
        Edit edit = test::paintAt(3, {bench.at({4.0, 4.0, 4.0})}, 2.0);
        const auto needs = [&document](const Edit& of, const BrickKey& key) {
            return RowDependencies(of, document, {}).covers(key);
        };
        const BrickKey near{Field::Labels, 1, 0};
        const BrickKey far{Field::Labels, 1, 8};
        QVERIFY(!needs(edit, near));
        *editableRangeOf(edit) = EditableRange{.outside = std::vector<int>{2}};
        QVERIFY(needs(edit, near));
        QVERIFY(!needs(edit, far));
        QVERIFY(!needs(edit, {Field::SeedWords, 1, 0}));
        QVERIFY(needs(edit, {Field::SeedWords, 0, 0}));
        Edit whole = InvertSegment{.segment = 1};
        QVERIFY(!needs(whole, far));
        *editableRangeOf(whole) = EditableRange{.inside = std::vector<int>{2}};
        QVERIFY(needs(whole, far));
        QVERIFY(!needs(whole, {Field::SeedWords, 1, 8}));
    }
};

BURIN_TEST(EditableRangesTest)

} // namespace editableRangesTest

#include "EditableRangesTest.moc"
