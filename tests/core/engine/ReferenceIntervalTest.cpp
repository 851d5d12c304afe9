// SPDX-License-Identifier: Apache-2.0
#include "core/edits/engine/EngineEdits.h"
#include "core/edits/kinds/growth/BarrierStroke.h"
#include "core/growth/SeedWord.h"
#include "tests/reference/ReferenceEngine.h"
#include "tests/support/cases/EngineConformance.h"
#include "tests/support/cases/RandomEdits.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/program/LongRun.h"
#include "tests/support/program/TestProgram.h"

#include <QtTest>

#include <array>
#include <memory>

namespace referenceIntervalTest {

using namespace core;
using reference::ReferenceEngine;
using test::Codes;
using test::lastResult;

/// What a growth becomes when its interval is changed, and where barriers are (rules in
/// core/growth/GrowthCommands.h).
class ReferenceIntervalTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    void movesEqualGrowingFromScratch_data();
    void movesEqualGrowingFromScratch();
    void growingAnewEqualsScratchWordForWord();
    void whatHungOnItLeavesAndComesBackLast();
    void barriersShutAndLetThrough();
    void barriersLeaveWhatIsLockedOrPainted();

private:
    struct Scene {
        Codes codes;
        test::Bytes held;
        std::vector<SeedPlacement> seeds;
        std::optional<PaintBarrier> barrier{};
        std::vector<Capsule> path{};
    };
    [[nodiscard]] static Scene randomScene(test::Random& random, int labels);
    [[nodiscard]] static std::unique_ptr<ReferenceEngine> sketched(const Scene& scene);
    static EngineResult grow(ReferenceEngine& engine, GrowBurst burst, std::uint32_t generation);
};

namespace {

/// A line of voxels with one seed at its beginning.
std::unique_ptr<ReferenceEngine> line(const std::vector<std::uint16_t>& codes)
{
    auto engine = std::make_unique<ReferenceEngine>();
    (void)engine->openVolume({int(codes.size()), 1, 1}, codes);
    submitWhole(*engine, SeedPlacement{.label = 4, .voxels = {{0, 0, 0}}});
    return engine;
}

std::vector<std::uint8_t> labelsOf(const ReferenceEngine& engine)
{
    reference::DenseFields fields = engine.fields();
    return fields.labels(0).values;
}

std::vector<std::uint32_t> wordsOf(const ReferenceEngine& engine)
{
    reference::DenseFields fields = engine.fields();
    return fields.seedWords(0).values;
}

} // namespace

ReferenceIntervalTest::Scene ReferenceIntervalTest::randomScene(test::Random& random, int labels)
{
    const glm::ivec3 size{test::randomInt(random, 3, 20), test::randomInt(random, 3, 20),
        test::randomInt(random, 3, 20)};
    Scene scene{.codes = random() % 2 ? test::balls(size, 5, random)
                                      : test::noiseVolume(size, test::tissueCode, random),
        .held = {size, {}},
        .seeds = {}};
    for (std::size_t i = 0; i < scene.codes.values.size(); ++i)
        scene.held.values.push_back(
            random() % 9 ? std::uint8_t(0) : std::uint8_t(test::randomInt(random, 1, 4)));
    for (int label = 1; label <= labels; ++label)
        scene.seeds.push_back({.label = std::uint8_t(label),
            .voxels = {test::randomVoxel(random, size), test::randomVoxel(random, size)}});
    if (random() % 2) {
        const Document document = test::randomDocument(size, random, false);
        const BarrierStroke stroke{.path = test::randomPath(document, random)};
        if (const auto barrier = paintBarrier(stroke, document)) {
            scene.barrier = *barrier;
            scene.path = capsules(stroke.path, document.volumes.front().geometry);
        }
    }
    return scene;
}

std::unique_ptr<ReferenceEngine> ReferenceIntervalTest::sketched(const Scene& scene)
{
    auto engine = std::make_unique<ReferenceEngine>();
    (void)engine->openVolume(scene.codes.size, scene.codes.values);
    engine->submit(SwapBricks{test::bricksOf(scene.held, Field::Labels, 0)});
    for (const SeedPlacement& placement : scene.seeds)
        submitWhole(*engine, placement);
    if (scene.barrier)
        submitWhole(*engine, *scene.barrier, {CapsulePath{scene.path}});
    return engine;
}

EngineResult ReferenceIntervalTest::grow(
    ReferenceEngine& engine, GrowBurst burst, std::uint32_t generation)
{
    burst.generation = generation;
    submitWhole(engine, burst, {GrowAdvance{}});
    return lastResult(engine);
}

void ReferenceIntervalTest::movesEqualGrowingFromScratch_data()
{
    QTest::addColumn<int>("seed");
    for (int seed = 0; seed < (test::longRun() ? 200 : 15); ++seed)
        QTest::addRow("%d", seed) << seed;
}

