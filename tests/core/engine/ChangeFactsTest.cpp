// SPDX-License-Identifier: Apache-2.0
#include "core/engine/ChangeFacts.h"

#include "core/growth/SeedWord.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/TestVolumes.h"

#include <QtTest>

#include <map>
#include <set>

namespace changeFactsTest {

using namespace core;

namespace {

constexpr std::size_t voxels = BrickGrid::voxelsPerBrick;

std::vector<std::uint8_t> randomValues(test::Random& random, int highest)
{
    std::vector<std::uint8_t> values(voxels, 0);
    for (std::uint8_t& value : values) {
        if (test::randomInt(random, 0, 2) == 0)
            value = std::uint8_t(test::randomInt(random, 0, highest));
    }
    return values;
}

std::uint32_t randomWord(test::Random& random)
{
    const auto label = std::uint32_t(test::randomInt(random, 1, 4));
    switch (test::randomInt(random, 0, 4)) {
    case 0:
        return seedWord::barrier;
    case 1:
        return seedWord::pendingSeed(label);
    case 2:
        return seedWord::member(std::uint32_t(test::randomInt(random, 1, 9)), label,
            std::uint32_t(test::randomInt(random, 0, 25)));
    case 3:
        return seedWord::member(
            std::uint32_t(test::randomInt(random, 20, 30)), label, seedWord::seedDirection);
    default:
        return seedWord::unvisited;
    }
}

std::vector<std::uint8_t> randomWords(test::Random& random)
{
    std::vector<std::uint8_t> bytes;
    for (std::size_t i = 0; i < voxels; ++i) {
        const std::uint32_t word = randomWord(random);
        for (int shift = 0; shift < 32; shift += 8)
            bytes.push_back(std::uint8_t(word >> shift));
    }
    return bytes;
}

/// No bytes now and then: such a brick is empty.
BrickBytes orNothing(test::Random& random, std::vector<std::uint8_t> bytes)
{
    return test::randomInt(random, 0, 3) == 0 ? BrickBytes() : BrickBytes(std::move(bytes));
}

std::vector<BrickChange> randomChanges(test::Random& random, int bricks)
{
    std::vector<BrickChange> changes;
    for (const Field field :
        {Field::Coverage, Field::Labels, Field::SeedWords, Field::Overwritten}) {
        for (int brick = 0; brick < bricks; ++brick) {
            if (test::randomInt(random, 0, 2) == 0)
                continue;
            const auto image = [&] {
                return orNothing(random,
                    field == Field::SeedWords ? randomWords(random) : randomValues(random, 5));
            };
            const auto plane = std::uint8_t(test::randomInt(random, 0, 1));
            changes.push_back(
                {.key = {field, plane, std::uint32_t(brick)}, .before = image(), .after = image()});
        }
    }
    return changes;
}

/// What is true of changes, voxel by voxel and as slowly as can be.
struct Truth {
    std::int64_t voxelsChanged = 0;
    std::int64_t words = 0;
    std::int64_t lost = 0;
    std::int64_t grown = 0;
    std::map<std::uint8_t, std::uint32_t> greatest; ///< by plane
    std::set<std::uint32_t> seeds;
    std::map<std::pair<int, int>, std::pair<std::int64_t, std::int64_t>> flows;

