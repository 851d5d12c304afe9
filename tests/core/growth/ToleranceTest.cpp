// SPDX-License-Identifier: Apache-2.0
#include "core/growth/Tolerance.h"

#include "core/growth/SeedWord.h"
#include "tests/reference/ReferenceEngine.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/program/LongRun.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/ToleranceScene.h"

#include <QtTest>

#include <algorithm>
#include <functional>

namespace toleranceTest {

using namespace core;
namespace seedWord = core::seedWord;

namespace {

/// Members of label 2 after a growth from its seeds with an interval.
std::vector<bool> grown(const test::ToleranceScene& scene, int low, int high)
{
    reference::ReferenceEngine engine;
    if (!engine.openVolume(scene.codes.size, scene.codes.values))
        qFatal("no volume");
    for (const EngineCommand& command : scene.commands)
        engine.submit(command);
    GrowBurst burst{.lowCode = low,
        .highCode = high,
        .connectivity = scene.rule.connectivity,
        .limits = scene.rule.limits,
        .opening = GrowOpening::Restart,
        .generation = 1000,
        .overwritable = scene.rule.overwritable,
        .range = scene.rule.range};
    burst.lockedLabels.set();
    burst.lockedLabels.reset(scene.rule.label);
    submitWhole(engine, burst, {GrowAdvance{}});
    reference::DenseFields fields = engine.fields();
    std::vector<bool> members;
    for (const std::uint32_t word : fields.seedWords(0).values)
        members.push_back(seedWord::isMember(word) && seedWord::label(word) == scene.rule.label);
    return members;
}

} // namespace

class ToleranceTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    void equalsGrowthFromScratch_data()
    {
        QTest::addColumn<int>("number");
        const int count = test::longRun() ? 1000 : 60;
        for (int number = 0; number < count; ++number)
            QTest::addRow("volume %d", number) << number;
    }

    /// What the field is for: the voxels of tolerance ≤ t are a growth's with centre ∓ t.
    void equalsGrowthFromScratch()
    {
        QFETCH(int, number);
        test::Random random(std::uint32_t(41000 + number));
        const glm::ivec3 size{test::randomInt(random, 1, 24), test::randomInt(random, 1, 20),
            test::randomInt(random, 1, 18)};
        const test::ToleranceScene scene = test::randomToleranceScene(size, random);
        reference::ReferenceEngine engine;
        QVERIFY(engine.openVolume(scene.codes.size, scene.codes.values));
        for (const EngineCommand& command : scene.commands)
            engine.submit(command);
        engine.submit(TraceTolerance{scene.rule});
        ProbeVoxels probe;
        for (int z = 0; z < scene.codes.size.z; ++z)
            for (int y = 0; y < scene.codes.size.y; ++y)
                for (int x = 0; x < scene.codes.size.x; ++x)
                    probe.voxels.emplace_back(x, y, z);
        engine.submit(probe);
        const std::vector<EngineResult> results = engine.collect();
        const EngineResult& traced = results[results.size() - 2];
        QVERIFY2(!traced.error, qPrintable(QString::number(number)));
        QVERIFY(traced.tolerance);
        const std::vector<ProbedVoxel>& probes = results.back().probes;
        const std::vector<std::int64_t> members = membersOf(*traced.tolerance);

        std::vector<int> tolerances{0, 1, ToleranceRule::greatest};
        for (int i = 0; i < 8; ++i) {
            const auto& voxel = probes[random() % probes.size()];
            tolerances.push_back(voxel.tolerance.value_or(int(random() % 3000)));
            tolerances.push_back(std::max(tolerances.back() - 1, 0));
        }
        for (const int tolerance : tolerances) {
            const std::vector<bool> expected = grown(
                scene, traced.tolerance->centre - tolerance, traced.tolerance->centre + tolerance);
            for (std::size_t i = 0; i < expected.size(); ++i) {
                const bool joined = probes[i].tolerance && *probes[i].tolerance <= tolerance;
                if (joined != expected[i])
                    QFAIL(
                        qPrintable(QStringLiteral("tolerance %1, voxel %2").arg(tolerance).arg(i)));
            }
            const std::int64_t counted =
                members.empty() ? 0 : members[std::min(std::size_t(tolerance), members.size() - 1)];
            QCOMPARE(counted, std::int64_t(std::count(expected.begin(), expected.end(), true)));
        }
    }

