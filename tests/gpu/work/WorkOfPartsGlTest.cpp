// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/filling/FillBetweenSlices.h"
#include "core/edits/kinds/filling/MirrorSegment.h"
#include "core/edits/kinds/pieces/ChangePiece.h"
#include "core/edits/kinds/pieces/CutPiece.h"
#include "core/edits/kinds/pieces/PastePiece.h"
#include "core/edits/kinds/segments/AddSegment.h"
#include "core/edits/kinds/segments/CombineSegments.h"
#include "core/edits/kinds/splitting/CopySegment.h"
#include "core/edits/kinds/splitting/SplitByCurve.h"
#include "core/edits/kinds/splitting/SplitIslands.h"
#include "core/edits/kinds/splitting/SplitSegment.h"
#include "core/session/EditSession.h"
#include "tests/support/fixtures/WorkTest.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/GradedBall.h"
#include "tests/support/scenes/PlainEdits.h"

#include <QtTest>

#include <vector>

namespace workOfPartsGlTest {

using namespace core;
using test::CountedSession;
using Ball = test::GradedBall;
using How = CombineSegments::How;

namespace {

constexpr int organ = 1;
constexpr glm::dvec3 axial(0.0, 0.0, 1.0);

/// The label of the newest segment.
int newest(CountedSession& counts)
{
    return counts.session().document().segments.back().label;
}

SplitPart part(const char* name)
{
    return {.name = QLatin1String(name), .rgb = 0x3060a0};
}

} // namespace

/// What it costs to divide, copy and combine segments, to take back one of several steps, and to
/// make pieces, counted as by WorkOfStepsGlTest. What it costs to invert one is in
/// WorkOfInvertingGlTest.
class WorkOfPartsGlTest : public test::WorkTest {
    Q_OBJECT

public:
    WorkOfPartsGlTest()
        : WorkTest(QStringLiteral("parts"))
    {
    }

private:
    void prepare(CountedSession& counts) override;
    void takeSteps(CountedSession& counts, int round) override;
    [[nodiscard]] test::MoreWork allowed(const QByteArray& step) const override;
    void divide(CountedSession& counts);
    void combine(CountedSession& counts);
    void fillBetween(CountedSession& counts);
    void takeBack(CountedSession& counts);
    void makePieces(CountedSession& counts);
};

void WorkOfPartsGlTest::divide(CountedSession& counts)
{
    counts.step("split by a plane",
        SplitSegment{.segment = organ,
            .placeLps = Ball::middle,
            .normalLps = {1.0, 0.0, 0.3},
            .into = part("Right")});
    const int right = newest(counts);
    counts.step("swap", CombineSegments{.segment = organ, .with = right, .how = How::Swap});
    counts.step("merging", CombineSegments{.segment = organ, .with = right});
    counts.step("split along a line",
        SplitByCurve{.segment = organ,
            .view = Ball::front(),
            .open = true,
            .curveMm = {{-3.0, -20.0}, {-3.0, 20.0}},
            .side = SplitByCurve::Side::Smaller,
            .into = part("Left")});
    counts.step("split within a curve",
        SplitByCurve{.segment = organ,
            .view = Ball::front(),
            .curveMm = {{2.0, -4.0}, {8.0, -4.0}, {8.0, 4.0}, {2.0, 4.0}},
            .into = part("Hole")});
    counts.prepare(test::paintAt(organ, {Ball::middle + 17.0 * axial}, 2.0));
    counts.step("split into islands", SplitIslands{.segment = organ});
    counts.step("mirror",
        MirrorSegment{
            .segment = organ, .placeLps = Ball::middle + glm::dvec3(4.0, 0.0, 0.0), .keep = true});
}

/// With a segment that overlaps.
void WorkOfPartsGlTest::combine(CountedSession& counts)
{
    counts.step("copy", CopySegment{.segment = organ, .name = QStringLiteral("Copy")});
    counts.prepare(AddSegment{.name = QStringLiteral("Over"), .plane = 2});
    const int over = newest(counts);
    counts.prepare(test::paintAt(over, {Ball::middle}, 6.0));
    counts.step("subtract", CombineSegments{.segment = organ, .with = over, .how = How::Subtract});
    counts.step("union", CombineSegments{.segment = organ, .with = over, .how = How::Union});
    counts.step(
        "intersect", CombineSegments{.segment = organ, .with = over, .how = How::Intersect});
}

void WorkOfPartsGlTest::fillBetween(CountedSession& counts)
{
    counts.prepare(test::newSegment(QStringLiteral("Drawn")));
    const int drawn = newest(counts);
    const glm::dvec3 low = Ball::middle - 14.0 * axial;
    const glm::dvec3 high = Ball::middle - 8.0 * axial;
    counts.prepare(test::paintDiscAt(drawn, low, axial, 5.0));
    counts.prepare(test::paintDiscAt(drawn, high, axial, 7.0));
    counts.step("between slices", FillBetweenSlices{.segment = drawn});
    const glm::dvec3 upright(1.0, 0.0, 0.0);
    const glm::dvec3 slanted(0.0, 1.0, 1.0);
    counts.prepare(test::paintDiscAt(drawn, high, upright, 8.0));
    counts.prepare(test::paintDiscAt(drawn, high, slanted, 8.0));
    counts.step("between planes",
        FillBetweenSlices{.segment = drawn,
            .planes = std::vector<DrawnPlane>{{high, axial}, {high, upright}, {high, slanted}}});
}

void WorkOfPartsGlTest::takeBack(CountedSession& counts)
{
    counts.prepare(test::paintAt(newest(counts), {Ball::middle + 12.0 * axial}, 3.0));
    const RowId row = counts.session().history().position();
    counts.prepare(test::paintAt(newest(counts), {Ball::middle - 20.0 * axial}, 3.0));
    counts.step("undo only", test::revertRows({row}));
}

void WorkOfPartsGlTest::makePieces(CountedSession& counts)
{
    counts.prepare(test::carveAt({Ball::middle + 10.0 * axial}, 5.0));
    counts.step("cut of a piece", CutPiece{.layer = 1, .name = QStringLiteral("Piece")});
    const int piece = counts.session().document().pieces.back().id;
    counts.step(
        "move of a piece", ChangePiece{.piece = piece, .offsetMm = glm::dvec3(20.0, 0.0, 0.0)});
    counts.step("paste of a segment",
        PastePiece{.segment = newest(counts),
            .name = QStringLiteral("Pasted"),
            .pose = {.offsetMm = {0.0, 30.0, 0.0}}});
}

void WorkOfPartsGlTest::prepare(CountedSession& counts)
{
    counts.prepare(test::newSegment(QStringLiteral("Organ")));
    counts.prepare(test::paintAt(organ, {Ball::middle}, 12.0));
}

void WorkOfPartsGlTest::takeSteps(CountedSession& counts, int /*round*/)
{
    divide(counts);
    combine(counts);
    fillBetween(counts);
    takeBack(counts);
    makePieces(counts);
}

test::MoreWork WorkOfPartsGlTest::allowed(const QByteArray& step) const
{
    // Lists of bricks, among which those are found that are concerned.
    const QByteArrayList listing{"copy", "union", "back through the history"};
    // Each layer of bricks is a portion of the large volume.
    const QByteArrayList all{"split by a plane", "split along a line", "split within a curve",
        "split into islands", "mirror", "between slices", "between planes"};
    // Besides, pictures of what lies along each line of sight, in each slice, or in each plane.
    const QByteArrayList pictured{"split along a line", "between slices", "between planes"};
    constexpr int pictureBytes = 64;
    if (!all.contains(step))
        return test::MoreWork{.tables = listing.contains(step)};
    test::MoreWork more = onAll(3);
    if (step == "between slices")
        more.bytesAllocated += moreVoxels();
    if (pictured.contains(step))
        more.bytesAllocated += pictureBytes * morePixels();
    return more;
}

BURIN_TEST(WorkOfPartsGlTest)

} // namespace workOfPartsGlTest

#include "WorkOfPartsGlTest.moc"
