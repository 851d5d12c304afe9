// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/splitting/SplitByCurve.h"

#include "core/brick/LabelRuns.h"
#include "core/edits/EditJson.h"
#include "core/edits/EditQuantise.h"
#include "core/session/EditSession.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/PlainEdits.h"
#include "tests/support/scenes/PlainMasks.h"
#include "tests/support/scenes/SmallStudy.h"
#include "tests/support/scenes/sessions/SessionBench.h"

#include <QTest>

#include <algorithm>
#include <array>
#include <cmath>

namespace splitByCurveTest {

using namespace core;

namespace {

using Labels = std::vector<std::uint8_t>;
using Side = SplitByCurve::Side;
using test::smallGrid;
using test::smallIndexOf;

/// Calls @p see(voxel, index) for all of them.
template <class See> void forEachVoxel(const See& see)
{
    const glm::ivec3& size = smallGrid().size;
    for (int z = 0; z < size.z; ++z) {
        for (int y = 0; y < size.y; ++y) {
            for (int x = 0; x < size.x; ++x)
                see(glm::ivec3(x, y, z), smallIndexOf({x, y, z}));
        }
    }
}

/// Two walls across y, "One", the near one at y = 8 … 11, and a block between them, "Two".
Edit walls()
{
    std::array<VoxelRuns, 2> runs;
    forEachVoxel([&runs](const glm::ivec3& voxel, std::size_t at) {
        const bool isNear = voxel.y >= 8 && voxel.y < 12;
        const bool isFar = voxel.y >= 24 && voxel.y < 26;
        const bool isWithin = voxel.x >= 4 && voxel.x < 36 && voxel.z >= 5 && voxel.z < 29;
        if (isWithin && (isNear || isFar))
            runs[0].append(at, 1);
        else if (isWithin && voxel.y >= 15 && voxel.y < 20)
            runs[1].append(at, 1);
    });
    return test::maskImport(QStringLiteral("walls.nii"), smallGrid().size,
        {{QStringLiteral("One"), runs[0]}, {QStringLiteral("Two"), runs[1], 8}});
}

struct Bench : test::SessionBench {
    explicit Bench(bool delayed = false)
        : SessionBench(delayed)
    {
        run(walls());
    }
    [[nodiscard]] const Document& document() const { return session->document(); }
};

/// Looks along y at the voxel (20, ·, 17): x to the right, z upwards.
SplitByCurve fromTheFront(const std::vector<glm::dvec2>& curveMm, Side side = Side::Inside)
{
    SplitByCurve edit{.segment = 1, .curveMm = curveMm, .side = side};
    edit.view.targetLps = smallGrid().toWorld(glm::dvec3(20.0, 0.0, 17.0));
    edit.view.eyeLps = edit.view.targetLps - glm::dvec3(0.0, 200.0, 0.0);
    edit.view.up = {0.0, 0.0, 1.0};
    edit.view.heightMm = 100.0;
    edit.into = {.name = QStringLiteral("Part"), .rgb = 0x336699};
    return edit;
}

/// A rectangle around the voxels from one column and slice to another, both included.
std::vector<glm::dvec2> around(const glm::ivec2& from, const glm::ivec2& to)
{
    const glm::dvec2 low((from.x - 20 - 0.5) * 1.0, (from.y - 17 - 0.5) * 1.5);
    const glm::dvec2 high((to.x - 20 + 0.5) * 1.0, (to.y - 17 + 0.5) * 1.5);
    return {low, {high.x, low.y}, high, {low.x, high.y}};
}

bool isIn(const glm::ivec3& voxel, const glm::ivec2& from, const glm::ivec2& to)
{
    return voxel.x >= from.x && voxel.x <= to.x && voxel.z >= from.y && voxel.z <= to.y;
}

/// Labels before, but where one is 1 and a place is meant it is 3.
template <class Meant> Labels splitWhere(const Labels& before, const Meant& meant)
{
    Labels after = before;
    forEachVoxel([&](const glm::ivec3& voxel, std::size_t at) {
        if (before[at] == 1 && meant(voxel))
            after[at] = 3;
    });
    return after;
}

constexpr glm::ivec2 from{8, 9};
constexpr glm::ivec2 to{19, 20};

} // namespace

class SplitByCurveTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    void whatIsInsideIsTheNewSegment()
    {
        const Bench bench;
        const Labels before = bench.labels();
        const QByteArray hash = bench.session->stateHash();
        bench.run(fromTheFront(around(from, to)));
        QVERIFY(bench.labels()
            == splitWhere(before, [](const glm::ivec3& voxel) { return isIn(voxel, from, to); }));
        QCOMPARE(bench.document().segments.size(), std::size_t(3));
        const Segment& made = bench.document().segments.back();
        QCOMPARE(int(made.label), 3);
        QCOMPARE(made.name, QStringLiteral("Part"));
        QCOMPARE(made.rgb, 0x336699u);
        QCOMPARE(made.voxels, std::int64_t(12 * 12 * 6));
        QCOMPARE(bench.rows().size(), std::size_t(2));
        QCOMPARE(bench.rows().back().name,
            QStringLiteral("Split 'One' by a curve, −%1 voxels").arg(12 * 12 * 6));
        const QByteArray changed = bench.session->stateHash();
        QVERIFY(bench.session->undo() && bench.session->settle());
        QCOMPARE(bench.session->stateHash(), hash);
        QCOMPARE(bench.document().segments.size(), std::size_t(2));
        QVERIFY(bench.session->redo() && bench.session->settle());
        QCOMPARE(bench.session->stateHash(), changed);
    }

