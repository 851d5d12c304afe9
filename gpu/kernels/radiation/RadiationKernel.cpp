// SPDX-License-Identifier: Apache-2.0
#include "gpu/kernels/radiation/RadiationKernel.h"

#include <algorithm>
#include <array>

namespace gpu {

namespace {

constexpr std::size_t mostBricksPerPass = 128;
constexpr std::size_t fieldWords = 24 * 24 * 24;
constexpr std::size_t firstBlurWords = 18 * 24 * 24;
constexpr std::size_t secondBlurWords = 18 * 18 * 24;
constexpr unsigned gatherGroupsPerBrick = 9; // 576 rows of 24, 64 to a group

std::uint32_t packed(const glm::ivec3& local)
{
    return std::uint32_t(local.x | local.y << 5 | local.z << 10);
}

Buffer words(const char* label, std::size_t count)
{
    return Buffer({.label = label, .bytes = count * sizeof(std::uint32_t)});
}

} // namespace

RadiationKernel::RadiationKernel(RadiationPrograms& programs, const core::BrickGrid& grid)
    : m_programs(programs)
    , m_grid(grid)
    , m_bricksPerPass(std::min(mostBricksPerPass, std::size_t(grid.brickCount())))
    , m_regions(words("radiation regions", 2 * m_bricksPerPass))
    , m_field(words("radiation field", fieldWords * m_bricksPerPass))
    , m_summaries(words("radiation summaries", m_bricksPerPass))
    , m_scratchA(words("radiation scratch A", firstBlurWords * m_bricksPerPass))
    , m_scratchB(words("radiation scratch B", secondBlurWords * m_bricksPerPass))
{
}

void RadiationKernel::updateFromCoverage(
    std::span<BrickField* const> layers, const Texture3D& target, std::span<const Region> regions)
{
    update({.target = target}, regions,
        [this, layers](unsigned count) { gatherLayers(layers, false, count); });
}

void RadiationKernel::updateFromLabels(Planes planes, const std::bitset<256>& shown,
    const Texture3D& target, std::span<const Region> regions)
{
    update({.target = target}, regions,
        [&, this](unsigned count) { gatherLabels(planes, shown, true, count); });
}

void RadiationKernel::updateFromLabels(Planes planes, const AtTolerance& segment,
    const std::bitset<256>& shown, const Texture3D& target, std::span<const Region> regions)
{
    Program& program = m_programs.gatherAtTolerance();
    program.set("volumeSize", m_grid.volumeSize)
        .set("volumeBricks", m_grid.bricks())
        .set("firstLayer", true)
        .set("shown", shown)
        .set("toleranceLabel", unsigned(segment.label))
        .set("tolerance", unsigned(std::max(segment.tolerance, 0)));
    update({.target = target}, regions, [&](unsigned count) {
        planes[segment.place]->bindUnit(0);
        segment.tolerances.bindUnit(13);
        segment.seedWords.atlas().bindUnit(14);
        segment.seedWords.pageTable().bindUnit(15);
        program.dispatch({count * gatherGroupsPerBrick, 1, 1});
        gatherLabels(planes.first(segment.place), shown, false, count);
        gatherLabels(planes.subspan(segment.place + 1), shown, false, count);
    });
}

void RadiationKernel::updateFootprint(BrickField& layer, std::span<BrickField* const> before,
    const Footprint& footprint, std::span<const Region> regions)
{
    std::vector<BrickField*> layers{&layer};
    layers.insert(layers.end(), before.begin(), before.end());
    update(
        footprint, regions, [this, &layers](unsigned count) { gatherLayers(layers, true, count); });
}

void RadiationKernel::updateFootprint(
    Planes planes, int label, const Footprint& footprint, std::span<const Region> regions)
{
    std::bitset<256> shown;
    shown.set(std::size_t(label));
    update(footprint, regions,
        [&, this](unsigned count) { gatherLabels(planes, shown, true, count); });
}

/// A summary only ever gains bits, so what is gathered over something must start it afresh.
void RadiationKernel::gatherMore()
{
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_BUFFER_UPDATE_BARRIER_BIT);
    m_summaries.fill(0);
}

/// @param subtract the first layer less all others, instead of the greatest
void RadiationKernel::gatherLayers(
    std::span<BrickField* const> layers, bool subtract, unsigned count)
{
    bool first = true;
    for (BrickField* layer : layers) {
        if (!first)
            gatherMore();
        layer->atlas().bindUnit(0);
        layer->pageTable().bindUnit(1);
        m_programs.gatherCoverage.set("firstLayer", first).set("subtract", subtract && !first);
        m_programs.gatherCoverage.dispatch({count * gatherGroupsPerBrick, 1, 1});
        first = false;
    }
}

void RadiationKernel::gatherLabels(
    Planes planes, const std::bitset<256>& shown, bool first, unsigned count)
{
    m_programs.gatherLabels.set("shown", shown);
    for (const Texture3D* plane : planes) {
        if (!first)
            gatherMore();
        plane->bindUnit(0);
        m_programs.gatherLabels.set("firstLayer", first);
        m_programs.gatherLabels.dispatch({count * gatherGroupsPerBrick, 1, 1});
        first = false;
    }
}

void RadiationKernel::update(const Footprint& footprint, std::span<const Region> regions,
    const std::function<void(unsigned count)>& gather)
{
    for (Program* each : {&m_programs.gatherCoverage, &m_programs.gatherLabels, &m_programs.raise})
        each->set("volumeSize", m_grid.volumeSize).set("volumeBricks", m_grid.bricks());
    for (std::size_t start = 0; start < regions.size(); start += m_bricksPerPass) {
        const auto piece =
            regions.subspan(start, std::min(m_bricksPerPass, regions.size() - start));
        const auto count = unsigned(piece.size());
        std::vector<glm::uvec2> words;
        for (const Region& region : piece)
            words.emplace_back(region.brick, packed(region.low) | packed(region.high) << 15);
        m_regions.write(std::span<const glm::uvec2>(words));
        m_summaries.fill(0);
        m_regions.bindBase(GL_SHADER_STORAGE_BUFFER, 0);
        m_field.bindBase(GL_SHADER_STORAGE_BUFFER, 1);
        m_summaries.bindBase(GL_SHADER_STORAGE_BUFFER, 2);
        glMemoryBarrier(GL_ALL_BARRIER_BITS);
        gather(count);

        const std::array<const Buffer*, 4> chain{&m_field, &m_scratchA, &m_scratchB, &m_scratchA};
        for (std::size_t axis = 0; axis < 3; ++axis) {
            glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
            chain[axis]->bindBase(GL_SHADER_STORAGE_BUFFER, 3);
            chain[axis + 1]->bindBase(GL_SHADER_STORAGE_BUFFER, 4);
            m_programs.blur[axis].dispatch({count, 1, 1});
        }
        glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
        m_scratchA.bindBase(GL_SHADER_STORAGE_BUFFER, 3);
        footprint.target.bindImage(0, GL_WRITE_ONLY);
        m_programs.raise.set("targetShift", footprint.shift);
        m_programs.raise.dispatch({count, 1, 1});
    }
    glMemoryBarrier(GL_ALL_BARRIER_BITS);
}

} // namespace gpu