    explicit Truth(const std::vector<BrickChange>& changes)
    {
        const auto valueOf = [](const BrickBytes& bytes, std::size_t voxel) {
            return bytes.empty() ? 0 : int(bytes.read()[voxel]);
        };
        const auto wordOf = [](const BrickBytes& bytes, std::size_t voxel) {
            return bytes.empty() ? seedWord::unvisited : seedWord::wordAt(&bytes.read()[4 * voxel]);
        };
        for (const BrickChange& change : changes) {
            for (std::size_t voxel = 0; voxel < voxels; ++voxel) {
                if (change.key.field == Field::SeedWords) {
                    const std::uint32_t word = wordOf(change.after, voxel);
                    words += word != wordOf(change.before, voxel) ? 1 : 0;
                    if (seedWord::isMember(word)) {
                        std::uint32_t& known = greatest[change.key.plane];
                        known = std::max(known, seedWord::generation(word));
                        if (seedWord::isSeed(word))
                            seeds.insert(seedWord::generation(word));
                    }
                    continue;
                }
                const int before = valueOf(change.before, voxel);
                const int after = valueOf(change.after, voxel);
                if (before == after || change.key.field == Field::Overwritten)
                    continue;
                ++voxelsChanged;
                if (change.key.field != Field::Labels)
                    continue;
                ++flows[{change.key.plane, after}].first;
                ++flows[{change.key.plane, before}].second;
                bool isGivenBack = false;
                for (const BrickChange& other : changes) {
                    if (other.key
                        == BrickKey{Field::Overwritten, change.key.plane, change.key.brick})
                        isGivenBack = after == valueOf(other.before, voxel)
                            && valueOf(other.after, voxel) == 0;
                }
                ++(after == 0 || isGivenBack ? lost : grown);
            }
        }
    }
};

} // namespace

class ChangeFactsTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    void countsWhatIsThere_data()
    {
        QTest::addColumn<int>("bricks");
        QTest::newRow("none") << 0;
        QTest::newRow("one") << 1;
        QTest::newRow("some") << 12;
        QTest::newRow("for several threads") << 700;
    }
    void countsWhatIsThere()
    {
        QFETCH(int, bricks);
        test::Random random{std::uint32_t(bricks + 3)};
        const BrickGrid grid{{16 * 50, 16 * 14, 16}};
        const std::vector<BrickChange> changes = randomChanges(random, bricks);
        const ChangeFacts facts = factsOf(changes, grid);
        const Truth truth(changes);

        QCOMPARE(facts.bricksOfAllFields, int(changes.size()));
        QCOMPARE(facts.empty(), changes.empty());
        QCOMPARE(facts.voxelsChanged, truth.voxelsChanged);
        QCOMPARE(facts.seedWordsChanged, truth.words);
        QCOMPARE(facts.labelsLost, truth.lost);
        QCOMPARE(facts.labelsGrown, truth.grown);
        for (const std::uint8_t plane : {0, 1, 2}) {
            const auto known = truth.greatest.find(plane);
            QCOMPARE(facts.greatestGeneration(plane),
                known == truth.greatest.end() ? 0u : known->second);
        }
        QCOMPARE(
            std::set<std::uint32_t>(facts.seedGenerations.begin(), facts.seedGenerations.end()),
            truth.seeds);
        for (std::uint32_t generation = 0; generation < 32; ++generation)
            QCOMPARE(facts.admittedSeedsAt(generation), truth.seeds.contains(generation));
        std::size_t flows = 0;
        for (const auto& [which, flow] : truth.flows) {
            if (which.second == 0)
                continue;
            ++flows;
            const LabelFlow told = facts.flow(std::uint8_t(which.first), which.second);
            QCOMPARE(told.gained, flow.first);
            QCOMPARE(told.lost, flow.second);
        }
        QCOMPARE(facts.flows.size(), flows);
        QCOMPARE(facts.flow(0, 200).gained, std::int64_t(0));
    }

    void boxesSurroundTheBricks()
    {
        const BrickGrid grid{{40, 40, 40}};
        const std::vector<std::uint8_t> ones(voxels, 1);
        const ChangeFacts facts =
            factsOf({{.key = {Field::Coverage, 1, 0}, .before = {}, .after = ones},
                        {.key = {Field::Coverage, 2, 1}, .before = {}, .after = ones},
                        {.key = {Field::Labels, 0, 26}, .before = ones, .after = {}}},
                grid);
        QVERIFY(facts.coverage.minimum == glm::ivec3(0));
        QVERIFY(facts.coverage.maximum == glm::ivec3(32, 16, 16));
        QVERIFY(facts.labels.minimum == glm::ivec3(32));
        QVERIFY(facts.labels.maximum == glm::ivec3(40));
        QVERIFY(facts.seedWords.empty());
        QCOMPARE(facts.bricks, 3);
    }
};

BURIN_TEST(ChangeFactsTest)

} // namespace changeFactsTest

#include "ChangeFactsTest.moc"