/// 50 moves, wider and narrower, of a growth of one label: after each the set is that of growing
/// from the same seeds anew, and every member has a parent that came before.
void ReferenceIntervalTest::movesEqualGrowingFromScratch()
{
    QFETCH(int, seed);
    test::Random random(std::uint32_t(8100 + seed));
    const Scene scene = randomScene(random, 1);
    const auto engine = sketched(scene);
    GrowBurst burst{.connectivity = std::array<int, 3>{6, 18, 26}[random() % 3]};
    std::uint32_t generation = 0;
    for (int move = 0; move < 50; ++move) {
        burst.lowCode = test::randomInt(random, 0, 600);
        burst.highCode = test::randomInt(random, 400, test::tissueCode);
        for (std::size_t label = 1; label <= 4; ++label)
            burst.overwritable[label] = random() % 2;
        burst.opening = GrowOpening::Narrow;
        const EngineResult result = grow(*engine, burst, generation);
        generation = result.generation;

        const auto scratch = sketched(scene);
        burst.opening = GrowOpening::GoOn;
        grow(*scratch, burst, 0);
        QCOMPARE(labelsOf(*engine), labelsOf(*scratch));
        const reference::DenseArray<std::uint32_t> words{scene.codes.size, wordsOf(*engine)};
        const std::vector<std::uint32_t> expected = wordsOf(*scratch);
        for (std::size_t at = 0; at < expected.size(); ++at) {
            const std::uint32_t word = words.values[at];
            QCOMPARE(seedWord::isMember(word), seedWord::isMember(expected[at]));
            QCOMPARE(word == seedWord::barrier, expected[at] == seedWord::barrier);
            QCOMPARE(seedWord::isPendingSeed(word), seedWord::isPendingSeed(expected[at]));
            if (!seedWord::isMember(word))
                continue;
            QVERIFY(seedWord::generation(word) <= generation);
            QCOMPARE(seedWord::isSeed(word), seedWord::isSeed(expected[at]));
            if (seedWord::direction(word) >= 29)
                continue;
            const int x = int(at) % scene.codes.size.x;
            const int y = int(at) / scene.codes.size.x % scene.codes.size.y;
            const int z = int(at) / scene.codes.size.x / scene.codes.size.y;
            const std::array<int, 3>& way = seedWord::offsets[seedWord::direction(word)];
            const std::uint32_t parent = words.at({x - way[0], y - way[1], z - way[2]});
            QVERIFY(seedWord::isMember(parent));
            QVERIFY(seedWord::generation(parent) < seedWord::generation(word));
        }
    }
}

void ReferenceIntervalTest::growingAnewEqualsScratchWordForWord()
{
    for (int seed = 0; seed < (test::longRun() ? 100 : 15); ++seed) {
        test::Random random(std::uint32_t(8400 + seed));
        const Scene scene = randomScene(random, 3);
        const auto engine = sketched(scene);
        GrowBurst burst{.connectivity = std::array<int, 3>{6, 18, 26}[random() % 3]};
        for (std::size_t label = 1; label <= 4; ++label)
            burst.overwritable[label] = random() % 2;
        std::uint32_t generation = 0;
        for (int move = 0; move < 10; ++move) {
            burst.lowCode = test::randomInt(random, 0, 300);
            burst.highCode = test::randomInt(random, 500, test::tissueCode);
            burst.opening = GrowOpening::Restart;
            const EngineResult result = grow(*engine, burst, generation);
            generation = result.generation;
            const auto scratch = sketched(scene);
            burst.opening = GrowOpening::GoOn;
            grow(*scratch, burst, 0);
            // A seed that waited, not accepted, where another label grew over it is gone for good.
            std::vector<std::uint32_t> expected = wordsOf(*scratch);
            const std::vector<std::uint32_t> words = wordsOf(*engine);
            bool overrun = false;
            for (std::size_t at = 0; at < words.size(); ++at)
                overrun = overrun
                    || (seedWord::isPendingSeed(expected[at])
                        && !seedWord::isPendingSeed(words[at]));
            if (overrun)
                break;
            QVERIFY(words == expected);
            QCOMPARE(labelsOf(*engine), labelsOf(*scratch));
        }
    }
}

