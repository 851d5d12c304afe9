// SPDX-License-Identifier: Apache-2.0
#include "tests/support/cases/EngineCases.h"
#include "tests/support/cases/growth/GrowthAnswers.h"

#include <array>

namespace test {

namespace {

using core::GrowAdvance;
using core::GrowBurst;

/// One label in matter with holes: fronts that are wide for their bricks, until they are not.
EngineCase wide(int number)
{
    Random random(std::uint32_t(81000 + number));
    Random smoothings(std::uint32_t(82000 + number));
    Random ranges(std::uint32_t(42000 + number));
    const glm::ivec3 size{
        randomInt(random, 20, 70), randomInt(random, 18, 60), randomInt(random, 18, 50)};
    EngineCase made{"wide front " + QByteArray::number(number),
        random() % 3 ? noiseVolume(size, 1000, random) : balls(size, 9, random), {}};
    if (random() % 2) {
        // Of the label itself, of others that give way and that do not.
        Bytes painted{size, {}};
        for (int z = 0; z < size.z; ++z)
            for (int y = 0; y < size.y; ++y)
                for (int x = 0; x < size.x; ++x)
                    painted.values.push_back(
                        std::uint8_t((x / 5 + y / 7 + z / 6) % 4 ? 0 : randomInt(random, 0, 3)));
        made.steps.push_back(
            core::EngineCommand(core::SwapBricks{bricksOf(painted, core::Field::Labels, 0)}));
    }
    for (int bursts = randomInt(random, 1, 3); bursts > 0; --bursts) {
        core::SeedPlacement seeds{.label = std::uint8_t(random() % 8 ? 1 : 2)};
        appendSeeds(made.steps, seeds, random() % 3 ? 1 : 40, size, random);
        const int low = randomInt(random, 0, 500);
        GrowBurst burst{.lowCode = low,
            .highCode = randomInt(random, 700, 2000),
            .connectivity = std::array<int, 3>{6, 18, 26}[random() % 3]};
        burst.overwritable[2] = random() % 2;
        burst.tellsHeld = random() % 2;
        if (random() % 4 == 0)
            burst.limits.majority = randomInt(random, 8, 18);
        burst.limits.smoothed = smoothings() % 5 == 0;
        if (number % 2)
            burst.range = randomGrowthRange(2000, ranges);
        if (random() % 4 == 0) {
            burst.limits.boxed = true;
            burst.limits.boxFrom = glm::ivec3(3);
            burst.limits.boxTo = size - 5;
        }
        made.steps.push_back(BeginGrowth{burst});
        for (int portions = randomInt(random, 0, 3); portions > 0; --portions)
            made.steps.push_back(
                core::EngineCommand(core::ExtendEdit{GrowAdvance{randomInt(random, 1, 24)}}));
        if (random() % 3)
            made.steps.push_back(
                core::EngineCommand(core::ExtendEdit{GrowAdvance{GrowAdvance::toClosure}}));
        made.steps.push_back(core::EngineCommand(
            core::EndEdit{random() % 6 ? core::Ending::Commit : core::Ending::Rollback}));
        if (random() % 3 == 0)
            made.steps.push_back(
                Shrink{.shrink = {}, .generations = std::uint32_t(randomInt(random, 0, 20))});
        if (random() % 4 == 0)
            made.steps.push_back(Undo{});
    }
    return made;
}

} // namespace

std::vector<EngineCase> wideGrowthCases(int randomCount)
{
    std::vector<EngineCase> cases;
    for (int number = 0; number < randomCount; ++number)
        cases.push_back(daily(wide(number)));
    return cases;
}

} // namespace test
