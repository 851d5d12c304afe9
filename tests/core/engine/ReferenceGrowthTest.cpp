// SPDX-License-Identifier: Apache-2.0
#include "core/growth/SeedWord.h"
#include "tests/reference/ReferenceEngine.h"
#include "tests/support/cases/EngineConformance.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/program/LongRun.h"
#include "tests/support/program/TestProgram.h"

#include <QtTest>

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <memory>
#include <set>

namespace referenceGrowthTest {

using namespace core;
using reference::ReferenceEngine;
using test::Codes;
using test::lastResult;

namespace {

constexpr int far = 1 << 30;

/// Distances from sources over faces within `allowed`: breadth first, as in any textbook.
std::vector<int> distances(const glm::ivec3& size, const std::vector<char>& allowed,
    const std::vector<glm::ivec3>& sources)
{
    const reference::DenseArray<char> field{size, allowed};
    std::vector<int> distance(allowed.size(), far);
    std::deque<glm::ivec3> queue;
    for (const glm::ivec3& source : sources) {
        if (field.at(source) && distance[field.offset(source)] == far) {
            distance[field.offset(source)] = 0;
            queue.push_back(source);
        }
    }
    while (!queue.empty()) {
        const glm::ivec3 voxel = queue.front();
        queue.pop_front();
        for (int axis = 0; axis < 3; ++axis) {
            for (const int way : {-1, 1}) {
                glm::ivec3 next = voxel;
                next[axis] += way;
                if (!field.contains(next) || !field.at(next) || distance[field.offset(next)] != far)
                    continue;
                distance[field.offset(next)] = distance[field.offset(voxel)] + 1;
                queue.push_back(next);
            }
        }
    }
    return distance;
}

/// A rule as it is written, with nothing remembered between steps: every voxel asks its neighbours.
std::vector<std::uint32_t> grownLiterally(const Codes& codes, const std::vector<std::uint8_t>& held,
    std::vector<std::uint32_t> words, const GrowBurst& burst, int steps)
{
    const auto accepts = [&](std::uint32_t label, std::size_t at) {
        return burst.lowCode <= codes.values[at] && codes.values[at] <= burst.highCode
            && (held[at] == 0 || held[at] == label || burst.overwritable[held[at]]);
    };
    // What the label held already is marked: 30 for a seed, 29 for any other.
    const auto mark = [&](std::size_t at, std::uint32_t label, std::uint32_t direction) {
        if (held[at] != label || !burst.tellsHeld)
            return direction;
        return direction == seedWord::seedDirection ? std::uint32_t(30) : std::uint32_t(29);
    };
    std::uint32_t generation = burst.generation;
    bool admitted = false;
    for (std::size_t at = 0; at < words.size(); ++at) {
        const std::uint32_t label = seedWord::label(words[at]);
        if (seedWord::isPendingSeed(words[at]) && accepts(label, at)) {
            words[at] =
                seedWord::member(generation + 1, label, mark(at, label, seedWord::seedDirection));
            admitted = true;
        }
    }
    generation += admitted ? 1 : 0;
    for (int step = 0; steps < 0 || step < steps; ++step) {
        const std::vector<std::uint32_t> old = words;
        bool added = false;
        for (int z = 0; z < codes.size.z; ++z) {
            for (int y = 0; y < codes.size.y; ++y) {
                for (int x = 0; x < codes.size.x; ++x) {
                    const glm::ivec3 child(x, y, z);
                    const std::size_t at = codes.offset(child);
                    if (seedWord::isMember(old[at]))
                        continue;
                    for (std::uint32_t direction = 0; direction < seedWord::directions;
                         ++direction) {
                        const std::array<int, 3>& way = seedWord::offsets[direction];
                        const int changed = std::abs(way[0]) + std::abs(way[1]) + std::abs(way[2]);
                        const int reach = burst.connectivity == 6 ? 1
                            : burst.connectivity == 18            ? 2
                                                                  : 3;
                        const glm::ivec3 parent = child - glm::ivec3(way[0], way[1], way[2]);
                        if (changed > reach || !codes.contains(parent))
                            continue;
                        const std::uint32_t word = old[codes.offset(parent)];
                        const std::uint32_t label = seedWord::label(word);
                        if (!seedWord::isMember(word) || !accepts(label, at))
                            continue;
                        words[at] = std::min(words[at],
                            seedWord::member(generation + 1, label, mark(at, label, direction)));
                        added = true;
                    }
                }
            }
        }
        if (!added)
            break;
        ++generation;
    }
    return words;
}

} // namespace

class ReferenceGrowthTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    void isBreadthFirst_data();
    void isBreadthFirst();
    void followsTheRuleLiterally();
    void limitsAreWhatTheySay();
    void seedsNarrowTheInterval();
    void directionsAreAllNeighboursInPairs();
    void shrinkingIsTheInverse_data();
    void shrinkingIsTheInverse();
    void shrinkingLeavesWhatWasThere();
    void corridorIsAsLongAsItIs();
    void portionsMakeNoDifference();
    void competingLabelsMeetHalfWay();
    void anErasedLabelNeverGrowsAgain();
};

