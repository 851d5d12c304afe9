// SPDX-License-Identifier: Apache-2.0
#include "core/document/Document.h"
#include "core/edits/engine/EngineEdits.h"
#include "core/edits/kinds/sculpt/BrushStroke.h"
#include "core/edits/kinds/sculpt/DrillPathSampler.h"
#include "core/edits/kinds/sculpt/LaserStroke.h"
#include "core/edits/kinds/sculpt/PeelCut.h"
#include "core/growth/SeedWord.h"
#include "tests/reference/DelayedEngine.h"
#include "tests/reference/ReferenceEngine.h"
#include "tests/reference/fields/Radiation.h"
#include "tests/support/cases/EngineCases.h"
#include "tests/support/cases/RandomEdits.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/fixtures/EditEngineFixture.h"
#include "tests/support/program/LongRun.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/CutEdits.h"

#include <QtTest>

#include <algorithm>
#include <map>

namespace engineConformanceGlTest {

using namespace core;
using reference::DelayedEngine;
using reference::ReferenceEngine;
using test::EngineCase;
using test::EngineOutcome;

/// Holds the GPU engine to the oracle: every result and the whole state at the end, byte for byte.
class EngineConformanceGlTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase();
    void init() { test::failOnUnexpectedMessages(); }
    void cleanup();

    void everyToolIsThere();
    void conforms_data();
    void conforms();
    void orderAndBatchesDoNotMatter_data();
    void orderAndBatchesDoNotMatter();
    void derivedTexturesFollow_data();
    void derivedTexturesFollow();
    void pausedGrowthIsGrowthOfSoManySteps_data();
    void pausedGrowthIsGrowthOfSoManySteps();
    void wakesWhenThereIsSomethingToCollect();
    void opensOneVolumeAfterTheOther();

private:
    [[nodiscard]] static const std::vector<EngineCase>& cases();

    test::EditEngineFixture m_gpu;
    EngineOutcome m_expected; ///< the oracle's, of the case m_expectedOf
    int m_expectedOf = -1;
};

void EngineConformanceGlTest::initTestCase()
{
    QVERIFY2(m_gpu.isReady(), m_gpu.why());
    qInfo("%s", m_gpu.rendererName().constData());
}

void EngineConformanceGlTest::cleanup()
{
    QCOMPARE(m_gpu.newErrors(), 0);
}

/// Made once: the long count has thousands.
const std::vector<EngineCase>& EngineConformanceGlTest::cases()
{
    static const std::vector<EngineCase> collected = [] {
        const bool all = test::longRun();
        std::vector<EngineCase> made = test::growthCases(all ? 400 : 20);
        for (auto more :
            {test::growLimitCases(all ? 400 : 16), test::seedGroupCases(all ? 400 : 16),
                test::intervalCases(all ? 300 : 12), test::backwardCases(all ? 300 : 16),
                test::overwrittenCases(all ? 400 : 24), test::wideGrowthCases(all ? 300 : 24),
                test::passageCases(all ? 300 : 8), test::drillCases(all ? 400 : 20),
                test::peelCases(all ? 640 : 20), test::scissorsCases(all ? 240 : 8),
                test::laserCases(all ? 520 : 20), test::carveCases(all ? 240 : 8),
                test::pickCases(all ? 150 : 8), test::eraseCases(all ? 300 : 12),
                test::layerCases(all ? 300 : 12), test::capsuleCases(all ? 400 : 20),
                test::layerWriteCases(all ? 400 : 20), test::relabelCases(all ? 400 : 20),
                test::outlineCases(all ? 400 : 20), test::thresholdCases(all ? 400 : 20),
                test::segmentScissorsCases(all ? 400 : 24), test::mapCases(all ? 400 : 20),
                test::editableCases(all ? 400 : 24), test::barrierCases(all ? 400 : 20),
                test::protectedCases(all ? 200 : 20), test::spreadCases(all ? 400 : 20),
                test::toleranceCases(all ? 300 : 16), test::refusalCases()})
            made.insert(made.end(), more.begin(), more.end());
        return made;
    }();
    return collected;
}

