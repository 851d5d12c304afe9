// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/EditParts.h"
#include "core/edits/kinds/growth/BarrierStroke.h"
#include "core/edits/kinds/growth/ChangeInterval.h"
#include "core/edits/kinds/growth/GrowSteps.h"
#include "core/edits/kinds/growth/ResumeGrowth.h"
#include "core/edits/kinds/growth/ShrinkSteps.h"
#include "core/edits/kinds/sculpt/BrushStroke.h"
#include "core/edits/kinds/sculpt/DrillStroke.h"
#include "core/edits/kinds/sculpt/LaserStroke.h"
#include "core/edits/kinds/segments/PaintStroke.h"
#include "core/edits/kinds/surface/SpherePush.h"
#include "tests/support/program/TestProgram.h"

#include <QTest>

#include <utility>

namespace editPartsTest {

using namespace core;

/// What an edit holds is found in it, and nothing where it holds another thing by that name.
class EditPartsTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void strokesHoldWhatThePenTold()
    {
        Edit drill = DrillStroke{.samples = {{.xMm = 1.0}}};
        Edit laser = LaserStroke{.samples = {{.xMm = 2.0}}};
        QCOMPARE(penSamplesOf(drill), &drill.get<DrillStroke>().samples);
        QCOMPARE(penSamplesOf(laser), &laser.get<LaserStroke>().samples);
        Edit brush = BrushStroke();
        QVERIFY(!penSamplesOf(brush));
    }
    void brushesHoldTheirWay()
    {
        Edit paint = PaintStroke(), barrier = BarrierStroke(), carve = BrushStroke();
        QCOMPARE(brushPathOf(paint), &paint.get<PaintStroke>().path);
        QCOMPARE(brushPathOf(barrier), &barrier.get<BarrierStroke>().path);
        QCOMPARE(brushPathOf(carve), &carve.get<BrushStroke>().path);
        // The way of a tool of the surface is of another kind.
        Edit push = SpherePush(), drill = DrillStroke();
        QVERIFY(!brushPathOf(push) && !brushPathOf(drill));
    }
    void growthsSayWhatTheyGoBy()
    {
        Edit grow = GrowSteps{.steps = 3}, change = ChangeInterval();
        QCOMPARE(growCriteriaOf(grow), &std::as_const(grow).get<GrowSteps>().criteria);
        QCOMPARE(growGuardOf(change), &std::as_const(change).get<ChangeInterval>().guard);
        *growStepsOf(grow) = 4;
        QCOMPARE(grow.get<GrowSteps>().steps, std::optional(4));
        QVERIFY(!growStepsOf(std::as_const(change))->has_value());
    }
    void stepsAloneAreNoGrowth()
    {
        Edit shrink = ShrinkSteps{.steps = 3}, resume = ResumeGrowth{.steps = 3};
        QVERIFY(!growStepsOf(shrink) && !growCriteriaOf(shrink) && !growGuardOf(shrink));
        QVERIFY(!growStepsOf(resume) && !growCriteriaOf(resume));
    }
};

BURIN_TEST(EditPartsTest)

} // namespace editPartsTest

#include "EditPartsTest.moc"
