// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/splitting/SplitSegment.h"

#include "core/brick/VoxelRuns.h"
#include "core/edits/EditJson.h"
#include "core/session/EditSession.h"
#include "core/session/questions/VoxelQuestions.h"
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
#include <memory>
#include <random>

namespace splitSegmentTest {

using namespace core;

namespace {

using Labels = std::vector<std::uint8_t>;
using test::smallGrid;
using test::smallIndexOf;

/// A ball, "One", that lies half in a block, "Two", and specks of it everywhere.
Edit ballAndBlock()
{
    std::array<VoxelRuns, 2> runs;
    const glm::ivec3& size = smallGrid().size;
    for (int z = 0; z < size.z; ++z) {
        for (int y = 0; y < size.y; ++y) {
            for (int x = 0; x < size.x; ++x) {
                const glm::dvec3 off = glm::dvec3(x, y, z) - glm::dvec3(19.0, 17.0, 16.0);
                const bool isSpeck = (x * 7 + y * 5 + z * 3) % 97 == 0;
                if (glm::length(off) < 9.0 || isSpeck)
                    runs[0].append(smallIndexOf({x, y, z}), 1);
                else if (x >= 19 && y >= 8 && y < 27 && z >= 10 && z < 22)
                    runs[1].append(smallIndexOf({x, y, z}), 1);
            }
        }
    }
    return test::maskImport(QStringLiteral("ball.nii"), size,
        {{QStringLiteral("One"), runs[0]}, {QStringLiteral("Two"), runs[1], 8}});
}

struct Bench : test::SessionBench {
    explicit Bench(bool delayed = false)
        : SessionBench(delayed)
    {
        run(ballAndBlock());
    }
    [[nodiscard]] const Document& document() const { return session->document(); }
};

SplitSegment splitAt(
    int segment, const glm::dvec3& index, const glm::dvec3& normalLps, const char* name = "Beyond")
{
    return {.segment = segment,
        .placeLps = smallGrid().toWorld(index),
        .normalLps = normalLps,
        .into = {.name = QLatin1String(name), .rgb = 0x336699}};
}

/// How far a voxel's centre lies beyond a plane.
double beyondMm(const SplitSegment& edit, const glm::ivec3& voxel)
{
    return glm::dot(
        glm::normalize(edit.normalLps), smallGrid().toWorld(glm::dvec3(voxel)) - edit.placeLps);
}

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

} // namespace

class SplitSegmentTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    /// Along the grid, through centres of voxels: those that lie on the plane stay.
    void whatLiesBeyondIsTheNewSegment()
    {
        const Bench bench;
        const Labels before = bench.labels();
        const QByteArray hash = bench.session->stateHash();
        bench.run(splitAt(1, {19.0, 3.0, 3.0}, {2.5, 0.0, 0.0}));
        Labels meant = before;
        std::int64_t moved = 0;
        forEachVoxel([&](const glm::ivec3& voxel, std::size_t at) {
            if (before[at] == 1 && voxel.x > 19) {
                meant[at] = 3;
                ++moved;
            }
        });
        QVERIFY(moved > 1000);
        QVERIFY(bench.labels() == meant);
        QCOMPARE(bench.document().segments.size(), std::size_t(3));
        const Segment& made = bench.document().segments.back();
        QCOMPARE(int(made.label), 3);
        QCOMPARE(made.name, QStringLiteral("Beyond"));
        QCOMPARE(made.rgb, 0x336699u);
        QCOMPARE(made.voxels, moved);
        QVERIFY(bench.rows().back().name.startsWith(QStringLiteral("Split 'One' by a plane, −")));
        const QByteArray changed = bench.session->stateHash();
        QVERIFY(bench.session->undo() && bench.session->settle());
        QCOMPARE(bench.session->stateHash(), hash);
        QCOMPARE(bench.document().segments.size(), std::size_t(2));
        QVERIFY(bench.session->redo() && bench.session->settle());
        QCOMPARE(bench.session->stateHash(), changed);
    }