void ReferenceGrowthTest::isBreadthFirst_data()
{
    QTest::addColumn<int>("seed");
    const int count = test::longRun() ? 200 : 25;
    for (int seed = 0; seed < count; ++seed)
        QTest::addRow("%d", seed) << seed;
}

void ReferenceGrowthTest::isBreadthFirst()
{
    QFETCH(int, seed);
    test::Random random(std::uint32_t(300 + seed));
    const glm::ivec3 size{test::randomInt(random, 1, 30), test::randomInt(random, 1, 30),
        test::randomInt(random, 1, 30)};
    const Codes codes =
        seed % 2 ? test::balls(size, 5, random) : test::noiseVolume(size, test::tissueCode, random);
    const int low = test::randomInt(random, 0, 500);
    const int high = test::randomInt(random, low, test::tissueCode);
    std::vector<glm::ivec3> seeds;
    for (int i = test::randomInt(random, 1, 4); i > 0; --i)
        seeds.push_back(test::randomVoxel(random, size));

    ReferenceEngine engine;
    QVERIFY(engine.openVolume(size, codes.values));
    submitWhole(engine, SeedPlacement{.label = 7, .voxels = seeds});
    submitWhole(engine, GrowBurst{.lowCode = low, .highCode = high}, {GrowAdvance{}});
    const EngineResult result = lastResult(engine);
    QVERIFY(!result.error);
    QVERIFY(result.atClosure);

    std::vector<char> allowed;
    for (const std::uint16_t code : codes.values)
        allowed.push_back(low <= code && code <= high);
    const std::vector<int> expected = distances(size, allowed, seeds);
    reference::DenseFields fields = engine.fields();
    int greatest = -1;
    std::int64_t members = 0;
    for (std::size_t at = 0; at < expected.size(); ++at) {
        const std::uint32_t word = fields.seedWords(0).values[at];
        const bool member = expected[at] != far;
        QCOMPARE(seedWord::isMember(word), member);
        QCOMPARE(int(fields.labels(0).values[at]), member ? 7 : 0);
        if (!member)
            continue;
        QCOMPARE(int(seedWord::generation(word)), expected[at] + 1);
        QCOMPARE(seedWord::direction(word) == seedWord::seedDirection, expected[at] == 0);
        greatest = std::max(greatest, expected[at]);
        ++members;
    }
    QCOMPARE(int(result.generation), greatest + 1);
    QCOMPARE(result.statistics.generations, greatest + 1);
    QCOMPARE(result.statistics.voxelsChanged, members);
}