    void whatIsOutsideIsTheNewSegment()
    {
        const Bench bench;
        const Labels before = bench.labels();
        bench.run(fromTheFront(around(from, to), Side::Outside));
        QVERIFY(bench.labels()
            == splitWhere(before, [](const glm::ivec3& voxel) { return !isIn(voxel, from, to); }));
    }

    /// Behind what each line of sight meets first of the segment, whatever lies in front.
    void toADepth()
    {
        const Bench bench;
        const Labels before = bench.labels();
        SplitByCurve edit = fromTheFront(around(from, to));
        edit.depthMm = 7.0;
        bench.run(edit);
        QVERIFY(bench.labels() == splitWhere(before, [](const glm::ivec3& voxel) {
            return isIn(voxel, from, to) && voxel.y < 12;
        }));
        QCOMPARE(bench.rows().back().name,
            QStringLiteral("Split 'One' by a curve, 7.0 mm deep, −%1 voxels").arg(12 * 12 * 4));
        // From behind the other wall is the near one.
        QVERIFY(bench.session->undo() && bench.session->settle());
        edit.view.eyeLps.y = 200.0;
        std::vector<glm::dvec2> mirrored = edit.curveMm;
        for (glm::dvec2& point : mirrored)
            point.x = -point.x;
        edit.curveMm = mirrored;
        bench.run(edit);
        QVERIFY(bench.labels() == splitWhere(before, [](const glm::ivec3& voxel) {
            return isIn(voxel, from, to) && voxel.y >= 24;
        }));
    }

    /// A line goes on straight at its ends, however short it is; the smaller side is split off.
    void alongALine()
    {
        const Bench bench;
        const Labels before = bench.labels();
        SplitByCurve edit = fromTheFront({{3.5, -1.0}, {3.5, 2.0}}, Side::Smaller);
        edit.open = true;
        const auto isRight = [](const glm::ivec3& voxel) { return voxel.x > 23; };
        bench.run(edit);
        QVERIFY(bench.labels() == splitWhere(before, isRight));
        QVERIFY(bench.rows().back().name.startsWith(QStringLiteral("Split 'One' along a line, −")));
        // The same from the other end, and the larger side.
        QVERIFY(bench.session->undo() && bench.session->settle());
        std::reverse(edit.curveMm.begin(), edit.curveMm.end());
        bench.run(edit);
        QVERIFY(bench.labels() == splitWhere(before, isRight));
        QVERIFY(bench.session->undo() && bench.session->settle());
        edit.side = Side::Larger;
        bench.run(edit);
        QVERIFY(bench.labels()
            == splitWhere(before, [&](const glm::ivec3& voxel) { return !isRight(voxel); }));
        // Its left and its right side: the line runs downwards now.
        QVERIFY(bench.session->undo() && bench.session->settle());
        edit.side = Side::Inside;
        bench.run(edit);
        QVERIFY(bench.labels() == splitWhere(before, isRight));
        QVERIFY(bench.session->undo() && bench.session->settle());
        edit.side = Side::Outside;
        bench.run(edit);
        QVERIFY(bench.labels()
            == splitWhere(before, [&](const glm::ivec3& voxel) { return !isRight(voxel); }));
    }

