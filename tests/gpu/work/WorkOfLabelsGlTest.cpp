// SPDX-License-Identifier: Apache-2.0
#include "core/brick/BrickGrid.h"
#include "core/edits/engine/NudgeDisc.h"
#include "core/edits/kinds/filling/EvolveContour.h"
#include "core/edits/kinds/filling/FloodFill.h"
#include "core/edits/kinds/filling/SegmentScissors.h"
#include "core/edits/kinds/segments/CleanSegment.h"
#include "core/edits/kinds/segments/PaintStroke.h"
#include "core/edits/kinds/segments/ReshapeSegment.h"
#include "core/edits/kinds/surface/LaySurface.h"
#include "core/edits/kinds/surface/SpherePush.h"
#include "core/edits/kinds/surface/WriteBack.h"
#include "core/edits/kinds/values/ThresholdSegment.h"
#include "core/session/EditSession.h"
#include "core/session/questions/VoxelQuestions.h"
#include "tests/support/fixtures/WorkTest.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/GradedBall.h"
#include "tests/support/scenes/PlainEdits.h"

#include <QtTest>

#include <vector>

namespace workOfLabelsGlTest {

using namespace core;
using test::CountedSession;
using Ball = test::GradedBall;

namespace {

constexpr int label = 1;

/// What *Nudge* does: it asks how the border lies, then pushes it with a disc that fits.
bool nudge(EditSession& session, const glm::dvec3& place, const glm::dvec3& to)
{
    PaintStroke stroke{.segment = label};
    stroke.path.radiusMm = 6.0;
    stroke.path.shape = BrushPath::Shape::Disc;
    stroke.path.normalLps = {0.0, 0.0, 1.0};
    stroke.path.pointsLps = {place};
    stroke.tool = PaintStroke::Tool::Nudge;
    const VolumeGeometry& geometry = session.document().volumes.front().geometry;
    const Result<NudgeDisc> disc = nudgeDisc(stroke.path, geometry, QStringLiteral("paint"));
    if (!disc)
        return false;
    std::vector<BrickKey> keys;
    for (const std::uint32_t brick : disc->bricks)
        keys.push_back({Field::Labels, 0, brick});
    session.questions().bricks(
        keys, [&session, stroke, disc = *disc, to](const Result<std::vector<BrickImage>>& near) {
            const BrickGrid grid{session.document().volumes.front().geometry.size};
            const NudgeStart start = nudgeStart(disc.frame, disc.centre, grid, label, *near);
            PaintStroke begun = stroke;
            begun.erase = !start.isInside;
            begun.path.radiusMm = fittingRadiusMm(start);
            begun.path.pointsLps.push_back(to);
            if (!session.apply(begun))
                qWarning("a nudge was refused");
        });
    return true;
}

} // namespace

/// What the tools cost that fill a segment, move its border or work on all of it, counted as by
/// WorkOfStepsGlTest.
class WorkOfLabelsGlTest : public test::WorkTest {
    Q_OBJECT

public:
    WorkOfLabelsGlTest()
        : WorkTest(QStringLiteral("labels"))
    {
    }

private:
    void prepare(CountedSession& counts) override;
    void takeSteps(CountedSession& counts, int round) override;
    [[nodiscard]] test::MoreWork allowed(const QByteArray& step) const override;
    void fill(CountedSession& counts, const glm::dvec3& place);
    void threshold(CountedSession& counts);
    void workOnAll(CountedSession& counts);
    void refine(CountedSession& counts);
};

void WorkOfLabelsGlTest::fill(CountedSession& counts, const glm::dvec3& place)
{
    EditSession& session = counts.session();
    const glm::dvec2 seen(place.x - Ball::middle.x, place.z - Ball::middle.z);
    counts.step("segment scissors",
        SegmentScissors{.segment = label,
            .view = Ball::front(),
            .polygonMm = Ball::squareAround(seen, 3.0),
            .depthMm = 5.0,
            .lower = Ball::threshold});
    counts.step("scissors that erase",
        SegmentScissors{.segment = label,
            .view = Ball::front(),
            .polygonMm = Ball::squareAround(seen, 2.0),
            .erase = true});
    const FloodFill flood{.segment = label, .placeLps = place, .tolerance = 60.0};
    FloodFill inSlice = flood;
    inSlice.within = SliceAxis::K;
    counts.step("flood fill of a slice", inSlice);
    counts.step("flood fill", flood);
    FloodFill erasing = inSlice;
    erasing.erase = true;
    counts.step("flood fill that erases", erasing);
    counts.step("undo of flood fill", [&] { return bool(session.undo()); });
    counts.step("nudge", [&] { return nudge(session, place, place + glm::dvec3(9.0, 0.0, 0.0)); });
}

void WorkOfLabelsGlTest::threshold(CountedSession& counts)
{
    const GrowBox box{.fromLps = Ball::middle - 12.0, .toLps = Ball::middle + 12.0};
    ThresholdSegment shown{.segment = label, .lower = Ball::valueAt(10.0), .box = box};
    const auto dragged = [&](double radiusMm) {
        shown.lower = Ball::valueAt(radiusMm);
        counts.begin(shown);
    };
    // Another preview takes the one before back.
    counts.tell([&] { dragged(10.0); });
    counts.event("drag of a threshold in a box", [&] { dragged(9.0); });
    shown.box.reset();
    counts.tell([&] { dragged(9.0); });
    counts.event("drag of a threshold", [&] { dragged(10.0); });
    counts.end(Ending::Rollback);
    counts.step("threshold in a box",
        ThresholdSegment{.segment = label, .lower = Ball::valueAt(10.0), .box = box});
}

void WorkOfLabelsGlTest::workOnAll(CountedSession& counts)
{
    const auto reshape = [](ShapeOperation operation, double mm) {
        return ReshapeSegment{.segment = label, .operation = operation, .mm = mm};
    };
    counts.step("margin", reshape(ShapeOperation::Grow, 2.0));
    counts.step("smoothing by a ball", reshape(ShapeOperation::Median, 2.0));
    counts.step("smoothing by a Gaussian", reshape(ShapeOperation::Gaussian, 1.5));
    counts.step("smaller margin", reshape(ShapeOperation::Shrink, 1.0));
    counts.step("islands", CleanSegment{.segment = label, .rule = IslandRule::KeepLargest});
    counts.step(
        "contour", EvolveContour{.segment = label, .lower = Ball::valueAt(14.0), .generations = 3});
}

void WorkOfLabelsGlTest::refine(CountedSession& counts)
{
    counts.step("laying a surface",
        LaySurface{.segment = label, .vertices = 400, .rules = newestSurfaceRules});
    const glm::dvec3 beside = Ball::middle + glm::dvec3(0.0, 0.0, 18.0);
    counts.step("push of a sphere",
        SpherePush{.path = {.radiusMm = 5.0,
                       .pointsLps = {beside, beside - glm::dvec3(0.0, 0.0, 6.0)},
                       .rules = newestSurfaceRules}});
    counts.step("writing a surface back", WriteBack{.rules = newestSurfaceRules});
}

void WorkOfLabelsGlTest::prepare(CountedSession& counts)
{
    counts.prepare(test::newSegment(QStringLiteral("A")));
}

void WorkOfLabelsGlTest::takeSteps(CountedSession& counts, int round)
{
    fill(counts, Ball::middle + glm::dvec3(9.0 - 18.0 * round, 0.0, 4.0));
    threshold(counts);
    workOnAll(counts);
    refine(counts);
}

test::MoreWork WorkOfLabelsGlTest::allowed(const QByteArray& step) const
{
    // Lists of bricks, among which those are found that are concerned.
    const QByteArrayList listing{"segment scissors", "scissors that erase", "drag of a threshold"};
    const QByteArrayList all{"margin", "smoothing by a ball", "smoothing by a Gaussian",
        "smaller margin", "islands", "contour", "laying a surface", "writing a surface back"};
    return all.contains(step) ? onAll(1) : test::MoreWork{.tables = listing.contains(step)};
}

BURIN_TEST(WorkOfLabelsGlTest)

} // namespace workOfLabelsGlTest

#include "WorkOfLabelsGlTest.moc"
