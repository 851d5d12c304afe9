// SPDX-License-Identifier: Apache-2.0
#include "core/growth/interval/IntervalOpener.h"
#include "tests/reference/growth/Growth.h"
#include "tests/support/program/LongRun.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/TestVolumes.h"

#include <QTest>

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

namespace intervalOpenerTest {

using namespace core;
using reference::DenseFields;
using test::Codes;
using test::Random;
using test::randomInt;

namespace {

/// A study with a growth, as an engine would hold it.
struct Scene {
    Codes codes;
    DenseFields fields;
    std::uint32_t generation = 0;

    [[nodiscard]] BrickGrid grid() const { return {codes.size}; }
    [[nodiscard]] std::vector<std::uint32_t> heldBricks() const
    {
        std::vector<std::uint32_t> held;
        for (std::uint32_t brick = 0; brick < std::uint32_t(grid().brickCount()); ++brick) {
            if (!fields.readBrick({Field::SeedWords, 0, brick}).empty())
                held.push_back(brick);
        }
        return held;
    }
    [[nodiscard]] std::vector<GrowthBrick> read(std::span<const std::uint32_t> bricks) const
    {
        std::vector<GrowthBrick> contents;
        for (const std::uint32_t brick : bricks) {
            GrowthBrick content{.words = fields.readBrick({Field::SeedWords, 0, brick}),
                .labels = fields.readBrick({Field::Labels, 0, brick}),
                .overwritten = fields.readBrick({Field::Overwritten, 0, brick}),
                .codes = std::vector<std::uint16_t>(BrickGrid::voxelsPerBrick, 500)};
            const VoxelBox box = grid().boxOf(int(brick));
            for (int z = box.minimum.z; z < box.maximum.z; ++z)
                for (int y = box.minimum.y; y < box.maximum.y; ++y)
                    for (int x = box.minimum.x; x < box.maximum.x; ++x)
                        content.codes[std::size_t(BrickGrid::offsetInBrick({x, y, z}))] =
                            codes.at({x, y, z});
            contents.push_back(std::move(content));
        }
        return contents;
    }
    [[nodiscard]] std::unique_ptr<IntervalOpener> prepared(const GrowBurst& burst) const
    {
        return IntervalOpener::prepare(burst, grid(), heldBricks(),
            [this](std::span<const std::uint32_t> bricks) { return read(bricks); });
    }
    /// Opens a burst as the rules say and takes so many steps. @return the generation after opening
    std::uint32_t grow(const GrowBurst& burst, int steps)
    {
        reference::Growth growth(codes, {}, fields, burst);
        const std::uint32_t opened = growth.generation();
        growth.advance(steps);
        generation = growth.generation();
        return opened;
    }
};

/// The members that can claim a neighbour, by asking all of them (GrowBurst, "Step").
std::vector<LeakGuard::Voxel> frontOf(Scene& scene, const GrowBurst& burst)
{
    const auto& words = scene.fields.seedWords(0);
    const auto& labels = scene.fields.labels(0);
    const glm::ivec3 size = scene.codes.size;
    const auto claims = [&](const glm::ivec3& from, const glm::ivec3& to) {
        const std::uint32_t label = seedWord::label(words.at(from));
        if (!words.contains(to) || seedWord::isMember(words.at(to))
            || words.at(to) == seedWord::barrier)
            return false;
        const int code = scene.codes.at(to);
        const std::uint8_t held = labels.at(to);
        const bool inBox = !burst.limits.boxed
            || (glm::all(glm::greaterThanEqual(to, burst.limits.boxFrom))
                && glm::all(glm::lessThanEqual(to, burst.limits.boxTo)));
        return code >= burst.lowCode && code <= burst.highCode && inBox
            && (held == 0 || held == label || burst.overwritable.test(held));
    };
    std::vector<LeakGuard::Voxel> front;
    for (int z = 0; z < size.z; ++z) {
        for (int y = 0; y < size.y; ++y) {
            for (int x = 0; x < size.x; ++x) {
                const glm::ivec3 from(x, y, z);
                const std::uint32_t word = words.at(from);
                if (!seedWord::isMember(word) || burst.lockedLabels.test(seedWord::label(word)))
                    continue;
                for (int direction = 0; direction < burst.connectivity; ++direction) {
                    const auto& way = seedWord::offsets[std::size_t(direction)];
                    if (claims(from, from + glm::ivec3(way[0], way[1], way[2]))) {
                        front.push_back(BrickVoxel::of(scene.grid(), from));
                        break;
                    }
                }
            }
        }
    }
    std::sort(front.begin(), front.end());
    return front;
}

/// What is not to be taken for granted: erased places, barriers, paint and strange directions.
void disturb(Scene& scene, Random& random)
{
    auto& words = scene.fields.seedWords(0);
    auto& labels = scene.fields.labels(0);
    for (int i = randomInt(random, 0, 40); i > 0; --i) {
        const glm::ivec3 voxel = test::randomVoxel(random, scene.codes.size);
        std::uint32_t& word = words.at(voxel);
        switch (randomInt(random, 0, 4)) {
        case 0:
            reference::setOrClearBarrier(scene.fields, 0, randomInt(random, 0, 2) == 0, {}, voxel);
            break;
        case 1:
            word = seedWord::unvisited;
            break;
        case 2:
            word = seedWord::member(0, 1, seedWord::heldDirection);
            labels.at(voxel) = 1;
            break;
        case 3:
            labels.at(voxel) = std::uint8_t(randomInt(random, 0, 4));
            break;
        default:
            if (!seedWord::isMember(word))
                word = std::min(word, seedWord::pendingSeed(1));
        }
    }
}

} // namespace

/// An interval that moves over a finished growth becomes what opening a burst with that interval
/// makes of it, word for word; the oracle asks every voxel each time.
class IntervalOpenerTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void everyOpeningIsThatOfTheOracle()
    {
        for (int seed = 0; seed < (test::longRun() ? 2000 : 150); ++seed) {
            move(seed);
            QVERIFY2(!QTest::currentTestFailed(), QByteArray::number(seed).constData());
        }
        // Otherwise the moves have shown nothing.
        QVERIFY2(m_withdrawn > 10'000, QByteArray::number(qulonglong(m_withdrawn)).constData());
        QVERIFY2(m_reached > 10'000, QByteArray::number(qulonglong(m_reached)).constData());
        QVERIFY2(m_admitted > 100, QByteArray::number(qulonglong(m_admitted)).constData());
    }

    /// A corridor of one voxel: what lies beyond an excluded place leaves with it.
    void whatHungOnItLeaves()
    {
        Scene scene{
            .codes = test::constantVolume({40, 1, 1}, 100), .fields = DenseFields({40, 1, 1})};
        scene.codes.at({20, 0, 0}) = 50;
        scene.codes.at({30, 0, 0}) = 10;
        reference::placeSeeds(scene.fields, {.label = 7, .voxels = {{0, 0, 0}}});
        GrowBurst burst{.lowCode = 50, .highCode = 200};
        scene.grow(burst, -1);
        QCOMPARE(scene.generation, 30u);
        burst.opening = GrowOpening::Narrow;
        burst.generation = scene.generation;
        const auto opener = scene.prepared(burst);
        QVERIFY(opener);
        QCOMPARE(opener->suspended().count(), std::size_t(1));
        QCOMPARE(opener->suspended().within(10, 10).size(), std::size_t(1));
        QVERIFY(opener->suspended().within(11, 200).empty());

        const OpenedInterval narrower = opener->open(51, 200);
        QCOMPARE(narrower.withdrawn, std::size_t(10));
        QCOMPARE(narrower.kept, 20u);
        QVERIFY(narrower.front.empty());
        const OpenedInterval wider = opener->open(10, 200);
        QCOMPARE(wider.withdrawn, std::size_t(0));
        QCOMPARE(wider.kept, 30u);
        QCOMPARE(
            wider.front, std::vector<LeakGuard::Voxel>{BrickVoxel::of(scene.grid(), {29, 0, 0})});
        QVERIFY(opener->bricks().changes().empty());
    }

    void othersAreOpenedAsBefore()
    {
        GrowBurst burst{.lowCode = 0, .highCode = 9};
        QVERIFY(!IntervalOpener::suits(burst)); // it goes on
        burst.opening = GrowOpening::Restart;
        QVERIFY(!IntervalOpener::suits(burst));
        burst.opening = GrowOpening::Narrow;
        QVERIFY(IntervalOpener::suits(burst));
        for (const int kind : {0, 1, 2, 3, 4}) {
            GrowBurst other = burst;
            if (kind == 0)
                other.limits.sigmas256 = 512;
            if (kind == 1)
                other.limits.gradient = 5;
            if (kind == 2)
                other.limits.majority = 14;
            if (kind == 3)
                other.limits.onlyVisible = true;
            if (kind == 4)
                other.limits.smoothed = true;
            QVERIFY(!IntervalOpener::suits(other));
        }

        Scene two{.codes = test::constantVolume({9, 9, 9}, 5), .fields = DenseFields({9, 9, 9})};
        QVERIFY(!two.prepared(burst)); // no label at all
        reference::placeSeeds(two.fields, {.label = 1, .voxels = {{0, 0, 0}}});
        const auto opener = two.prepared(burst);
        QVERIFY(opener);
        GrowBurst guarded = burst;
        guarded.lowCode = 3;
        guarded.guard.emplace();
        QVERIFY(opener->serves(guarded));
        GrowBurst wider = burst;
        wider.connectivity = 26;
        QVERIFY(!opener->serves(wider));
        reference::placeSeeds(two.fields, {.label = 2, .voxels = {{8, 8, 8}}});
        QVERIFY(!two.prepared(burst)); // two that compete
        burst.lockedLabels[2] = true;
        QVERIFY(two.prepared(burst)); // one of them stands still
    }

private:
    /// One random growth and eight moves.
    void move(int seed)
    {
        Random random(std::uint32_t(61000 + seed));
        const glm::ivec3 size{
            randomInt(random, 1, 36), randomInt(random, 2, 36), randomInt(random, 2, 20)};
        // Few values make ties of generation and direction common.
        const int greatest = std::array<int, 3>{3, 40, test::tissueCode}[std::size_t(seed) % 3];
        Scene scene{.codes = seed % 3 == 2 && random() % 2
                ? test::balls(size, 6, random)
                : test::noiseVolume(size, greatest, random),
            .fields = DenseFields(size)};
        if (random() % 2)
            scene.fields.labels(0) = test::labelBoxes(size, 6, random);
        const auto randomInterval = [&](GrowBurst& burst) {
            burst.lowCode = randomInt(random, 0, greatest / 2);
            burst.highCode = randomInt(random, greatest / 2 - 1, greatest);
        };
        GrowBurst burst{.connectivity = std::array<int, 3>{6, 18, 26}[random() % 3]};
        burst.overwritable[3] = random() % 3 == 0;
        burst.overwritable[4] = random() % 2 == 0;
        burst.tellsHeld = random() % 5 != 0;
        randomInterval(burst);
        if (random() % 4 == 0) { // a locked label stands in the way, with words of its own
            reference::placeSeeds(scene.fields,
                {.label = 2,
                    .voxels = {test::randomVoxel(random, size), test::randomVoxel(random, size)}});
            scene.grow(burst, 3);
        }
        burst.lockedLabels[2] = true;
        core::SeedPlacement seeds{.label = 1};
        for (int i = randomInt(random, 1, 4); i > 0; --i)
            seeds.voxels.push_back(test::randomVoxel(random, size));
        reference::placeSeeds(scene.fields, seeds);
        if (random() % 4 == 0) {
            burst.limits.boxed = true;
            burst.limits.boxFrom = size / 5;
            burst.limits.boxTo = size - 1;
        }
        // Growths whose interval was changed before, some of which were stopped early.
        for (int round = randomInt(random, 1, 3); round > 0; --round) {
            burst.generation = scene.generation;
            scene.grow(burst, random() % 3 ? -1 : randomInt(random, 0, 6));
            burst.opening = GrowOpening::Narrow;
            randomInterval(burst);
        }
        if (random() % 2)
            disturb(scene, random);
        burst.generation = scene.generation;

        const auto opener = scene.prepared(burst);
        const std::vector<std::uint32_t>& words = scene.fields.seedWords(0).values;
        const bool isThere = std::any_of(words.begin(), words.end(), [](std::uint32_t word) {
            return (seedWord::isMember(word) || seedWord::isPendingSeed(word))
                && seedWord::label(word) == 1;
        });
        QCOMPARE(bool(opener), isThere);
        if (!opener)
            return;
        for (int move = 0; move < 8; ++move) {
            randomInterval(burst);
            if (move == 5)
                burst.highCode = burst.lowCode - 1; // nothing stays but what was painted
            QVERIFY(opener->serves(burst));
            const OpenedInterval opened = opener->open(burst.lowCode, burst.highCode);

            Scene expected = scene;
            const std::uint32_t generation = expected.grow(burst, 0);
            QCOMPARE(opened.kept + (opened.admitted.empty() ? 0u : 1u), generation);
            Scene found = scene;
            for (const GrowthChange& change : opener->bricks().changes()) {
                const BrickVoxel changed{
                    .brick = change.brick, .offset = change.labelsAndOffset >> 16};
                const glm::ivec3 voxel = changed.place(scene.grid());
                found.fields.seedWords(0).at(voxel) = change.word;
                found.fields.labels(0).at(voxel) = std::uint8_t(change.labelsAndOffset);
                found.fields.overwritten(0).at(voxel) = std::uint8_t(change.labelsAndOffset >> 8);
            }
            QCOMPARE(found.fields.seedWords(0).values, expected.fields.seedWords(0).values);
            QCOMPARE(found.fields.labels(0).values, expected.fields.labels(0).values);
            QCOMPARE(found.fields.overwritten(0).values, expected.fields.overwritten(0).values);
            QCOMPARE(opened.front, frontOf(expected, burst));
            for (const LeakGuard::Voxel voxel : opened.admitted) {
                const std::uint32_t word = found.fields.seedWords(0).at(voxel.place(scene.grid()));
                QVERIFY(seedWord::isMember(word) && seedWord::isSeed(word));
                QCOMPARE(seedWord::generation(word), generation);
            }

            // And so it goes on: grown from there to closure, it is what the change is to become.
            GrowBurst goesOn = burst;
            goesOn.opening = GrowOpening::GoOn;
            goesOn.generation = generation;
            found.grow(goesOn, -1);
            Scene whole = scene;
            whole.grow(burst, -1);
            QCOMPARE(found.generation, whole.generation);
            QVERIFY(DenseFields::changes(found.fields, whole.fields).empty());
            m_withdrawn += opened.withdrawn;
            m_reached += opened.front.size();
            m_admitted += opened.admitted.size();
        }
    }

    std::size_t m_withdrawn = 0;
    std::size_t m_reached = 0;
    std::size_t m_admitted = 0;
};

BURIN_PLAIN_TEST(IntervalOpenerTest)

} // namespace intervalOpenerTest

#include "IntervalOpenerTest.moc"
