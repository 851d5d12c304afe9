// SPDX-License-Identifier: Apache-2.0
#include "gpu/kernels/fronts/FrontBits.h"

#include "gpu/gl/Gl.h"
#include "gpu/kernels/criterion/GrowCriterion.h"

#include <algorithm>
#include <cstring>

namespace gpu {

namespace {

constexpr std::size_t wordsOfFront = 128; // frontBits.glsl
constexpr std::size_t wordsOfOpen = 136;
// By estimate, not by measure: on llvmpipe a brick in reach costs as much as a few queued voxels.
constexpr std::size_t widePerBrick = 8;
constexpr std::size_t narrowPerBrick = 3;

Program program(const ShaderLibrary& library, const char* path, const ShaderDefines& defines)
{
    return Program(library, ComputeProgramOptions{.label = path, .path = path, .defines = defines});
}

struct ListedBrick { // frontBits.glsl
    std::uint32_t index = 0;
    std::uint32_t page = 0;
    std::uint32_t x = 0;
    std::uint32_t yz = 0;
};

ShaderDefines definesOfOpen(const core::GrowLimits& limits, bool ranged)
{
    ShaderDefines defines = definesOf(limits);
    if (ranged)
        defines.emplace_back("RANGE", 1);
    return defines;
}

/// Work groups that walk over this many.
unsigned groupsFor(std::size_t parts)
{
    return unsigned(std::min(parts, mostWorkGroups));
}

/// Where kernels find what is stored for a listed brick.
enum class Indices {
    OfBricks,
    OfPlaces, ///< in the list
};

Buffer listOf(std::span<const std::uint32_t> bricks, const BrickField& words,
    const glm::ivec3& grid, Indices indices = Indices::OfBricks)
{
    std::vector<ListedBrick> listed;
    listed.reserve(bricks.size() + 1);
    listed.push_back({std::uint32_t(bricks.size()), 1, 1, 0}); // the groups of a dispatch
    for (const std::uint32_t brick : bricks) {
        const int row = int(brick) / grid.x;
        const auto place = std::uint32_t(listed.size() - 1);
        listed.push_back({.index = indices == Indices::OfBricks ? brick : place,
            .page = words.pageOf(brick),
            .x = brick % std::uint32_t(grid.x),
            .yz = std::uint32_t(row % grid.y | row / grid.y << 16)});
    }
    Buffer buffer({.label = "front bricks", .bytes = listed.size() * sizeof(ListedBrick)});
    buffer.write(std::span<const ListedBrick>(listed));
    return buffer;
}

} // namespace

Program openBitsProgram(const ShaderLibrary& shaders, const core::GrowLimits& limits, bool ranged)
{
    return program(shaders, "kernels/fronts/frontBitsOpen.comp", definesOfOpen(limits, ranged));
}

std::vector<core::VoxelBits> openBits(Program& program, const BrickField& words,
    const glm::ivec3& grid, std::uint8_t label, std::span<const std::uint32_t> bricks)
{
    if (bricks.empty())
        return {};
    Buffer found({.label = "open bits", .bytes = bricks.size() * wordsOfOpen * sizeof(GLuint)});
    const Buffer list = listOf(bricks, words, grid, Indices::OfPlaces);
    list.bindBase(GL_SHADER_STORAGE_BUFFER, 4);
    found.bindBase(GL_SHADER_STORAGE_BUFFER, 7);
    program.set("growing", unsigned(label));
    program.dispatch({groupsFor(bricks.size()), 1, 1});
    glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    std::vector<std::uint32_t> bits(bricks.size() * wordsOfOpen);
    found.read(std::span<std::uint32_t>(bits));
    std::vector<core::VoxelBits> open(bricks.size());
    for (std::size_t i = 0; i < open.size(); ++i)
        std::memcpy(open[i].data(), &bits[i * wordsOfOpen], sizeof open[i]);
    return open;
}

FrontBitsPrograms::FrontBitsPrograms(const ShaderLibrary& shaders, int connectivity,
    const core::GrowLimits& limits, bool overwritten, bool ranged)
    : open(openBitsProgram(shaders, limits, ranged))
    , fill(program(shaders, "kernels/fronts/frontBitsFill.comp", {}))
    , reach(
          program(shaders, "kernels/fronts/frontBitsReach.comp", {{"CONNECTIVITY", connectivity}}))
    , end(program(shaders, "kernels/fronts/frontBitsEnd.comp", {}))
{
    ShaderDefines defines{{"CONNECTIVITY", connectivity}};
    if (overwritten)
        defines.emplace_back("OVERWRITTEN", 1);
    ring = program(shaders, "kernels/fronts/frontBitsRing.comp", defines);
}

bool FrontBits::isFor(const core::GrowLimits& limits)
{
    return !limits.difference && !limits.gradientDifference && !core::isAsked(limits.passage);
}

bool FrontBits::pays(std::uint32_t frontVoxels, std::size_t bricksInReach) const
{
    return frontVoxels >= (m_holdsFront ? narrowPerBrick : widePerBrick) * bricksInReach;
}

void FrontBits::bind(unsigned front) const
{
    m_fronts[front].bindBase(GL_SHADER_STORAGE_BUFFER, 2);
    m_fronts[1 - front].bindBase(GL_SHADER_STORAGE_BUFFER, 6);
    m_open.bindBase(GL_SHADER_STORAGE_BUFFER, 7);
}

void FrontBits::enter(FrontBitsPrograms& programs, int brickCount, const Front& front)
{
    const std::size_t bytes = std::size_t(brickCount) * sizeof(std::uint32_t);
    if (!m_open) {
        for (Buffer& each : m_fronts)
            each = Buffer({.label = "front bits", .bytes = bytes * wordsOfFront});
        m_open = Buffer({.label = "open bits", .bytes = bytes * wordsOfOpen});
        m_reach = Buffer({.label = "bricks in reach",
            .bytes = (std::size_t(brickCount) + 1) * sizeof(ListedBrick)});
        const ListedBrick none{0, 1, 1, 0};
        m_reach.write(std::span<const ListedBrick>(&none, 1));
    }
    for (Buffer& each : m_fronts)
        each.fill(0);
    m_open.fill(0);
    // What a queue claimed meanwhile is not known here.
    m_known.assign(std::size_t(brickCount), false);
    m_front = 0;
    m_label = front.label;
    m_holdsFront = true;
    bind(m_front);
    programs.fill.set("baseGeneration", front.generation);
    programs.fill.dispatch({groupsFor((std::size_t(front.voxels) + 63) / 64), 1, 1});
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
}

void FrontBits::advance(FrontBitsPrograms& programs, const BrickField& words,
    const glm::ivec3& grid, std::uint32_t generation, int rings,
    std::span<const std::uint32_t> bricks)
{
    std::vector<std::uint32_t> fresh;
    for (const std::uint32_t brick : bricks) {
        if (!m_known[brick])
            fresh.push_back(brick);
        m_known[brick] = true;
    }
    bind(m_front);
    if (!fresh.empty()) {
        const Buffer list = listOf(fresh, words, grid);
        list.bindBase(GL_SHADER_STORAGE_BUFFER, 4);
        programs.open.set("growing", unsigned(m_label));
        programs.open.dispatch({groupsFor(fresh.size()), 1, 1});
        glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
    }
    const Buffer list = listOf(bricks, words, grid);
    programs.reach.set("baseGeneration", generation);
    programs.ring.set("growing", unsigned(m_label)).set("baseGeneration", generation);
    for (int ring = 0; ring < rings; ++ring) {
        m_reach.fill(0, 0, sizeof(std::uint32_t));
        list.bindBase(GL_SHADER_STORAGE_BUFFER, 4);
        m_reach.bindBase(GL_SHADER_STORAGE_BUFFER, 6);
        programs.reach.set("ring", unsigned(ring));
        programs.reach.dispatch({unsigned(bricks.size() + 63) / 64, 1, 1});
        glMemoryBarrier(
            GL_SHADER_STORAGE_BARRIER_BIT | GL_COMMAND_BARRIER_BIT | GL_BUFFER_UPDATE_BARRIER_BIT);
        m_reach.bindBase(GL_SHADER_STORAGE_BUFFER, 4);
        bind(m_front);
        programs.ring.set("ring", unsigned(ring));
        // How many are in reach is not known here: they may be more than may be started at once.
        if (bricks.size() > mostWorkGroups)
            programs.ring.dispatch({groupsFor(bricks.size()), 1, 1});
        else
            programs.ring.dispatchIndirect(m_reach);
        glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_SHADER_IMAGE_ACCESS_BARRIER_BIT
            | GL_BUFFER_UPDATE_BARRIER_BIT);
        m_front = 1 - m_front;
    }
    bind(m_front);
    list.bindBase(GL_SHADER_STORAGE_BUFFER, 4);
    programs.end.set("generation", generation + std::uint32_t(rings));
    programs.end.dispatch({groupsFor(bricks.size()), 1, 1});
    glMemoryBarrier(GL_ALL_BARRIER_BITS);
}

} // namespace gpu