    void centreIsTheRoundedMean()
    {
        reference::ReferenceEngine engine;
        const std::vector<std::uint16_t> codes{10, 11, 13, 60000};
        QVERIFY(engine.openVolume({4, 1, 1}, codes));
        submitWhole(engine, SeedPlacement{.label = 1, .voxels = {{0, 0, 0}, {1, 0, 0}}});
        engine.submit(TraceTolerance{{.label = 1}});
        std::vector<EngineResult> results = engine.collect();
        QCOMPARE(results.back().tolerance->centre, 11); // 10.5 is rounded up
        submitWhole(engine, SeedPlacement{.label = 1, .voxels = {{2, 0, 0}}});
        engine.submit(TraceTolerance{{.label = 1}});
        results = engine.collect();
        QCOMPARE(results.back().tolerance->centre, 11); // 11.33
        const std::vector<std::uint32_t> sizes = results.back().tolerance->sizes;
        QCOMPARE(int(sizes.size()), 60000 - 11 + 1);
        QCOMPARE(sizes[0], 1u);
        QCOMPARE(sizes[1], 1u);
        QCOMPARE(sizes[2], 1u);
        QCOMPARE(sizes.back(), 1u);
    }

    void refusesWhatHasNoLeastTolerance()
    {
        ToleranceRule rule{.label = 1};
        QVERIFY(isSound(rule));
        rule.limits.gradient = 5;
        rule.limits.onlyVisible = true;
        rule.limits.majority = 1;
        QVERIFY(isSound(rule));
        for (const auto& spoil : std::vector<std::function<void(ToleranceRule&)>>{
                 [](ToleranceRule& wrong) { wrong.label = 0; },
                 [](ToleranceRule& wrong) { wrong.connectivity = 8; },
                 [](ToleranceRule& wrong) { wrong.limits.difference = 3; },
                 [](ToleranceRule& wrong) { wrong.limits.gradientDifference = 3; },
                 [](ToleranceRule& wrong) { wrong.limits.majority = 14; },
                 [](ToleranceRule& wrong) { wrong.limits.sigmas256 = 256; },
                 [](ToleranceRule& wrong) { wrong.limits.smoothed = true; },
                 [](ToleranceRule& wrong) { wrong.limits.gradient = -1; }}) {
            ToleranceRule wrong = rule;
            spoil(wrong);
            QVERIFY(!isSound(wrong));
        }
    }

    void marksJumps()
    {
        // Grows a little, leaks at 40, goes on a little, leaks once more at 43.
        ToleranceCurve curve{.sizes = std::vector<std::uint32_t>(60, 10)};
        curve.sizes[0] = 2000;
        curve.sizes[40] = 1500;
        curve.sizes[43] = 9000;
        const std::vector<std::int64_t> members = membersOf(curve);
        QCOMPARE(members.back(), std::int64_t(2000 + 57 * 10 + 1500 + 9000));
        QCOMPARE(jumpsOf(members), (std::vector<int>{40, 43}));
        // Not by much more, or not of many voxels.
        QCOMPARE(jumpsOf(members, {.factor256 = 512}), (std::vector<int>{43}));
        QCOMPARE(jumpsOf(members, {.leastVoxels = 9001}), std::vector<int>{});
        QCOMPARE(jumpsOf({}), std::vector<int>{});
        QCOMPARE(jumpsOf({100000}), std::vector<int>{});
    }

    void jumpsOfFineCodesAreSeenToo()
    {
        // A leak that opens code by code where a code is a sixteenth of a unit.
        ToleranceCurve curve{.sizes = std::vector<std::uint32_t>(40000, 0)};
        curve.sizes[0] = 3000;
        for (std::size_t t = 20001; t <= 20008; ++t)
            curve.sizes[t] = 400;
        const std::vector<int> jumps = jumpsOf(membersOf(curve));
        QCOMPARE(jumps.size(), std::size_t(1));
        QVERIFY(jumps.front() >= 20008 && jumps.front() < 20018);
    }
};

BURIN_TEST(ToleranceTest)

} // namespace toleranceTest

#include "ToleranceTest.moc"
