// SPDX-License-Identifier: Apache-2.0
#include "core/edits/EditTask.h"
#include "core/edits/EditJson.h"
#include "core/edits/document/DocumentEdits.h"
#include "core/edits/kinds/AnyEdit.h"
#include "core/edits/kinds/GrowthKinds.h"
#include "core/edits/kinds/SurfaceEdit.h"
#include "core/engine/EngineEdit.h"
#include "tests/support/program/TestProgram.h"

#include <QTest>

namespace editTaskTest {

using namespace core;

namespace {

bool adds(const EditEffects& effects)
{
    return effects.fills.added != AddedSegments::None;
}

template <class E> void checkKind()
{
    const Edit edit = E();
    const EditEffects effects = effectsOf(edit);
    const QByteArray name = editName(edit).toUtf8();
    QVERIFY2((effects.task == EditTask::Engine) == hasEngineEdit<E>, name.constData());
    QVERIFY2((effects.task == EditTask::Surface) == isSurfaceKind<E>, name.constData());
    QVERIFY2(!effects.movesGenerationOf || isGrowthKind<E>, name.constData());
    if (effects.onlyDocument)
        QVERIFY2(effects.changes && effects.task != EditTask::Engine, name.constData());
    if (effects.task == EditTask::Document)
        QVERIFY2(effects.onlyDocument && !effects.standsOpen, name.constData());
    if (effects.writesTo)
        QVERIFY2(effects.fills.label || adds(effects), name.constData());
    if (effects.takesVoxelsOrNothing)
        QVERIFY2(effects.task != EditTask::Document && adds(effects), name.constData());
}

template <class... Es> void checkKinds(EditKinds<Es...>)
{
    (checkKind<Es>(), ...);
}

} // namespace

/// What edits say of themselves fits together; that they say it at all, the compiler sees to.
class EditTaskTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void effectsFitTogether() { checkKinds(AllEdits()); }

    void growthsAndTheirCutsMoveTheGeneration()
    {
        for (const Edit& edit : {Edit(GrowSteps()), Edit(ChangeInterval()), Edit(ResumeGrowth()),
                 Edit(ShrinkSteps()), Edit(ShrinkAt()), Edit(PlugLeak())})
            QVERIFY2(effectsOf(edit).movesGenerationOf == 0, qPrintable(editName(edit)));
        GrowCriteria further;
        further.plane = 2;
        for (const Edit& edit :
            {Edit(GrowSteps{.criteria = further}), Edit(ChangeInterval{.criteria = further}),
                Edit(ResumeGrowth{.plane = 2}), Edit(ShrinkSteps{.plane = 2}),
                Edit(ShrinkAt{.plane = 2}), Edit(PlugLeak{.plane = 2})})
            QVERIFY2(effectsOf(edit).movesGenerationOf == 2, qPrintable(editName(edit)));
        for (const Edit& edit :
            {Edit(SeedStroke()), Edit(BarrierStroke()), Edit(GrowFromSeeds()), Edit(PaintStroke())})
            QVERIFY2(!effectsOf(edit).movesGenerationOf, qPrintable(editName(edit)));
    }

