// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/splitting/CopySegment.h"

#include "core/edits/EditJson.h"
#include "core/edits/document/DocumentEdits.h"
#include "core/edits/kinds/history/RevertRows.h"
#include "core/edits/kinds/imports/ImportMask.h"
#include "core/edits/kinds/parts/GrowBox.h"
#include "core/edits/kinds/segments/AddSegment.h"
#include "core/edits/kinds/segments/ChangeSegment.h"
#include "core/edits/kinds/segments/CombineSegments.h"
#include "core/edits/kinds/segments/RemoveSegment.h"
#include "core/recipe/Recipe.h"
#include "core/session/EditSession.h"
#include "core/session/questions/VoxelQuestions.h"
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

namespace copySegmentTest {

using namespace core;

namespace {

using Boxes = std::vector<VoxelBox>;

constexpr glm::ivec3 size(40, 36, 34); // of the small study
constexpr VoxelBox one{{2, 3, 4}, {15, 9, 8}};
constexpr VoxelBox two{{10, 3, 4}, {20, 9, 8}};
constexpr VoxelBox part{{12, 5, 5}, {14, 7, 7}}; // in both
constexpr VoxelBox apart{{22, 20, 18}, {30, 26, 24}};
constexpr std::int64_t voxelsOfOne = 13 * 6 * 4;

/// Segments S1, S2 … in these planes.
ImportMask importOf(const Boxes& boxes, std::vector<int> planes)
{
    ImportMask mask = test::importOfBoxes(boxes, size);
    mask.planes = std::move(planes);
    return mask;
}

CopySegment copyOf(int segment)
{
    return {.segment = segment, .name = QStringLiteral("Again"), .rgb = 0x123456};
}

struct Bench : test::SessionBench {
    explicit Bench(bool delayed = false, const QString& file = {})
        : SessionBench(delayed, test::smallStudy(), file)
    {
    }
    [[nodiscard]] const Document& document() const { return session->document(); }
    [[nodiscard]] const Segment& last() const { return document().segments.back(); }
    [[nodiscard]] glm::dvec3 at(const glm::dvec3& voxel) const { return geometry().toWorld(voxel); }
    void back() const { QVERIFY(session->undo() && session->settle()); }
    void again() const { QVERIFY(session->redo() && session->settle()); }
};

/// The voxels that have a label, for comparison of planes.
std::vector<bool> voxelsWith(const std::vector<std::uint8_t>& labels, int label)
{
    std::vector<bool> voxels(labels.size(), false);
    for (std::size_t voxel = 0; voxel < labels.size(); ++voxel)
        voxels[voxel] = labels[voxel] == label;
    return voxels;
}

} // namespace

class CopySegmentTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    /// All of it, also of a locked segment, with its code and none of its state; one row.
    void theCopyHasItsVoxels_data()
    {
        QTest::addColumn<bool>("delayed");
        QTest::newRow("at once") << false;
        QTest::newRow("answers come late") << true;
    }
    void theCopyHasItsVoxels()
    {
        QFETCH(bool, delayed);
        const QTemporaryDir folder;
        const QString file = folder.filePath(QStringLiteral("a.burin"));
        const CodedConcept liver{
            QStringLiteral("SCT"), QStringLiteral("10200004"), QStringLiteral("Liver")};
        QByteArray after;
        {
            const Bench bench(delayed, file);
            bench.run(importOf({one, apart}, {0, 0}));
            bench.run(ChangeSegment{.segment = 1, .code = liver});
            bench.run(test::lockSegment(1));
            const std::vector<std::uint8_t> first = bench.labels(0);
            const QByteArray before = bench.session->stateHash();
            bench.run(copyOf(1));
            QCOMPARE(bench.rows().size(), std::size_t(4));
            QCOMPARE(bench.rows().back().name,
                QStringLiteral("Copy segment 'S1' as 'Again', +%1 voxels").arg(voxelsOfOne));
            QCOMPARE(int(bench.last().label), 3);
            QCOMPARE(int(bench.last().plane), 1);
            QCOMPARE(bench.last().name, QStringLiteral("Again"));
            QCOMPARE(bench.last().rgb, 0x123456u);
            QVERIFY(bench.last().code == liver && !bench.last().locked);
            QCOMPARE(bench.last().voxels, voxelsOfOne);
            QCOMPARE(bench.labels(0), first);
            QVERIFY(voxelsWith(bench.labels(1), 3) == voxelsWith(first, 1));
            after = bench.session->stateHash();
            bench.back();
            QCOMPARE(bench.session->stateHash(), before);
            QCOMPARE(bench.document().segments.size(), std::size_t(2));
            QCOMPARE(bench.voxels(0, 1), std::int64_t(size.x) * size.y * size.z);
            bench.again();
            QCOMPARE(bench.session->stateHash(), after);
        }
        reference::ReferenceEngine engine;
        const auto opened = EditSession::open(engine, test::smallStudy(), file);
        QVERIFY(opened);
        QCOMPARE((*opened)->stateHash(), after);
        // The row says what it found, and is carried out in the same way anew.
        const Bench anew;
        for (const HistoryRow& row : (*opened)->history().rows()) {
            const Result<Edit> edit = editFromJson(editToJson(row.edit));
            QVERIFY(edit);
            anew.run(*edit);
        }
        QCOMPARE(anew.session->stateHash(), after);
        QVERIFY((*opened)->history().rows().back().edit.get<CopySegment>().plane == 1);
    }

