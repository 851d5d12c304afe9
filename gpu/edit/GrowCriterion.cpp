// SPDX-License-Identifier: Apache-2.0
#include "gpu/edit/GrowCriterion.h"

#include <algorithm>
#include <tuple>

namespace gpu {

namespace {

/// An empty interval is one whose low end no code reaches.
std::pair<unsigned, unsigned> interval(int lowCode, int highCode)
{
    if (lowCode > highCode || highCode < 0)
        return {65536u, 0u};
    return {unsigned(std::max(lowCode, 0)), unsigned(highCode)};
}

/// Every define of growCriterion.glsl, and whether it is needed.
std::array<std::pair<const char*, bool>, 7> questions(const core::GrowLimits& limits)
{
    return {
        {{"DIFFERENCE", limits.difference.has_value()}, {"GRADIENT", limits.gradient.has_value()},
            {"GRADIENT_DIFFERENCE", limits.gradientDifference.has_value()},
            {"MAJORITY", limits.majority > 1}, // the voxel itself is one
            {"ONLY_VISIBLE", limits.onlyVisible}, {"BOXED", limits.boxed},
            {"SIGMAS", limits.sigmas256 > 0}}};
}

std::uint64_t wide(const std::uint32_t* words)
{
    return std::uint64_t(words[0]) | std::uint64_t(words[1]) << 32;
}

} // namespace

ShaderDefines definesOf(const core::GrowLimits& limits)
{
    ShaderDefines defines;
    for (const auto& [name, isAsked] : questions(limits)) {
        if (isAsked)
            defines.emplace_back(name, 1);
    }
    return defines;
}

unsigned kindOf(const core::GrowLimits& limits)
{
    unsigned kind = 0;
    for (const auto& question : questions(limits))
        kind = 2 * kind + (question.second ? 1 : 0);
    return 2 * kind + (core::isAsked(limits.passage) ? 1 : 0);
}

SeedSumsByLabel seedSums(
    Program& kernel, VoxelFields& fields, std::uint8_t plane, int lowCode, int highCode)
{
    SeedSumsByLabel sums{};
    BrickField& words = fields.seedWords(plane);
    const std::vector<std::uint32_t> bricks = words.heldBricks();
    const auto [low, high] = interval(lowCode, highCode);
    constexpr std::size_t bricksAtOnce = 65535; // the least that GL promises
    std::array<std::uint32_t, sums.size() * 6> counted{};
    Buffer result({.label = "seed sums", .bytes = sizeof(counted)});
    result.fill(0);
    kernel.set("volumeSize", fields.grid().volumeSize)
        .set("volumeBricks", fields.grid().bricks())
        .set("lowCode", low)
        .set("highCode", high);
    words.pageTable().bindUnit(1);
    words.atlas().bindUnit(0);
    fields.codes().bindUnit(2);
    result.bindBase(GL_SHADER_STORAGE_BUFFER, 1);
    for (std::size_t first = 0; first < bricks.size(); first += bricksAtOnce) {
        const std::span<const std::uint32_t> batch =
            std::span(bricks).subspan(first, std::min(bricksAtOnce, bricks.size() - first));
        Buffer list({.label = "seed bricks", .bytes = batch.size_bytes()});
        list.write(batch);
        list.bindBase(GL_SHADER_STORAGE_BUFFER, 0);
        kernel.dispatch({unsigned(batch.size()), 1, 1});
        glMemoryBarrier(GL_ALL_BARRIER_BITS);
    }
    result.read(std::span<std::uint32_t>(counted));
    for (std::size_t label = 0; label < sums.size(); ++label) {
        const std::uint32_t* words6 = &counted[6 * label];
        sums[label] = {
            .voxels = wide(words6), .codes = wide(words6 + 2), .squares = wide(words6 + 4)};
    }
    return sums;
}

GrowCriterion::GrowCriterion(Program& statistics, VoxelFields& fields, const core::GrowBurst& burst)
    : m_limits(burst.limits)
{
    std::tie(m_lowCode, m_highCode) = interval(burst.lowCode, burst.highCode);
    if (m_limits.sigmas256 <= 0)
        return;
    const SeedSumsByLabel sums =
        seedSums(statistics, fields, burst.plane, burst.lowCode, burst.highCode);
    for (std::size_t label = 0; label < sums.size(); ++label) {
        const core::CodeInterval codes = core::seedInterval(sums[label], m_limits.sigmas256);
        m_seedIntervals[label] = unsigned(codes.low) | unsigned(codes.high) << 16;
    }
}

void GrowCriterion::setUniforms(Program& program) const
{
    constexpr int greatest = 65534; // no magnitude reaches it, and it has a square
    program.set("lowCode", m_lowCode)
        .set("highCode", m_highCode)
        .set("difference", unsigned(m_limits.difference.value_or(0)))
        .set("gradientWeights", glm::uvec3(m_limits.gradientWeights))
        .set("gradient", unsigned(std::min(m_limits.gradient.value_or(0), greatest)))
        .set("gradientDifference", unsigned(m_limits.gradientDifference.value_or(0)))
        .set("majority", m_limits.majority)
        .set("boxFrom", m_limits.boxFrom)
        .set("boxTo", m_limits.boxTo)
        .set("seedIntervals", std::span<const unsigned>(m_seedIntervals));
}

void GrowCriterion::bind(VoxelFields& fields) const
{
    if (m_limits.onlyVisible)
        fields.radiation().bindUnit(0);
}

} // namespace gpu
