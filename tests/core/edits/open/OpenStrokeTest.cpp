// SPDX-License-Identifier: Apache-2.0
#include "core/edits/open/OpenStroke.h"
#include "core/edits/EditJson.h"
#include "core/edits/EditQuantise.h"
#include "core/edits/EditTask.h"
#include "core/edits/document/DocumentEdits.h"
#include "core/edits/engine/EngineEdits.h"
#include "core/edits/kinds/AnyEdit.h"
#include "core/edits/kinds/sculpt/DrillPathSampler.h"
#include "core/edits/open/StrokeExtension.h"
#include "core/engine/EngineEdit.h"
#include "core/engine/EngineResult.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/SmallStudy.h"

#include <QtTest>

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <vector>

namespace openStrokeTest {

using namespace core;

// Who can stand open, and how, is known when the program is compiled.
static_assert(hasOpenStroke<DrillStroke> && hasOpenStroke<GrowSteps> && hasOpenStroke<ShrinkAt>);
static_assert(!hasOpenStroke<ScissorsCut> && !hasOpenStroke<SeedStroke>);
static_assert(isSurfaceTool<SpherePush> && !isSurfaceTool<BrushStroke>);
static_assert(!isSurfaceTool<ApplyTemplate> && hasOpenManner<ApplyTemplate>);
static_assert(!isSurfaceTool<LaySurface> && !hasOpenManner<LaySurface>);
static_assert(hasOpenManner<ReshapeSegment> && hasOpenManner<FillBetweenSlices>);
static_assert(hasOpenManner<SplitIslands> && hasOpenManner<SplitSegment>);
static_assert(!hasOpenManner<SplitByCurve> && !hasOpenManner<FloodFill>);

namespace {

Document documentWithSegment()
{
    Document document = initialDocument(test::smallStudy().volume);
    static_cast<void>(applyToDocument(test::addSegment("Brain"), document));
    return document;
}

template <class E> void checkKind()
{
    Edit edit = E();
    const QByteArray name = editName(edit).toUtf8();
    const bool isTold = openStrokeOf(edit) != nullptr;
    QVERIFY2(!isTold || taskOf(edit) == EditTask::Engine, name.constData());
    QVERIFY2(
        canStandOpen(edit) == (isTold || isSurfaceTool<E> || hasOpenManner<E>), name.constData());
    QVERIFY2(canStandOpen(edit) || !openMannerOf(edit).withoutPen, name.constData());
}

template <class... Es> void checkKinds(EditKinds<Es...>)
{
    (checkKind<Es>(), ...);
}

/// One of each that an open edit can be told.
const std::vector<StrokeExtension>& extensions()
{
    static const std::vector<StrokeExtension> all{PenSamples{.samples = {{.xMm = 1.0}}},
        PathPoints{.pointsLps = {{1.0, 2.0, 3.0}}}, ToDepth{3.0}, ToSteps{2},
        ToInterval{.lower = 1.0, .upper = 2.0}, GrowAdvance{.steps = 2}, PauseGrowth{},
        ForgetPreview{}};
    return all;
}

template <class... Extensions> std::vector<std::size_t> takes()
{
    return {StrokeExtension(Extensions()).index()...};
}

struct OpenCase {
    Edit edit;
    std::vector<std::size_t> takes; ///< indices in StrokeExtension
    OpenManner manner;
};

/// Every kind that can stand open while the engine carries it out.
std::vector<OpenCase> openCases()
{
    const OpenManner underPen;
    const OpenManner kept{.withoutPen = true, .usualEnding = Ending::Commit};
    const OpenManner preview{.withoutPen = true, .endsIfRefused = true};
    const OpenManner spread{.withoutPen = true, .endsIfRefused = true, .keepsForNext = true};
    return {{DrillStroke(), takes<PenSamples>(), underPen},
        {LaserStroke(), takes<PenSamples>(), underPen},
        {BrushStroke(), takes<PathPoints>(), underPen},
        {PaintStroke(), takes<PathPoints>(), underPen},
        {BarrierStroke(), takes<PathPoints>(), underPen}, {PeelCut(), takes<ToDepth>(), kept},
        {GrowSteps(), takes<GrowAdvance, PauseGrowth>(), kept},
        {ResumeGrowth(), takes<GrowAdvance, PauseGrowth>(), kept},
        {ChangeInterval(), takes<ToInterval, GrowAdvance, PauseGrowth>(), kept},
        {ShrinkSteps(), takes<ToSteps>(), kept}, {ShrinkAt{.steps = 1}, takes<ToSteps>(), kept},
        {GrowFromSeeds(), takes<ForgetPreview>(), spread}, {ThresholdSegment(), takes<>(), preview},
        {InvertSegment(), takes<>(), preview}, {CombineSegments(), takes<>(), preview}};
}

template <class... Es> std::size_t openKinds(EditKinds<Es...>)
{
    return (std::size_t(hasOpenStroke<Es>) + ...);
}

/// What it is told, which must not be refused.
OpenStroke::Told told(OpenStroke& stroke, const StrokeExtension& extension)
{
    static const Document document = documentWithSegment();
    Result<OpenStroke::Told> answer = stroke.extend(extension, document);
    if (!answer)
        throw std::runtime_error("refused");
    return *std::move(answer);
}

/// The whole of a path that was told in pieces.
std::vector<DrillSample> samplesOf(const std::vector<OpenStroke::Told>& pieces)
{
    std::vector<DrillSample> samples;
    for (const OpenStroke::Told& piece : pieces) {
        for (const EngineExtension& extension : piece) {
            const std::vector<DrillSample>& part = std::get<DrillPath>(extension).samples;
            samples.insert(samples.end(), part.begin(), part.end());
        }
    }
    return samples;
}

bool areSame(const std::vector<Capsule>& a, const std::vector<Capsule>& b)
{
    return std::equal(
        a.begin(), a.end(), b.begin(), b.end(), [](const Capsule& x, const Capsule& y) {
            return x.from == y.from && x.direction == y.direction && x.length == y.length
                && x.less == y.less && x.strength == y.strength;
        });
}

} // namespace

/// What an edit can be told while it stands open, and what the engine is told then.
class OpenStrokeTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    void whoStandsOpenSaysHow()
    {
        checkKinds(AllEdits());
        // Of a kind of which only some stand open.
        Edit whole = ShrinkAt(), open = ShrinkAt{.steps = 1};
        QVERIFY(!canStandOpen(whole) && !openStrokeOf(whole));
        QVERIFY(canStandOpen(open) && openStrokeOf(open));
        QVERIFY(openMannerOf(ApplyTemplate()).withoutPen);
        QVERIFY(!openMannerOf(SpherePush()).withoutPen);
        // What is worked out first is a preview as a threshold is.
        for (const Edit& edit : std::vector<Edit>{CleanSegment(), ReshapeSegment(),
                 FillBetweenSlices(), MirrorSegment(), SplitIslands(), SplitSegment()}) {
            const OpenManner manner = openMannerOf(edit);
            QVERIFY(manner.withoutPen && manner.endsIfRefused && !manner.keepsForNext);
            QVERIFY(manner.usualEnding == Ending::Rollback);
        }
        QCOMPARE(openCases().size(), openKinds(AllEdits()));
    }