    /// Whoever may have its first voxels from an edit is told, so that a code is asked for in time.
    void whoReceivesVoxelsIsTold()
    {
        CombineSegments both{.segment = 1, .with = 2};
        QVERIFY(effectsOf(both).fills.label == 1 && !effectsOf(both).fills.other);
        both.how = CombineSegments::How::Swap;
        QVERIFY(effectsOf(both).fills.label == 1 && effectsOf(both).fills.other == 2);
        FillOutline outline{.segment = 4};
        QVERIFY(effectsOf(outline).fills.label == 4 && effectsOf(outline).writesTo == 4);
        outline.erase = true;
        QVERIFY(!effectsOf(outline).fills.label && effectsOf(outline).writesTo == 4);
        QVERIFY(effectsOf(outline).boundToStudy);
        CleanSegment clean{.segment = 1};
        QVERIFY(effectsOf(clean).fills.label == 1 && !effectsOf(clean).boundToStudy);
        clean.islandLps = glm::dvec3(0.0);
        clean.to = 3;
        QVERIFY(effectsOf(clean).fills.label == 3 && effectsOf(clean).writesTo == 1);
        QVERIFY(effectsOf(clean).boundToStudy); // it names a place
        const ReshapeSegment reshape{.segment = 2, .mm = 1.0};
        QVERIFY(effectsOf(reshape).fills.label == 2 && effectsOf(reshape).writesTo == 2);
        QVERIFY(!effectsOf(reshape).boundToStudy);
        FloodFill flood{.segment = 5};
        QVERIFY(effectsOf(flood).fills.label == 5 && effectsOf(flood).writesTo == 5);
        QVERIFY(effectsOf(flood).boundToStudy); // it names a place
        flood.erase = true;
        QVERIFY(!effectsOf(flood).fills.label && effectsOf(flood).writesTo == 5);
        MirrorSegment mirror{.segment = 2};
        QVERIFY(effectsOf(mirror).fills.label == 2 && effectsOf(mirror).writesTo == 2);
        QVERIFY(!effectsOf(mirror).boundToStudy);
        mirror.placeLps = glm::dvec3(0.0);
        QVERIFY(effectsOf(mirror).boundToStudy); // it names a place
        const FillBetweenSlices between{.segment = 3};
        QVERIFY(effectsOf(between).fills.label == 3 && effectsOf(between).writesTo == 3);
        QVERIFY(!effectsOf(between).boundToStudy);
        SegmentScissors scissors{.segment = 6};
        QVERIFY(effectsOf(scissors).fills.label == 6 && effectsOf(scissors).writesTo == 6);
        QVERIFY(effectsOf(scissors).boundToStudy); // it names places
        scissors.erase = true;
        QVERIFY(!effectsOf(scissors).fills.label && effectsOf(scissors).writesTo == 6);
        EvolveContour contour{.segment = 4};
        QVERIFY(effectsOf(contour).fills.label == 4 && effectsOf(contour).writesTo == 4);
        QVERIFY(!effectsOf(contour).boundToStudy);
        contour.bubbleLps = glm::dvec3(0.0);
        QVERIFY(effectsOf(contour).boundToStudy); // it names a place
        contour.erase = true;
        QVERIFY(!effectsOf(contour).fills.label && effectsOf(contour).writesTo == 4);
        SplitIslands islands{.segment = 3};
        QCOMPARE(effectsOf(islands).fills.added, AddedSegments::UnknownNumber);
        QVERIFY(effectsOf(islands).writesTo == 3 && !effectsOf(islands).boundToStudy);
        islands.into.emplace(2); // it names what it made of the islands of one study
        QCOMPARE(effectsOf(islands).fills.added, AddedSegments::Known);
        QVERIFY(effectsOf(islands).boundToStudy);
        const SplitSegment split{.segment = 3};
        QCOMPARE(effectsOf(split).fills.added, AddedSegments::Known);
        QVERIFY(effectsOf(split).writesTo == 3);
        QVERIFY(effectsOf(split).boundToStudy); // it names a place
        CopySegment copy{.segment = 3};
        QCOMPARE(effectsOf(copy).fills.added, AddedSegments::UnknownPlane);
        QVERIFY(!effectsOf(copy).writesTo && !effectsOf(copy).boundToStudy);
        copy.plane = 1;
        QCOMPARE(effectsOf(copy).fills.added, AddedSegments::Known);
        copy.editable.emplace().box = GrowBox{};
        QVERIFY(effectsOf(copy).boundToStudy); // it names places
        const SplitByCurve curve{.segment = 3};
        QCOMPARE(effectsOf(curve).fills.added, AddedSegments::Known);
        QVERIFY(effectsOf(curve).writesTo == 3);
        QVERIFY(effectsOf(curve).boundToStudy); // it names places
        ThresholdSegment threshold{.segment = 5};
        QVERIFY(effectsOf(threshold).fills.label == 5 && effectsOf(threshold).writesTo == 5);
        QVERIFY(!effectsOf(threshold).boundToStudy && effectsOf(threshold).standsOpen);
        threshold.mode = ThresholdSegment::Mode::Subtract;
        threshold.box = GrowBox{};
        QVERIFY(!effectsOf(threshold).fills.label && effectsOf(threshold).writesTo == 5);
        QVERIFY(effectsOf(threshold).boundToStudy); // it names places
    }
};

BURIN_TEST(EditTaskTest)

} // namespace editTaskTest

#include "EditTaskTest.moc"
