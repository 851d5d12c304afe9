// SPDX-License-Identifier: Apache-2.0
#include "gpu/edit/GrowthKernel.h"

#include "core/growth/SeedWord.h"

#include <algorithm>
#include <cstddef>
#include <iterator>

namespace gpu {

namespace {

Program program(const ShaderLibrary& library, const char* path)
{
    return Program(library, ComputeProgramOptions{.label = path, .path = path, .defines = {}});
}

Buffer listBuffer(std::span<const std::uint32_t> list)
{
    Buffer buffer({.label = "growth bricks", .bytes = std::max<std::size_t>(list.size_bytes(), 4)});
    buffer.write(list);
    return buffer;
}

} // namespace

GrowthPrograms::GrowthPrograms(const ShaderLibrary& library)
    : placeSeeds(program(library, "edit/placeSeeds.comp"))
    , admit(program(library, "edit/growAdmit.comp"))
    , front(program(library, "edit/growFront.comp"))
    , ring(program(library, "edit/growRing.comp"))
    , advance(program(library, "edit/growAdvance.comp"))
    , label(program(library, "edit/growLabel.comp"))
{
}

std::vector<std::uint32_t> placeSeeds(GrowthPrograms& programs, VoxelFields& fields,
    BeforeImages& before, const core::SeedPlacement& placement)
{
    std::vector<glm::ivec4> voxels;
    std::set<std::uint32_t> brickSet;
    for (const glm::ivec3& voxel : placement.voxels) {
        voxels.emplace_back(voxel, 0);
        brickSet.insert(std::uint32_t(fields.grid().brickOf(voxel)));
    }
    const std::vector<std::uint32_t> bricks(brickSet.begin(), brickSet.end());
    if (bricks.empty())
        return bricks;
    before.capture(core::Field::SeedWords, placement.plane, bricks);
    BrickField& words = fields.seedWords(placement.plane);
    words.ensure(bricks);

    Buffer list({.label = "seed voxels", .bytes = voxels.size() * sizeof(glm::ivec4)});
    list.write(std::span<const glm::ivec4>(voxels));
    words.pageTable().bindUnit(1);
    words.atlas().bindImage(0, GL_READ_WRITE);
    list.bindBase(GL_SHADER_STORAGE_BUFFER, 0);
    programs.placeSeeds.set("voxelCount", unsigned(voxels.size()))
        .set("label", unsigned(placement.label));
    programs.placeSeeds.dispatch({unsigned(voxels.size() + 63) / 64, 1, 1});
    glMemoryBarrier(GL_ALL_BARRIER_BITS);
    return bricks;
}

GrowthKernel::GrowthKernel(GrowthPrograms& programs, VoxelFields& fields, BeforeImages& before,
    const core::GrowBurst& burst)
    : m_programs(programs)
    , m_fields(fields)
    , m_before(before)
    , m_burst(burst)
    , m_state({.label = "growth state", .bytes = sizeof(State)})
    , m_touched({.label = "growth touched bricks",
          .bytes = std::size_t(fields.grid().brickCount() + 31) / 32 * sizeof(std::uint32_t)})
    , m_generation(burst.generation)
{
    for (Buffer& queue : m_queues)
        queue = Buffer({.label = "growth front", .bytes = m_queueCapacity * sizeof(std::uint32_t)});
    for (Program* each : {&programs.admit, &programs.front, &programs.ring, &programs.label})
        setCriterion(*each);
    programs.front.set("openGeneration", burst.generation);
}

void GrowthKernel::setCriterion(Program& each) const
{
    // An empty interval is one whose low end no code reaches.
    const bool none = m_burst.lowCode > m_burst.highCode || m_burst.highCode < 0;
    std::array<unsigned, 8> overwritable{};
    for (std::size_t label = 0; label < 256; ++label) {
        if (m_burst.overwritable[label])
            overwritable[label / 32] |= 1u << (label % 32);
    }
    each.set("volumeSize", m_fields.grid().volumeSize)
        .set("volumeBricks", m_fields.grid().bricks())
        .set("lowCode", none ? 65536u : unsigned(std::max(m_burst.lowCode, 0)))
        .set("highCode", none ? 0u : unsigned(m_burst.highCode))
        .set("overwritable", std::span<const unsigned>(overwritable))
        .set("queueCapacity", m_queueCapacity);
}

void GrowthKernel::bind()
{
    BrickField& words = m_fields.seedWords(m_burst.plane);
    m_fields.codes().bindUnit(0);
    words.pageTable().bindUnit(1);
    words.atlas().bindImage(0, GL_READ_WRITE);
    m_fields.labels(m_burst.plane).bindImage(1, GL_READ_WRITE);
    m_state.bindBase(GL_SHADER_STORAGE_BUFFER, 0);
    m_queues[0].bindBase(GL_SHADER_STORAGE_BUFFER, 1);
    m_queues[1].bindBase(GL_SHADER_STORAGE_BUFFER, 2);
    m_touched.bindBase(GL_SHADER_STORAGE_BUFFER, 3);
}

void GrowthKernel::open()
{
    const std::vector<std::uint32_t> held = m_fields.seedWords(m_burst.plane).heldBricks();
    if (held.empty())
        return;
    m_before.capture(core::Field::SeedWords, m_burst.plane, held);
    m_before.capture(core::Field::Labels, m_burst.plane, held);

    m_state.fill(0);
    m_touched.fill(0);
    bind();
    const Buffer list = listBuffer(held);
    if (m_generation < core::seedWord::maxGeneration) {
        list.bindBase(GL_SHADER_STORAGE_BUFFER, 4);
        m_programs.admit.set("admittedGeneration", m_generation + 1);
        m_programs.admit.dispatch({unsigned(held.size()), 1, 1});
        glMemoryBarrier(GL_ALL_BARRIER_BITS);
        const std::uint32_t admitted = takeBatch().ringSizes[0];
        if (admitted > 0) {
            ++m_generation;
            m_frontSizes.push_back(admitted);
            m_members = admitted;
        }
    }
    findFront();
}

void GrowthKernel::findFront()
{
    const std::vector<std::uint32_t> held = m_fields.seedWords(m_burst.plane).heldBricks();
    for (;;) {
        m_state.write(std::span<const State>(std::array{State{.generation = m_generation}}));
        m_touched.fill(0);
        bind();
        const Buffer list = listBuffer(held);
        list.bindBase(GL_SHADER_STORAGE_BUFFER, 4);
        m_programs.front.dispatch({unsigned(held.size()), 1, 1});
        glMemoryBarrier(GL_ALL_BARRIER_BITS);
        State state;
        m_state.read(std::span<State>(&state, 1));
        if (state.overflow == 0)
            break;
        enlargeQueues();
    }
    m_programs.advance.set("countsAsRing", false);
    m_programs.advance.dispatch({1, 1, 1});
    glMemoryBarrier(GL_ALL_BARRIER_BITS);
    std::swap(m_queues[0], m_queues[1]);

    // The front's bricks are those it was found in; what was claimed before is known already.
    const std::set<std::uint32_t> claimedBefore = std::move(m_allTouched);
    m_allTouched.clear();
    takeBatch();
    m_allTouched = claimedBefore;
}

void GrowthKernel::enlargeQueues()
{
    m_queueCapacity *= 4;
    for (Buffer& queue : m_queues)
        queue = Buffer({.label = "growth front", .bytes = m_queueCapacity * sizeof(std::uint32_t)});
    for (Program* each : {&m_programs.front, &m_programs.ring})
        each->set("queueCapacity", m_queueCapacity);
}

void GrowthKernel::prepareBricks()
{
    const std::vector<std::uint32_t> reachable = m_fields.withNeighbours(m_frontBricks);
    BrickField& words = m_fields.seedWords(m_burst.plane);
    m_before.capture(core::Field::SeedWords, m_burst.plane, reachable);
    m_before.capture(core::Field::Labels, m_burst.plane, reachable);
    for (const std::uint32_t brick : reachable) {
        if (!words.holds(brick))
            m_newPages.insert(brick);
    }
    words.ensure(reachable);
}

int GrowthKernel::advance(int rings)
{
    const std::uint32_t left = core::seedWord::maxGeneration - m_generation;
    const int wanted = std::min<int>({rings, ringsPerBatch, int(std::min(left, 16u))});
    if (m_atClosure || wanted == 0)
        return 0;
    int done = 0;
    if (!m_frontBricks.empty()) {
        prepareBricks();
        // Counters of this batch start afresh; the front and its dispatch size stay.
        m_state.fill(0, offsetof(State, ringsDone), sizeof(State) - offsetof(State, ringsDone));
        m_touched.fill(0);
        m_programs.advance.set("countsAsRing", true);
        for (int ring = 0; ring < wanted; ++ring) {
            bind();
            m_programs.ring.dispatchIndirect(m_state);
            glMemoryBarrier(GL_ALL_BARRIER_BITS);
            m_programs.advance.dispatch({1, 1, 1});
            glMemoryBarrier(GL_ALL_BARRIER_BITS);
            std::swap(m_queues[0], m_queues[1]);
        }
        bind();
        m_programs.label.dispatchIndirect(m_state);
        glMemoryBarrier(GL_ALL_BARRIER_BITS);

        const State state = takeBatch();
        done = int(state.ringsDone);
        m_generation = state.generation;
        for (int ring = 0; ring < done; ++ring) {
            m_frontSizes.push_back(state.ringSizes[std::size_t(ring)]);
            m_members += state.ringSizes[std::size_t(ring)];
        }
        if (state.overflow != 0) {
            // The ring that overflowed is complete in the words; only its list is not.
            enlargeQueues();
            findFront();
            return done + advance(wanted - done);
        }
    }
    m_atClosure = done < wanted;
    return done;
}

GrowthKernel::State GrowthKernel::takeBatch()
{
    State state;
    m_state.read(std::span<State>(&state, 1));
    std::vector<std::uint32_t> bits(m_touched.bytes() / sizeof(std::uint32_t));
    m_touched.read(std::span<std::uint32_t>(bits));
    m_frontBricks.clear();
    for (std::uint32_t word = 0; word < bits.size(); ++word) {
        for (std::uint32_t bit = 0; bit < 32 && bits[word] >> bit != 0; ++bit) {
            if ((bits[word] >> bit & 1u) != 0)
                m_frontBricks.push_back(word * 32 + bit);
        }
    }
    m_allTouched.insert(m_frontBricks.begin(), m_frontBricks.end());
    if (!m_frontBricks.empty())
        m_fields.noteChanged(core::Field::Labels, m_frontBricks);
    return state;
}

std::vector<std::uint32_t> GrowthKernel::touchedBricks() const
{
    return {m_allTouched.begin(), m_allTouched.end()};
}

void GrowthKernel::releaseUnused()
{
    std::vector<std::uint32_t> unused;
    std::set_difference(m_newPages.begin(), m_newPages.end(), m_allTouched.begin(),
        m_allTouched.end(), std::back_inserter(unused));
    m_fields.seedWords(m_burst.plane).release(unused);
}

} // namespace gpu
