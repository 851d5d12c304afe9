// SPDX-License-Identifier: Apache-2.0
#include "tests/reference/ReferenceEngine.h"
#include "tests/support/cases/EngineCases.h"
#include "tests/support/cases/RandomEdits.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/program/TestProgram.h"

#include <QtTest>

#include <algorithm>
#include <map>

namespace referenceEngineTest {

using namespace core;
using reference::ReferenceEngine;
using test::Codes;
using test::lastResult;

class ReferenceEngineTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    void picksMeetTheSurface();
    void rollbackRestores();
    void swappingTwiceIsIdentity();
    void refusals();
    void casesAreWorthRunning();
};

void ReferenceEngineTest::picksMeetTheSurface()
{
    const glm::ivec3 size(16, 16, 16);
    Codes codes = test::slab(size, 2, 6, 15);
    codes.at({4, 4, 11}) = 3000;
    ReferenceEngine engine;
    QVERIFY(engine.openVolume(size, codes.values));
    const PickRay along{
        .origin = {4 << 16, 4 << 16, -(3 << 16)}, .step = {0, 0, 1 << 14}, .samples = 100};
    const PickRay beside{.origin = {40 << 16, 4 << 16, 0}, .step = {0, 0, 1 << 14}, .samples = 100};
    const std::vector<PickRay> rays{along, beside};
    engine.submit(PickVoxels{.rays = rays, .thresholdCode = 500});
    engine.submit(PickVoxels{.rays = rays, .seenBy = SeenBy::BrightestVoxel});
    // Codes below 768 are clear, the others shut out a little less than half of the light.
    std::vector<std::uint32_t> opacities(256, 0);
    std::fill(opacities.begin() + 3, opacities.end(), 30000u);
    engine.submit(PickVoxels{.rays = rays, .seenBy = SeenBy::Opacity, .opacityOfCode = opacities});
    const std::vector<EngineResult> results = engine.collect();
    QCOMPARE(results.size(), std::size_t(3));
    for (const EngineResult& result : results)
        QVERIFY(!result.picks[1]);
    // Half the code is reached at 5.5, whose nearest voxel is 6.
    QVERIFY(results[0].picks[0] == glm::ivec3(4, 4, 6));
    QVERIFY(results[1].picks[0] == glm::ivec3(4, 4, 11));
    // 0.75 · 1000 = 750 is still clear at 5.75, so the samples at 6 and 6.25 make it.
    QVERIFY(results[2].picks[0] == glm::ivec3(4, 4, 6));
}

void ReferenceEngineTest::rollbackRestores()
{
    test::Random random(5);
    for (int i = 0; i < 10; ++i) {
        const glm::ivec3 size(20, 17, 18);
        const Document document = test::randomDocument(size, random, false);
        ReferenceEngine engine;
        QVERIFY(engine.openVolume(size, test::balls(size, 4, random).values));
        const Edit stroke = test::randomDrill(document, random);
        const DrillCut cut = test::drillCutOf(stroke, document);
        const DrillPath path{test::drillSamplesOf(stroke, cut)};
        submitWhole(engine, cut, {path});
        submitWhole(engine, SeedPlacement{.label = 2, .voxels = {test::randomVoxel(random, size)}});
        const reference::DenseFields before = engine.fields();
        const std::vector<std::pair<EngineEdit, EngineExtension>> edits{
            {SeedPlacement{.label = 1, .voxels = {{1, 1, 1}}}, GrowPause{}},
            {GrowBurst{.lowCode = 0, .highCode = 65535}, GrowAdvance{}},
            {test::drillCutOf(test::randomDrill(document, random), document), path}};
        for (const auto& [edit, extension] : edits) {
            engine.submit(BeginEdit{edit});
            engine.submit(ExtendEdit{extension});
            engine.submit(EndEdit{Ending::Rollback});
            const EngineResult result = lastResult(engine);
            QVERIFY(!result.error);
            QVERIFY(result.changes.empty());
            QCOMPARE(result.statistics.voxelsChanged, std::int64_t(0));
            QCOMPARE(result.generation, 0u);
            QVERIFY(reference::DenseFields::changes(before, engine.fields()).empty());
        }
    }
}

void ReferenceEngineTest::swappingTwiceIsIdentity()
{
    for (const test::EngineCase& engineCase : test::drillCases(10)) {
        ReferenceEngine engine;
        const test::EngineOutcome outcome = test::runCase(engine, engineCase);
        QVERIFY2(outcome.failure.isEmpty(), qPrintable(outcome.failure));
        const reference::DenseFields before = engine.fields();
        SwapBricks swap;
        for (const BrickKey& key : before.occupiedBricks())
            swap.bricks.push_back({key, {}});
        engine.submit(swap);
        const EngineResult there = lastResult(engine);
        QVERIFY(engine.fields().occupiedBricks().empty());
        QCOMPARE(there.changes.size(), swap.bricks.size());
        SwapBricks back;
        for (const BrickChange& change : there.changes)
            back.bricks.push_back({change.key, change.before});
        engine.submit(back);
        QCOMPARE(lastResult(engine).changes.size(), swap.bricks.size());
        QVERIFY(reference::DenseFields::changes(before, engine.fields()).empty());
    }
}

