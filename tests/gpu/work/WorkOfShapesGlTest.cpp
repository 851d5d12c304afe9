// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/segments/CleanSegment.h"
#include "core/edits/kinds/segments/ReshapeSegment.h"
#include "core/edits/kinds/surface/ApplyTemplate.h"
#include "core/edits/kinds/surface/AttractSurface.h"
#include "core/edits/kinds/surface/DropSurface.h"
#include "core/edits/kinds/surface/LaySurface.h"
#include "core/edits/kinds/surface/MarkSurface.h"
#include "core/edits/kinds/surface/PlaneScrape.h"
#include "core/edits/kinds/surface/PointDrag.h"
#include "core/edits/kinds/surface/SmoothSurface.h"
#include "core/session/EditSession.h"
#include "tests/support/fixtures/WorkTest.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/GradedBall.h"
#include "tests/support/scenes/PlainEdits.h"

#include <QtTest>

#include <vector>

namespace workOfShapesGlTest {

using namespace core;
using test::CountedSession;
using Ball = test::GradedBall;

namespace {

constexpr int organ = 1;
constexpr int other = 2;
constexpr double surfaceMm = 22.0; ///< radius of what is refined; values end at Ball::radius

SurfacePath along(std::vector<glm::dvec3> pointsLps)
{
    return {.radiusMm = 6.0, .pointsLps = std::move(pointsLps), .rules = newestSurfaceRules};
}

/// How a lobe ought to run that stands out 5 mm, in the plane of x and a direction.
std::vector<glm::dvec3> lobeAlong(const glm::dvec3& direction)
{
    std::vector<glm::dvec3> line;
    for (int i = -8; i <= 8; ++i) {
        const double aside = 0.75 * i;
        line.push_back(
            Ball::at(surfaceMm + 5.0 - 0.14 * aside * aside, 0.0, 0.0) + aside * direction);
    }
    return line;
}

} // namespace

/// What it costs to clean a segment up, to give it another shape and to refine its surface with
/// each of the tools, counted as by WorkOfStepsGlTest. Margins, smoothing, laying and writing back
/// are in WorkOfLabelsGlTest.
class WorkOfShapesGlTest : public test::WorkTest {
    Q_OBJECT

public:
    WorkOfShapesGlTest()
        : WorkTest(QStringLiteral("shapes"))
    {
    }

private:
    void prepare(CountedSession& counts) override;
    void takeSteps(CountedSession& counts, int round) override;
    [[nodiscard]] test::MoreWork allowed(const QByteArray& step) const override;
    void refine(CountedSession& counts);
    void cleanUp(CountedSession& counts);
    void reshape(CountedSession& counts);
};

void WorkOfShapesGlTest::refine(CountedSession& counts)
{
    counts.prepare(test::thresholdOf(organ, Ball::valueAt(surfaceMm)));
    counts.prepare(LaySurface{.segment = organ, .vertices = 800, .rules = newestSurfaceRules});
    counts.step("scrape",
        PlaneScrape{.path = along(
                        {Ball::at(0.0, 0.0, surfaceMm - 1.0), Ball::at(4.0, 0.0, surfaceMm - 1.0)}),
            .normalLps = {0.0, 0.0, 1.0}});
    counts.step("drag of a point",
        PointDrag{along({Ball::at(0.0, surfaceMm, 0.0), Ball::at(0.0, surfaceMm + 4.0, 0.0)})});
    counts.step("smoothing of the surface",
        SmoothSurface{
            along({Ball::at(0.0, surfaceMm + 2.0, 0.0), Ball::at(2.0, surfaceMm + 1.0, 0.0)})});
    counts.step("attraction",
        AttractSurface{along({Ball::at(0.0, -surfaceMm, 0.0), Ball::at(3.0, -surfaceMm, 0.0)})});
    counts.prepare(
        MarkSurface{.mark = SurfaceMark::Red, .path = along({Ball::at(surfaceMm, 0.0, 0.0)})});
    counts.step("template",
        ApplyTemplate{.contoursLps = {lobeAlong({0.0, 1.0, 0.0}), lobeAlong({0.0, 0.0, 1.0})},
            .rules = newestSurfaceRules});
    counts.prepare(DropSurface{});
}

/// A ball with a hole, and a speck beside it.
void WorkOfShapesGlTest::cleanUp(CountedSession& counts)
{
    counts.prepare(test::thresholdOf(organ, Ball::valueAt(12.0)));
    counts.prepare(test::eraseAt(organ, {Ball::at(0.0, 0.0, -5.0)}, 2.5));
    counts.step("filling holes", CleanSegment{.segment = organ, .rule = IslandRule::FillHoles});
    counts.prepare(test::paintAt(organ, {Ball::at(0.0, 0.0, 18.0)}, 1.5));
    counts.step("removing small islands",
        CleanSegment{.segment = organ, .rule = IslandRule::RemoveSmall, .mm3 = 500.0});
}

/// What each operation is for is there before it: a spur, a cleft, a cavity that a narrow way leads
/// into, and a neighbour.
void WorkOfShapesGlTest::reshape(CountedSession& counts)
{
    const auto step = [&counts](const char* name, ShapeOperation operation, double mm) {
        counts.step(name, ReshapeSegment{.segment = organ, .operation = operation, .mm = mm});
    };
    const std::vector<glm::dvec3> wayIn{Ball::at(14.0, 0.0, 0.0), Ball::at(4.0, 0.0, 0.0)};
    counts.prepare(test::paintAt(organ, {Ball::at(0.0, 0.0, 13.5)}, 2.0));
    step("opening", ShapeOperation::Open, 4.0);
    counts.prepare(test::eraseAt(organ, wayIn, 1.5));
    step("closing", ShapeOperation::Close, 3.0);
    counts.prepare(test::eraseAt(organ, wayIn, 1.5));
    counts.prepare(test::eraseAt(organ, {Ball::middle}, 4.0));
    step("wrap", ShapeOperation::Wrap, 3.0);
    counts.prepare(test::paintOverAt(other, {Ball::at(0.0, 0.0, 10.0)}, 5.0));
    counts.step("joint smoothing",
        ReshapeSegment{.segment = organ,
            .operation = ShapeOperation::Gaussian,
            .mm = 1.5,
            .with = std::vector<int>{other}});
    step("hollow", ShapeOperation::Hollow, 3.0);
}

void WorkOfShapesGlTest::prepare(CountedSession& counts)
{
    for (const char* name : {"Organ", "Other"})
        counts.prepare(test::newSegment(QLatin1String(name)));
}

void WorkOfShapesGlTest::takeSteps(CountedSession& counts, int /*round*/)
{
    refine(counts);
    cleanUp(counts);
    reshape(counts);
}

test::MoreWork WorkOfShapesGlTest::allowed(const QByteArray& step) const
{
    // Tools of the surface know no volume.
    const QByteArrayList all{"filling holes", "removing small islands", "opening", "closing",
        "wrap", "joint smoothing", "hollow"};
    return all.contains(step) // the segment lies in two portions
        ? onAll(2)
        : test::MoreWork{.tables = step == "back through the history"};
}

BURIN_TEST(WorkOfShapesGlTest)

} // namespace workOfShapesGlTest

#include "WorkOfShapesGlTest.moc"