    void mannersAreThoseOfTheKind()
    {
        for (OpenCase& open : openCases()) {
            const QByteArray name = editName(open.edit).toUtf8();
            const OpenManner manner = openStrokeOf(open.edit)->manner();
            QVERIFY2(manner.withoutPen == open.manner.withoutPen, name.constData());
            QVERIFY2(manner.usualEnding == open.manner.usualEnding, name.constData());
            QVERIFY2(manner.endsIfRefused == open.manner.endsIfRefused, name.constData());
            QVERIFY2(manner.keepsForNext == open.manner.keepsForNext, name.constData());
        }
    }

    /// Whatever applies changes the edit or is told to the engine; all else does neither.
    void whatDoesNotApplyIsIgnored()
    {
        QCOMPARE(extensions().size(), std::variant_size_v<StrokeExtensionVariant>);
        for (OpenCase& open : openCases()) {
            for (const StrokeExtension& extension : extensions()) {
                Edit edit = open.edit;
                const bool applies =
                    std::find(open.takes.begin(), open.takes.end(), extension.index())
                    != open.takes.end();
                const OpenStroke::Told answer = told(*openStrokeOf(edit), extension);
                const bool isChanged = editToJson(edit) != editToJson(open.edit);
                QVERIFY2((isChanged || !answer.empty()) == applies,
                    qPrintable(
                        QStringLiteral("%1, %2").arg(editName(edit)).arg(extension.index())));
            }
        }
    }