    /// The first plane with segments in which all its voxels are free, or else one without.
    void whereItFits_data()
    {
        QTest::addColumn<Edit>("mask");
        QTest::addColumn<int>("copied");
        QTest::addColumn<int>("plane"); // −1: nowhere
        const auto row = [](const char* name, const Boxes& boxes, std::vector<int> planes,
                             int copied, int plane) {
            QTest::newRow(name) << Edit(importOf(boxes, std::move(planes))) << copied << plane;
        };
        row("the only plane", {one}, {0}, 1, 1);
        row("beside one that shares none", {one, apart}, {0, 1}, 1, 1);
        row("not beside one that shares some", {one, part}, {0, 1}, 1, 2);
        row("down into the first", {apart, two}, {0, 1}, 2, 0);
        row("into the first, which is empty", {one}, {2}, 1, 0);
        row("a gap between planes", {one, two, part}, {0, 1, 3}, 1, 2);
        row("the last one", {one, two, part, apart}, {0, 1, 2, 3}, 1, 3);
        row("two in one plane", {one, two, apart, part, apart}, {0, 1, 1, 2, 3}, 3, 0);
        row("nowhere", {one, two, part, one}, {0, 1, 2, 3}, 1, -1);
    }
    void whereItFits()
    {
        QFETCH(Edit, mask);
        QFETCH(int, copied);
        QFETCH(int, plane);
        const Bench bench;
        bench.run(mask);
        const std::size_t segments = bench.document().segments.size();
        const QByteArray before = bench.session->stateHash();
        const QString refused = bench.tried(copyOf(copied));
        if (plane < 0) {
            QCOMPARE(refused,
                QStringLiteral("copySegment: a session has at most 4 label planes, and in each of "
                               "them other segments have voxels of 'S1'"));
            QCOMPARE(bench.session->stateHash(), before);
            QCOMPARE(bench.rows().size(), std::size_t(1));
            return;
        }
        QCOMPARE(refused, QString());
        QCOMPARE(bench.document().segments.size(), segments + 1);
        QCOMPARE(int(bench.last().plane), plane);
        const Segment& original = *bench.document().segment(copied);
        QCOMPARE(bench.last().voxels, original.voxels);
        QVERIFY(voxelsWith(bench.labels(plane), bench.last().label)
            == voxelsWith(bench.labels(original.plane), copied));
        for (const Segment& segment : bench.document().segments)
            QCOMPARE(segment.voxels, bench.voxels(segment.label, segment.plane));
    }

    /// What others have in a plane that is named is left out.
    void aNamedPlane()
    {
        const Bench bench;
        bench.run(importOf({one, two}, {0, 1}));
        const std::vector<std::uint8_t> second = bench.labels(1);
        CopySegment copy = copyOf(1);
        copy.plane = 1;
        bench.run(copy);
        QCOMPARE(bench.last().voxels, std::int64_t(8 * 6 * 4));
        QVERIFY(voxelsWith(bench.labels(1), 2) == voxelsWith(second, 2));
        copy.plane = 3;
        bench.run(copy);
        QCOMPARE(bench.voxels(4, 3), voxelsOfOne);
    }

    void theEditableRangeIsKept()
    {
        const Bench bench;
        bench.run(importOf({one, apart}, {0, 0}));
        CopySegment copy = copyOf(1);
        copy.editable.emplace().box = GrowBox{bench.at({2.0, 3.0, 4.0}), bench.at({4.0, 8.0, 7.0})};
        bench.run(copy);
        QCOMPARE(bench.last().voxels, std::int64_t(3 * 6 * 4));
        copy.editable = EditableRange{.inside = std::vector<int>{2}};
        QVERIFY(bench.tried(copy).contains(QStringLiteral("cannot be asked as well")));
        copy.editable->inside = std::vector<int>{1, 2};
        bench.run(copy);
        QCOMPARE(bench.last().voxels, voxelsOfOne);
        copy.editable = EditableRange{.outside = std::vector<int>{3}};
        bench.run(copy);
        QCOMPARE(bench.last().voxels, voxelsOfOne - 3 * 6 * 4);
    }

