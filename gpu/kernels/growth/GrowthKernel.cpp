// SPDX-License-Identifier: Apache-2.0
#include "gpu/kernels/growth/GrowthKernel.h"

#include "core/growth/SeedWord.h"

#include <algorithm>
#include <cstddef>
#include <iterator>

namespace gpu {

namespace {

constexpr std::uint32_t holdsFront = 2; // growth.glsl
constexpr std::uint32_t smallFront = 256; // voxels that one work group grows from

/// What lies around the seeds of a burst, where it asks for that.
core::GroupedSeedSums sumsFor(
    GrowthPrograms& programs, VoxelFields& fields, const core::GrowBurst& burst)
{
    if (burst.limits.sigmas256 == 0)
        return {};
    return seedSums(programs.seedStatistics, fields,
        {burst.plane, burst.lowCode, burst.highCode, burst.seedGroups});
}

} // namespace

std::vector<std::uint32_t> placeSeeds(GrowthPrograms& programs, VoxelFields& fields,
    BeforeImages& before, const core::SeedPlacement& placement)
{
    std::set<std::uint32_t> brickSet;
    for (const std::vector<glm::ivec3>* voxels : {&placement.taken, &placement.voxels}) {
        for (const glm::ivec3& voxel : *voxels)
            brickSet.insert(std::uint32_t(fields.grid().brickOf(voxel)));
    }
    const std::vector<std::uint32_t> bricks(brickSet.begin(), brickSet.end());
    if (bricks.empty())
        return bricks;
    before.capture(core::Field::SeedWords, placement.plane, bricks);
    BrickField& words = fields.seedWords(placement.plane);
    words.ensure(bricks);

    words.pageTable().bindUnit(1);
    words.atlas().bindImage(0, GL_READ_WRITE);
    programs.placeSeeds.set("label", unsigned(placement.label));
    for (const std::vector<glm::ivec3>* voxels : {&placement.taken, &placement.voxels}) {
        if (voxels->empty())
            continue;
        std::vector<glm::ivec4> padded;
        for (const glm::ivec3& voxel : *voxels)
            padded.emplace_back(voxel, 0);
        Buffer list({.label = "seed voxels", .bytes = padded.size() * sizeof(glm::ivec4)});
        list.write(std::span<const glm::ivec4>(padded));
        list.bindBase(GL_SHADER_STORAGE_BUFFER, 0);
        programs.placeSeeds.set("voxelCount", unsigned(padded.size()))
            .set("take", voxels == &placement.taken);
        programs.placeSeeds.dispatch({unsigned(padded.size() + 63) / 64, 1, 1});
        glMemoryBarrier(GL_ALL_BARRIER_BITS);
    }
    return bricks;
}

GrowthKernel::GrowthKernel(GrowthPrograms& programs, VoxelFields& fields, BeforeImages& before,
    const core::GrowBurst& burst)
    : m_programs(programs)
    , m_fields(fields)
    , m_before(before)
    , m_burst(burst)
    , m_mayTake(burst.tellsHeld && burst.overwritable.any())
    // What is there by now may be gone once this growth is shrunk, and must not come back then.
    , m_kind{.connectivity = burst.connectivity,
          .limits = burst.limits,
          .overwritten = m_mayTake || fields.anyOverwritten(burst.plane),
          .ranged = burst.range.has_value()}
    , m_growing(programs.rings(m_kind))
    , m_rings(m_growing.get())
    , m_criterion(burst, sumsFor(programs, fields, burst))
    , m_state({.label = "growth state", .bytes = sizeof(State)})
    , m_openGeneration(burst.generation)
    , m_generation(burst.generation)
    , m_prepared(std::size_t(fields.grid().brickCount()), false)
{
    setQueues(1u << 18);
    for (Program* each :
        {&m_rings->admit, &m_rings->front, &m_rings->ring, &m_rings->severalRings, &m_rings->label})
        setUniforms(*each);
    if (core::isAsked(burst.limits.passage))
        m_passage.emplace(programs.passage, fields, burst);
    if (burst.guard)
        m_guard.emplace(fields.grid(), *burst.guard);
}

void GrowthKernel::setUniforms(Program& each) const
{
    each.set("volumeSize", m_fields.grid().volumeSize)
        .set("volumeBricks", m_fields.grid().bricks())
        .set("overwritable", m_burst.overwritable)
        .set("lockedLabels", m_burst.lockedLabels)
        .set("tellsHeld", m_burst.tellsHeld)
        .set("openGeneration", m_openGeneration)
        .set("queueCapacity", m_queueCapacity);
    if (m_burst.range)
        setRange(each, *m_burst.range);
    m_criterion.setUniforms(each);
}

void GrowthKernel::bind()
{
    BrickField& words = m_fields.seedWords(m_burst.plane);
    words.atlas().bindImage(0, GL_READ_WRITE);
    m_fields.labels(m_burst.plane).bindImage(1, GL_READ_WRITE);
    m_fields.codes().bindImage(2, GL_READ_ONLY);
    m_criterion.bind(m_fields);
    if (m_passage)
        m_passage->bind();
    words.pageTable().bindImage(3, GL_READ_ONLY);
    if (m_kind.overwritten) {
        BrickField& overwritten = m_fields.overwritten(m_burst.plane);
        overwritten.atlas().bindImage(4, GL_READ_WRITE);
        overwritten.pageTable().bindUnit(3);
    }
    words.pageOwners().bindBase(GL_SHADER_STORAGE_BUFFER, 5);
    m_state.bindBase(GL_SHADER_STORAGE_BUFFER, 0);
    m_queues.bindBase(GL_SHADER_STORAGE_BUFFER, 1);
    m_reached.bindBase(GL_SHADER_STORAGE_BUFFER, 3);
}

void GrowthKernel::setQueues(std::uint32_t capacity)
{
    m_queueCapacity = capacity;
    m_queues = Buffer(
        {.label = "growth fronts", .bytes = 2 * std::size_t(capacity) * sizeof(std::uint32_t)});
    for (Program* each : {&m_rings->front, &m_rings->ring, &m_rings->severalRings})
        each->set("queueCapacity", m_queueCapacity);
    if (!m_floodsBack)
        m_rings->label.set("queueCapacity", m_queueCapacity);
}

void GrowthKernel::start(const State& state)
{
    m_state.write(std::span<const State>(&state, 1));
    const std::size_t pageBytes = m_fields.seedWords(m_burst.plane).pageOwners().bytes();
    if (m_reached.bytes() != pageBytes)
        m_reached = Buffer({.label = "growth reached pages", .bytes = pageBytes});
    m_reached.fill(0);
    bind();
}

void GrowthKernel::open()
{
    const std::vector<std::uint32_t> held = m_fields.seedWords(m_burst.plane).heldBricks();
    if (held.empty())
        return;
    capture(held);
    if (m_burst.opening == core::GrowOpening::Narrow)
        narrow(held);
    else if (m_burst.opening == core::GrowOpening::Restart)
        restart();
    setOpenGeneration();
    if (m_generation < core::seedWord::maxGeneration)
        admitSeeds(m_programs.growsOnProcessor() ? withPendingSeeds(held) : held);
    const std::vector<std::uint32_t> now = m_fields.seedWords(m_burst.plane).heldBricks();
    if (!findFrontOnProcessor(now))
        findFront(now);
}

void GrowthKernel::setOpenGeneration()
{
    m_openGeneration = m_generation;
    for (Program* each :
        {&m_rings->admit, &m_rings->front, &m_rings->ring, &m_rings->severalRings, &m_rings->label})
        each->set("openGeneration", m_openGeneration);
}

void GrowthKernel::admitSeeds(const std::vector<std::uint32_t>& held)
{
    if (held.empty())
        return;
    m_rings->admit.set("admittedGeneration", m_generation + 1);
    const std::uint32_t admitted = runOver(m_rings->admit, held).admitted;
    if (admitted == 0)
        return;
    ++m_generation;
    m_frontSizes.push_back(admitted);
    m_members = admitted;
    watch(frontInWords());
}

GrowthKernel::State GrowthKernel::runOver(
    Program& program, const std::vector<std::uint32_t>& bricks)
{
    start({});
    for (std::size_t first = 0; first < bricks.size(); first += mostWorkGroups) {
        const auto piece =
            std::span(bricks).subspan(first, std::min(mostWorkGroups, bricks.size() - first));
        const Buffer list = bufferOf("growth bricks", piece);
        list.bindBase(GL_SHADER_STORAGE_BUFFER, 4);
        program.dispatch({unsigned(piece.size()), 1, 1});
    }
    glMemoryBarrier(GL_ALL_BARRIER_BITS);
    return takeBatch();
}

void GrowthKernel::findFront(const std::vector<std::uint32_t>& bricks)
{
    // Members of before are no claims of this burst: the bricks found count as front only.
    const std::set<std::uint32_t> touchedBefore = m_allTouched;
    for (;;) {
        m_rings->front.set("firstQueue", 1 - m_frontQueue);
        const State found = runOver(m_rings->front, bricks);
        m_frontCount = found.counts[1];
        m_onlyLabel.reset();
        if (found.greatestLabel + found.leastLabelDown == 255)
            m_onlyLabel = std::uint8_t(found.greatestLabel);
        if (m_frontCount <= m_queueCapacity)
            break;
        setQueues(4 * m_queueCapacity);
    }
    m_allTouched = touchedBefore;
}

void GrowthKernel::capture(std::span<const std::uint32_t> bricks)
{
    m_before.capture(core::Field::SeedWords, m_burst.plane, bricks);
    m_before.capture(core::Field::Labels, m_burst.plane, bricks);
    if (!m_kind.overwritten)
        return;
    m_before.capture(core::Field::Overwritten, m_burst.plane, bricks);
    if (!m_mayTake)
        return;
    BrickField& overwritten = m_fields.overwritten(m_burst.plane);
    for (const std::uint32_t brick : bricks) {
        if (!overwritten.holds(brick))
            m_newOverwritten.insert(brick);
    }
    overwritten.ensure(bricks);
}

std::vector<std::uint32_t> GrowthKernel::prepareBricks()
{
    std::vector<std::uint32_t> reachable = m_fields.withNeighbours(m_frontBricks);
    releaseUnused(reachable);
    prepare(reachable, BrickField::NewPages::Empty);
    return reachable;
}

std::vector<std::uint32_t> GrowthKernel::prepare(
    std::vector<std::uint32_t> bricks, BrickField::NewPages pages)
{
    std::erase_if(bricks, [this](std::uint32_t brick) { return m_prepared[brick]; });
    if (bricks.empty())
        return bricks;
    BrickField& words = m_fields.seedWords(m_burst.plane);
    capture(bricks);
    for (const std::uint32_t brick : bricks)
        m_prepared[brick] = true;
    std::erase_if(bricks, [&](std::uint32_t brick) { return words.holds(brick); });
    m_newPages.insert(bricks.begin(), bricks.end());
    words.ensure(bricks, pages);
    return bricks;
}

void GrowthKernel::chooseForm(const std::vector<std::uint32_t>& bricks)
{
    const bool wide = !m_guard && m_onlyLabel && FrontBits::isFor(m_burst.limits)
        && m_frontBits.pays(m_frontCount, bricks.size());
    if (wide && !m_frontBits.holdsFront()) {
        m_bitPrograms = m_programs.frontBits(m_kind);
        FrontBitsPrograms& programs = *m_bitPrograms;
        for (Program* each :
            {&programs.open, &programs.fill, &programs.reach, &programs.ring, &programs.end})
            setUniforms(*each);
        programs.fill.set("firstQueue", m_frontQueue);
        State state;
        state.counts[0] = m_frontCount;
        start(state);
        m_frontBits.enter(programs, m_fields.grid().brickCount(),
            {.label = *m_onlyLabel, .generation = m_generation, .voxels = m_frontCount});
    } else if (!wide && m_frontBits.holdsFront()) {
        m_frontBits.leave();
        const std::vector<std::uint32_t> frontBricks = m_frontBricks;
        findFront(frontBricks);
    }
}

void GrowthKernel::preparePassages()
{
    if (!m_passage)
        return;
    m_passage->prepare(m_criterion, m_frontBricks);
    for (Program* each : {&m_rings->ring, &m_rings->severalRings})
        m_passage->setUniforms(*each);
}

void GrowthKernel::runRings(int count)
{
    for (Program* each : {&m_rings->ring, &m_rings->severalRings})
        each->set("firstQueue", m_frontQueue).set("baseGeneration", m_generation);
    if (!m_floodsBack)
        m_rings->label.set("firstQueue", m_frontQueue);
    m_frontQueue = (m_frontQueue + unsigned(count)) % 2;

    int ring = 0;
    if (m_frontCount <= smallFront) {
        m_rings->severalRings.set("ringCount", unsigned(count));
        m_rings->severalRings.dispatch({1, 1, 1});
        glMemoryBarrier(GL_ALL_BARRIER_BITS);
        State state;
        m_state.read(std::span<State>(&state, 1));
        ring = int(state.nextRing);
        if (ring == count)
            return;
    }
    // A front that outgrows these groups is walked in strides; in few where a voxel is asked in
    // loops (growCriterion.glsl says why).
    const bool isLong = m_burst.limits.majority > 0 || m_burst.limits.gradientDifference;
    const glm::uvec3 groups(
        std::clamp((2 * m_frontCount + 255) / 256, isLong ? 64u : 1u, 65535u), 1, 1);
    for (; ring < count; ++ring) {
        m_rings->ring.set("ring", unsigned(ring));
        m_rings->ring.dispatch(groups);
        glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
    }
    if (m_floodsBack) {
        glMemoryBarrier(GL_ALL_BARRIER_BITS);
        return;
    }
    m_rings->label.set("ring", unsigned(count));
    m_rings->label.dispatch(groups);
    glMemoryBarrier(GL_ALL_BARRIER_BITS);
}

int GrowthKernel::advance(int rings)
{
    if (!m_guard)
        return advanceBatch(rings);
    int done = 0;
    while (done < std::min(rings, ringsPerBatch) && !m_alarm && advanceBatch(1) == 1)
        ++done;
    return done;
}

int GrowthKernel::advanceBatch(int rings)
{
    const std::uint32_t left = core::seedWord::maxGeneration - m_generation;
    const int wanted = std::min<int>({rings, ringsPerBatch, int(std::min(left, 16u))});
    if (m_atClosure || wanted == 0)
        return 0;
    int done = 0;
    if (m_frontCount > 0 && isOnProcessor()) {
        done = advanceOnProcessor(wanted);
    } else if (m_frontCount > 0) {
        const std::vector<std::uint32_t> reachable = prepareBricks();
        preparePassages();
        chooseForm(reachable);
        State state;
        state.counts[0] = m_frontCount;
        start(state);
        if (m_frontBits.holdsFront())
            m_frontBits.advance(*m_bitPrograms, m_fields.seedWords(m_burst.plane),
                m_fields.grid().bricks(), m_generation, wanted, reachable);
        else
            runRings(wanted);
        state = takeBatch();
        while (done < wanted && state.counts[std::size_t(done) + 1] > 0)
            ++done;
        count(std::span(state.counts).subspan(1, std::size_t(done)));
        m_frontCount = state.counts[std::size_t(wanted)];
        if (!m_frontBits.holdsFront() && done > 0
            && state.counts[std::size_t(done)] > m_queueCapacity) {
            // The ring that overflowed is complete in the words; only its list is not. So it is not
            // known which bricks it came to: it may have ended in some, where no front is found.
            m_lastTouched = reachable;
            m_allTouched.insert(reachable.begin(), reachable.end());
            m_fields.noteChanged(core::Field::Labels, reachable);
            watch(frontInWords());
            setQueues(4 * m_queueCapacity);
            findFront(m_fields.seedWords(m_burst.plane).heldBricks());
            return done + advanceBatch(wanted - done);
        }
        if (m_guard && done > 0)
            watch(listedFront());
    }
    m_atClosure = done < wanted;
    return done;
}

void GrowthKernel::count(std::span<const std::uint32_t> sizes)
{
    for (const std::uint32_t size : sizes) {
        m_frontSizes.push_back(size);
        m_members += size;
    }
    m_generation += std::uint32_t(sizes.size());
}

GrowthKernel::State GrowthKernel::takeBatch()
{
    State state;
    m_state.read(std::span<State>(&state, 1));
    std::vector<std::uint32_t> reached(m_reached.bytes() / sizeof(std::uint32_t));
    m_reached.read(std::span<std::uint32_t>(reached));
    m_frontBricks.clear();
    std::vector<std::uint32_t> touched;
    const BrickField& words = m_fields.seedWords(m_burst.plane);
    for (std::uint32_t page = 0; page < reached.size(); ++page) {
        if (reached[page] == 0)
            continue;
        touched.push_back(words.ownerOf(page));
        if (reached[page] == holdsFront)
            m_frontBricks.push_back(touched.back());
    }
    m_allTouched.insert(touched.begin(), touched.end());
    m_lastTouched = touched;
    if (!touched.empty())
        m_fields.noteChanged(core::Field::Labels, touched);
    return state;
}

std::vector<std::uint32_t> GrowthKernel::touchedBricks() const
{
    return {m_allTouched.begin(), m_allTouched.end()};
}

void GrowthKernel::releaseUnused(std::span<const std::uint32_t> reachable)
{
    std::vector<std::uint32_t> unused;
    for (const std::uint32_t brick : m_newPages) {
        if (m_allTouched.count(brick) == 0
            && !std::binary_search(reachable.begin(), reachable.end(), brick))
            unused.push_back(brick);
    }
    for (const std::uint32_t brick : unused) {
        m_newPages.erase(brick);
        m_prepared[brick] = false;
    }
    m_fields.seedWords(m_burst.plane).release(unused);
    if (!m_mayTake)
        return;
    std::erase_if(
        unused, [this](std::uint32_t brick) { return m_newOverwritten.erase(brick) == 0; });
    m_fields.overwritten(m_burst.plane).release(unused);
}

void GrowthKernel::releaseOverwritten(std::span<const core::BrickChange> changes)
{
    if (!m_mayTake)
        return;
    for (const core::BrickChange& change : changes) {
        if (change.key.field == core::Field::Overwritten && !change.after.empty())
            m_newOverwritten.erase(change.key.brick);
    }
    m_fields.overwritten(m_burst.plane)
        .release(std::vector<std::uint32_t>(m_newOverwritten.begin(), m_newOverwritten.end()));
    m_newOverwritten.clear();
}

} // namespace gpu
