// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/imports/ImportMask.h"
#include "core/edits/kinds/layers/SegmentToLayer.h"
#include "core/edits/kinds/segments/LayerToSegment.h"
#include "core/edits/kinds/segments/RemoveSegment.h"
#include "core/edits/kinds/segments/SegmentSeen.h"
#include "core/edits/kinds/surface/DropSurface.h"
#include "core/edits/kinds/surface/FollowMask.h"
#include "core/edits/kinds/surface/LaySurface.h"
#include "core/edits/kinds/surface/SurfaceBarrier.h"
#include "core/session/EditSession.h"
#include "tests/support/cases/BoxedMasks.h"
#include "tests/support/fixtures/WorkTest.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/GradedBall.h"
#include "tests/support/scenes/PlainEdits.h"

#include <QtTest>

namespace workOfWholesGlTest {

using namespace core;
using test::CountedSession;
using Ball = test::GradedBall;

namespace {

constexpr int organ = 1;

} // namespace

/// What steps cost that concern all of a segment, of a layer, of a mask or of what is seen, counted
/// as by WorkOfStepsGlTest.
class WorkOfWholesGlTest : public test::WorkTest {
    Q_OBJECT

public:
    WorkOfWholesGlTest()
        : WorkTest(QStringLiteral("wholes"))
    {
    }

private:
    void prepare(CountedSession& counts) override;
    void takeSteps(CountedSession& counts, int round) override;
    [[nodiscard]] test::MoreWork allowed(const QByteArray& step) const override;
    static void followAndBar(CountedSession& counts);
    static void passBetween(CountedSession& counts);
    static void importMask(CountedSession& counts);
};

void WorkOfWholesGlTest::prepare(CountedSession& counts)
{
    counts.prepare(test::newSegment(QStringLiteral("Organ")));
    counts.prepare(test::paintAt(organ, {Ball::middle}, 12.0));
}

/// The mask has changed since the surface was laid.
void WorkOfWholesGlTest::followAndBar(CountedSession& counts)
{
    counts.prepare(LaySurface{.segment = organ, .vertices = 400, .rules = newestSurfaceRules});
    counts.prepare(test::paintAt(organ, {Ball::at(12.0, 0.0, 0.0)}, 4.0));
    counts.step("following a mask", FollowMask{.rules = newestSurfaceRules});
    counts.step("barriers along a surface", SurfaceBarrier{});
    counts.prepare(DropSurface{});
}

/// Between layers, what is seen, and segments.
void WorkOfWholesGlTest::passBetween(CountedSession& counts)
{
    counts.prepare(test::carveAt({Ball::at(0.0, 0.0, 16.0)}, 5.0));
    counts.step("layer to segment",
        LayerToSegment{.layer = 1, .target = {.name = QStringLiteral("Carved")}});
    counts.step("segment to layer", SegmentToLayer{.segment = organ, .layer = 1});
    counts.step("segment of what is seen",
        SegmentSeen{.target = {.name = QStringLiteral("Seen")}, .lower = Ball::valueAt(20.0)});
}

void WorkOfWholesGlTest::importMask(CountedSession& counts)
{
    EditSession& session = counts.session();
    const VoxelBox box{.minimum = glm::ivec3(72), .maximum = glm::ivec3(90)};
    counts.step("import of a mask",
        test::importOfBoxes({box}, session.document().volumes.front().geometry.size));
    counts.step(
        "removal of a segment", RemoveSegment{.segment = session.document().segments.back().label});
}

void WorkOfWholesGlTest::takeSteps(CountedSession& counts, int /*round*/)
{
    followAndBar(counts);
    passBetween(counts);
    importMask(counts);
}

test::MoreWork WorkOfWholesGlTest::allowed(const QByteArray& step) const
{
    if (step == "following a mask") // the segment lies in two portions
        return onAll(2);
    // Lists of bricks, among which those are found that are concerned.
    return test::MoreWork{.tables = true};
}

BURIN_TEST(WorkOfWholesGlTest)

} // namespace workOfWholesGlTest

#include "WorkOfWholesGlTest.moc"