void ReferenceGrowthTest::followsTheRuleLiterally()
{
    for (int seed = 0; seed < (test::longRun() ? 200 : 30); ++seed) {
        test::Random random(std::uint32_t(40 + seed));
        const glm::ivec3 size{test::randomInt(random, 1, 20), test::randomInt(random, 1, 20),
            test::randomInt(random, 1, 20)};
        const Codes codes = test::noiseVolume(size, 9, random);
        test::Bytes labels{size, {}};
        for (std::size_t i = 0; i < codes.values.size(); ++i)
            labels.values.push_back(
                random() % 4 ? std::uint8_t(0) : std::uint8_t(test::randomInt(random, 1, 4)));
        ReferenceEngine engine;
        QVERIFY(engine.openVolume(size, codes.values));
        engine.submit(SwapBricks{test::bricksOf(labels, Field::Labels, 0)});
        std::uint32_t generation = 0;
        for (int burst = 0; burst < 3; ++burst) {
            for (int i = 0; i < 3; ++i)
                submitWhole(engine,
                    SeedPlacement{.label = std::uint8_t(test::randomInt(random, 1, 4)),
                        .voxels = {test::randomVoxel(random, size)}});
            reference::DenseFields before = engine.fields();
            GrowBurst grow{.lowCode = test::randomInt(random, 0, 4),
                .highCode = test::randomInt(random, 4, 9),
                .connectivity = std::array<int, 3>{6, 18, 26}[std::size_t(seed + burst) % 3],
                .generation = generation};
            grow.overwritable[2] = random() % 2;
            grow.overwritable[3] = random() % 2;
            const int steps = test::randomInt(random, -1, 5);
            submitWhole(engine, grow, {GrowAdvance{steps}});
            generation = lastResult(engine).generation;
            reference::DenseFields after = engine.fields();
            QVERIFY(after.seedWords(0).values
                == grownLiterally(
                    codes, before.labels(0).values, before.seedWords(0).values, grow, steps));
        }
    }
}

/// Each limit by itself, on volumes where its result is plain.
void ReferenceGrowthTest::limitsAreWhatTheySay()
{
    // A line that rises by 5 a voxel, by 9 from x = 12 on: 0, 5 … 60, 69 …
    const glm::ivec3 size(20, 3, 3);
    Codes line{size, {}};
    for (int z = 0; z < 3; ++z)
        for (int y = 0; y < 3; ++y)
            for (int x = 0; x < 20; ++x)
                line.values.push_back(std::uint16_t(5 * x + 4 * std::max(x - 12, 0)));
    const auto grown = [&](const Codes& codes, const glm::ivec3& seed, const GrowLimits& limits,
                           int low = 0) {
        ReferenceEngine engine;
        (void)engine.openVolume(codes.size, codes.values);
        submitWhole(engine, SeedPlacement{.label = 6, .voxels = {seed}});
        submitWhole(engine, GrowBurst{.lowCode = low, .highCode = 65535, .limits = limits},
            {GrowAdvance{}});
        reference::DenseFields fields = engine.fields();
        return fields.labels(0);
    };
    const auto reach = [&](const GrowLimits& limits) { // along the middle, from its low end
        const auto labels = grown(line, {0, 1, 1}, limits);
        int x = 0;
        while (x < 20 && labels.at({x, 1, 1}) == 6)
            ++x;
        return x;
    };
    QCOMPARE(reach({}), 20);
    QCOMPARE(reach({.difference = 4}), 1);
    QCOMPARE(reach({.difference = 5}), 13);
    QCOMPARE(reach({.difference = 9}), 20);
    // 1024 to a whole one: the difference of two voxels, half as much at the rim.
    const glm::ivec3 along(1024, 0, 0);
    QCOMPARE(reach({.gradient = 4, .gradientWeights = along}), 0);
    QCOMPARE(reach({.gradient = 9, .gradientWeights = along}), 1);
    QCOMPARE(reach({.gradient = 10, .gradientWeights = along}), 12);
    QCOMPARE(reach({.gradient = 14, .gradientWeights = along}), 13);
    QCOMPARE(reach({.gradient = 18, .gradientWeights = along}), 20);
    QCOMPARE(reach({.gradient = 9, .gradientWeights = {512, 65535, 65535}}), 20);
    QCOMPARE(reach({.gradientDifference = 4, .gradientWeights = along}), 1);
    QCOMPARE(reach({.gradientDifference = 5, .gradientWeights = along}), 19); // 18, then 9
    QCOMPARE(reach({.gradientDifference = 9, .gradientWeights = along}), 20);
    QCOMPARE(reach({.boxed = true, .boxFrom = {0, 1, 1}, .boxTo = {6, 1, 1}}), 7);

    // All but a plane is open: half of the 27 lie on or beyond it one voxel away.
    Codes wall = test::constantVolume({9, 5, 5}, 100);
    for (int z = 0; z < 5; ++z)
        for (int y = 0; y < 5; ++y)
            wall.at({5, y, z}) = 0;
    for (const auto& [majority, count] : {std::pair{18, 5}, std::pair{19, 4}, std::pair{27, 4}}) {
        const auto labels = grown(wall, {0, 2, 2}, {.majority = majority}, 1);
        QCOMPARE(int(std::count(labels.values.begin(), labels.values.end(), 6)), count * 25);
    }

    // Carved is closed, but where the layer is muted.
    for (const bool muted : {false, true}) {
        ReferenceEngine engine;
        QVERIFY(engine.openVolume(size, line.values));
        test::Bytes carved{size, std::vector<std::uint8_t>(line.values.size(), 0)};
        for (int z = 0; z < 3; ++z)
            for (int y = 0; y < 3; ++y) {
                carved.at({4, y, z}) = 127;
                carved.at({8, y, z}) = 128;
            }
        engine.submit(SwapBricks{test::bricksOf(carved, Field::Coverage, 3)});
        if (muted)
            engine.submit(MuteLayers{std::bitset<256>().set(3)});
        submitWhole(engine, SeedPlacement{.label = 6, .voxels = {{0, 1, 1}}});
        submitWhole(engine,
            GrowBurst{.lowCode = 0, .highCode = 65535, .limits = {.onlyVisible = true}},
            {GrowAdvance{}});
        QCOMPARE(lastResult(engine).statistics.voxelsChanged, std::int64_t(muted ? 180 : 72));
    }
}