    /// Nothing is left of a copy without voxels.
    void nothingToCopy()
    {
        const Bench bench;
        bench.run(importOf({one, two, one}, {0, 1, 2}));
        bench.run(test::addSegment("Empty"));
        const QByteArray before = bench.session->stateHash();
        const std::size_t rows = bench.rows().size();
        const auto nothing = [&](const CopySegment& copy) {
            QCOMPARE(bench.tried(copy), QString());
            QCOMPARE(bench.rows().size(), rows);
            QCOMPARE(bench.session->stateHash(), before);
        };
        nothing(copyOf(4));
        CopySegment taken = copyOf(1);
        taken.plane = 2;
        nothing(taken);
        CopySegment nowhere = copyOf(1);
        nowhere.editable.emplace().outside = std::vector<int>{1};
        nothing(nowhere);
    }

    void whatIsRefused()
    {
        const Bench bench;
        bench.run(importOf({one, two}, {0, 1}));
        QCOMPARE(int(bench.refusal(copyOf(3))), int(ErrorCode::UnknownSegment));
        CopySegment same = copyOf(2);
        same.plane = 1;
        QVERIFY(bench.tried(same).contains(QStringLiteral("is the label plane of the segment")));
        for (const char* wrong : {"{'edit':'copySegment','name':'A','color':'#102030'}",
                 "{'edit':'copySegment','segment':1,'color':'#102030'}",
                 "{'edit':'copySegment','segment':1,'name':'A'}",
                 "{'edit':'copySegment','segment':1,'name':'A','color':'#102030','plane':4}",
                 "{'edit':'copySegment','segment':1,'name':'A','color':'#102030','plane':-1}"})
            QVERIFY2(!editFromJson(
                         QJsonDocument::fromJson(QByteArray(wrong).replace('\'', '"')).object()),
                wrong);
        Document full = bench.document();
        full.greatestRemovedLabel = 255;
        const Result<void> refused = check(copyOf(1), full);
        QVERIFY(!refused && refused.error().arguments.join(u' ').contains(u"255 segments"));
    }

    /// What is asked for before the plane has been found waits, and is checked then.
    void othersWaitForIt()
    {
        const Bench bench(true);
        bench.run(importOf({one, two}, {0, 1}));
        QVERIFY(bench.session->apply(copyOf(1)));
        QVERIFY(bench.session->apply(test::renameSegment(3, QStringLiteral("Third"))));
        QVERIFY(bench.session->settle());
        QCOMPARE(bench.last().name, QStringLiteral("Third"));
        QCOMPARE(int(bench.last().plane), 2);
    }

    /// Nobody knows before it is carried out beside whom a copy will lie.
    void recipesAreCheckedAsFarAsIsKnown()
    {
        const Document document = initialDocument(test::smallStudy().volume);
        const auto isSound = [&](const CopySegment& copy) {
            const Recipe recipe{.path = QStringLiteral("r.json"),
                .study = {},
                .steps = {test::addSegment("One"),
                    AddSegment{.name = QStringLiteral("Over"), .plane = 1}, copy,
                    CombineSegments{.segment = 3, .with = 2, .how = CombineSegments::How::Swap}},
                .entries = {},
                .withoutSurface = {},
                .exports = {}};
            return bool(checkRecipe(recipe, document, false));
        };
        CopySegment copy = copyOf(1);
        QVERIFY(isSound(copy)); // it may lie beside the other one, and be swapped with it
        copy.plane = 1;
        QVERIFY(isSound(copy));
        copy.plane = 2;
        QVERIFY(!isSound(copy));
    }

    /// Later steps keep "undo only" from taking back what they read: the segment, and what was
    /// free.
    void whatItReadIsADependency()
    {
        for (const int painted : {1, 2}) {
            const Bench bench;
            bench.run(importOf({one, apart}, {0, 1}));
            const glm::dvec3 place = painted == 1 ? bench.at({17, 6, 6}) : bench.at({32, 23, 21});
            bench.run(test::paintAt(painted, {place}, 2.0));
            const RowId row = bench.session->history().position();
            bench.run(copyOf(1));
            QCOMPARE(int(bench.last().plane), 1);
            QVERIFY(bench.tried(RevertRows{{row}}).contains(QStringLiteral("the same place")));
        }
    }

    /// It is a segment like others: the plane is used again when the copy is gone.
    void theCopyGoes()
    {
        const Bench bench;
        bench.run(importOf({one}, {0}));
        bench.run(copyOf(1));
        const std::vector<std::uint8_t> first = bench.labels(0);
        bench.run(test::eraseAt(2, {bench.at({5, 6, 6})}, 3.0));
        QVERIFY(bench.last().voxels < voxelsOfOne && bench.labels(0) == first);
        bench.run(RemoveSegment{.segment = 2});
        bench.run(copyOf(1));
        QCOMPARE(int(bench.last().label), 3);
        QCOMPARE(int(bench.last().plane), 1);
        QCOMPARE(bench.last().voxels, voxelsOfOne);
    }
};

BURIN_TEST(CopySegmentTest)

} // namespace copySegmentTest

#include "CopySegmentTest.moc"