    /// An oblique line with a bend, held to how far voxels lie from it and what it goes on to.
    void alongABentLine()
    {
        const Bench bench;
        const Labels before = bench.labels();
        SplitByCurve edit = fromTheFront({{-12.0, -6.0}, {0.0, 6.0}, {15.0, 9.0}}, Side::Smaller);
        edit.open = true;
        bench.run(edit);
        const Labels after = bench.labels();
        int sure = 0;
        std::array<int, 2> sides{};
        bool isRight = true;
        forEachVoxel([&](const glm::ivec3& voxel, std::size_t at) {
            if (before[at] != 1)
                return;
            const glm::dvec2 place((voxel.x - 20) * 1.0, (voxel.z - 17) * 1.5);
            const double atPlace = place.x < 0.0 ? 6.0 + place.x : 6.0 + place.x / 5.0;
            if (std::abs(place.y - atPlace) < 1.5)
                return;
            ++sure;
            ++sides.at(after[at] == 3 ? 1 : 0);
            isRight = isRight && (after[at] == 3) == (place.y > atPlace);
        });
        QVERIFY(sure > 3000);
        QVERIFY(sides[1] > 500 && sides[1] < sides[0]);
        QVERIFY(isRight);
    }

    /// As many on both sides: inside.
    void ofEqualSidesItIsTheInside()
    {
        const Bench bench;
        const Labels before = bench.labels();
        SplitByCurve edit = fromTheFront({{-0.5, 4.0}, {-0.5, -4.0}}, Side::Smaller);
        edit.open = true; // downwards: the right half of the picture is on its left
        bench.run(edit);
        QVERIFY(bench.labels()
            == splitWhere(before, [](const glm::ivec3& voxel) { return voxel.x >= 20; }));
    }

    /// What is hidden stays, and counts on no side.
    void whatIsHiddenStays()
    {
        const Bench bench;
        const Labels before = bench.labels();
        SplitByCurve edit = fromTheFront({{3.5, 5.0}, {3.5, -5.0}}, Side::Smaller);
        edit.open = true;
        const glm::dvec3 place = smallGrid().toWorld(glm::dvec3(17.5, 0.0, 0.0));
        edit.hidden = std::vector<ClipHalfSpace>{
            {.normalLps = {-1.0, 0.0, 0.0}, .offsetMm = -place.x}}; // the left of the picture
        bench.run(edit);
        QVERIFY(bench.labels() == splitWhere(before, [](const glm::ivec3& voxel) {
            return voxel.x >= 18 && voxel.x <= 23;
        }));
    }

    void isToldBefore()
    {
        const Bench bench;
        const Labels before = bench.labels();
        SplitByCurve edit = fromTheFront({{3.5, 5.0}, {3.5, -5.0}}, Side::Larger);
        edit.open = true;
        const Result<SplitSides> sides = sidesOf(edit, bench.document(), labelRuns(before, 1), {});
        QVERIFY(sides && !sides->isInside);
        bench.run(edit);
        const auto count = [&bench](int label) { return bench.voxels(label); };
        QCOMPARE(std::int64_t(sides->beyond.voxelCount()), count(3));
        QCOMPARE(std::int64_t(sides->staying), count(1));
        QVERIFY(labelRuns(bench.labels(), 3) == sides->beyond);
    }