void ReferenceIntervalTest::whatHungOnItLeavesAndComesBackLast()
{
    const auto engine = line({5, 5, 9, 5, 5, 1});
    grow(*engine, {.lowCode = 5, .highCode = 9}, 0);
    QCOMPARE(labelsOf(*engine), (std::vector<std::uint8_t>{4, 4, 4, 4, 4, 0}));
    GrowBurst narrow{.lowCode = 5, .highCode = 6, .opening = GrowOpening::Narrow};
    QCOMPARE(grow(*engine, narrow, 5).generation, 2u);
    QCOMPARE(labelsOf(*engine), (std::vector<std::uint8_t>{4, 4, 0, 0, 0, 0}));
    // Wider at the other end: all that comes is later than what is there.
    GrowBurst wide{.lowCode = 1, .highCode = 9, .opening = GrowOpening::Narrow};
    QCOMPARE(grow(*engine, wide, 2).generation, 6u);
    QCOMPARE(labelsOf(*engine), std::vector<std::uint8_t>(6, 4));
    submitWhole(*engine, ShrinkGrowth{.generation = 6, .keep = 2});
    QCOMPARE(labelsOf(*engine), (std::vector<std::uint8_t>{4, 4, 0, 0, 0, 0}));
    // A seed that does not qualify is no member, and waits.
    QCOMPARE(
        grow(*engine, {.lowCode = 6, .highCode = 9, .opening = GrowOpening::Narrow}, 2).generation,
        0u);
    QCOMPARE(labelsOf(*engine), std::vector<std::uint8_t>(6, 0));
    QCOMPARE(wordsOf(*engine).front(), seedWord::pendingSeed(4));
    QCOMPARE(grow(*engine, wide, 0).generation, 6u);
    QCOMPARE(labelsOf(*engine), std::vector<std::uint8_t>(6, 4));
}

namespace {

/// Along a line of voxels, 1 mm apart: those from first to last.
PaintBarrier barrierOn(int first, int last, std::vector<Capsule>& path)
{
    constexpr int mm = 65536;
    PaintBarrier barrier;
    barrier.frame.perI = {std::int64_t(1) << 30, 0, 0};
    barrier.frame.perJ = {0, std::int64_t(1) << 30, 0};
    barrier.frame.perK = {0, 0, std::int64_t(1) << 30};
    barrier.frame.radius = mm / 4;
    barrier.frame.rampHalfWidth = 1;
    barrier.frame.reach = 20 * mm;
    while (barrier.frame.reach >> barrier.frame.shift >= 1 << 14)
        ++barrier.frame.shift;
    path = {
        {.from = {first * mm, 0, 0}, .direction = {1 << 14, 0, 0}, .length = (last - first) * mm}};
    return barrier;
}

} // namespace

void ReferenceIntervalTest::barriersShutAndLetThrough()
{
    const auto engine = line(std::vector<std::uint16_t>(8, 5));
    std::vector<Capsule> path;
    PaintBarrier barrier = barrierOn(3, 4, path);
    submitWhole(*engine, barrier, {CapsulePath{path}});
    QCOMPARE(grow(*engine, {.lowCode = 5, .highCode = 5}, 0).generation, 3u);
    QCOMPARE(labelsOf(*engine), (std::vector<std::uint8_t>{4, 4, 4, 0, 0, 0, 0, 0}));
    barrier.erase = true;
    submitWhole(*engine, barrier, {CapsulePath{path}});
    QCOMPARE(grow(*engine, {.lowCode = 5, .highCode = 5}, 3).generation, 8u);
    QCOMPARE(labelsOf(*engine), std::vector<std::uint8_t>(8, 4));
    // What had grown under one goes; what hung on it stays until the growth is asked again.
    barrier.erase = false;
    submitWhole(*engine, barrier, {CapsulePath{path}});
    QCOMPARE(labelsOf(*engine), (std::vector<std::uint8_t>{4, 4, 4, 0, 0, 4, 4, 4}));
    grow(*engine, {.lowCode = 5, .highCode = 5, .opening = GrowOpening::Narrow}, 8);
    QCOMPARE(labelsOf(*engine), (std::vector<std::uint8_t>{4, 4, 4, 0, 0, 0, 0, 0}));
}

void ReferenceIntervalTest::barriersLeaveWhatIsLockedOrPainted()
{
    const auto engine = line(std::vector<std::uint16_t>(8, 5));
    // The label holds the fifth already.
    test::Bytes held{{8, 1, 1}, {0, 0, 0, 0, 4, 0, 0, 0}};
    engine->submit(SwapBricks{test::bricksOf(held, Field::Labels, 0)});
    grow(*engine, {.lowCode = 5, .highCode = 5}, 0);
    const std::vector<std::uint32_t> grown = wordsOf(*engine);
    std::vector<Capsule> path;
    PaintBarrier barrier = barrierOn(2, 5, path);
    barrier.lockedLabels.set(4);
    submitWhole(*engine, barrier, {CapsulePath{path}});
    QVERIFY(wordsOf(*engine) == grown);
    barrier.lockedLabels.reset();
    submitWhole(*engine, barrier, {CapsulePath{path}});
    QCOMPARE(labelsOf(*engine), (std::vector<std::uint8_t>{4, 4, 0, 0, 4, 0, 4, 4}));
    for (std::size_t at = 2; at <= 5; ++at)
        QCOMPARE(wordsOf(*engine)[at], seedWord::barrier);
}

BURIN_TEST(ReferenceIntervalTest)

} // namespace referenceIntervalTest

#include "ReferenceIntervalTest.moc"
