// SPDX-License-Identifier: Apache-2.0
#include "core/session/past/DrawnPlanes.h"

#include "core/edits/kinds/filling/FloodFill.h"
#include "core/edits/kinds/segments/FillOutline.h"
#include "core/edits/kinds/segments/PaintStroke.h"
#include "core/session/EditSession.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/PlainEdits.h"
#include "tests/support/scenes/SmallStudy.h"
#include "tests/support/scenes/sessions/SessionBench.h"

#include <QTest>

#include <cmath>
#include <vector>

namespace drawnPlanesTest {

using namespace core;

namespace {

using test::smallGrid;

glm::dvec3 lps(const glm::dvec3& voxel)
{
    return smallGrid().toWorld(voxel);
}

struct Bench : test::SessionBench {
    Bench()
        : SessionBench(false, test::smallStudy(), {})
    {
        run(test::addSegment("Organ"));
        run(test::addSegment("Other"));
    }
    [[nodiscard]] std::vector<DrawnPlane> planes(int segment = 1) const
    {
        return drawnPlanes(segment, session->history(), smallGrid());
    }
};

Edit discAt(int segment, int axis, const glm::dvec3& voxel)
{
    return test::paintDiscAt(segment, lps(voxel), smallGrid().direction()[axis], 3.0);
}

} // namespace

class DrawnPlanesTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    /// Of discs, outlines and floods in a slice, each slice once; not of balls, of what was erased,
    /// and of other segments.
    void strokesOnSlices()
    {
        Bench bench;
        QVERIFY(bench.planes().empty() && areAcrossOneAxis(bench.planes(), smallGrid()));
        bench.run(discAt(1, 2, {20.0, 18.0, 8.0}));
        bench.run(discAt(1, 2, {24.0, 18.0, 8.2}));
        bench.run(discAt(1, 2, {20.0, 18.0, 14.0}));
        QCOMPARE(bench.planes().size(), std::size_t(2));
        QVERIFY(areAcrossOneAxis(bench.planes(), smallGrid()));
        bench.run(discAt(2, 0, {20.0, 18.0, 8.0}));
        bench.run(test::paintAt(1, {lps({20.0, 18.0, 11.0})}, 2.0));
        Edit erased = discAt(1, 0, {20.0, 18.0, 8.0});
        erased.as<PaintStroke>()->erase = true;
        bench.run(erased);
        QCOMPARE(bench.planes().size(), std::size_t(2));
        QCOMPARE(bench.planes(2).size(), std::size_t(1));

        bench.run(FloodFill{.segment = 1,
            .placeLps = lps({10.0, 9.0, 9.0}),
            .within = SliceAxis::J,
            .tolerance = 5.0});
        QCOMPARE(bench.planes().size(), std::size_t(3));
        QVERIFY(std::abs(glm::dot(bench.planes()[2].normalLps, smallGrid().direction()[1])) > 0.99);
        QVERIFY(!areAcrossOneAxis(bench.planes(), smallGrid()));
        bench.run(FillOutline{.segment = 1,
            .originLps = lps({20.0, 18.0, 8.0}),
            .rightLps = {1.0, 1.0, 0.0},
            .upLps = {0.0, 0.0, 1.0},
            .polygonMm = {{-3.0, -3.0}, {3.0, -3.0}, {0.0, 4.0}}});
        QCOMPARE(bench.planes().size(), std::size_t(4));
        QVERIFY(std::abs(glm::dot(
                    glm::normalize(bench.planes()[3].normalLps), glm::dvec3(0.0, 0.0, 1.0)))
            < 0.01);
        bench.run(FloodFill{.segment = 1,
            .placeLps = lps({10.0, 9.0, 9.0}),
            .normalLps = glm::dvec3(1.0, 0.0, 1.0),
            .tolerance = 5.0});
        QCOMPARE(bench.planes().size(), std::size_t(5));
        QVERIFY(glm::dot(glm::normalize(bench.planes()[4].normalLps),
                    glm::normalize(glm::dvec3(1.0, 0.0, 1.0)))
            > 0.999);
    }

    /// What is undone or taken back was not drawn; one slice has nothing between it.
    void strokesThatStand()
    {
        Bench bench;
        bench.run(discAt(1, 2, {20.0, 18.0, 8.0}));
        bench.run(discAt(1, 1, {20.0, 18.0, 8.0}));
        QVERIFY(!areAcrossOneAxis(bench.planes(), smallGrid()));
        QVERIFY(bench.session->undo() && bench.session->settle());
        QCOMPARE(bench.planes().size(), std::size_t(1));
        QVERIFY(bench.session->redo() && bench.session->settle());
        bench.run(test::revertRows({bench.session->history().position()}));
        QCOMPARE(bench.planes().size(), std::size_t(1));
        const DrawnPlane oblique{lps({20.0, 18.0, 8.0}), {1.0, 2.0, 2.0}};
        QVERIFY(areAcrossOneAxis({oblique}, smallGrid()));
        QVERIFY(!areAcrossOneAxis({oblique, oblique}, smallGrid()));
    }
};

BURIN_TEST(DrawnPlanesTest)

} // namespace drawnPlanesTest

#include "DrawnPlanesTest.moc"