    /// Of nothing, or of all.
    void allOnOneSideStaysAsItIs()
    {
        const Bench bench;
        const QByteArray hash = bench.session->stateHash();
        bench.run(fromTheFront(around({0, 0}, {2, 3})));
        bench.run(fromTheFront(around({0, 0}, {2, 3}), Side::Outside));
        bench.run(fromTheFront(around({0, 0}, {39, 33})));
        SplitByCurve line = fromTheFront({{-18.0, 5.0}, {-18.0, -5.0}}, Side::Smaller);
        line.open = true;
        bench.run(line);
        line.side = Side::Larger;
        bench.run(line);
        QCOMPARE(bench.rows().size(), std::size_t(1));
        QCOMPARE(bench.document().segments.size(), std::size_t(2));
        QCOMPARE(bench.session->stateHash(), hash);
    }

    /// As JSON and on an engine that delivers late it comes to the same.
    void comesToTheSame()
    {
        const Bench bench;
        SplitByCurve inside = fromTheFront(around(from, to));
        inside.depthMm = 7.0;
        bench.run(inside);
        SplitByCurve line = fromTheFront({{-7.3, -3.0}, {1.1, 2.2}, {4.0, 1.0}}, Side::Smaller);
        line.open = true;
        line.hidden = std::vector<ClipHalfSpace>{
            {.normalLps = {0.0, 0.0, 1.0}, .offsetMm = smallGrid().toWorld({0, 0, 25}).z}};
        bench.run(line);
        line.segment = 2;
        line.side = Side::Outside;
        bench.run(line);
        QCOMPARE(bench.rows().size(), std::size_t(4));
        const Bench anew(true);
        for (std::size_t row = 1; row < bench.rows().size(); ++row) {
            const Result<Edit> told = editFromJson(editToJson(bench.rows()[row].edit));
            QVERIFY(told);
            anew.run(*told);
        }
        QCOMPARE(anew.session->stateHash(), bench.session->stateHash());
    }

    void whatCannotBe()
    {
        const Bench bench;
        const auto fieldOf = [&bench](const SplitByCurve& edit) {
            const Result<void> done = bench.carriedOut(edit);
            return done ? QString() : done.error().arguments.front();
        };
        SplitByCurve edit = fromTheFront(around(from, to));
        edit.segment = 7;
        QCOMPARE(bench.refusal(edit), ErrorCode::UnknownSegment);
        edit.segment = 1;
        edit.side = Side::Outside;
        edit.depthMm = 4.0;
        QCOMPARE(fieldOf(edit), QStringLiteral("splitByCurve.depthMm"));
        edit.side = Side::Smaller;
        QCOMPARE(fieldOf(edit), QStringLiteral("splitByCurve.depthMm"));
        edit.depthMm.reset();
        edit.curveMm = {{0.0, 0.0}, {0.1, 0.0}, {0.0, 0.1}};
        QCOMPARE(fieldOf(edit), QStringLiteral("splitByCurve.curveMm"));
        edit.open = true;
        edit.curveMm = {{1.0, 1.0}, {1.0, 1.0}};
        QCOMPARE(fieldOf(edit), QStringLiteral("splitByCurve.curveMm"));
        edit.curveMm = {{1.0, 1.0}};
        QCOMPARE(fieldOf(edit), QStringLiteral("splitByCurve.curveMm"));
        edit.curveMm = {{1.0, 1.0}, {1.0, 5.0}};
        edit.view.up = {0.0, 1.0, 0.0};
        QVERIFY(fieldOf(edit).startsWith(QStringLiteral("splitByCurve.view")));
        bench.run(test::lockSegment(1));
        const SplitByCurve plain = fromTheFront(around(from, to));
        QCOMPARE(bench.refusal(plain), ErrorCode::SegmentLocked);
        QCOMPARE(bench.document().segments.size(), std::size_t(2));
    }
};

BURIN_TEST(SplitByCurveTest)

} // namespace splitByCurveTest

#include "SplitByCurveTest.moc"
