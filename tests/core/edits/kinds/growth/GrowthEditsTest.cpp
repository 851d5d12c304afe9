// SPDX-License-Identifier: Apache-2.0
#include "core/edits/EditJson.h"
#include "core/edits/document/DocumentEdits.h"
#include "core/edits/engine/EngineEdits.h"
#include "core/edits/kinds/growth/GrowSteps.h"
#include "core/edits/kinds/growth/PlugLeak.h"
#include "core/edits/kinds/growth/SeedStroke.h"
#include "core/edits/kinds/growth/ShrinkAt.h"
#include "core/edits/kinds/segments/ChangeSegment.h"
#include "core/recipe/Recipe.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/PlainEdits.h"
#include "tests/support/scenes/sessions/SmallDocument.h"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include <array>
#include <cstdint>

namespace growthEditsTest {

using namespace core;

class GrowthEditsTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void cutsNameVoxelsAndWhatIsLocked()
    {
        Document document = test::smallDocument();
        document.segments[1].locked = true;
        ShrinkAt shrink{.pointsLps = {{100 - 0.5 * 3, -50 + 0.5 * 4, 30 - 2.0 * 5}}};
        Result<CutGrowth> cut = cutGrowth(shrink, document);
        QVERIFY(cut);
        QVERIFY(cut->how == CutGrowth::How::Subtree && cut->barrier);
        QCOMPARE(cut->voxels.size(), std::size_t(1));
        QVERIFY(cut->voxels.front() == glm::ivec3(3, 4, 5));
        QVERIFY(cut->lockedLabels.count() == 1 && cut->lockedLabels[document.segments[1].label]);
        shrink.onlyHere = true;
        shrink.barrier = false;
        cut = cutGrowth(shrink, document);
        QVERIFY(cut && cut->how == CutGrowth::How::Here && !cut->barrier);
        shrink.steps = 7;
        QVERIFY(!cutGrowth(shrink, document)); // only here there are no steps
        shrink.onlyHere = false;
        cut = cutGrowth(shrink, document);
        QVERIFY(cut && cut->how == CutGrowth::How::Backwards && cut->steps == 7);
        const PlugLeak plug{.pointLps = shrink.pointsLps.front()};
        cut = cutGrowth(plug, document);
        QVERIFY(cut && cut->how == CutGrowth::How::Neck && cut->barrier);

        shrink.pointsLps.push_back({1000, 0, 0});
        cut = cutGrowth(shrink, document);
        QVERIFY(!cut && cut.error().code == ErrorCode::InvalidField);
        QCOMPARE(cut.error().arguments.front(), QStringLiteral("shrinkAt.pointsLps"));
        for (Segment& segment : document.segments)
            segment.locked = true;
        cut = cutGrowth(plug, document);
        QVERIFY(!cut && cut.error().code == ErrorCode::SegmentLocked);
    }
    /// Without a list all grow that are not locked, as before; with one all others rest.
    void aGrowthNamesWhoGrows()
    {
        Document document = test::smallDocument();
        GrowSteps grow{.criteria = {.lower = 0.0, .upper = 10.0, .overwriteUnlocked = true}};
        Result<GrowBurst> burst = growBurst(grow, document);
        QVERIFY(burst && burst->lockedLabels.none());
        QVERIFY(!editToJson(grow).contains(QStringLiteral("segments")));
        const int label = document.segments[1].label;
        grow.criteria.segments = std::vector<int>{label};
        burst = growBurst(grow, document);
        QVERIFY(burst);
        QVERIFY(!burst->lockedLabels.test(std::size_t(label)));
        QVERIFY(burst->lockedLabels.test(document.segments[0].label));
        QVERIFY(burst->overwritable.test(document.segments[0].label));
        const Result<Edit> read = editFromJson(editToJson(grow));
        QVERIFY(read && read->get<GrowSteps>().criteria == grow.criteria);

        document.segments[1].locked = true;
        burst = growBurst(grow, document);
        QVERIFY(!burst && burst.error().code == ErrorCode::SegmentLocked);
        grow.criteria.segments = std::vector<int>{250};
        burst = growBurst(grow, document);
        QVERIFY(!burst && burst.error().code == ErrorCode::UnknownSegment);
    }
    void guardsAreWholeNumbers()
    {
        GrowSteps grow{.criteria = {.lower = 0.0, .upper = 10.0}, .guard = {.factor = 1.5}};
        grow.guard.voxels = 7; // as recipes of before have it
        Result<GrowBurst> burst = growBurst(grow, test::smallDocument());
        QVERIFY(burst && burst->guard);
        QCOMPARE(burst->guard->factor256, 384);
        QCOMPARE(burst->guard->excess, std::int64_t(7));
        QCOMPARE(burst->guard->window, std::int64_t(20));
        QVERIFY(!burst->guard->measure);

        grow.guard.voxels.reset();
        grow.guard.areaMm2 = 12.5;
        grow.guard.backMm = 7.25;
        burst = growBurst(grow, test::smallDocument());
        QVERIFY(burst && burst->guard && burst->guard->measure);
        QCOMPARE(burst->guard->excess, std::int64_t(12500000));
        QCOMPARE(burst->guard->window, std::int64_t(7250));
        // Voxels of 0.5 × 0.5 × 2 mm: one across x and y 1 mm², across z 0.25 mm².
        const std::array<std::int64_t, 8>& areas = burst->guard->measure->areaUm2;
        QCOMPARE(areas[1], std::int64_t(1000000));
        QCOMPARE(areas[2], std::int64_t(1000000));
        QCOMPARE(areas[4], std::int64_t(250000));
        QCOMPARE(areas[0], std::int64_t(250000));
        QCOMPARE(areas[3], std::int64_t(1414213)); // √2
        QCOMPARE(areas[7], std::int64_t(1436140));
        QCOMPARE(burst->guard->measure->volumeUm3, std::int64_t(500000000));
        grow.guard.factor.reset();
        QVERIFY(!growBurst(grow, test::smallDocument())->guard);
    }
    void seedsLandOnTheNearestVoxelOnce()
    {
        const Document document = test::smallDocument();
        const SeedStroke stroke{.segment = 2,
            .pointsLps = {{100 - 0.5 * 3, -50 + 0.5 * 4, 30 - 2.0 * 5},
                {100 - 0.5 * 3 + 0.2, -50 + 0.5 * 4 - 0.2, 30 - 2.0 * 5 + 0.9}, {100, -50, 30},
                {100 + 0.24, -50 - 0.24, 30 + 0.99}}};
        const Result<SeedPlacement> placement = seedPlacement(stroke, document);
        QVERIFY(placement);
        QCOMPARE(int(placement->label), 2);
        QCOMPARE(placement->voxels.size(), std::size_t(2));
        QVERIFY(placement->voxels[0] == glm::ivec3(0, 0, 0));
        QVERIFY(placement->voxels[1] == glm::ivec3(3, 4, 5));
    }

