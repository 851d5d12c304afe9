// SPDX-License-Identifier: Apache-2.0
#include "gpu/kernels/labels/EraseKernel.h"

#include "gpu/gl/Program.h"

#include <algorithm>

namespace gpu {

namespace {

Program program(const ShaderLibrary& library, const ShaderDefines& defines)
{
    const char* path = "kernels/labels/eraseLabel.comp";
    return Program(library, ComputeProgramOptions{.label = path, .path = path, .defines = defines});
}

/// Runs the bound kernel over bricks. @return those that hold the label
std::vector<std::uint32_t> run(
    Program& kernel, const std::vector<std::uint32_t>& bricks, bool erase)
{
    const std::size_t bytes = bricks.size() * sizeof(std::uint32_t);
    Buffer list({.label = "erase bricks", .bytes = bytes});
    Buffer found({.label = "erase found", .bytes = bytes});
    list.write(std::span<const std::uint32_t>(bricks));
    found.fill(0);
    list.bindBase(GL_SHADER_STORAGE_BUFFER, 0);
    found.bindBase(GL_SHADER_STORAGE_BUFFER, 1);
    kernel.set("brickCount", unsigned(bricks.size())).set("erase", erase);
    kernel.dispatch({unsigned(std::min(bricks.size(), mostWorkGroups)), 1, 1});
    glMemoryBarrier(GL_ALL_BARRIER_BITS);
    std::vector<std::uint32_t> flags(bricks.size());
    found.read(std::span<std::uint32_t>(flags));
    std::vector<std::uint32_t> holders;
    for (std::size_t i = 0; i < bricks.size(); ++i) {
        if (flags[i] != 0)
            holders.push_back(bricks[i]);
    }
    return holders;
}

/// One field: find, save, write, tell.
void eraseFrom(core::Field field, Program& kernel, VoxelFields& fields, BeforeImages& before,
    const core::EraseLabel& erase, std::vector<core::BrickKey>& keys)
{
    BrickField* paged = fields.paged(field, erase.plane);
    const std::vector<std::uint32_t> bricks = paged ? paged->heldBricks() : fields.labelledBricks();
    if (bricks.empty())
        return;
    const auto bind = [&] {
        if (paged)
            paged->pageTable().bindUnit(1);
        fields.textures(field, erase.plane).voxels->bindImage(0, GL_READ_WRITE);
    };
    kernel.set("volumeSize", fields.grid().volumeSize)
        .set("volumeBricks", fields.grid().bricks())
        .set("label", unsigned(erase.label));
    bind();
    const std::vector<std::uint32_t> holders = run(kernel, bricks, false);
    if (holders.empty())
        return;
    before.capture(field, erase.plane, holders);
    bind(); // capturing has bound textures of its own
    run(kernel, holders, true);
    fields.noteChanged(field, holders);
    for (const std::uint32_t brick : holders)
        keys.push_back({.field = field, .plane = erase.plane, .brick = brick});
}

} // namespace

ErasePrograms::ErasePrograms(const ShaderLibrary& library)
    : labels(program(library, {}))
    , seedWords(program(library, {{"SEED_WORDS", 1}}))
    , m_library(library)
{
}

Program& ErasePrograms::overwritten()
{
    if (!m_overwritten)
        m_overwritten = program(m_library, {{"OVERWRITTEN", 1}});
    return m_overwritten;
}

std::vector<std::uint32_t> labelHolders(
    ErasePrograms& programs, VoxelFields& fields, std::uint8_t plane, std::uint8_t label)
{
    const std::vector<std::uint32_t> bricks = fields.labelledBricks();
    if (bricks.empty())
        return {};
    programs.labels.set("volumeSize", fields.grid().volumeSize)
        .set("volumeBricks", fields.grid().bricks())
        .set("label", unsigned(label));
    fields.labels(plane).bindImage(0, GL_READ_WRITE);
    return run(programs.labels, bricks, false);
}

std::vector<core::BrickKey> eraseLabel(ErasePrograms& programs, VoxelFields& fields,
    BeforeImages& before, const core::EraseLabel& erase)
{
    std::vector<core::BrickKey> keys;
    eraseFrom(core::Field::Labels, programs.labels, fields, before, erase, keys);
    eraseFrom(core::Field::SeedWords, programs.seedWords, fields, before, erase, keys);
    if (fields.anyOverwritten(erase.plane))
        eraseFrom(core::Field::Overwritten, programs.overwritten(), fields, before, erase, keys);
    return keys;
}

} // namespace gpu
