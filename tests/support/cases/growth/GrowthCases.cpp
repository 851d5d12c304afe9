// SPDX-License-Identifier: Apache-2.0

#include "core/growth/SeedWord.h"
#include "tests/support/cases/EngineCases.h"

#include <algorithm>
#include <array>

namespace test {

namespace {

using core::GrowAdvance;
using core::GrowBurst;
using core::SeedPlacement;

/// A growth as a session tells it: begin, advance in these portions, end.
void appendGrowth(std::vector<EngineStep>& steps, const GrowBurst& burst,
    const std::vector<int>& portions, core::Ending ending = core::Ending::Commit)
{
    steps.push_back(BeginGrowth{burst});
    for (const int portion : portions) {
        const double pace = portion % 2 ? 400.0 : 0.0; // changes no result
        steps.push_back(command(core::ExtendEdit{GrowAdvance{portion, pace}}));
        if (portion > 0) {
            // A finished generation shows at once.
            steps.push_back(Settle{});
            steps.push_back(command(core::ProbeVoxels{{{0, 0, 0}}, burst.plane}));
            steps.push_back(command(core::ReadBricks{
                {{core::Field::Labels, burst.plane, 0}, {core::Field::SeedWords, burst.plane, 0},
                    {core::Field::Overwritten, burst.plane, 0}}}));
        }
    }
    steps.push_back(command(core::EndEdit{ending}));
}

std::vector<glm::ivec3> corners(const glm::ivec3& size)
{
    std::vector<glm::ivec3> all;
    for (int corner = 0; corner < 8; ++corner)
        all.push_back({corner & 1 ? size.x - 1 : 0, corner & 2 ? size.y - 1 : 0,
            corner & 4 ? size.z - 1 : 0});
    return all;
}

constexpr int growthClosure = GrowAdvance::toClosure;
const GrowBurst wholeRange{.lowCode = 0, .highCode = 65535};
const GrowBurst tissue{.lowCode = tissueCode / 2, .highCode = tissueCode};

EngineCase oneSeed(
    const QByteArray& name, Codes codes, const glm::ivec3& seed, const GrowBurst& burst)
{
    EngineCase made{name, std::move(codes), {}};
    appendWhole(made.steps, SeedPlacement{.label = 1, .voxels = {seed}});
    made.steps.push_back(command(core::ProbeVoxels{{seed}, burst.plane})); // waits
    appendGrowth(made.steps, burst, {growthClosure});
    made.steps.push_back(Undo{});
    made.steps.push_back(Redo{});
    return made;
}

Codes randomGrowthCodes(const glm::ivec3& size, Random& random)
{
    switch (random() % 6) {
    case 0:
        return constantVolume(size, tissueCode);
    case 1:
        return noiseVolume(size, tissueCode, random);
    case 2:
        return spiralCorridor(size);
    case 3:
        return shells(size);
    default:
        return balls(size, randomInt(random, 2, 8), random);
    }
}

glm::ivec3 randomGrowthSize(Random& random)
{
    switch (random() % 5) {
    case 0:
        return {randomInt(random, 1, 4), randomInt(random, 1, 4), randomInt(random, 1, 40)};
    case 1:
        return {16, 32, 16};
    case 2:
        return {17, 33, 5};
    default:
        return {randomInt(random, 5, 40), randomInt(random, 5, 40), randomInt(random, 5, 40)};
    }
}

/// Two rooms, x < 16 and x > 18, and between them a wall with square holes: `side` voxels wide, the
/// first in the middle.
Codes rooms(const glm::ivec3& size, int side, int holes)
{
    Codes codes = constantVolume(size, tissueCode);
    for (int z = 0; z < size.z; ++z) {
        for (int y = 0; y < size.y; ++y) {
            bool open = false;
            for (int hole = 0; hole < holes; ++hole) {
                const glm::ivec2 low = hole == 0 ? glm::ivec2(size.y / 2, size.z / 2) - side / 2
                                                 : glm::ivec2(1, 4 * hole - 3);
                open = open || (y >= low.x && y < low.x + side && z >= low.y && z < low.y + side);
            }
            for (int x = 16; x < 19; ++x)
                codes.at({x, y, z}) = open ? tissueCode : std::uint16_t(0);
        }
    }
    return codes;
}

core::CutGrowth randomCut(Random& random, const glm::ivec3& size)
{
    using How = core::CutGrowth::How;
    core::CutGrowth cut{.plane = std::uint8_t(random() % 5 ? 0 : 1),
        .how = std::array<How, 4>{How::Subtree, How::Subtree, How::Neck, How::Here}[random() % 4],
        .barrier = random() % 4 != 0,
        .connectivity = std::array<int, 4>{26, 26, 18, 6}[random() % 4]};
    for (int i = random() % 3 ? 1 : randomInt(random, 0, 30); i > 0; --i)
        cut.voxels.push_back(randomVoxel(random, size));
    if (random() % 6 == 0)
        cut.lockedLabels.set(std::size_t(randomInt(random, 1, 4)));
    return cut;
}

EngineCase randomGrowth(int number)
{
    Random random(std::uint32_t(1000 + number));
    Random locks(std::uint32_t(9000 + number));
    Random newer(std::uint32_t(17000 + number)); // older cases stay as they are
    Random cuts(std::uint32_t(25000 + number));
    Random ranges(std::uint32_t(41000 + number));
    const glm::ivec3 size = randomGrowthSize(random);
    EngineCase made{
        "random growth " + QByteArray::number(number), randomGrowthCodes(size, random), {}};
    if (random() % 2)
        made.steps.push_back(command(
            core::SwapBricks{bricksOf(labelBoxes(size, 6, random), core::Field::Labels, 0)}));
    std::vector<glm::ivec3> placed;
    for (int edit = randomInt(random, 3, 9); edit > 0; --edit) {
        switch (random() % 8) {
        case 0:
        case 1:
        case 2: {
            SeedPlacement seeds{.plane = std::uint8_t(random() % 5 ? 0 : 1),
                .label = std::uint8_t(randomInt(random, 1, 4))};
            for (int i = randomInt(random, 0, 5); i > 0; --i)
                seeds.voxels.push_back(randomVoxel(random, size));
            // Some that are there, perhaps of this label and waiting still; some that never were.
            for (int i = placed.empty() ? 0 : randomInt(random, -3, 3); i > 0; --i)
                seeds.taken.push_back(random() % 4
                        ? placed[std::size_t(randomInt(random, 0, int(placed.size()) - 1))]
                        : randomVoxel(random, size));
            placed.insert(placed.end(), seeds.voxels.begin(), seeds.voxels.end());
            appendWhole(made.steps, seeds, {},
                random() % 6 ? core::Ending::Commit : core::Ending::Rollback);
            break;
        }
        case 3:
            made.steps.push_back(Undo{});
            break;
        case 4:
            made.steps.push_back(Redo{});
            break;
        default: {
            const int low = randomInt(random, 0, tissueCode);
            GrowBurst burst{.plane = std::uint8_t(random() % 5 ? 0 : 1),
                .lowCode = low,
                .highCode = randomInt(random, low, tissueCode)};
            if (random() % 3 == 0) {
                burst.lowCode = 0;
                burst.highCode = tissueCode;
            }
            for (int label = 1; label <= 4; ++label)
                burst.overwritable[std::size_t(label)] = random() % 3 == 0;
            if (locks() % 4 == 0)
                burst.lockedLabels.set(std::size_t(randomInt(locks, 1, 4)));
            burst.connectivity = std::array<int, 4>{6, 6, 18, 26}[newer() % 4];
            if (cuts() % 3 == 0)
                burst.guard = core::GuardRule{.factor256 = randomInt(cuts, 256, 700),
                    .excess = randomInt(cuts, 0, 20),
                    .window = randomInt(cuts, 1, 8)};
            burst.tellsHeld = newer() % 4 != 0;
            if (number % 2)
                burst.range = randomGrowthRange(tissueCode, ranges);
            std::vector<int> portions;
            for (int i = randomInt(random, 0, 3); i > 0; --i)
                portions.push_back(randomInt(random, 0, 4));
            if (random() % 2)
                portions.push_back(growthClosure);
            appendGrowth(made.steps, burst, portions,
                random() % 5 ? core::Ending::Commit : core::Ending::Rollback);
            if (newer() % 2) {
                Shrink shrink{.shrink = {.plane = burst.plane}};
                if (newer() % 4)
                    shrink.generations = std::uint32_t(randomInt(newer, 0, 8));
                if (newer() % 4 == 0)
                    shrink.shrink.lockedLabels.set(std::size_t(randomInt(newer, 1, 4)));
                if (newer() % 5 == 0)
                    shrink.ending = core::Ending::Rollback;
                if (newer() % 2) {
                    for (int i = randomInt(newer, 1, 5); i > 0; --i)
                        shrink.then.push_back(newer() % 4 ? std::uint32_t(newer()) : 0);
                }
                made.steps.push_back(shrink);
                if (newer() % 4 == 0)
                    made.steps.push_back(Undo{});
                if (newer() % 4 == 0)
                    made.steps.push_back(Redo{});
            }
            if (cuts() % 2) {
                Cut cut{randomCut(cuts, size)};
                cut.ending = cuts() % 5 ? core::Ending::Commit : core::Ending::Rollback;
                made.steps.push_back(cut);
                if (cuts() % 4 == 0)
                    made.steps.push_back(Undo{});
                if (cuts() % 4 == 0)
                    made.steps.push_back(Redo{});
            }
            break;
        }
        }
        if (random() % 3 == 0)
            made.steps.push_back(
                command(core::ProbeVoxels{{randomVoxel(random, size), randomVoxel(random, size)},
                    std::uint8_t(random() % 2)}));
    }
    return made;
}

} // namespace

std::vector<EngineCase> growthCases(int randomCount)
{
    Random random(42);
    std::vector<EngineCase> cases;
    cases.push_back(
        oneSeed("one voxel", constantVolume({1, 1, 1}, tissueCode), {0, 0, 0}, wholeRange));
    cases.push_back(oneSeed("one voxel, refused", constantVolume({1, 1, 1}, 0), {0, 0, 0}, tissue));
    cases.push_back(
        oneSeed("all alike", constantVolume({17, 33, 5}, tissueCode), {16, 0, 4}, wholeRange));
    cases.push_back(
        oneSeed("all alike, 64³", constantVolume({64, 64, 64}, 65535), {31, 32, 33}, wholeRange));
    cases.push_back(oneSeed("checkerboard", checkerboard({17, 33, 5}), {8, 8, 2}, tissue));
    cases.push_back(oneSeed("corridor", spiralCorridor({17, 33, 5}), {0, 0, 0}, tissue));
    cases.push_back(oneSeed("long line", spiralCorridor({70, 1, 1}), {69, 0, 0}, tissue));
    cases.push_back(oneSeed("shells", shells({40, 40, 33}), {20, 3, 16}, tissue));
    cases.push_back(oneSeed("bounds that admit nothing", noiseVolume({17, 18, 19}, 900, random),
        {3, 4, 5}, {.lowCode = 5, .highCode = 4}));
    cases.push_back(
        oneSeed("seed outside the bounds", slab({20, 20, 20}, 0, 5, 9), {0, 0, 0}, tissue));

    EngineCase competing{"labels that meet half-way", constantVolume({33, 17, 16}, 7), {}};
    appendWhole(competing.steps, SeedPlacement{.label = 200, .voxels = {{0, 8, 8}}});
    appendWhole(competing.steps, SeedPlacement{.label = 3, .voxels = {{32, 8, 8}, {16, 0, 0}}});
    appendWhole(competing.steps, SeedPlacement{.label = 255, .voxels = {{16, 16, 15}}});
    appendGrowth(competing.steps, wholeRange, {growthClosure});
    cases.push_back(competing);

    EngineCase sameVoxel{"two labels on one voxel", constantVolume({20, 20, 20}, 7), {}};
    appendWhole(sameVoxel.steps, SeedPlacement{.label = 9, .voxels = {{5, 5, 5}, {5, 5, 5}}});
    appendWhole(sameVoxel.steps, SeedPlacement{.label = 4, .voxels = {{5, 5, 5}, {9, 9, 9}}});
    appendWhole(sameVoxel.steps, SeedPlacement{.label = 7, .voxels = {{5, 5, 5}, {9, 9, 9}}});
    appendGrowth(sameVoxel.steps, wholeRange, {2});
    cases.push_back(sameVoxel);

    const glm::ivec3 size(33, 18, 20);
    EngineCase atCorners{"seeds at all corners", balls(size, 5, random), {}};
    appendWhole(atCorners.steps, SeedPlacement{.label = 1, .voxels = corners(size)});
    appendGrowth(atCorners.steps, wholeRange, {1, 2, growthClosure});
    cases.push_back(atCorners);

    EngineCase thawed{"frozen, then thawed", constantVolume(size, tissueCode), {}};
    appendWhole(thawed.steps, SeedPlacement{.label = 1, .voxels = corners(size)});
    appendWhole(thawed.steps, SeedPlacement{.label = 200, .voxels = {size / 2}});
    GrowBurst frozen = wholeRange;
    frozen.lockedLabels.set(200);
    appendGrowth(thawed.steps, frozen, {3});
    frozen.generation = 4;
    frozen.lockedLabels.reset().set(1);
    appendGrowth(thawed.steps, frozen, {2});
    frozen.generation = 7;
    frozen.lockedLabels.reset();
    appendGrowth(thawed.steps, frozen, {growthClosure});
    cases.push_back(thawed);

    for (const int connectivity : {18, 26}) {
        const QByteArray name = ", " + QByteArray::number(connectivity) + " neighbours";
        GrowBurst wide = wholeRange;
        wide.connectivity = connectivity;
        cases.push_back(oneSeed(
            "all alike, 64³" + name, constantVolume({64, 64, 64}, 65535), {31, 32, 33}, wide));
        wide.lowCode = tissueCode / 2;
        wide.highCode = tissueCode;
        cases.push_back(oneSeed("checkerboard" + name, checkerboard({17, 33, 5}), {8, 8, 2}, wide));
        cases.push_back(oneSeed("corridor" + name, spiralCorridor({17, 33, 5}), {0, 0, 0}, wide));
        cases.push_back(oneSeed("shells" + name, shells({40, 40, 33}), {20, 3, 16}, wide));
    }

    for (const bool toSeeds : {false, true}) {
        EngineCase shrunk{toSeeds ? "shrunk to the seeds" : "shrunk ring by ring, grown again",
            balls(size, 6, random), {}};
        shrunk.steps.push_back(command(
            core::SwapBricks{bricksOf(labelBoxes(size, 6, random), core::Field::Labels, 0)}));
        appendWhole(shrunk.steps, SeedPlacement{.label = 1, .voxels = corners(size)});
        appendWhole(shrunk.steps, SeedPlacement{.label = 2, .voxels = {size / 2}});
        GrowBurst burst = wholeRange;
        burst.overwritable.set(3);
        appendGrowth(shrunk.steps, burst, {5});
        appendWhole(shrunk.steps, SeedPlacement{.label = 3, .voxels = {{20, 4, 4}, {3, 9, 9}}});
        appendGrowth(shrunk.steps, burst, {growthClosure});
        for (int i = 0; i < 4; ++i)
            shrunk.steps.push_back(toSeeds ? Shrink{} : Shrink{.shrink = {}, .generations = 3});
        shrunk.steps.push_back(Undo{});
        shrunk.steps.push_back(Undo{});
        shrunk.steps.push_back(Redo{});
        appendGrowth(shrunk.steps, burst, {2, growthClosure});
        cases.push_back(shrunk);
    }

    EngineCase lockedShrink{"what is locked does not shrink", constantVolume(size, 7), {}};
    appendWhole(lockedShrink.steps, SeedPlacement{.label = 1, .voxels = corners(size)});
    appendWhole(lockedShrink.steps, SeedPlacement{.label = 200, .voxels = {size / 2}});
    appendGrowth(lockedShrink.steps, wholeRange, {4});
    Shrink keeping{.shrink = {}, .generations = 2};
    keeping.shrink.lockedLabels.set(200);
    lockedShrink.steps.push_back(keeping);
    appendGrowth(lockedShrink.steps, wholeRange, {3});
    cases.push_back(lockedShrink);

    for (const int connectivity : {6, 18, 26}) {
        for (int kind = 0; kind < 6; ++kind) {
            const glm::ivec3 hall(36, 14, 17);
            EngineCase leak{"leak " + QByteArray::number(kind) + ", "
                    + QByteArray::number(connectivity) + " neighbours",
                rooms(hall, 1 + kind % 3, 1 + kind / 3), {}};
            GrowBurst burst = tissue;
            burst.connectivity = connectivity;
            if (kind == 3)
                burst.guard = core::GuardRule{.factor256 = 512, .excess = 8, .window = 12};
            if (kind == 4)
                leak.steps.push_back(command(core::SwapBricks{
                    bricksOf(labelBoxes(hall, 6, random), core::Field::Labels, 0)}));
            appendWhole(leak.steps, SeedPlacement{.label = 1, .voxels = {{2, 3, 4}, {9, 9, 9}}});
            if (kind == 5)
                appendWhole(leak.steps, SeedPlacement{.label = 2, .voxels = {{30, 2, 2}}});
            appendGrowth(leak.steps, burst, {kind == 1 ? 26 : growthClosure});
            using How = core::CutGrowth::How;
            const How how = kind == 2 ? How::Neck : How::Subtree;
            leak.steps.push_back(Cut{{.how = how, .voxels = {{24, 8, 8}, {26, 3, 8}}}});
            appendGrowth(leak.steps, burst, {growthClosure});
            leak.steps.push_back(Cut{{.how = How::Here, .voxels = {{9, 9, 9}, {4, 4, 4}}}});
            leak.steps.push_back(Undo{});
            leak.steps.push_back(Undo{});
            leak.steps.push_back(Undo{});
            leak.steps.push_back(Cut{{.how = how, .barrier = false, .voxels = {{24, 8, 8}}}});
            leak.steps.push_back(
                Cut{{.how = How::Neck, .voxels = {{4, 4, 4}}}, {}, core::Ending::Rollback});
            appendGrowth(leak.steps, wholeRange, {3});
            leak.steps.push_back(Shrink{.shrink = {}, .generations = 2});
            cases.push_back(leak);
        }
    }

    for (const bool overwrite : {false, true}) {
        EngineCase painted{overwrite ? "painted labels, overwritable" : "painted labels",
            constantVolume(size, tissueCode), {}};
        painted.steps.push_back(command(
            core::SwapBricks{bricksOf(labelBoxes(size, 6, random), core::Field::Labels, 0)}));
        appendWhole(painted.steps, SeedPlacement{.label = 1, .voxels = corners(size)});
        appendWhole(painted.steps, SeedPlacement{.label = 2, .voxels = {size / 2}});
        GrowBurst burst = wholeRange;
        if (overwrite)
            burst.overwritable.set(2).set(3);
        appendGrowth(painted.steps, burst, {3, growthClosure});
        painted.steps.push_back(command(core::ProbeVoxels{corners(size)}));
        painted.steps.push_back(Undo{});
        appendGrowth(painted.steps, wholeRange, {growthClosure});
        cases.push_back(painted);
    }

    for (const auto& [name, portions] :
        {std::pair{"in steps", std::vector<int>{1, 2, growthClosure}},
            std::pair{"at once", std::vector<int>{growthClosure}},
            std::pair{"beyond closure", std::vector<int>{growthClosure, 5, growthClosure}},
            std::pair{"opening only", std::vector<int>{}},
            std::pair{"no step", std::vector<int>{0}}}) {
        EngineCase inSteps{QByteArray("growth ") + name, balls(size, 6, random), {}};
        appendWhole(inSteps.steps, SeedPlacement{.label = 1, .voxels = {{5, 5, 5}, {30, 2, 2}}});
        appendGrowth(inSteps.steps, {.lowCode = 0, .highCode = 700}, portions);
        cases.push_back(inSteps);
    }

    EngineCase widened{"several bursts, bounds widened, seeds added", balls(size, 6, random), {}};
    appendWhole(widened.steps, SeedPlacement{.label = 1, .voxels = {{5, 5, 5}}});
    appendGrowth(widened.steps, {.lowCode = 0, .highCode = 180}, {4});
    appendGrowth(widened.steps, {.lowCode = 0, .highCode = 240}, {growthClosure});
    appendWhole(widened.steps, SeedPlacement{.label = 2, .voxels = {{30, 15, 15}, {5, 5, 5}}});
    appendGrowth(widened.steps, wholeRange, {3});
    appendGrowth(widened.steps, wholeRange, {2}, core::Ending::Rollback);
    for (int i = 0; i < 4; ++i)
        widened.steps.push_back(Undo{});
    for (int i = 0; i < 2; ++i)
        widened.steps.push_back(Redo{});
    appendGrowth(widened.steps, wholeRange, {growthClosure});
    cases.push_back(widened);

    EngineCase last{"the last generations", constantVolume({40, 3, 3}, 1), {}};
    appendWhole(last.steps, SeedPlacement{.label = 1, .voxels = {{0, 0, 0}}});
    GrowBurst late = wholeRange;
    late.generation = core::seedWord::maxGeneration - 4;
    last.steps.push_back(command(core::BeginEdit{late}));
    last.steps.push_back(command(core::ExtendEdit{GrowAdvance{}}));
    last.steps.push_back(command(core::EndEdit{}));
    late.generation = core::seedWord::maxGeneration;
    appendWhole(last.steps, SeedPlacement{.label = 1, .voxels = {{39, 2, 2}}});
    appendWhole(last.steps, late, {GrowAdvance{}});
    cases.push_back(last);

    EngineCase nothing{"nothing to grow from", noiseVolume(size, 5, random), {}};
    appendWhole(nothing.steps, SeedPlacement{.label = 1});
    appendGrowth(nothing.steps, wholeRange, {growthClosure});
    cases.push_back(nothing);

    for (int number = 0; number < randomCount; ++number)
        cases.push_back(randomGrowth(number));
    return cases;
}

} // namespace test