    /// Any plane, held to the distance of each voxel's centre from it. The rows come to the same
    /// from scratch, as JSON too, and on an engine that delivers late.
    void anyPlane()
    {
        std::mt19937 random(5);
        const Bench bench;
        for (int step = 0; step < 12; ++step) {
            const auto part = [&random](int least, int most) {
                return least + double(random() % 1000) / 1000.0 * (most - least);
            };
            const glm::dvec3 place{part(12, 26), part(10, 24), part(10, 22)};
            const glm::dvec3 normal{part(-4, 4), part(-4, 4), part(-4, 4) + 0.01};
            const Labels before = bench.labels();
            const int label = bench.document().lastLabelGiven() + 1;
            const std::size_t rows = bench.rows().size();
            const std::vector<Segment>& segments = bench.document().segments;
            const int segment = std::max_element(
                segments.begin(), segments.end(), [](const Segment& one, const Segment& other) {
                    return one.voxels < other.voxels;
                })->label;
            const SplitSegment asked = splitAt(segment, place, normal);
            bench.run(asked);
            if (bench.rows().size() == rows) {
                std::array<int, 2> sides{};
                forEachVoxel([&](const glm::ivec3& voxel, std::size_t at) {
                    const double offMm = beyondMm(asked, voxel);
                    if (before[at] == segment && std::abs(offMm) > 0.01)
                        ++sides.at(offMm > 0.0 ? 1 : 0);
                });
                QVERIFY(sides[0] == 0 || sides[1] == 0);
                QVERIFY(bench.labels() == before);
                continue;
            }
            const auto& edit = bench.rows().back().edit.get<SplitSegment>();
            const Labels after = bench.labels();
            int sure = 0;
            bool isRight = true;
            forEachVoxel([&](const glm::ivec3& voxel, std::size_t at) {
                const double offMm = beyondMm(edit, voxel);
                const bool mayBe =
                    after[at] == before[at] || (before[at] == segment && after[at] == label);
                isRight = isRight && mayBe;
                if (before[at] != segment || std::abs(offMm) < 0.001)
                    return;
                isRight = isRight && after[at] == (offMm > 0.0 ? label : segment);
                ++sure;
            });
            QVERIFY2(isRight, qPrintable(QString::number(step)));
            QVERIFY(sure > 10);
        }
        QVERIFY(bench.rows().size() > 6);
        const Bench anew(true);
        for (std::size_t row = 1; row < bench.rows().size(); ++row) {
            const Result<Edit> told = editFromJson(editToJson(bench.rows()[row].edit));
            QVERIFY(told);
            anew.run(*told);
        }
        QCOMPARE(anew.session->stateHash(), bench.session->stateHash());
    }

    /// The length of the normal says nothing, and its sign which side is the new one.
    void theOtherWayRound()
    {
        const Bench bench;
        const Labels before = bench.labels();
        const SplitSegment forwards = splitAt(1, {19.3, 17.1, 16.2}, {0.5, 0.25, 0.125});
        bench.run(forwards);
        const Labels there = bench.labels();
        QVERIFY(bench.session->undo() && bench.session->settle());
        SplitSegment longer = forwards;
        longer.normalLps *= 64.0;
        bench.run(longer);
        QVERIFY(bench.labels() == there);
        QVERIFY(bench.session->undo() && bench.session->settle());
        SplitSegment backwards = forwards;
        backwards.normalLps = -forwards.normalLps;
        bench.run(backwards);
        const Labels back = bench.labels();
        for (std::size_t voxel = 0; voxel < before.size(); ++voxel) {
            if (before[voxel] == 1)
                QVERIFY((there[voxel] == 3) != (back[voxel] == 3));
        }
    }

    void allOnOneSideStaysAsItIs()
    {
        const Bench bench;
        const QByteArray hash = bench.session->stateHash();
        for (const double sign : {1.0, -1.0}) {
            bench.run(splitAt(1, {-1.0, 17.0, 16.0}, {sign, 0.0, 0.0}));
            bench.run(splitAt(1, {40.0, 17.0, 16.0}, {sign, 0.0, 0.0}));
        }
        QCOMPARE(bench.rows().size(), std::size_t(1));
        QCOMPARE(bench.document().segments.size(), std::size_t(2));
        QCOMPARE(bench.session->stateHash(), hash);
    }

    void whatCannotBe()
    {
        const Bench bench;
        const Result<void> unknown =
            bench.carriedOut(splitAt(7, {19.0, 17.0, 16.0}, {1.0, 0.0, 0.0}));
        QVERIFY(!unknown && unknown.error().code == ErrorCode::UnknownSegment);
        const Result<void> nowhere =
            bench.carriedOut(splitAt(1, {19.0, 17.0, 16.0}, {0.0, 0.0, 0.0}));
        QVERIFY(!nowhere && nowhere.error().code == ErrorCode::InvalidField);
        QCOMPARE(nowhere.error().arguments.front(), QStringLiteral("splitSegment.normalLps"));
        bench.run(test::lockSegment(1));
        const Result<void> locked =
            bench.carriedOut(splitAt(1, {19.0, 17.0, 16.0}, {1.0, 0.0, 0.0}));
        QVERIFY(!locked && locked.error().code == ErrorCode::SegmentLocked);
        bench.run(splitAt(2, {25.0, 17.0, 16.0}, {1.0, 0.0, 0.0}));
        QCOMPARE(bench.document().segments.size(), std::size_t(3));
    }
};

BURIN_TEST(SplitSegmentTest)

} // namespace splitSegmentTest

#include "SplitSegmentTest.moc"