/// Issue 4 wants 200 random strokes of every tool, either way.
void EngineConformanceGlTest::everyToolIsThere()
{
    std::map<QByteArray, int> strokes;
    for (const EngineCase& each : cases()) {
        for (const test::EngineStep& step : each.steps) {
            const auto* command = std::get_if<EngineCommand>(&step);
            const auto* begin = command ? std::get_if<BeginEdit>(command) : nullptr;
            if (!begin)
                continue;
            const auto count = [&strokes](const char* tool, Laying laying) {
                ++strokes[QByteArray(tool) + (laying == Laying::Carve ? "" : ", restoring")];
            };
            if (const auto* drill = std::get_if<DrillCut>(&begin->edit))
                count("drill", drill->laying);
            else if (const auto* laser = std::get_if<LaserCut>(&begin->edit))
                count("laser", laser->laying);
            else if (const auto* peel = std::get_if<ShellPeel>(&begin->edit))
                count("peel", peel->laying);
            else if (const auto* scissors = std::get_if<OutlineCut>(&begin->edit))
                count("scissors", scissors->laying);
            else if (const auto* brush = std::get_if<CapsuleCut>(&begin->edit))
                count("carve brush", brush->restore ? Laying::Refill : Laying::Carve);
        }
    }
    for (const auto& [tool, count] : strokes)
        qInfo("%s: %d strokes", tool.constData(), count);
    QCOMPARE(strokes.size(), std::size_t(10));
    for (const auto& [tool, count] : strokes)
        QVERIFY2(count >= (test::longRun() ? 200 : 8), tool.constData());
}

void EngineConformanceGlTest::orderAndBatchesDoNotMatter_data()
{
    QTest::addColumn<QByteArray>("tool");
    for (const char* tool : {"drill", "drill by time", "laser", "laser by time", "peel", "brush"})
        QTest::addRow("%s", tool) << QByteArray(tool);
}

/// However a stroke's events come in batches and in whatever order; and those that count once may
/// be told twice (a second told twice is two seconds).
void EngineConformanceGlTest::orderAndBatchesDoNotMatter()
{
    QFETCH(QByteArray, tool);
    const int count = test::longRun() ? 200 : 6;
    qInfo("%d strokes", count);
    for (int number = 0; number < count; ++number) {
        test::Random random(std::uint32_t(51000 + number));
        const glm::ivec3 size{test::randomInt(random, 8, 30), test::randomInt(random, 8, 30),
            test::randomInt(random, 2, 30)};
        const Document document = test::randomDocument(size, random, false);
        const DrillMode mode = tool.endsWith("time") ? DrillMode::Rate : DrillMode::Limit;
        EngineEdit edit;
        std::vector<EngineExtension> path;
        if (tool.startsWith("drill")) {
            const Edit stroke =
                test::drillWith({.mode = mode}, test::randomDrill(document, random));
            const DrillCut cut = test::drillCutOf(stroke, document);
            for (const DrillSample& sample : test::drillSamplesOf(stroke, cut))
                path.push_back(DrillPath{{sample}});
            edit = cut;
        } else if (tool.startsWith("laser")) {
            LaserStroke stroke = test::randomLaser(document, random);
            stroke.mode = mode;
            const LaserCut cut = *laserCut(stroke, document);
            for (const DrillSample& sample : laserPath(stroke, cut))
                path.push_back(DrillPath{{sample}});
            edit = cut;
        } else if (tool == "peel") {
            const PeelCut cut = test::randomPeel(document, random);
            path.push_back(peelDepth(cut));
            edit = *shellPeel(cut, document);
        } else {
            const BrushStroke stroke = test::randomBrush(document, random);
            for (const Capsule& capsule : capsules(stroke.path, document.volumes.front().geometry))
                path.push_back(CapsulePath{{capsule}});
            edit = *capsuleCut(stroke, document);
        }
        EngineCase whole{tool, test::balls(size, 5, random), {}};
        test::appendWhole(whole.steps, edit, path);
        ReferenceEngine oracle;
        const EngineOutcome expected = test::runCase(oracle, whole);
        for (int round = 0; round < 3; ++round) {
            std::vector<EngineExtension> told = path;
            if (tool == "peel") { // what was said last counts
                for (int i = test::randomInt(random, 0, 3); i > 0; --i)
                    told.insert(told.begin(), PeelDepth{test::randomInt(random, 0, 1 << 20)});
                told.push_back(told.back());
            } else {
                for (std::size_t i = 0; mode == DrillMode::Limit && i < path.size(); i += 3)
                    told.push_back(path[i]);
                for (std::size_t i = told.size(); i > 1; --i)
                    std::swap(told[i - 1], told[random() % i]);
            }
            EngineCase shuffled{tool, whole.codes, {}};
            shuffled.steps.push_back(EngineCommand(BeginEdit{edit}));
            for (std::size_t i = 0; i < told.size(); ++i) {
                shuffled.steps.push_back(EngineCommand(ExtendEdit{told[i]}));
                // Else those that wait are taken together.
                if (random() % 4 == 0)
                    shuffled.steps.push_back(test::Settle{});
            }
            shuffled.steps.push_back(EngineCommand(EndEdit{Ending::Commit}));
            const EngineOutcome actual = test::runCase(m_gpu.engine(), shuffled);
            QVERIFY2(actual.failure.isEmpty(), qPrintable(actual.failure));
            EngineOutcome a;
            EngineOutcome b;
            a.state = expected.state;
            b.state = actual.state;
            const QString text = test::difference(a, b);
            QVERIFY2(
                text.isEmpty(), qPrintable(QStringLiteral("stroke %1: %2").arg(number).arg(text)));
        }
    }
}

