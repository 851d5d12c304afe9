// SPDX-License-Identifier: Apache-2.0
#include "tests/reference/DelayedEngine.h"
#include "tests/reference/ReferenceEngine.h"
#include "tests/support/cases/EngineCases.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/program/LongRun.h"
#include "tests/support/program/TestProgram.h"

#include <QtTest>

#include <algorithm>
#include <atomic>
#include <numeric>

namespace delayedEngineTest {

using namespace core;

namespace {

/// How many of ten readings come out at each of many calls of collect().
std::vector<std::size_t> deliveries(std::uint32_t seed)
{
    reference::ReferenceEngine inner;
    reference::DelayedEngine engine(inner, seed);
    (void)engine.openVolume({2, 2, 2}, test::constantVolume({2, 2, 2}, 1).values);
    for (int i = 0; i < 10; ++i)
        engine.submit(ProbeVoxels{{{0, 0, 0}}});
    std::vector<std::size_t> counts;
    for (int i = 0; i < 200; ++i)
        counts.push_back(engine.collect().size());
    return counts;
}

} // namespace

class DelayedEngineTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    void resultsComeLateAndInBursts();
    void finishBringsAll();
    void wakesUntilNothingIsHeld();
    void delayChangesNothing();
};

void DelayedEngineTest::resultsComeLateAndInBursts()
{
    std::size_t greatestBurst = 0;
    bool late = false;
    for (std::uint32_t seed = 0; seed < 20; ++seed) {
        const std::vector<std::size_t> counts = deliveries(seed);
        QCOMPARE(std::accumulate(counts.begin(), counts.end(), std::size_t(0)), std::size_t(10));
        QVERIFY(counts == deliveries(seed)); // the schedule is a function of the seed
        greatestBurst = std::max(greatestBurst, *std::max_element(counts.begin(), counts.end()));
        late = late || (counts[0] == 0 && counts[1] == 0);
    }
    QVERIFY(greatestBurst > 2);
    QVERIFY(late);
    QVERIFY(deliveries(1) != deliveries(2));
}

void DelayedEngineTest::finishBringsAll()
{
    for (std::uint32_t seed = 0; seed < 20; ++seed) {
        reference::ReferenceEngine inner;
        reference::DelayedEngine engine(inner, seed);
        QVERIFY(engine.openVolume({2, 2, 2}, test::constantVolume({2, 2, 2}, 1).values));
        const Ticket first = engine.submit(ProbeVoxels{{{0, 0, 0}}});
        submitWhole(engine, SeedPlacement{.label = 1, .voxels = {{1, 1, 1}}});
        engine.finish();
        const std::vector<EngineResult> results = engine.collect();
        QCOMPARE(results.size(), std::size_t(2));
        QCOMPARE(results[0].ticket, first);
        QCOMPARE(results[1].ticket, first + 2);
    }
}

void DelayedEngineTest::wakesUntilNothingIsHeld()
{
    reference::ReferenceEngine inner;
    reference::DelayedEngine engine(inner, 3);
    QVERIFY(engine.openVolume({2, 2, 2}, test::constantVolume({2, 2, 2}, 1).values));
    std::atomic<int> calls = 0;
    engine.setWakeUp([&calls] { ++calls; });
    for (int i = 0; i < 5; ++i)
        engine.submit(ProbeVoxels{{{0, 0, 0}}});
    std::size_t got = 0;
    // A caller that collects only when woken gets everything.
    for (int seen = 0; got < 5;) {
        QTRY_VERIFY(calls > seen);
        seen = calls;
        got += engine.collect().size();
    }
    QCOMPARE(got, std::size_t(5));
}

void DelayedEngineTest::delayChangesNothing()
{
    const int random = test::longRun() ? 100 : 15;
    std::vector<test::EngineCase> cases = test::growthCases(random);
    for (auto more : {test::drillCases(random), test::pickCases(random), test::eraseCases(random),
             test::layerCases(random), test::refusalCases()})
        cases.insert(cases.end(), more.begin(), more.end());
    std::uint32_t seed = 0;
    for (const test::EngineCase& engineCase : cases) {
        reference::ReferenceEngine direct;
        reference::ReferenceEngine inner;
        reference::DelayedEngine delayed(inner, ++seed);
        const QString text =
            test::difference(test::runCase(direct, engineCase), test::runCase(delayed, engineCase));
        QVERIFY2(text.isEmpty(), qPrintable(QString::fromUtf8(engineCase.name + ": ") + text));
    }
}

BURIN_TEST(DelayedEngineTest)

} // namespace delayedEngineTest

#include "DelayedEngineTest.moc"
