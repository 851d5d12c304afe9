// SPDX-License-Identifier: Apache-2.0
#include "tests/reference/ReferenceEngine.h"
#include "core/growth/SeedWord.h"
#include "tests/reference/DelayedEngine.h"
#include "tests/support/EngineCases.h"
#include "tests/support/FailingLog.h"

#include <QtTest>

#include <algorithm>
#include <deque>
#include <map>

using namespace core;
using reference::ReferenceEngine;
using test::Codes;

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

/// The result that came last.
EngineResult lastResult(EditEngine& engine)
{
    engine.finish();
    std::vector<EngineResult> results = engine.collect();
    return results.empty() ? EngineResult{} : std::move(results.back());
}

/// A rule as it is written, with nothing remembered between steps: every voxel asks its neighbours.
std::vector<std::uint32_t> grownLiterally(const Codes& codes, const std::vector<std::uint8_t>& held,
    std::vector<std::uint32_t> words, const GrowBurst& burst, int steps)
{
    const auto accepts = [&](std::uint32_t label, std::size_t at) {
        return burst.lowCode <= codes.values[at] && codes.values[at] <= burst.highCode
            && (held[at] == 0 || held[at] == label || burst.overwritable[held[at]]);
    };
    std::uint32_t generation = burst.generation;
    bool admitted = false;
    for (std::size_t at = 0; at < words.size(); ++at) {
        const std::uint32_t label = seedWord::label(words[at]);
        if (seedWord::isPendingSeed(words[at]) && accepts(label, at)) {
            words[at] = seedWord::member(generation + 1, label, seedWord::seedDirection);
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
                    for (std::uint32_t direction = 0; direction < 6; ++direction) {
                        glm::ivec3 parent = child;
                        parent[int(direction / 2)] += direction % 2 ? 1 : -1;
                        if (!codes.contains(parent))
                            continue;
                        const std::uint32_t word = old[codes.offset(parent)];
                        if (!seedWord::isMember(word) || !accepts(seedWord::label(word), at))
                            continue;
                        words[at] = std::min(words[at],
                            seedWord::member(generation + 1, seedWord::label(word), direction));
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

/// A view along an index axis of a box of 1 mm voxels, target in the middle.
struct StraightView {
    Document document;
    DrillStroke stroke;

    explicit StraightView(const glm::ivec3& size)
    {
        Volume volume;
        volume.geometry.size = size;
        document.volumes.push_back(volume);
        stroke.view.targetLps = glm::dvec3(size) / 2.0;
        stroke.view.eyeLps = stroke.view.targetLps - glm::dvec3(0, 0, 300);
        stroke.view.up = {0.0, 1.0, 0.0};
        stroke.radiusMm = 6.0;
        stroke.depthMm = 5.0;
        stroke.pressureExponent = 1;
        stroke.surfaceThreshold = test::tissueCode / 2;
        stroke.samples = {{.pressure = 1.0}};
    }

    EngineResult drill(EditEngine& engine) const
    {
        const DrillCut cut = test::drillCutOf(stroke, document);
        submitWhole(engine, cut, {DrillPath{test::drillSamplesOf(stroke, cut)}});
        return lastResult(engine);
    }
};

} // namespace

class ReferenceEngineTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    void growthIsBreadthFirst_data();
    void growthIsBreadthFirst();
    void growthFollowsTheRuleLiterally();
    void corridorIsAsLongAsItIs();
    void portionsOfAGrowthMakeNoDifference();
    void competingLabelsMeetHalfWay();

    void drillReachesItsDepth_data();
    void drillReachesItsDepth();
    void drillStopsAtAGap();
    void drillStaysUnderItsMask();
    void drillLeavesWhatItDoesNotSee();
    void drillIgnoresItsOwnCut();
    void obliqueDrillCutsBetweenTwoPlanes();
    void portionsOfAStrokeMakeNoDifference();

    void picksMeetTheSurface();
    void rollbackRestores();
    void swappingTwiceIsIdentity();
    void refusals();
    void delayChangesNothing();
    void casesAreWorthRunning();
};

void ReferenceEngineTest::growthIsBreadthFirst_data()
{
    QTest::addColumn<int>("seed");
    const int count = test::longRun() ? 200 : 25;
    for (int seed = 0; seed < count; ++seed)
        QTest::addRow("%d", seed) << seed;
}

void ReferenceEngineTest::growthIsBreadthFirst()
{
    QFETCH(int, seed);
    test::Random random(std::uint32_t(300 + seed));
    const glm::ivec3 size(test::randomInt(random, 1, 30), test::randomInt(random, 1, 30),
        test::randomInt(random, 1, 30));
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

void ReferenceEngineTest::growthFollowsTheRuleLiterally()
{
    for (int seed = 0; seed < (test::longRun() ? 200 : 30); ++seed) {
        test::Random random(std::uint32_t(40 + seed));
        const glm::ivec3 size(test::randomInt(random, 1, 20), test::randomInt(random, 1, 20),
            test::randomInt(random, 1, 20));
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

void ReferenceEngineTest::corridorIsAsLongAsItIs()
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

void ReferenceEngineTest::portionsOfAGrowthMakeNoDifference()
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

void ReferenceEngineTest::competingLabelsMeetHalfWay()
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

void ReferenceEngineTest::drillReachesItsDepth_data()
{
    QTest::addColumn<double>("pressure");
    QTest::addColumn<int>("exponent");
    QTest::addRow("full") << 1.0 << 1;
    QTest::addRow("half") << 0.5 << 1;
    QTest::addRow("half, squared") << 0.5 << 2;
    QTest::addRow("none") << 0.0 << 1;
}

void ReferenceEngineTest::drillReachesItsDepth()
{
    QFETCH(double, pressure);
    QFETCH(int, exponent);
    const glm::ivec3 size(32, 32, 32);
    constexpr int surface = 8; // the first voxel of tissue
    ReferenceEngine engine;
    QVERIFY(engine.openVolume(size, test::slab(size, 2, surface, 31).values));
    StraightView view(size);
    view.stroke.depthMm = 12.0;
    view.stroke.pressureExponent = exponent;
    view.stroke.samples.front().pressure = pressure;
    const EngineResult result = view.drill(engine);
    QVERIFY(!result.error);
    const double depth = 12.0 * std::pow(pressure, exponent);
    QCOMPARE(result.changes.empty(), depth == 0.0);
    // Linear interpolation meets half the code half a voxel before the first voxel of tissue.
    const double first = surface - 0.5;
    reference::DenseFields fields = engine.fields();
    for (int z = 0; z < size.z; ++z) {
        const bool cut = fields.coverage(1).at({16, 16, z}) >= 128;
        // Sixteenths of half a voxel and the middle of the ramp: 0.1 voxel is undecided.
        if (std::abs(z - (first + depth)) > 0.1 && z >= surface)
            QCOMPARE(cut, z < first + depth);
        else if (z < surface - 2)
            QVERIFY(!cut);
    }
}

void ReferenceEngineTest::drillStopsAtAGap()
{
    const glm::ivec3 size(32, 32, 48);
    Codes codes = test::slab(size, 2, 5, 9);
    for (int z = 20; z < 26; ++z)
        for (int y = 0; y < 32; ++y)
            for (int x = 0; x < 32; ++x)
                codes.at({x, y, z}) = test::tissueCode;
    for (const bool throughGaps : {false, true}) {
        ReferenceEngine engine;
        QVERIFY(engine.openVolume(size, codes.values));
        StraightView view(size);
        view.stroke.depthMm = 40.0;
        view.stroke.throughGaps = throughGaps;
        (void)view.drill(engine);
        reference::DenseFields fields = engine.fields();
        for (int z = 5; z < 26; ++z) {
            if (codes.at({16, 16, z}) == 0)
                continue;
            QCOMPARE(fields.coverage(1).at({16, 16, z}) >= 128, z < 10 || throughGaps);
        }
    }
}

void ReferenceEngineTest::drillStaysUnderItsMask()
{
    const glm::ivec3 size(40, 40, 20);
    ReferenceEngine engine;
    QVERIFY(engine.openVolume(size, test::slab(size, 2, 4, 19).values));
    StraightView view(size);
    view.stroke.samples = {{.xMm = 3.0, .yMm = -4.0}};
    (void)view.drill(engine);
    reference::DenseFields fields = engine.fields();
    // Seen along +z with +y up, right is −x. The path has one point: a disc.
    const glm::dvec2 centre(20.0 - 3.0, 20.0 - 4.0);
    for (int y = 0; y < size.y; ++y) {
        for (int x = 0; x < size.x; ++x) {
            const double r = glm::length(glm::dvec2(x, y) - centre);
            const bool cut = fields.coverage(1).at({x, y, 5}) >= 128;
            if (r < 5.0)
                QVERIFY2(cut, qPrintable(QStringLiteral("%1 %2").arg(x).arg(y)));
            if (r > 7.0)
                QVERIFY2(!cut, qPrintable(QStringLiteral("%1 %2").arg(x).arg(y)));
        }
    }
}

void ReferenceEngineTest::drillLeavesWhatItDoesNotSee()
{
    const glm::ivec3 size(20, 20, 20);
    for (const auto& [code, threshold] :
        {std::pair{0, 1.0}, std::pair{65535, 70000.0}, std::pair{499, 500.0}}) {
        ReferenceEngine engine;
        QVERIFY(engine.openVolume(size, test::constantVolume(size, std::uint16_t(code)).values));
        StraightView view(size);
        view.stroke.surfaceThreshold = threshold;
        QVERIFY(view.drill(engine).changes.empty());
    }
    ReferenceEngine engine;
    QVERIFY(engine.openVolume(size, test::constantVolume(size, 0).values));
    StraightView view(size);
    view.stroke.surfaceThreshold = -5.0; // code 0 and above: all of it is seen
    QVERIFY(!view.drill(engine).changes.empty());
    view.stroke.samples.front().xMm = 100.0;
    QVERIFY(view.drill(engine).changes.empty());
}

void ReferenceEngineTest::drillIgnoresItsOwnCut()
{
    const glm::ivec3 size(32, 32, 32);
    const auto depthAfter = [&](int strokes, std::size_t repeats, std::uint8_t layerStep) {
        ReferenceEngine engine;
        (void)engine.openVolume(size, test::slab(size, 2, 4, 31).values);
        StraightView view(size);
        view.stroke.samples.assign(repeats, view.stroke.samples.front());
        int deepest = -1;
        for (int i = 0; i < strokes; ++i) {
            view.stroke.layer = 1 + i * layerStep;
            (void)view.drill(engine);
        }
        reference::DenseFields fields = engine.fields();
        const auto carved = fields.composedCoverage();
        for (int z = 0; z < size.z; ++z)
            deepest = carved.at({16, 16, z}) >= 128 ? z : deepest;
        return deepest;
    };
    const int once = depthAfter(1, 1, 0);
    QVERIFY(once > 5);
    QCOMPARE(depthAfter(1, 9, 0), once); // within a stroke the surface stays what it was
    const int twice = depthAfter(2, 1, 0);
    QVERIFY(twice >= once + 4 && twice <= once + 6); // the next one starts from the cut
    QCOMPARE(depthAfter(2, 1, 1), twice); // whatever layer holds it
}

void ReferenceEngineTest::obliqueDrillCutsBetweenTwoPlanes()
{
    const glm::ivec3 size(40, 40, 40);
    ReferenceEngine engine;
    QVERIFY(engine.openVolume(size, test::slab(size, 2, 10, 39).values));
    StraightView view(size);
    const glm::dvec3 towards = glm::normalize(glm::dvec3(0.5, 0.3, 1.0));
    view.stroke.view.targetLps = {20.0, 20.0, 9.5};
    view.stroke.view.eyeLps = view.stroke.view.targetLps - 200.0 * towards;
    view.stroke.depthMm = 8.0;
    (void)view.drill(engine);
    reference::DenseFields fields = engine.fields();
    int inside = 0;
    for (int z = 0; z < size.z; ++z) {
        for (int y = 0; y < size.y; ++y) {
            for (int x = 0; x < size.x; ++x) {
                const glm::dvec3 p = glm::dvec3(x, y, z) - view.stroke.view.targetLps;
                // Along the view direction from the plane z = 9.5 to the voxel, and off the axis.
                const double below = p.z / towards.z;
                const double off = glm::length(p - glm::dot(p, towards) * towards);
                const bool cut = fields.coverage(1).at({x, y, z}) >= 128;
                if (off < 5.0 && below > 0.5 && below < 7.0) {
                    QVERIFY(cut);
                    ++inside;
                }
                // An element is half a voxel wide and meets the slope at one height.
                if (off > 7.0 || below > 9.0 || below < -3.0)
                    QVERIFY(!cut);
            }
        }
    }
    QVERIFY(inside > 100);
}

void ReferenceEngineTest::portionsOfAStrokeMakeNoDifference()
{
    test::Random random(77);
    for (int i = 0; i < (test::longRun() ? 60 : 8); ++i) {
        const glm::ivec3 size(30, 25, 20);
        const Codes codes = test::balls(size, 5, random);
        const Document document = test::randomDocument(size, random, i % 2);
        const DrillStroke stroke = test::randomDrill(document, random);
        const DrillCut cut = test::drillCutOf(stroke, document);
        std::vector<DrillSample> path = test::drillSamplesOf(stroke, cut);
        ReferenceEngine whole;
        ReferenceEngine parts;
        QVERIFY(whole.openVolume(size, codes.values));
        QVERIFY(parts.openVolume(size, codes.values));
        submitWhole(whole, cut, {DrillPath{path}});
        std::shuffle(path.begin(), path.end(), random);
        std::vector<EngineExtension> extensions;
        for (const DrillSample& sample : path)
            extensions.push_back(DrillPath{{sample}});
        submitWhole(parts, cut, std::move(extensions));
        QVERIFY(reference::DenseFields::changes(whole.fields(), parts.fields()).empty());
    }
}

void ReferenceEngineTest::picksMeetTheSurface()
{
    const glm::ivec3 size(16, 16, 16);
    Codes codes = test::slab(size, 2, 6, 15);
    codes.at({4, 4, 11}) = 3000;
    ReferenceEngine engine;
    QVERIFY(engine.openVolume(size, codes.values));
    const PickVoxels::Ray along{
        .origin = {4 << 16, 4 << 16, -(3 << 16)}, .step = {0, 0, 1 << 14}, .samples = 100};
    const PickVoxels::Ray beside{
        .origin = {40 << 16, 4 << 16, 0}, .step = {0, 0, 1 << 14}, .samples = 100};
    const std::vector<PickVoxels::Ray> rays{along, beside};
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
        const DrillStroke stroke = test::randomDrill(document, random);
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
        {"begin twice, roll back", {1}}, {"swap while an edit is open", {1}},
        {"bricks that are not there", {0, 1, 2, 3}}, {"images cut short", {0}},
        {"voxels outside", {0, 1, 2, 3}}, {"label 0", {0, 1}}, {"connectivity", {2, 3, 4}},
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
            QVERIFY(result.error->code == ErrorCode::InvalidField);
            QVERIFY(result.changes.empty());
        }
        QVERIFY2(failed == failing.at(engineCase.name), engineCase.name.constData());
    }
    // Nothing was committed in the case that swaps while an edit is open but the seeds.
    ReferenceEngine engine;
    (void)test::runCase(engine, cases.at(4));
    reference::DenseFields fields = engine.fields();
    QCOMPARE(std::count(fields.labels(0).values.begin(), fields.labels(0).values.end(), 0),
        std::ptrdiff_t(fields.labels(0).values.size()));
    ReferenceEngine small;
    const std::vector<std::uint16_t> codes(7);
    QVERIFY(!small.openVolume({2, 2, 2}, codes));
}

void ReferenceEngineTest::delayChangesNothing()
{
    const int random = test::longRun() ? 100 : 15;
    std::vector<test::EngineCase> cases = test::growthCases(random);
    for (auto more : {test::drillCases(random), test::pickCases(random), test::refusalCases()})
        cases.insert(cases.end(), more.begin(), more.end());
    std::uint32_t seed = 0;
    for (const test::EngineCase& engineCase : cases) {
        ReferenceEngine direct;
        ReferenceEngine inner;
        reference::DelayedEngine delayed(inner, ++seed);
        const QString text =
            test::difference(test::runCase(direct, engineCase), test::runCase(delayed, engineCase));
        QVERIFY2(text.isEmpty(), qPrintable(QString::fromUtf8(engineCase.name + ": ") + text));
    }
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
    QVERIFY2(drills > 0.6, qPrintable(QString::number(drills)));
    QVERIFY2(picks > 0.8, qPrintable(QString::number(picks)));
}

QTEST_GUILESS_MAIN(ReferenceEngineTest)
#include "ReferenceEngineTest.moc"