    void whatIsOutOfRangeIsRefused()
    {
        const double nan = std::numeric_limits<double>::quiet_NaN();
        const double infinite = std::numeric_limits<double>::infinity();
        for (const double mm : {-0.1, 60.1, nan, infinite})
            QVERIFY(!quantisedIfInRange(ToDepth{mm}));
        QVERIFY(!quantisedIfInRange(ToSteps{-1}));
        QVERIFY(quantisedIfInRange(ToSteps{0}));
        for (const ToInterval& interval :
            {ToInterval{2.0, 1.0}, ToInterval{nan, 1.0}, ToInterval{1.0, infinite}})
            QVERIFY(!quantisedIfInRange(interval));
        QVERIFY(quantisedIfInRange(ToInterval{1.0, 1.0}));
        QVERIFY(quantisedIfInRange(GrowAdvance{}) && quantisedIfInRange(PauseGrowth{}));
    }

    void numbersAreRoundedAsInEdits()
    {
        const auto depth = quantisedIfInRange(ToDepth{3.0 + 0.4 / 1024.0});
        QCOMPARE(std::get<ToDepth>(*depth).mm, 3.0);
        const PathPoints further{.pointsLps = {{0.3 / 1024.0, 1.0, 2.0}, {4.0, 5.0, 6.0}},
            .lifted = true,
            .pressures = {2.0, -1.0}};
        const auto rounded = quantisedIfInRange(further);
        const auto& path = std::get<PathPoints>(*rounded);
        QVERIFY(path.lifted && path.pointsLps == quantised(further.pointsLps));
        QVERIFY(path.pointsLps.front() == glm::dvec3(0.0, 1.0, 2.0));
        QVERIFY((path.pressures == std::vector<double>{1.0, 0.0}));
        const std::vector<PenSample> reported{{.xMm = 1.00001, .yMm = 2.0, .pressure = 0.3}};
        const auto pen = quantisedIfInRange(PenSamples{reported});
        QCOMPARE(std::get<PenSamples>(*pen).samples.front().xMm, quantised(reported).front().xMm);
    }

    /// However a path is told, the engine is told the same in the end.
    void pathOfPenInPieces()
    {
        const Document document = documentWithSegment();
        const DrillStroke whole = test::drillAt(0).get<DrillStroke>();
        const DrillCut cut = *drillCut(whole, document);
        const std::vector<DrillSample> path = drillPath(whole, cut);
        QVERIFY(path.size() > 2);
        const PenSamples first{{whole.samples.front()}}, second{{whole.samples.back()}};
        for (const int waiting : {0, 1, 2}) { // pieces that come before it begins
            Edit edit = whole;
            edit.get<DrillStroke>().samples.clear();
            const std::unique_ptr<OpenStroke> stroke = openStrokeOf(edit);
            QVERIFY(stroke->lift().empty());
            std::vector<OpenStroke::Told> pieces;
            if (waiting > 0)
                pieces.push_back(told(*stroke, first));
            if (waiting > 1)
                pieces.push_back(told(*stroke, second));
            QVERIFY(samplesOf(pieces).empty());
            pieces.push_back(stroke->begin(cut, document, false));
            if (waiting < 1)
                pieces.push_back(told(*stroke, first));
            if (waiting < 2)
                pieces.push_back(told(*stroke, second));
            pieces.push_back(stroke->lift());
            QVERIFY(samplesOf(pieces) == path);
            QCOMPARE(editToJson(edit), editToJson(whole));
        }
    }