/// To mean ± k σ of what lies around them within it, for each label by itself.
void ReferenceGrowthTest::seedsNarrowTheInterval()
{
    test::Random random(5);
    const glm::ivec3 size(30, 12, 12);
    Codes codes = test::noiseVolume(size, 99, random);
    for (int z = 0; z < 12; ++z)
        for (int y = 0; y < 12; ++y)
            for (int x = 15; x < 30; ++x)
                codes.at({x, y, z}) = std::uint16_t(codes.at({x, y, z}) + 1000);
    ReferenceEngine engine;
    QVERIFY(engine.openVolume(size, codes.values));
    const std::vector<glm::ivec3> seeds{{3, 5, 5}, {1, 1, 6}, {26, 5, 5}, {28, 10, 11}};
    submitWhole(engine, SeedPlacement{.label = 2, .voxels = {seeds[0], seeds[1]}});
    submitWhole(engine, SeedPlacement{.label = 5, .voxels = {seeds[2], seeds[3]}});
    engine.submit(ProbeSeeds{.plane = 0, .lowCode = 20, .highCode = 1080});
    const std::vector<ProbedSeeds> probed = lastResult(engine).seeds;
    QCOMPARE(probed.size(), std::size_t(2));
    submitWhole(engine,
        GrowBurst{
            .lowCode = 20, .highCode = 1080, .connectivity = 26, .limits = {.sigmas256 = 384}},
        {GrowAdvance{}});
    reference::DenseFields fields = engine.fields();
    for (std::size_t half = 0; half < 2; ++half) {
        std::vector<double> around;
        for (const glm::ivec3& seed : {seeds[2 * half], seeds[2 * half + 1]})
            for (int i = 0; i < 343; ++i) {
                const glm::ivec3 voxel = seed + glm::ivec3(i % 7, i / 7 % 7, i / 49) - 3;
                if (codes.contains(voxel) && codes.at(voxel) >= 20 && codes.at(voxel) <= 1080)
                    around.push_back(codes.at(voxel));
            }
        double mean = 0.0;
        for (const double code : around)
            mean += code / double(around.size());
        double variance = 0.0;
        for (const double code : around)
            variance += (code - mean) * (code - mean) / double(around.size());
        QCOMPARE(int(probed[half].label), half == 0 ? 2 : 5);
        QCOMPARE(probed[half].sums.voxels, std::uint64_t(around.size()));
        const double low = mean - 1.5 * std::sqrt(variance);
        const double high = mean + 1.5 * std::sqrt(variance);
        int grown = 0;
        for (int z = 0; z < 12; ++z) {
            for (int y = 0; y < 12; ++y) {
                for (int x = 15 * int(half); x < 15 + 15 * int(half); ++x) {
                    const int code = codes.at({x, y, z});
                    const int label = fields.labels(0).at({x, y, z});
                    if (label != 0) {
                        QCOMPARE(label, half == 0 ? 2 : 5);
                        QVERIFY(code >= low - 0.1 && code <= high + 0.1);
                    }
                    grown += label != 0 ? 1 : 0;
                }
            }
        }
        QVERIFY2(grown > 800, qPrintable(QString::number(grown)));
    }
}