void ReferenceEngineTest::refusals()
{
    // What each case is about fails, and what surrounds it does not suffer from it.
    const std::map<QByteArray, std::vector<int>> failing{{"extend without an edit", {0, 1, 2}},
        {"end without an edit", {0, 1, 4}}, {"begin twice", {1, 2}},
        {"begin twice, roll back", {1}},
        {"shrink to where nothing is open, or something else, or beyond", {0, 2, 5, 7}},
        {"cut further where nothing is open, or something else, or no step", {0, 2, 4, 5, 6, 7}},
        {"swap while an edit is open", {1}}, {"bricks that are not there", {0, 1, 2, 3}},
        {"images cut short", {0}}, {"voxels outside", {0, 1, 2, 3}}, {"label 0", {0, 1}},
        {"connectivity", {2, 3, 4}}, {"shrinking to more than there is", {0, 1}},
        {"extensions of another kind", {1, 4, 8}}, {"frames", {0, 1, 2, 3}}, {"opacities", {0}}};
    const std::vector<test::EngineCase> cases = test::refusalCases();
    QCOMPARE(cases.size(), failing.size());
    for (const test::EngineCase& engineCase : cases) {
        ReferenceEngine engine;
        const test::EngineOutcome outcome = test::runCase(engine, engineCase);
        QVERIFY2(outcome.failure.isEmpty(), qPrintable(outcome.failure));
        std::vector<int> failed;
        for (const EngineResult& result : outcome.results) {
            if (!result.error)
                continue;
            failed.push_back(int(result.ticket));
            // The last cut of that case is sound, but nothing has grown.
            const bool isEmptyCut = engineCase.name.startsWith("cut further") && result.ticket == 5;
            QCOMPARE(
                result.error->code, isEmptyCut ? ErrorCode::NothingGrown : ErrorCode::InvalidField);
            QVERIFY(result.changes.empty());
        }
        QVERIFY2(failed == failing.at(engineCase.name), engineCase.name.constData());
    }
    // Nothing was committed in the case that swaps while an edit is open but the seeds.
    ReferenceEngine engine;
    const auto swapping = std::find_if(cases.begin(), cases.end(),
        [](const test::EngineCase& one) { return one.name == "swap while an edit is open"; });
    QVERIFY(swapping != cases.end());
    (void)test::runCase(engine, *swapping);
    reference::DenseFields fields = engine.fields();
    QCOMPARE(std::count(fields.labels(0).values.begin(), fields.labels(0).values.end(), 0),
        std::ptrdiff_t(fields.labels(0).values.size()));
    ReferenceEngine small;
    const std::vector<std::uint16_t> codes(7);
    QVERIFY(!small.openVolume({2, 2, 2}, codes));
}

void ReferenceEngineTest::casesAreWorthRunning()
{
    // A suite whose random cases cut, grow and hit next to nothing would compare nothing.
    const auto share = [](const std::vector<test::EngineCase>& cases, auto worthy) {
        int count = 0;
        for (const test::EngineCase& engineCase : cases) {
            ReferenceEngine engine;
            count += worthy(test::runCase(engine, engineCase)) ? 1 : 0;
        }
        return double(count) / double(cases.size());
    };
    const auto changes = [](const test::EngineOutcome& outcome) {
        return std::any_of(outcome.results.begin(), outcome.results.end(),
            [](const EngineResult& result) { return result.statistics.voxelsChanged > 20; });
    };
    const auto hits = [](const test::EngineOutcome& outcome) {
        return std::any_of(
            outcome.results.begin(), outcome.results.end(), [](const EngineResult& result) {
                return std::any_of(result.picks.begin(), result.picks.end(),
                    [](const auto& pick) { return pick.has_value(); });
            });
    };
    const double growths = share(test::growthCases(40), changes);
    const double drills = share(test::drillCases(40), changes);
    const double picks = share(test::pickCases(20), hits);
    QVERIFY2(growths > 0.6, qPrintable(QString::number(growths)));
    QVERIFY2(drills > 0.5, qPrintable(QString::number(drills)));
    QVERIFY2(picks > 0.8, qPrintable(QString::number(picks)));
}

BURIN_TEST(ReferenceEngineTest)

} // namespace referenceEngineTest

#include "ReferenceEngineTest.moc"