    /// A recipe may take seeds away, put others in their place, or only do the former.
    void aRecipeTakesSeedsAway()
    {
        const QTemporaryDir folder;
        QFile file(folder.filePath(QStringLiteral("taken.json")));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(R"({"edits": [
            {"edit": "seed", "segment": 2, "pointsLps": [[98.5, -48.0, 20.0]]},
            {"edit": "seed", "segment": 2, "pointsLps": [[98.5, -48.0, 18.0]],
             "takenLps": [[98.5, -48.0, 20.0]]},
            {"edit": "seed", "segment": 2, "pointsLps": [], "takenLps": [[98.5, -48.0, 18.0]]},
            {"edit": "seed", "segment": 2, "pointsLps": []}]})");
        file.close();
        const Result<Recipe> recipe = readRecipe(file.fileName());
        QVERIFY2(recipe, recipe ? "" : qPrintable(recipe.error().arguments.join(u'\n')));
        QCOMPARE(recipe->steps.size(), std::size_t(4));
        const Document document = test::smallDocument();
        std::vector<Result<SeedPlacement>> placements;
        for (const RecipeStep& step : recipe->steps)
            placements.push_back(seedPlacement(std::get<Edit>(step).get<SeedStroke>(), document));
        const glm::ivec3 first(3, 4, 5);
        const glm::ivec3 second(3, 4, 6);
        QVERIFY(placements[0] && placements[1] && placements[2]);
        QVERIFY(placements[0]->voxels == std::vector{first} && placements[0]->taken.empty());
        QVERIFY(placements[1]->voxels == std::vector{second});
        QVERIFY(placements[1]->taken == std::vector{first});
        QVERIFY(placements[2]->voxels.empty() && placements[2]->taken == std::vector{second});
        QVERIFY(!placements[3]); // neither
        // What is told again is the same.
        for (const RecipeStep& step : recipe->steps) {
            const Edit& edit = std::get<Edit>(step);
            const Result<Edit> again = editFromJson(editToJson(edit));
            QVERIFY(again);
            QCOMPARE(editToJson(*again), editToJson(edit));
        }
    }

    void seedsOutsideAreRefusedWithTheirPoint()
    {
        const Document document = test::smallDocument();
        for (const glm::dvec3& point : {glm::dvec3(100.26, -50, 30), glm::dvec3(100, -50, 31.1),
                 glm::dvec3(100 - 0.5 * 19.6, -50, 30)}) {
            const Result<SeedPlacement> placement =
                seedPlacement({.segment = 1, .pointsLps = {{100, -50, 30}, point}}, document);
            QVERIFY(!placement);
            QCOMPARE(placement.error().code, ErrorCode::SeedOutsideVolume);
            QVERIFY(placement.error().arguments.value(0).contains(QString::number(point.x)));
        }
    }

    void seedsNeedTheirSegment()
    {
        Document document = test::smallDocument();
        const SeedStroke stroke{.segment = 9, .pointsLps = {{100, -50, 30}}};
        QCOMPARE(seedPlacement(stroke, document).error().code, ErrorCode::UnknownSegment);
        document.segment(1)->locked = true;
        const auto placement =
            seedPlacement({.segment = 1, .pointsLps = {{100, -50, 30}}}, document);
        QCOMPARE(placement.error().code, ErrorCode::SegmentLocked);
        QCOMPARE(placement.error().arguments.value(0), document.segment(1)->name);
    }

    void aGrowthNeedsOneSegmentThatIsNotLocked()
    {
        Document document = test::smallDocument();
        for (Segment& segment : document.segments)
            segment.locked = true;
        const Result<GrowBurst> refused =
            growBurst(GrowSteps{.criteria = {.lower = 0, .upper = 1}}, document);
        QVERIFY(!refused);
        QCOMPARE(refused.error().code, ErrorCode::SegmentLocked);
        document.segments.back().locked = false;
        QVERIFY(growBurst(GrowSteps{.criteria = {.lower = 0, .upper = 1}}, document));
    }

    void boundsAreInclusive()
    {
        const Document document = test::smallDocument();
        const Result<GrowBurst> burst =
            growBurst(GrowSteps{.criteria = {.lower = -1023.75, .upper = -1023.0}}, document);
        QVERIFY(burst);
        QCOMPARE(burst->lowCode, 1);
        QCOMPARE(burst->highCode, 4);
        const Result<GrowBurst> between =
            growBurst(GrowSteps{.criteria = {.lower = -1023.7, .upper = -1023.1}}, document);
        QCOMPARE(between->lowCode, 2);
        QCOMPARE(between->highCode, 3);
    }

    void overwritingSparesLockedSegments()
    {
        Document document = test::smallDocument();
        document.segment(2)->locked = true;
        document.growths.front().generation = 17;
        QVERIFY(growBurst(GrowSteps{.criteria = {.lower = 0, .upper = 1}}, document)
                    ->overwritable.none());
        const Result<GrowBurst> burst = growBurst(
            GrowSteps{.criteria = {.lower = 0, .upper = 1, .overwriteUnlocked = true}}, document);
        QVERIFY(burst->overwritable.test(1) && burst->overwritable.test(3));
        QVERIFY(!burst->overwritable.test(2) && !burst->overwritable.test(0));
        QCOMPARE(burst->generation, 17u);
    }

    void boundsMustNotCross()
    {
        const Result<GrowBurst> burst =
            growBurst(GrowSteps{.criteria = {.lower = 2, .upper = 1}}, test::smallDocument());
        QVERIFY(!burst);
        QCOMPARE(burst.error().code, ErrorCode::InvalidField);
        QVERIFY(!growBurst(GrowSteps{.criteria = {.lower = 0, .upper = 1, .connectivity = 14}},
            test::smallDocument()));
    }

    void segmentsAreNumberedInOrder()
    {
        Document document = initialDocument({});
        for (int label = 1; label <= 255; ++label) {
            QVERIFY(applyToDocument(test::newSegment(QStringLiteral("S")), document));
            QCOMPARE(int(document.segments.back().label), label);
        }
        const Result<bool> tooMany =
            applyToDocument(test::newSegment(QStringLiteral("S")), document);
        QVERIFY(!tooMany);
        QCOMPARE(document.segments.size(), std::size_t(255));
    }

    void changingSaysWhetherAnythingChanged()
    {
        Document document = test::smallDocument();
        const ChangeSegment rename{.segment = 2, .name = QStringLiteral("Bone"), .rgb = 0x112233};
        QVERIFY(*applyToDocument(rename, document));
        QCOMPARE(document.segment(2)->name, QStringLiteral("Bone"));
        QCOMPARE(document.segment(2)->rgb, 0x112233u);
        QVERIFY(!*applyToDocument(rename, document));
        QCOMPARE(applyToDocument(ChangeSegment{.segment = 8}, document).error().code,
            ErrorCode::UnknownSegment);
    }

    void theHashedStateKnowsNoDisplayState()
    {
        Document document = test::smallDocument();
        const QJsonObject before = document.hashedState();
        document.segment(1)->visible = false;
        document.segment(1)->voxels = 12;
        QCOMPARE(document.hashedState(), before);
        document.segment(1)->name = QStringLiteral("T");
        QVERIFY(document.hashedState() != before);
    }
};

BURIN_TEST(GrowthEditsTest)

} // namespace growthEditsTest

#include "GrowthEditsTest.moc"