void ReferenceGrowthTest::directionsAreAllNeighboursInPairs()
{
    std::set<std::array<int, 3>> all;
    for (std::uint32_t direction = 0; direction < seedWord::directions; ++direction) {
        const std::array<int, 3>& way = seedWord::offsets[direction];
        const std::array<int, 3>& back = seedWord::offsets[direction ^ 1U];
        int axes = 0;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            QCOMPARE(way[axis], -back[axis]);
            QVERIFY(std::abs(way[axis]) <= 1);
            axes += way[axis] != 0 ? 1 : 0;
        }
        QCOMPARE(axes, direction < 6 ? 1 : direction < 18 ? 2 : 3);
        all.insert(way);
    }
    QCOMPARE(all.size(), std::size_t(26));
}

void ReferenceGrowthTest::shrinkingIsTheInverse_data()
{
    QTest::addColumn<int>("seed");
    const int count = test::longRun() ? 150 : 20;
    for (int seed = 0; seed < count; ++seed)
        QTest::addRow("%d", seed) << seed;
}

/// To any generation: what growing so far from scratch gives, and growing on gives what was there.
void ReferenceGrowthTest::shrinkingIsTheInverse()
{
    QFETCH(int, seed);
    test::Random random(std::uint32_t(700 + seed));
    const glm::ivec3 size{test::randomInt(random, 4, 24), test::randomInt(random, 4, 24),
        test::randomInt(random, 4, 24)};
    const Codes codes = test::balls(size, 5, random);
    test::Bytes labels{size, {}};
    for (std::size_t i = 0; i < codes.values.size(); ++i)
        labels.values.push_back(
            random() % 6 ? std::uint8_t(0) : std::uint8_t(test::randomInt(random, 1, 3)));
    GrowBurst grow{.lowCode = 0,
        .highCode = test::randomInt(random, 300, test::tissueCode),
        .connectivity = std::array<int, 3>{6, 18, 26}[random() % 3]};
    std::vector<SeedPlacement> seeds;
    for (int label = 1; label <= 3; ++label)
        seeds.push_back({.label = std::uint8_t(label),
            .voxels = {test::randomVoxel(random, size), test::randomVoxel(random, size)}});
    for (std::size_t label = 1; label <= 3; ++label)
        grow.overwritable[label] = random() % 2;
    const auto grown = [&](int steps) {
        auto engine = std::make_unique<ReferenceEngine>();
        (void)engine->openVolume(size, codes.values);
        engine->submit(SwapBricks{test::bricksOf(labels, Field::Labels, 0)});
        for (const SeedPlacement& placement : seeds)
            submitWhole(*engine, placement);
        submitWhole(*engine, grow, {GrowAdvance{steps}});
        return engine;
    };
    auto engine = grown(GrowAdvance::toClosure);
    const std::uint32_t last = lastResult(*engine).generation;
    if (last == 0)
        return; // no seed was accepted
    reference::DenseFields whole = engine->fields();
    // A seed that waited, not accepted, where another label grew over it is gone for good.
    const auto withoutOverrun = [&whole](reference::DenseFields& fields) {
        std::vector<std::uint32_t> words = fields.seedWords(0).values;
        for (std::size_t i = 0; i < words.size(); ++i) {
            const std::uint32_t later = whole.seedWords(0).values[i];
            if (seedWord::isPendingSeed(words[i]) && seedWord::isMember(later))
                words[i] = seedWord::unvisited;
        }
        return words;
    };
    const std::uint32_t keep = 1 + random() % last;
    submitWhole(*engine, ShrinkGrowth{.generation = last, .keep = keep});
    const EngineResult shrunk = lastResult(*engine);
    QCOMPARE(shrunk.generation, keep);
    QCOMPARE(shrunk.statistics.generations, int(last - keep));
    reference::DenseFields there = engine->fields();
    reference::DenseFields scratch = grown(int(keep) - 1)->fields();
    QVERIFY(there.seedWords(0).values == withoutOverrun(scratch));
    QVERIFY(there.labels(0).values == scratch.labels(0).values);

    grow.generation = keep;
    submitWhole(*engine, grow, {GrowAdvance{}});
    there = engine->fields();
    QVERIFY(there.seedWords(0).values == whole.seedWords(0).values);
    QVERIFY(there.labels(0).values == whole.labels(0).values);

    grow.generation = 0;
    // To the seeds: as the first generation was; to nothing: as if only sketched.
    submitWhole(*engine, ShrinkGrowth{.generation = last, .keepSeeds = true});
    QCOMPARE(lastResult(*engine).generation, 1u);
    there = engine->fields();
    scratch = grown(0)->fields();
    QVERIFY(there.seedWords(0).values == withoutOverrun(scratch));
    submitWhole(*engine, ShrinkGrowth{.generation = 1});
    there = engine->fields();
    QVERIFY(there.labels(0).values == labels.values);
    QVERIFY(there.overwritten(0).values == std::vector<std::uint8_t>(labels.values.size(), 0));
    for (const std::uint32_t word : there.seedWords(0).values)
        QVERIFY(word == seedWord::unvisited || seedWord::isPendingSeed(word));
}