void EngineConformanceGlTest::conforms_data()
{
    QTest::addColumn<int>("number");
    QTest::addColumn<bool>("delayed");
    int number = 0;
    for (const EngineCase& engineCase : cases()) {
        QTest::addRow("%s", engineCase.name.constData()) << number << false;
        if (test::longRun() || number % 2 == 0)
            QTest::addRow("%s, delayed", engineCase.name.constData()) << number << true;
        ++number;
    }
}

void EngineConformanceGlTest::conforms()
{
    QFETCH(int, number);
    QFETCH(bool, delayed);
    const EngineCase& engineCase = cases().at(std::size_t(number));

    // A case and its delayed twin stand side by side: the oracle carries it out once for both.
    if (m_expectedOf != number) {
        ReferenceEngine oracle;
        m_expected = test::runCase(oracle, engineCase);
        m_expectedOf = number;
    }
    const EngineOutcome& expected = m_expected;
    EngineOutcome actual;
    if (delayed) {
        DelayedEngine engine(m_gpu.engine(), std::uint32_t(number));
        actual = test::runCase(engine, engineCase);
    } else {
        actual = test::runCase(m_gpu.engine(), engineCase);
    }
    const QString text = test::difference(expected, actual);
    QVERIFY2(text.isEmpty(), qPrintable(text));
}

void EngineConformanceGlTest::derivedTexturesFollow_data()
{
    QTest::addColumn<int>("number");
    const int count = int(cases().size());
    for (int number = 0; number < count; number += test::longRun() ? 1 : 5)
        QTest::addRow("%s", cases().at(std::size_t(number)).name.constData()) << number;
}

/// What the renderers read is what the oracle derives from the same state.
void EngineConformanceGlTest::derivedTexturesFollow()
{
    QFETCH(int, number);
    const EngineCase& engineCase = cases().at(std::size_t(number));
    std::bitset<256> shown;
    shown.set(1).set(3).set(255);
    m_gpu.showSegments(shown);
    ReferenceEngine oracle;
    (void)test::runCase(oracle, engineCase);
    (void)test::runCase(m_gpu.engine(), engineCase);

    reference::DenseFields fields = oracle.fields();
    QVERIFY(m_gpu.read(gpu::VolumeField::Labels).values == fields.labels(0).values);
    QVERIFY(m_gpu.read(gpu::VolumeField::Radiation).values == oracle.carved().values);
    const BrickGrid grid{engineCase.codes.size};
    std::vector<std::uint8_t> shut(std::size_t(grid.brickCount()), 0);
    const auto& words = fields.seedWords(0);
    for (int z = 0; z < words.size.z; ++z)
        for (int y = 0; y < words.size.y; ++y)
            for (int x = 0; x < words.size.x; ++x)
                if (words.at({x, y, z}) == seedWord::barrier)
                    shut[std::size_t(grid.brickOf({x, y, z}))] = 1;
    QVERIFY(m_gpu.read(gpu::VolumeField::BarrierBricks).values == shut);
    reference::DenseArray<std::uint8_t> members = fields.labels(0);
    std::ranges::fill(members.values, std::uint8_t(0));
    for (const auto& [plane, labels] : fields.labelPlanes()) {
        QVERIFY(plane < core::mostLabelPlanes);
        for (std::size_t i = 0; i < members.values.size(); ++i) {
            if (shown.test(labels->values[i]))
                members.values[i] = 255;
        }
    }
    QVERIFY(
        m_gpu.read(gpu::VolumeField::Segmentation).values == reference::radiation(members).values);
}