    void pathOfBrushInPieces()
    {
        const Document document = documentWithSegment();
        const VolumeGeometry& geometry = document.volumes.front().geometry;
        const glm::dvec3 middle = test::pointsInBrain().front();
        BrushStroke stroke;
        stroke.path = {.radiusMm = 2.0, .pointsLps = {middle}};
        Edit edit = stroke;
        const std::unique_ptr<OpenStroke> open = openStrokeOf(edit);
        QVERIFY(told(*open, PathPoints{.pointsLps = {middle + glm::dvec3(3, 0, 0)}}).empty());
        std::vector<Capsule> pieces;
        const auto add = [&pieces](const OpenStroke::Told& answer) {
            QCOMPARE(answer.size(), std::size_t(1));
            const auto& part = std::get<CapsulePath>(answer.front());
            QVERIFY(part.under.empty()); // only a brush that follows edges has those
            pieces.insert(pieces.end(), part.capsules.begin(), part.capsules.end());
        };
        add(open->begin(*engineEditOf(edit, document), document, false));
        add(told(*open, PathPoints{.pointsLps = {middle + glm::dvec3(3, 4, 0)}}));
        add(told(*open,
            PathPoints{.pointsLps = {middle, middle + glm::dvec3(0, 2, 0)}, .lifted = true}));
        const BrushPath& path = edit.get<BrushStroke>().path;
        QCOMPARE(path.pointsLps.size(), std::size_t(5));
        QVERIFY(path.lifts == std::vector<std::int64_t>{3});
        QVERIFY(areSame(pieces, capsules(path, geometry)));
        QVERIFY(open->lift().empty());
    }

    void edgesNeedTheVoxelsUnderThePen()
    {
        const Document document = documentWithSegment();
        const VolumeGeometry& geometry = document.volumes.front().geometry;
        const glm::dvec3 middle = test::pointsInBrain().front();
        PaintStroke stroke{.segment = 1, .edgeTolerance = 50.0};
        stroke.path = {.radiusMm = 2.0, .pointsLps = {middle}};
        Edit edit = stroke;
        const std::unique_ptr<OpenStroke> open = openStrokeOf(edit);
        const OpenStroke::Told begun = open->begin(*engineEditOf(edit, document), document, false);
        QVERIFY(std::get<CapsulePath>(begun.front()).under == voxelsUnder(stroke.path, geometry));
        const glm::dvec3 end = middle + glm::dvec3(4, 0, 0);
        const OpenStroke::Told further = told(*open, PathPoints{.pointsLps = {end}});
        const std::vector<glm::ivec3>& under = std::get<CapsulePath>(further.front()).under;
        QVERIFY(!under.empty() && under == voxelsUnder(stroke.path, geometry, &middle, {end}));
    }

    void depthAndStepsReplaceTheEarlierOnes()
    {
        const Document document = documentWithSegment();
        Edit peel = PeelCut{.depthMm = 2.0};
        const std::unique_ptr<OpenStroke> open = openStrokeOf(peel);
        QVERIFY(told(*open, ToDepth{3.0}).empty()); // it begins with that
        const OpenStroke::Told begun = open->begin(ShellPeel(), document, false);
        QCOMPARE(std::get<PeelDepth>(begun.front()).depth, 3 * 65536);
        QVERIFY(told(*open, ToDepth{3.0}).empty()); // as it is
        const OpenStroke::Told less = told(*open, ToDepth{1.5});
        QCOMPARE(std::get<PeelDepth>(less.front()).depth, 3 * 32768);
        QCOMPARE(peel.get<PeelCut>().depthMm, 1.5);

        Edit shrink = ShrinkSteps{.steps = 1};
        const std::unique_ptr<OpenStroke> back = openStrokeOf(shrink);
        QVERIFY(told(*back, ToSteps{4}).empty());
        QVERIFY(back->begin(ShrinkGrowth{.generation = 5}, document, false).empty());
        for (const auto& [steps, keep] : {std::pair(2, 3U), std::pair(9, 0U), std::pair(0, 5U)}) {
            const OpenStroke::Told moved = told(*back, ToSteps{steps});
            QCOMPARE(std::get<ShrinkTo>(moved.front()).keep, keep);
            QCOMPARE(shrink.get<ShrinkSteps>().steps, std::optional(steps));
        }
    }