void ReferenceGrowthTest::shrinkingLeavesWhatWasThere()
{
    // A line of ten voxels of which the label held the third, and another label the sixth.
    const glm::ivec3 size(10, 1, 1);
    ReferenceEngine engine;
    QVERIFY(engine.openVolume(size, test::constantVolume(size, 5).values));
    test::Bytes labels{size, {0, 0, 4, 0, 0, 9, 0, 0, 0, 0}};
    engine.submit(SwapBricks{test::bricksOf(labels, Field::Labels, 0)});
    submitWhole(engine, SeedPlacement{.label = 4, .voxels = {{0, 0, 0}}});
    GrowBurst grow{.lowCode = 5, .highCode = 5};
    grow.overwritable.set(9);
    submitWhole(engine, grow, {GrowAdvance{}});
    reference::DenseFields fields = engine.fields();
    QCOMPARE(fields.labels(0).values, std::vector<std::uint8_t>(10, 4));
    submitWhole(engine, ShrinkGrowth{.generation = 10, .keepSeeds = true});
    fields = engine.fields();
    QCOMPARE(fields.labels(0).values, (std::vector<std::uint8_t>{4, 0, 4, 0, 0, 9, 0, 0, 0, 0}));
    // Locked: neither shrinks nor lets the generation fall below its own.
    submitWhole(engine, GrowBurst{.lowCode = 5, .highCode = 5, .generation = 1}, {GrowAdvance{4}});
    ShrinkGrowth locked{.generation = 5, .keep = 2};
    locked.lockedLabels.set(4);
    submitWhole(engine, locked);
    const EngineResult result = lastResult(engine);
    QVERIFY(result.changes.empty());
    QCOMPARE(result.generation, 5u);
}

