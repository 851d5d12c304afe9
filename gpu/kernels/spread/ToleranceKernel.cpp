// SPDX-License-Identifier: Apache-2.0
#include "gpu/kernels/spread/ToleranceKernel.h"

#include "gpu/gl/Program.h"

#include <algorithm>
#include <array>
#include <utility>

namespace gpu {

namespace {

constexpr std::uint32_t notReached = 0xFFFFFFFFu; // tolerance.glsl
constexpr std::size_t sizeCount = 65536;
/// Looking at what voxels are, and counting them, is so much less work than bringing to rest.
constexpr std::size_t looksPerBrick = 8;

Program program(const ShaderLibrary& library, const char* path, const ShaderDefines& defines = {})
{
    return Program(library, ComputeProgramOptions{.label = path, .path = path, .defines = defines});
}

/// Every code, and what else the rule asks.
core::GrowBurst burstOf(const core::ToleranceRule& rule)
{
    return {.plane = rule.plane, .lowCode = 0, .highCode = 65535, .limits = rule.limits};
}

/// None where the label has no seeds.
std::optional<int> centreOf(Program& kernel, VoxelFields& fields, const core::ToleranceRule& rule)
{
    BrickField& words = fields.seedWords(rule.plane);
    const std::vector<std::uint32_t> bricks = words.heldBricks();
    std::uint64_t seeds = 0;
    std::uint64_t codes = 0;
    kernel.set("volumeSize", fields.grid().volumeSize)
        .set("volumeBricks", fields.grid().bricks())
        .set("label", unsigned(rule.label));
    fields.codes().bindUnit(0);
    words.pageTable().bindUnit(1);
    words.atlas().bindUnit(2);
    for (std::size_t first = 0; first < bricks.size(); first += mostWorkGroups) {
        const std::span<const std::uint32_t> batch =
            std::span(bricks).subspan(first, std::min(mostWorkGroups, bricks.size() - first));
        Buffer list({.label = "tolerance seed bricks", .bytes = batch.size_bytes()});
        list.write(batch);
        const Buffer found(
            {.label = "tolerance seed sums", .bytes = batch.size() * sizeof(glm::uvec2)});
        list.bindBase(GL_SHADER_STORAGE_BUFFER, 0);
        found.bindBase(GL_SHADER_STORAGE_BUFFER, 1);
        kernel.dispatch({unsigned(batch.size()), 1, 1});
        glMemoryBarrier(GL_ALL_BARRIER_BITS);
        std::vector<glm::uvec2> sums(batch.size());
        found.read(std::span<glm::uvec2>(sums));
        for (const glm::uvec2& sum : sums) {
            seeds += sum.x;
            codes += sum.y;
        }
    }
    if (seeds == 0)
        return std::nullopt;
    return int((2 * codes + seeds) / (2 * seeds));
}

} // namespace

Program& TolerancePrograms::seeds()
{
    if (!m_seeds)
        m_seeds = program(m_shaders, "kernels/spread/toleranceSeeds.comp");
    return m_seeds;
}

std::shared_ptr<Program> TolerancePrograms::init(const core::GrowLimits& limits, bool overwritten)
{
    return m_init.of({kindOf(limits), overwritten}, [&] {
        ShaderDefines defines = definesOf(limits);
        if (overwritten)
            defines.emplace_back("OVERWRITTEN", 1);
        return std::make_shared<Program>(
            program(m_shaders, "kernels/spread/toleranceInit.comp", defines));
    });
}

Program& TolerancePrograms::relax(int connectivity)
{
    Program& known = m_relax[connectivity];
    if (!known)
        known = program(
            m_shaders, "kernels/spread/toleranceRelax.comp", {{"CONNECTIVITY", connectivity}});
    return known;
}

Program& TolerancePrograms::count()
{
    if (!m_count)
        m_count = program(m_shaders, "kernels/spread/toleranceCount.comp");
    return m_count;
}

core::Result<std::unique_ptr<ToleranceKernel>> ToleranceKernel::begin(
    TolerancePrograms& programs, VoxelFields& fields, const core::ToleranceRule& rule)
{
    const auto refuse = [&fields](const char* field, const core::Clause& reason) {
        fields.dropTolerance();
        return core::failure(core::ErrorCode::InvalidField, QLatin1String(field), reason);
    };
    if (!core::isSound(rule))
        return refuse("rule", core::Clause::saying("is not sound"));
    const std::optional<int> centre = centreOf(programs.seeds(), fields, rule);
    if (!centre)
        return refuse("seeds", core::Clause::saying("there are none"));
    ToleranceField& field = fields.tolerance();
    const glm::ivec3 size = fields.grid().bricks() * core::BrickGrid::side;
    if (!field.tolerances)
        field.tolerances = Texture3D({.label = "tolerances", .size = size, .format = GL_R16UI});
    return std::unique_ptr<ToleranceKernel>(new ToleranceKernel(programs, fields, rule, *centre));
}

ToleranceKernel::ToleranceKernel(
    TolerancePrograms& programs, VoxelFields& fields, const core::ToleranceRule& rule, int centre)
    : m_programs(programs)
    , m_fields(fields)
    , m_field(fields.tolerance())
    , m_overwritten(fields.anyOverwritten(rule.plane))
    , m_init(programs.init(rule.limits, m_overwritten))
    , m_relax(programs.relax(rule.connectivity))
    , m_criterion(burstOf(rule)) // σ is refused
    , m_digest({.label = "tolerance digest", .bytes = sizeof(m_field.digest)})
{
    const bool again = m_field.worked && m_field.rule == rule && m_field.curve.centre == centre;
    fields.hideTolerance();
    if (!again) {
        m_field.worked = false;
        m_field.rule = rule;
        m_field.curve = {.centre = centre};
    }
    for (Program* each : {m_init.get(), &m_relax, &programs.count()})
        each->set("volumeSize", fields.grid().volumeSize)
            .set("volumeBricks", fields.grid().bricks())
            .set("centre", unsigned(centre));
    take(again ? Phase::Compare : Phase::Init);
}

void ToleranceKernel::take(Phase phase)
{
    m_phase = phase;
    m_next = 0;
    const std::size_t bricks = std::size_t(m_fields.grid().brickCount());
    if (phase == Phase::Compare || phase == Phase::Init)
        m_digest.fill(0);
    if ((phase == Phase::Compare || phase == Phase::Init) && !m_pending)
        m_pending = Buffer({.label = "tolerance pending", .bytes = bricks * sizeof(std::uint32_t)});
    if (phase == Phase::Init) {
        m_field.worked = false;
        m_pending.fill(notReached);
    }
    if (phase == Phase::Count) {
        m_sizes = Buffer({.label = "tolerance sizes", .bytes = sizeCount * sizeof(std::uint32_t)});
        m_sizes.fill(0);
        m_ranges = Buffer({.label = "tolerance ranges", .bytes = bricks * sizeof(std::uint32_t)});
    }
    if (phase == Phase::Done) {
        m_field.worked = true;
        m_fields.standTolerance();
    }
}

void ToleranceKernel::advance(std::size_t bricks)
{
    switch (m_phase) {
    case Phase::Compare:
    case Phase::Init:
        look(looksPerBrick * bricks);
        break;
    case Phase::Relax:
        relax(bricks);
        break;
    case Phase::Count:
        count(looksPerBrick * bricks);
        break;
    case Phase::Done:
        break;
    }
}

void ToleranceKernel::look(std::size_t bricks)
{
    const std::size_t all = std::size_t(m_fields.grid().brickCount());
    const std::size_t count = std::min({bricks, all - m_next, mostWorkGroups});
    BrickField& words = m_fields.seedWords(m_field.rule.plane);
    m_criterion.setUniforms(*m_init);
    setRange(*m_init, m_field.rule.range);
    m_criterion.bind(m_fields);
    m_init->set("firstBrick", unsigned(m_next))
        .set("label", unsigned(m_field.rule.label))
        .set("overwritable", m_field.rule.overwritable)
        .set("write", m_phase == Phase::Init);
    m_field.tolerances.bindImage(0, GL_READ_WRITE);
    m_fields.codes().bindImage(2, GL_READ_ONLY);
    words.pageTable().bindUnit(1);
    words.atlas().bindUnit(2);
    m_fields.labels(m_field.rule.plane).bindUnit(3);
    if (m_overwritten) {
        BrickField& overwritten = m_fields.overwritten(m_field.rule.plane);
        overwritten.pageTable().bindUnit(5);
        overwritten.atlas().bindUnit(6);
    }
    m_pending.bindBase(GL_SHADER_STORAGE_BUFFER, 1);
    m_digest.bindBase(GL_SHADER_STORAGE_BUFFER, 2);
    m_init->dispatch({unsigned(count), 1, 1});
    glMemoryBarrier(GL_ALL_BARRIER_BITS);
    m_next += count;
    if (m_next < all)
        return;
    std::array<std::uint32_t, 2> digest{};
    m_digest.read(std::span<std::uint32_t>(digest));
    if (m_phase == Phase::Compare) {
        take(digest == m_field.digest ? Phase::Done : Phase::Init);
        return;
    }
    m_field.digest = digest;
    take(Phase::Relax);
}

void ToleranceKernel::relax(std::size_t bricks)
{
    std::vector<std::uint32_t> brought(std::size_t(m_fields.grid().brickCount()));
    m_pending.read(std::span<std::uint32_t>(brought));
    std::vector<std::uint32_t> chosen;
    for (std::uint32_t brick = 0; brick < brought.size(); ++brick) {
        if (brought[brick] != notReached)
            chosen.push_back(brick);
    }
    if (chosen.empty())
        return take(Phase::Count);
    const std::size_t most = std::min(bricks, mostWorkGroups);
    if (chosen.size() > most) {
        // Least first: what comes later is then seldom undercut.
        std::nth_element(chosen.begin(), chosen.begin() + std::ptrdiff_t(most), chosen.end(),
            [&brought](std::uint32_t a, std::uint32_t b) { return brought[a] < brought[b]; });
        chosen.resize(most);
        std::sort(chosen.begin(), chosen.end());
    }
    for (const std::uint32_t brick : chosen)
        brought[brick] = notReached;
    m_pending.write(std::span<const std::uint32_t>(brought));
    m_visits += chosen.size();

    Buffer list({.label = "tolerance bricks", .bytes = chosen.size() * sizeof(std::uint32_t)});
    list.write(std::span<const std::uint32_t>(chosen));
    m_field.tolerances.bindImage(0, GL_READ_WRITE);
    m_fields.codes().bindUnit(0);
    list.bindBase(GL_SHADER_STORAGE_BUFFER, 0);
    m_pending.bindBase(GL_SHADER_STORAGE_BUFFER, 1);
    m_relax.dispatch({unsigned(chosen.size()), 1, 1});
    glMemoryBarrier(GL_ALL_BARRIER_BITS);
}

void ToleranceKernel::count(std::size_t bricks)
{
    const std::size_t all = std::size_t(m_fields.grid().brickCount());
    const std::size_t count = std::min({bricks, all - m_next, mostWorkGroups});
    Program& kernel = m_programs.count();
    kernel.set("firstBrick", unsigned(m_next));
    m_field.tolerances.bindImage(0, GL_READ_ONLY);
    m_sizes.bindBase(GL_SHADER_STORAGE_BUFFER, 2);
    m_ranges.bindBase(GL_SHADER_STORAGE_BUFFER, 3);
    kernel.dispatch({unsigned(count), 1, 1});
    glMemoryBarrier(GL_ALL_BARRIER_BITS);
    m_next += count;
    if (m_next < all)
        return;
    std::vector<std::uint32_t>& sizes = m_field.curve.sizes;
    sizes.resize(sizeCount);
    m_sizes.read(std::span<std::uint32_t>(sizes));
    while (!sizes.empty() && sizes.back() == 0)
        sizes.pop_back();
    m_field.ranges.resize(all);
    m_ranges.read(std::span<std::uint32_t>(m_field.ranges));
    take(Phase::Done);
}

} // namespace gpu
