// SPDX-License-Identifier: Apache-2.0
#include "gpu/kernels/shrink/ShrinkKernel.h"

#include "core/growth/SeedWord.h"
#include "gpu/gl/Program.h"

#include <algorithm>

namespace gpu {

namespace {

Program program(const ShaderLibrary& library, const char* label, const char* path,
    const ShaderDefines& defines = {})
{
    return Program(
        library, ComputeProgramOptions{.label = label, .path = path, .defines = defines});
}

Buffer listOf(const char* label, std::span<const std::uint32_t> values)
{
    Buffer buffer({.label = label, .bytes = values.size_bytes()});
    buffer.write(values);
    return buffer;
}

void setGrid(Program& each, const core::BrickGrid& grid, std::size_t bricks)
{
    each.set("volumeSize", grid.volumeSize)
        .set("volumeBricks", grid.bricks())
        .set("brickCount", unsigned(bricks));
}

void dispatch(Program& each, std::size_t bricks)
{
    each.dispatch({unsigned(std::min(bricks, mostWorkGroups)), 1, 1});
    glMemoryBarrier(GL_ALL_BARRIER_BITS);
}

} // namespace

ShrinkPrograms::ShrinkPrograms(const ShaderLibrary& library)
    : look(program(library, "look for generations", "kernels/shrink/shrink.comp", {{"LOOK", 1}}))
    , shrink(program(library, "shrink", "kernels/shrink/shrink.comp"))
    , count(program(library, "count generations", "kernels/shrink/countGenerations.comp"))
    , m_library(library)
{
}

Program& ShrinkPrograms::giveBack()
{
    if (!m_giveBack)
        m_giveBack = program(
            m_library, "shrink and give back", "kernels/shrink/shrink.comp", {{"OVERWRITTEN", 1}});
    return m_giveBack;
}

ShrinkKernel::ShrinkKernel(ShrinkPrograms& programs, VoxelFields& fields, BeforeImages& before,
    const core::ShrinkGrowth& command)
    : m_programs(programs)
    , m_givesBack(fields.anyOverwritten(command.plane))
    , m_shrink(m_givesBack ? programs.giveBack() : programs.shrink)
    , m_fields(fields)
    , m_before(before)
    , m_command(command)
    , m_keep(command.generation)
{
    for (Program* each : {&programs.look, &m_shrink})
        each->set("lockedLabels", command.lockedLabels);
    look();
    shrinkTo(command.keep, command.keepSeeds);
}

void ShrinkKernel::look()
{
    BrickField& words = m_fields.seedWords(m_command.plane);
    const std::vector<std::uint32_t> held = words.heldBricks();
    if (held.empty())
        return;
    const Buffer list = listOf("shrink bricks", held);
    constexpr std::size_t head = 2; // shrink.comp
    std::vector<std::uint32_t> answer(head + 2 * held.size());
    Buffer found({.label = "shrink found", .bytes = answer.size() * sizeof(std::uint32_t)});
    found.fill(0);
    list.bindBase(GL_SHADER_STORAGE_BUFFER, 0);
    found.bindBase(GL_SHADER_STORAGE_BUFFER, 1);
    words.atlas().bindUnit(0);
    words.pageTable().bindUnit(1);
    setGrid(m_programs.look, m_fields.grid(), held.size());
    dispatch(m_programs.look, held.size());
    found.read(std::span<std::uint32_t>(answer));
    m_greatestLocked = answer[0];
    m_anySeeds = answer[1] != 0;
    for (std::size_t i = 0; i < held.size(); ++i) {
        if (const std::uint32_t greatest = answer[head + 2 * i + 1]; greatest != 0)
            m_bricks.push_back(
                {.brick = held[i], .least = ~answer[head + 2 * i], .greatest = greatest});
    }
}

void ShrinkKernel::save()
{
    std::vector<std::uint32_t> bricks;
    for (const Brick& each : m_bricks)
        bricks.push_back(each.brick);
    const BrickCopier& copier = m_fields.copier();
    m_words = copier.packed(m_fields.textures(core::Field::SeedWords, m_command.plane), bricks);
    m_labels = copier.packed(m_fields.textures(core::Field::Labels, m_command.plane), bricks);
    if (m_givesBack)
        m_overwritten =
            copier.packed(m_fields.textures(core::Field::Overwritten, m_command.plane), bricks);
}

void ShrinkKernel::shrinkTo(std::uint32_t keep, bool keepSeeds)
{
    const std::uint32_t low = std::min(keep, m_keep);
    const std::uint32_t high = std::max(keep, m_keep);
    // Seeds of any generation stay or go with the others by keepSeeds.
    const bool all = keepSeeds != m_keepSeeds;
    m_keep = keep;
    m_keepSeeds = keepSeeds;
    std::vector<std::uint32_t> bricks;
    std::vector<std::uint32_t> places;
    for (std::size_t i = 0; i < m_bricks.size(); ++i) {
        Brick& each = m_bricks[i];
        if (!all && (each.greatest <= low || each.least > high))
            continue;
        each.written = true;
        bricks.push_back(each.brick);
        places.push_back(std::uint32_t(i));
    }
    if (bricks.empty())
        return;
    if (!m_words)
        save();
    m_before.capture(core::Field::SeedWords, m_command.plane, bricks);
    m_before.capture(core::Field::Labels, m_command.plane, bricks);
    if (m_givesBack)
        m_before.capture(core::Field::Overwritten, m_command.plane, bricks);

    BrickField& words = m_fields.seedWords(m_command.plane);
    const Buffer list = listOf("shrink bricks", bricks);
    const Buffer placeList = listOf("shrink places", places);
    list.bindBase(GL_SHADER_STORAGE_BUFFER, 0);
    placeList.bindBase(GL_SHADER_STORAGE_BUFFER, 1);
    m_words.bindBase(GL_SHADER_STORAGE_BUFFER, 2);
    m_labels.bindBase(GL_SHADER_STORAGE_BUFFER, 3);
    words.pageTable().bindUnit(1);
    words.atlas().bindImage(0, GL_WRITE_ONLY);
    m_fields.labels(m_command.plane).bindImage(1, GL_WRITE_ONLY);
    if (m_givesBack) {
        BrickField& overwritten = m_fields.overwritten(m_command.plane);
        m_overwritten.bindBase(GL_SHADER_STORAGE_BUFFER, 4);
        overwritten.pageTable().bindUnit(2);
        overwritten.atlas().bindImage(2, GL_WRITE_ONLY);
    }
    setGrid(m_shrink, m_fields.grid(), bricks.size());
    m_shrink.set("keep", keep).set("keepSeeds", keepSeeds);
    dispatch(m_shrink, bricks.size());
    m_fields.noteChanged(core::Field::Labels, bricks);
}

std::uint32_t ShrinkKernel::generation() const
{
    return std::max({m_keep, m_greatestLocked, m_keepSeeds && m_anySeeds ? 1u : 0u});
}

std::vector<core::BrickKey> ShrinkKernel::touchedKeys() const
{
    std::vector<core::BrickKey> keys;
    for (const core::Field field :
        {core::Field::SeedWords, core::Field::Labels, core::Field::Overwritten}) {
        if (field == core::Field::Overwritten && !m_givesBack)
            continue;
        for (const Brick& each : m_bricks) {
            if (each.written)
                keys.push_back({.field = field, .plane = m_command.plane, .brick = each.brick});
        }
    }
    return keys;
}

std::vector<std::uint32_t> generationSizes(
    ShrinkPrograms& programs, VoxelFields& fields, std::uint8_t plane)
{
    BrickField& words = fields.seedWords(plane);
    const std::vector<std::uint32_t> held = words.heldBricks();
    if (held.empty())
        return {};
    std::vector<std::uint32_t> sizes(core::seedWord::maxGeneration + 1);
    const Buffer list = listOf("counted bricks", held);
    Buffer counts({.label = "generation sizes", .bytes = sizes.size() * sizeof(std::uint32_t)});
    counts.fill(0);
    list.bindBase(GL_SHADER_STORAGE_BUFFER, 0);
    counts.bindBase(GL_SHADER_STORAGE_BUFFER, 1);
    words.atlas().bindUnit(0);
    words.pageTable().bindUnit(1);
    setGrid(programs.count, fields.grid(), held.size());
    dispatch(programs.count, held.size());
    counts.read(std::span<std::uint32_t>(sizes));
    while (!sizes.empty() && sizes.back() == 0)
        sizes.pop_back();
    return sizes;
}

} // namespace gpu