void ReferenceGrowthTest::corridorIsAsLongAsItIs()
{
    const Codes codes = test::spiralCorridor({17, 33, 5});
    const auto voxels = std::count(codes.values.begin(), codes.values.end(), test::tissueCode);
    ReferenceEngine engine;
    QVERIFY(engine.openVolume(codes.size, codes.values));
    submitWhole(engine, SeedPlacement{.label = 1, .voxels = {{0, 0, 0}}});
    submitWhole(engine, GrowBurst{.lowCode = 1, .highCode = 65535}, {GrowAdvance{}});
    const EngineResult result = lastResult(engine);
    QCOMPARE(result.statistics.voxelsChanged, std::int64_t(voxels));
    // One voxel a generation: it branches nowhere.
    QCOMPARE(std::int64_t(result.generation), std::int64_t(voxels));
}

void ReferenceGrowthTest::portionsMakeNoDifference()
{
    test::Random random(1);
    const Codes codes = test::balls({40, 33, 20}, 6, random);
    const auto grow = [&](std::vector<EngineExtension> portions) {
        ReferenceEngine engine;
        (void)engine.openVolume(codes.size, codes.values);
        submitWhole(engine, SeedPlacement{.label = 1, .voxels = {{3, 3, 3}, {39, 32, 19}}});
        submitWhole(engine, GrowBurst{.lowCode = 0, .highCode = 240}, std::move(portions));
        return lastResult(engine);
    };
    const EngineResult whole = grow({GrowAdvance{}});
    const EngineResult parts = grow({GrowAdvance{1}, GrowPause{}, GrowAdvance{2},
        GrowAdvance{GrowAdvance::toClosure, 3.0}, GrowAdvance{4}});
    QVERIFY(whole.generation > 4);
    QCOMPARE(parts.generation, whole.generation);
    QVERIFY(std::equal(whole.changes.begin(), whole.changes.end(), parts.changes.begin(),
        parts.changes.end(), [](const BrickChange& a, const BrickChange& b) {
            return a.key == b.key && a.before == b.before && a.after == b.after;
        }));
}

void ReferenceGrowthTest::competingLabelsMeetHalfWay()
{
    const glm::ivec3 size(21, 3, 3);
    ReferenceEngine engine;
    QVERIFY(engine.openVolume(size, test::constantVolume(size, 5).values));
    submitWhole(engine, SeedPlacement{.label = 9, .voxels = {{0, 1, 1}}});
    submitWhole(engine, SeedPlacement{.label = 4, .voxels = {{20, 1, 1}}});
    submitWhole(engine, GrowBurst{.lowCode = 5, .highCode = 5}, {GrowAdvance{}});
    reference::DenseFields fields = engine.fields();
    for (int x = 0; x < size.x; ++x) // the tie in the middle goes to the lower label
        QCOMPARE(int(fields.labels(0).at({x, 1, 1})), x < 10 ? 9 : 4);
}

void ReferenceGrowthTest::anErasedLabelNeverGrowsAgain()
{
    const glm::ivec3 size(21, 3, 3);
    ReferenceEngine engine;
    QVERIFY(engine.openVolume(size, test::constantVolume(size, 5).values));
    submitWhole(engine, SeedPlacement{.label = 9, .voxels = {{0, 1, 1}}});
    submitWhole(engine, SeedPlacement{.label = 4, .voxels = {{20, 1, 1}}});
    submitWhole(engine, GrowBurst{.lowCode = 5, .highCode = 5}, {GrowAdvance{5}});
    submitWhole(engine, SeedPlacement{.label = 9, .voxels = {{10, 0, 0}}});
    submitWhole(engine, EraseLabel{.label = 9});
    submitWhole(engine, GrowBurst{.lowCode = 5, .highCode = 5, .generation = 6}, {GrowAdvance{}});
    // Label 4 goes on from where it stood and takes everything.
    QCOMPARE(lastResult(engine).generation, 6u + 17u);
    reference::DenseFields fields = engine.fields();
    for (const std::uint8_t label : fields.labels(0).values)
        QCOMPARE(int(label), 4);
    for (const std::uint32_t word : fields.seedWords(0).values)
        QVERIFY(seedWord::isMember(word) && seedWord::label(word) == 4);
}

BURIN_TEST(ReferenceGrowthTest)

} // namespace referenceGrowthTest

#include "ReferenceGrowthTest.moc"