    void backwardsOnlyGoesOn()
    {
        Edit edit = ShrinkAt{.steps = 1};
        const std::unique_ptr<OpenStroke> open = openStrokeOf(edit);
        QVERIFY(open->begin(CutGrowth(), documentWithSegment(), false).empty());
        QVERIFY(told(*open, ToSteps{0}).empty());
        QCOMPARE(std::get<CutFurther>(told(*open, ToSteps{3}).front()).steps, 3U);
        QCOMPARE(edit.get<ShrinkAt>().steps, std::optional(1));
        EngineResult result;
        result.statistics.generations = 2;
        open->carriedOut(result, true);
        QCOMPARE(edit.get<ShrinkAt>().steps, std::optional(1));
        open->carriedOut(result, false); // there were no more to take
        QCOMPARE(edit.get<ShrinkAt>().steps, std::optional(2));
    }

    void wholeGrowthsAreToldTheirSteps()
    {
        const Document document = documentWithSegment();
        const auto begun = [&document](std::optional<int> steps, bool isWhole) {
            Edit edit = GrowSteps{.steps = steps};
            return openStrokeOf(edit)->begin(GrowBurst(), document, isWhole);
        };
        QCOMPARE(std::get<GrowAdvance>(begun(3, true).front()).steps, 3);
        QCOMPARE(std::get<GrowAdvance>(begun({}, true).front()).steps, GrowAdvance::toClosure);
        QVERIFY(begun(0, true).empty());
        QVERIFY(begun(3, false).empty() && begun({}, false).empty()); // whoever watches asks
    }

    void growthsSayHowFarTheyCame()
    {
        EngineResult result;
        result.generation = 7;
        result.statistics.generations = 4;
        const auto came = [&result](bool isWhole) {
            Edit edit = GrowSteps{.steps = 9};
            openStrokeOf(edit)->carriedOut(result, isWhole);
            return edit.get<GrowSteps>().steps;
        };
        QCOMPARE(came(true), std::optional(9)); // as it was asked for
        QCOMPARE(came(false), std::optional(4));
        result.alarm = LeakAlarm();
        QCOMPARE(came(true), std::optional(4)); // its guard has stopped it
        result.atClosure = true;
        QVERIFY(!came(false));
    }

    void changedIntervalsBeginAnew()
    {
        Document document = documentWithSegment();
        Edit edit = ChangeInterval{.criteria = {.lower = 0.0, .upper = 100.0}, .asBefore = false};
        const std::unique_ptr<OpenStroke> open = openStrokeOf(edit);
        const ToInterval narrower{.lower = 10.0, .upper = 90.0};
        QVERIFY(told(*open, narrower).empty()); // it begins with that
        QCOMPARE(edit.get<ChangeInterval>().criteria.lower, 10.0);
        QVERIFY(open->begin(*engineEditOf(edit, document), document, false).empty());
        const OpenStroke::Told anew = told(*open, ToInterval{.lower = 20.0, .upper = 80.0});
        const Result<GrowBurst> burst = growBurst(edit.get<ChangeInterval>(), document);
        QCOMPARE(std::get<GrowAnew>(anew.front()).burst.lowCode, burst->lowCode);
        QCOMPARE(std::get<GrowAnew>(anew.front()).burst.highCode, burst->highCode);
        QCOMPARE(burst->lowCode, 20 + 1024);
        // What the engine cannot be told is an error, and nothing is told.
        document.segments.front().locked = true;
        QVERIFY(!open->extend(narrower, document));
    }
};

BURIN_TEST(OpenStrokeTest)

} // namespace openStrokeTest

#include "OpenStrokeTest.moc"
