// SPDX-License-Identifier: Apache-2.0
#include "gpu/edit/ShrinkKernel.h"

#include <algorithm>
#include <array>

namespace gpu {

namespace {

constexpr std::size_t mostGroups = 65535; // the least that GL promises; more bricks are walked
constexpr std::uint32_t losesWords = 1; // shrink.comp
constexpr std::uint32_t losesLabels = 2;

/// What a look at bricks found.
struct Found {
    std::vector<std::uint32_t> flags; ///< one a brick
    std::uint32_t greatest = 0; ///< generation of a member that stays
};

Found run(Program& shrink, VoxelFields& fields, std::uint8_t plane,
    const std::vector<std::uint32_t>& bricks, bool write)
{
    const std::size_t bytes = bricks.size() * sizeof(std::uint32_t);
    Buffer list({.label = "shrink bricks", .bytes = bytes});
    Buffer found({.label = "shrink found", .bytes = bytes + sizeof(std::uint32_t)});
    list.write(std::span<const std::uint32_t>(bricks));
    found.fill(0);
    list.bindBase(GL_SHADER_STORAGE_BUFFER, 0);
    found.bindBase(GL_SHADER_STORAGE_BUFFER, 1);
    BrickField& words = fields.seedWords(plane);
    words.pageTable().bindUnit(1);
    words.atlas().bindImage(0, GL_READ_WRITE);
    fields.labels(plane).bindImage(1, GL_READ_WRITE);
    shrink.set("brickCount", unsigned(bricks.size())).set("write", write);
    shrink.dispatch({unsigned(std::min(bricks.size(), mostGroups)), 1, 1});
    glMemoryBarrier(GL_ALL_BARRIER_BITS);
    Found result;
    result.flags.resize(bricks.size() + 1);
    found.read(std::span<std::uint32_t>(result.flags));
    result.greatest = result.flags.front();
    result.flags.erase(result.flags.begin());
    return result;
}

} // namespace

ShrinkOutcome shrinkGrowth(
    Program& shrink, VoxelFields& fields, BeforeImages& before, const core::ShrinkGrowth& command)
{
    ShrinkOutcome outcome{.keys = {}, .generation = command.keep};
    const std::vector<std::uint32_t> held = fields.seedWords(command.plane).heldBricks();
    if (held.empty())
        return outcome;
    std::array<unsigned, 8> frozen{};
    for (std::size_t label = 0; label < command.frozen.size(); ++label) {
        if (command.frozen[label])
            frozen[label / 32] |= 1u << (label % 32);
    }
    shrink.set("volumeSize", fields.grid().volumeSize)
        .set("volumeBricks", fields.grid().bricks())
        .set("keep", command.keep)
        .set("keepSeeds", command.keepSeeds)
        .set("frozen", std::span<const unsigned>(frozen));
    const Found found = run(shrink, fields, command.plane, held, false);
    outcome.generation = std::max(command.keep, found.greatest);

    std::vector<std::uint32_t> inWords;
    std::vector<std::uint32_t> inLabels;
    for (std::size_t i = 0; i < held.size(); ++i) {
        if ((found.flags[i] & losesWords) != 0)
            inWords.push_back(held[i]);
        if ((found.flags[i] & losesLabels) != 0)
            inLabels.push_back(held[i]);
    }
    if (inWords.empty())
        return outcome;
    before.capture(core::Field::SeedWords, command.plane, inWords);
    before.capture(core::Field::Labels, command.plane, inLabels);
    run(shrink, fields, command.plane, inWords, true);
    fields.noteChanged(core::Field::Labels, inLabels);
    for (const std::uint32_t brick : inWords)
        outcome.keys.push_back(
            {.field = core::Field::SeedWords, .plane = command.plane, .brick = brick});
    for (const std::uint32_t brick : inLabels)
        outcome.keys.push_back(
            {.field = core::Field::Labels, .plane = command.plane, .brick = brick});
    return outcome;
}

} // namespace gpu
