// SPDX-License-Identifier: Apache-2.0
#include "gpu/kernels/spread/SpreadKernel.h"

#include "gpu/gl/Program.h"
#include "gpu/kernels/criterion/GrowCriterion.h"

#include <algorithm>
#include <array>
#include <set>
#include <utility>

namespace gpu {

namespace {

constexpr std::uint32_t resting = 0xFFFFFFFFu; // spread.glsl
constexpr std::uint32_t changedLabel = 1; // spreadLabel.comp
constexpr std::uint32_t changedWord = 2;
constexpr int leastStepLabels = 2; // below it is no competition

/// Found of spreadInit.comp.
struct Seen {
    std::array<std::int32_t, 3> low{};
    std::array<std::int32_t, 3> high{};
    std::array<std::uint32_t, 8> labels{};
};

Program program(
    const ShaderLibrary& library, const char* path, int connectivity, const char* also = nullptr)
{
    ShaderDefines defines{{"CONNECTIVITY", connectivity}};
    if (also)
        defines.push_back({also, 1});
    return Program(library, ComputeProgramOptions{.label = path, .path = path, .defines = defines});
}

Buffer restingBuffer(const char* label, std::size_t bricks)
{
    Buffer buffer({.label = label, .bytes = bricks * sizeof(std::uint32_t)});
    buffer.fill(resting);
    return buffer;
}

void setSeeds(Program& program, VoxelFields& fields, const core::SpreadLabels& spread)
{
    program.set("volumeSize", fields.grid().volumeSize)
        .set("volumeBricks", fields.grid().bricks())
        .set("seeds", spread.seeds)
        .set("overwritable", spread.overwritable);
    setRange(program, spread.range);
    const core::VoxelBox within =
        spread.within.value_or(core::VoxelBox{glm::ivec3(0), fields.grid().volumeSize});
    program.set("withinLow", within.minimum).set("withinHigh", within.maximum);
    fields.codes().bindUnit(3);
    fields.labels(spread.plane).bindUnit(0);
    BrickField& seedWords = fields.seedWords(spread.plane);
    seedWords.pageTable().bindUnit(1);
    seedWords.atlas().bindUnit(2);
}

/// The box around all seeds, and how many labels have any.
std::pair<core::VoxelBox, int> seedBox(
    Program& find, VoxelFields& fields, const core::SpreadLabels& spread)
{
    std::set<std::uint32_t> holders;
    for (const std::vector<std::uint32_t>& bricks :
        {fields.labelledBricks(), fields.seedWords(spread.plane).heldBricks()})
        holders.insert(bricks.begin(), bricks.end());
    const std::vector<std::uint32_t> bricks(holders.begin(), holders.end());
    if (bricks.empty())
        return {};
    Seen seen;
    const glm::ivec3 size = fields.grid().volumeSize;
    seen.low = {size.x, size.y, size.z};
    seen.high = {-1, -1, -1};
    Buffer found({.label = "spread found", .bytes = sizeof(Seen)});
    found.write(std::span<const Seen>(&seen, 1));
    const Buffer list = bufferOf("spread bricks", bricks);
    setSeeds(find, fields, spread);
    list.bindBase(GL_SHADER_STORAGE_BUFFER, 0);
    found.bindBase(GL_SHADER_STORAGE_BUFFER, 3);
    find.set("brickCount", unsigned(bricks.size()));
    find.dispatch({unsigned(std::min(bricks.size(), mostWorkGroups)), 1, 1});
    glMemoryBarrier(GL_ALL_BARRIER_BITS);
    found.read(std::span<Seen>(&seen, 1));
    int labels = 0;
    for (const std::uint32_t bits : seen.labels)
        labels += int(std::bitset<32>(bits).count());
    return {core::VoxelBox{{seen.low[0], seen.low[1], seen.low[2]},
                {seen.high[0] + 1, seen.high[1] + 1, seen.high[2] + 1}},
        labels};
}

} // namespace

SpreadPrograms::Steps::Steps(const ShaderLibrary& shaders, int connectivity)
    : init(program(shaders, "kernels/spread/spreadInit.comp", connectivity))
    , doubt(program(shaders, "kernels/spread/spreadRelax.comp", connectivity, "DOUBT"))
    , relax(program(shaders, "kernels/spread/spreadRelax.comp", connectivity))
    , label(program(shaders, "kernels/spread/spreadLabel.comp", connectivity))
{
}

SpreadPrograms::Steps& SpreadPrograms::steps(int connectivity)
{
    const auto known = m_steps.find(connectivity);
    if (known != m_steps.end())
        return known->second;
    return m_steps.try_emplace(connectivity, m_shaders, connectivity).first->second;
}

Program& SpreadPrograms::find()
{
    if (!m_find)
        m_find = program(m_shaders, "kernels/spread/spreadInit.comp", 6, "FIND");
    return m_find;
}

core::Result<std::unique_ptr<SpreadKernel>> SpreadKernel::begin(SpreadPrograms& programs,
    VoxelFields& fields, BeforeImages& before, const core::SpreadLabels& spread)
{
    const auto [around, labels] = seedBox(programs.find(), fields, spread);
    if (labels < leastStepLabels)
        return core::failure(core::ErrorCode::InvalidField, QStringLiteral("seeds"),
            core::Clause::saying("fewer than two segments have any"));
    const core::VoxelBox box = core::spreadBox(spread, around, fields.grid().volumeSize);
    return std::unique_ptr<SpreadKernel>(new SpreadKernel(programs, fields, before, spread, box));
}

SpreadKernel::SpreadKernel(SpreadPrograms& programs, VoxelFields& fields, BeforeImages& before,
    const core::SpreadLabels& spread, const core::VoxelBox& box)
    : m_steps(programs.steps(spread.connectivity))
    , m_fields(fields)
    , m_before(before)
    , m_spread(spread)
    , m_field(fields.spread())
    , m_update(m_field.fit(fields.grid(), spread, box))
    , m_pending(restingBuffer("spread pending", m_field.brickCount()))
    , m_doubtful(restingBuffer("spread doubtful", m_field.brickCount()))
{
    for (Program* each : {&m_steps.init, &m_steps.doubt, &m_steps.relax, &m_steps.label}) {
        each->set("volumeSize", fields.grid().volumeSize)
            .set("volumeBricks", fields.grid().bricks())
            .set("boxBricks", m_field.bricks())
            .set("firstBrick", m_field.firstBrick())
            .set("differenceWeight", spread.differenceWeight)
            .set("lengths", std::span<const unsigned>(spread.lengths));
    }
    m_steps.init.set("boxLow", m_field.box().minimum)
        .set("boxHigh", m_field.box().maximum)
        .set("update", m_update);
}

void SpreadKernel::bind()
{
    m_field.words().bindImage(0, GL_READ_WRITE);
    m_pending.bindBase(GL_SHADER_STORAGE_BUFFER, 1);
    m_doubtful.bindBase(GL_SHADER_STORAGE_BUFFER, 2);
}

void SpreadKernel::advance(std::size_t bricks)
{
    switch (m_phase) {
    case Phase::Init:
        init(8 * bricks);
        break;
    case Phase::Doubt:
        if (!settle(m_steps.doubt, m_doubtful, bricks))
            m_phase = Phase::Relax;
        break;
    case Phase::Relax:
        if (!settle(m_steps.relax, m_pending, bricks)) {
            m_field.finished = true;
            m_phase = Phase::Label;
            m_next = 0;
        }
        break;
    case Phase::Label:
        label(4 * bricks);
        break;
    case Phase::Done:
        break;
    }
}

void SpreadKernel::init(std::size_t bricks)
{
    const std::size_t count = std::min({bricks, m_field.brickCount() - m_next, mostWorkGroups});
    setSeeds(m_steps.init, m_fields, m_spread);
    bind();
    m_steps.init.set("firstSlot", unsigned(m_next)).set("brickCount", unsigned(count));
    m_steps.init.dispatch({unsigned(count), 1, 1});
    glMemoryBarrier(GL_ALL_BARRIER_BITS);
    m_next += count;
    if (m_next == m_field.brickCount())
        m_phase = m_update ? Phase::Doubt : Phase::Relax;
}

bool SpreadKernel::settle(Program& program, Buffer& waiting, std::size_t bricks)
{
    std::vector<std::uint32_t> costs(m_field.brickCount());
    waiting.read(std::span<std::uint32_t>(costs));
    std::vector<std::uint32_t> chosen;
    for (std::uint32_t place = 0; place < costs.size(); ++place) {
        if (costs[place] != resting)
            chosen.push_back(place);
    }
    if (chosen.empty())
        return false;
    if (chosen.size() > bricks) {
        // Least first: what comes later is then seldom undercut.
        std::nth_element(chosen.begin(), chosen.begin() + std::ptrdiff_t(bricks), chosen.end(),
            [&costs](std::uint32_t a, std::uint32_t b) { return costs[a] < costs[b]; });
        chosen.resize(bricks);
        std::sort(chosen.begin(), chosen.end());
    }
    for (const std::uint32_t place : chosen)
        costs[place] = resting;
    waiting.write(std::span<const std::uint32_t>(costs));
    m_visits += chosen.size();

    const Buffer list = bufferOf("spread bricks", chosen);
    bind();
    m_fields.codes().bindUnit(0);
    list.bindBase(GL_SHADER_STORAGE_BUFFER, 0);
    program.dispatch({unsigned(chosen.size()), 1, 1});
    glMemoryBarrier(GL_ALL_BARRIER_BITS);
    return true;
}

void SpreadKernel::label(std::size_t bricks)
{
    const std::size_t last = std::min(m_next + bricks, m_field.brickCount());
    std::vector<std::uint32_t> batch;
    for (; m_next < last; ++m_next)
        batch.push_back(m_field.brickAt(m_fields.grid(), m_next));
    if (m_next == m_field.brickCount())
        m_phase = Phase::Done;

    BrickField& seedWords = m_fields.seedWords(m_spread.plane);
    const auto run = [&](const std::vector<std::uint32_t>& list, bool write) {
        std::vector<std::uint32_t> found(list.size(), 0);
        const Buffer bricksBuffer = bufferOf("spread bricks", list);
        const Buffer changed = bufferOf("spread changed", found);
        bind();
        m_fields.labels(m_spread.plane).bindImage(2, GL_READ_WRITE);
        seedWords.pageTable().bindUnit(1);
        seedWords.atlas().bindImage(1, GL_READ_WRITE);
        bricksBuffer.bindBase(GL_SHADER_STORAGE_BUFFER, 0);
        changed.bindBase(GL_SHADER_STORAGE_BUFFER, 3);
        m_steps.label.set("write", write);
        m_steps.label.dispatch({unsigned(list.size()), 1, 1});
        glMemoryBarrier(GL_ALL_BARRIER_BITS);
        changed.read(std::span<std::uint32_t>(found));
        return found;
    };
    const std::vector<std::uint32_t> found = run(batch, false);
    std::vector<std::uint32_t> inLabels;
    std::vector<std::uint32_t> inWords;
    for (std::size_t i = 0; i < batch.size(); ++i) {
        if ((found[i] & changedLabel) != 0)
            inLabels.push_back(batch[i]);
        if ((found[i] & changedWord) != 0)
            inWords.push_back(batch[i]);
    }
    if (inLabels.empty())
        return;
    m_before.capture(core::Field::Labels, m_spread.plane, inLabels);
    m_before.capture(core::Field::SeedWords, m_spread.plane, inWords);
    run(inLabels, true); // a seed word changes only where the label does
    m_fields.noteChanged(core::Field::Labels, inLabels);
    m_fields.noteChanged(core::Field::SeedWords, inWords);
    for (const std::uint32_t brick : inLabels)
        m_keys.push_back({core::Field::Labels, m_spread.plane, brick});
    for (const std::uint32_t brick : inWords)
        m_keys.push_back({core::Field::SeedWords, m_spread.plane, brick});
}

void SpreadKernel::close(bool committed)
{
    if (committed || !m_keep || !m_field.finished)
        m_field.release();
}

} // namespace gpu
