// SPDX-License-Identifier: Apache-2.0
#include "core/growth/front/OpenVoxels.h"
#include "core/growth/SeedWord.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/program/LongRun.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/TestVolumes.h"

#include <QTest>

#include <vector>

namespace openVoxelsTest {

using namespace core;

namespace {

constexpr int side = BrickGrid::side;

/// As GrowthCommands.h and GrowthRange.h define it, voxel by voxel.
bool mayBeClaimed(const GrowBurst& burst, std::uint8_t label, const glm::ivec3& volumeSize,
    const glm::ivec3& voxel, int code, std::uint32_t word, std::uint8_t there)
{
    if (glm::any(glm::greaterThanEqual(voxel, volumeSize)))
        return false;
    if (word == seedWord::barrier || seedWord::isMember(word))
        return false;
    if (there != 0 && there != label && !burst.overwritable.test(there))
        return false;
    if (burst.range
        && (code < burst.range->lowCode || code > burst.range->highCode
            || burst.range->closed.test(there)))
        return false;
    const GrowLimits& limits = burst.limits;
    if (limits.boxed
        && (glm::any(glm::lessThan(voxel, limits.boxFrom))
            || glm::any(glm::greaterThan(voxel, limits.boxTo))))
        return false;
    return code >= burst.lowCode && code <= burst.highCode;
}

GrowBurst randomBurst(test::Random& random)
{
    GrowBurst burst;
    burst.lowCode = test::randomInt(random, -3, 6);
    burst.highCode = test::randomInt(random, 2, 12);
    if (test::randomInt(random, 0, 1) == 0)
        burst.overwritable.set(std::size_t(test::randomInt(random, 1, 3)));
    if (test::randomInt(random, 0, 1) == 0) {
        burst.range = GrowthRange{.lowCode = test::randomInt(random, 0, 4),
            .highCode = test::randomInt(random, 3, 65535)};
        burst.range->closed.set(std::size_t(test::randomInt(random, 0, 3)));
    }
    if (test::randomInt(random, 0, 1) == 0) {
        burst.limits.boxed = true;
        for (int axis = 0; axis < 3; ++axis) {
            burst.limits.boxFrom[axis] = test::randomInt(random, -5, 30);
            burst.limits.boxTo[axis] = test::randomInt(random, 10, 60);
        }
    }
    return burst;
}

} // namespace

class OpenVoxelsTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }
    void areThoseOfTheDefinition();
    void furtherLimitsAreNotItsBusiness();
};

void OpenVoxelsTest::areThoseOfTheDefinition()
{
    test::Random random(8121);
    int open = 0;
    for (int round = 0; round < (test::longRun() ? 3000 : 150); ++round) {
        const GrowBurst burst = randomBurst(random);
        const auto label = std::uint8_t(test::randomInt(random, 1, 3));
        const glm::ivec3 origin =
            side * glm::ivec3(test::randomInt(random, 0, 1), test::randomInt(random, 0, 1), 1);
        const glm::ivec3 volumeSize =
            origin + glm::ivec3(test::randomInt(random, 1, side), side, 9);
        std::vector<std::uint16_t> codes;
        std::vector<std::uint32_t> words;
        std::vector<std::uint8_t> labels;
        const std::uint32_t kinds[]{seedWord::unvisited, seedWord::barrier,
            seedWord::pendingSeed(label), seedWord::member(3, label, 2)};
        for (int i = 0; i < BrickGrid::voxelsPerBrick; ++i) {
            codes.push_back(std::uint16_t(test::randomInt(random, 0, 10)));
            words.push_back(kinds[test::randomInt(random, 0, 3)]);
            labels.push_back(std::uint8_t(test::randomInt(random, 0, 3)));
        }
        const bool isNew = round % 3 == 0; // no seed words yet
        const bool isUnlabelled = round % 5 == 0;
        const std::optional<OpenRule> rule = openRule(burst, label, volumeSize);
        QVERIFY(rule);
        AskedBrick brick{.origin = origin, .codes = codes};
        if (!isNew)
            brick.words = words;
        if (!isUnlabelled)
            brick.labels = labels;
        const VoxelBits found = openVoxels(*rule, brick);
        for (int i = 0; i < BrickGrid::voxelsPerBrick; ++i) {
            const glm::ivec3 inBrick(i % side, i / side % side, i / (side * side));
            const auto at = std::size_t(i);
            const bool wanted = mayBeClaimed(burst, label, volumeSize, origin + inBrick, codes[at],
                isNew ? seedWord::unvisited : words[at], isUnlabelled ? 0 : labels[at]);
            const bool actual =
                (found[std::size_t(inBrick.y + side * inBrick.z)] >> inBrick.x & 1) != 0;
            QCOMPARE(actual, wanted);
            open += wanted ? 1 : 0;
        }
    }
    QVERIFY(open > 10000);
}

/// What asks for more than a voxel's own code is left to the kernel.
void OpenVoxelsTest::furtherLimitsAreNotItsBusiness()
{
    const GrowLimits further[]{{.gradient = 3}, {.majority = 14}, {.smoothed = true},
        {.onlyVisible = true}, {.sigmas256 = 512}, {.difference = 2}, {.gradientDifference = 2},
        {.passage = {.spacing = glm::ivec3(1), .reach = 4}}};
    for (const GrowLimits& limits : further)
        QVERIFY(!openRule({.limits = limits}, 1, glm::ivec3(16)));
    QVERIFY(openRule({}, 1, glm::ivec3(16)));
    QVERIFY(openRule({.limits = {.gradientWeights = glm::ivec3(5)}}, 1, glm::ivec3(16)));
}

BURIN_TEST(OpenVoxelsTest)

} // namespace openVoxelsTest

#include "OpenVoxelsTest.moc"