void EngineConformanceGlTest::pausedGrowthIsGrowthOfSoManySteps_data()
{
    QTest::addColumn<double>("pace");
    QTest::addColumn<int>("generations");
    QTest::addRow("paused at once") << 0.0 << 0;
    QTest::addRow("paced, paused") << 200.0 << 6;
    QTest::addRow("unpaced, paused") << 0.0 << 2;
}

/// A pause depends on time; what it leaves is the growth of some number of steps, and which one the
/// result says.
void EngineConformanceGlTest::pausedGrowthIsGrowthOfSoManySteps()
{
    QFETCH(double, pace);
    QFETCH(int, generations);
    const test::Codes codes = test::spiralCorridor({33, 33, 9});
    const SeedPlacement seeds{.label = 5, .voxels = {{0, 0, 0}}};
    const GrowBurst burst{.lowCode = 1, .highCode = 65535};
    EditEngine& engine = m_gpu.engine();
    engine.finish();
    (void)engine.collect();
    QVERIFY(engine.openVolume(codes.size, codes.values));
    submitWhole(engine, seeds);
    engine.submit(BeginEdit{burst});
    engine.submit(ExtendEdit{GrowAdvance{GrowAdvance::toClosure, pace}});
    const auto hasGrown = [&] {
        return engine.growthProgress().frontSizes.size() >= std::size_t(generations);
    };
    QVERIFY(QTest::qWaitFor(hasGrown, 60000));
    engine.submit(ExtendEdit{GrowPause{}});
    engine.submit(EndEdit{Ending::Commit});
    engine.finish();
    const std::vector<EngineResult> results = engine.collect();
    QCOMPARE(results.size(), std::size_t(2));
    const EngineResult& paused = results.back();
    QVERIFY(!paused.error);
    QVERIFY(paused.generation >= 1);

    ReferenceEngine oracle;
    QVERIFY(oracle.openVolume(codes.size, codes.values));
    submitWhole(oracle, seeds);
    submitWhole(oracle, burst,
        {GrowAdvance{paused.atClosure ? GrowAdvance::toClosure : int(paused.generation) - 1}});
    const EngineResult expected = oracle.collect().back();
    EngineOutcome a;
    EngineOutcome b;
    a.results.push_back(expected);
    b.results.push_back(paused);
    b.results.back().ticket = expected.ticket;
    const QString text = test::difference(a, b);
    QVERIFY2(text.isEmpty(), qPrintable(text));
}

void EngineConformanceGlTest::wakesWhenThereIsSomethingToCollect()
{
    EditEngine& engine = m_gpu.engine();
    std::atomic<int> calls = 0;
    engine.setWakeUp([&calls] { ++calls; });
    QVERIFY(engine.openVolume({4, 4, 4}, test::constantVolume({4, 4, 4}, 9).values));
    engine.submit(ProbeVoxels{{{1, 2, 3}}});
    std::vector<EngineResult> results;
    for (int seen = 0; results.empty();) {
        QTRY_VERIFY(calls > seen);
        seen = calls;
        results = engine.collect();
    }
    QCOMPARE(results.front().probes.front().code, 9);
    engine.finish();
    engine.setWakeUp({});
}

void EngineConformanceGlTest::opensOneVolumeAfterTheOther()
{
    EditEngine& engine = m_gpu.engine();
    std::vector<std::uint16_t> codes(8);
    QVERIFY(!engine.openVolume({2, 2, 3}, codes));
    // Nothing of the first volume is left in the second: neither cuts nor an open edit.
    const std::vector<EngineCase>& all = cases();
    QVERIFY(engine.openVolume({20, 20, 20}, test::constantVolume({20, 20, 20}, 9).values));
    submitWhole(engine, SeedPlacement{.label = 1, .voxels = {{1, 1, 1}}});
    engine.submit(BeginEdit{GrowBurst{.lowCode = 0, .highCode = 9}});
    engine.submit(ExtendEdit{GrowAdvance{3}});
    engine.finish();
    (void)engine.collect();
    ReferenceEngine oracle;
    const QString text =
        test::difference(test::runCase(oracle, all.front()), test::runCase(engine, all.front()));
    QVERIFY2(text.isEmpty(), qPrintable(text));
}

BURIN_TEST(EngineConformanceGlTest)

} // namespace engineConformanceGlTest

#include "EngineConformanceGlTest.moc"
