// SPDX-License-Identifier: Apache-2.0
#include "gpu/kernels/passage/PassageField.h"

#include "gpu/gl/Program.h"

#include <algorithm>

namespace gpu {

namespace {

constexpr std::size_t pageBytes = 4 * 4096 / 8; // four sets of bits
constexpr std::uint32_t firstPages = 1024;
constexpr std::uint32_t mostPages = 65536; // 128 MiB: what every driver gives a storage buffer
// Bricks worked on at once: with all around them that they look at they fit mostPages.
constexpr std::size_t bricksAtOnce = 256;
constexpr std::size_t roomsKept = 4096; // bricks; beyond that only what the front is near
constexpr int deepestTexture = 2048; // the least that GL promises

Program program(const ShaderLibrary& library, const char* path, const ShaderDefines& defines = {})
{
    return Program(library, ComputeProgramOptions{.label = path, .path = path, .defines = defines});
}

} // namespace

Program& PassagePrograms::labels()
{
    if (!m_labels)
        m_labels = program(m_shaders, "kernels/passage/passageLabels.comp");
    return m_labels;
}

std::shared_ptr<Program> PassagePrograms::free(
    const core::GrowLimits& limits, bool overwritten, bool ranged)
{
    return m_free.of({kindOf(limits), overwritten, ranged}, [&] {
        ShaderDefines defines = definesOf(limits);
        if (overwritten)
            defines.emplace_back("OVERWRITTEN", 1);
        if (ranged)
            defines.emplace_back("RANGE", 1);
        return std::make_shared<Program>(
            program(m_shaders, "kernels/passage/passageFree.comp", defines));
    });
}

Program& PassagePrograms::centres()
{
    if (!m_centres)
        m_centres = program(m_shaders, "kernels/passage/passageCentres.comp");
    return m_centres;
}

Program& PassagePrograms::room()
{
    if (!m_room)
        m_room = program(m_shaders, "kernels/passage/passageRoom.comp");
    return m_room;
}

PassageField::PassageField(
    PassagePrograms& programs, VoxelFields& fields, const core::GrowBurst& burst)
    : m_programs(programs)
    , m_fields(fields)
    , m_burst(burst)
{
    const glm::uvec3 spacing(burst.limits.passage.spacing);
    const glm::ivec3 reach = core::reachOf(burst.limits.passage);
    for (Program* each : {&m_programs.centres(), &m_programs.room()})
        each->set("volumeSize", m_fields.grid().volumeSize)
            .set("volumeBricks", m_fields.grid().bricks())
            .set("spacing", spacing)
            .set("reach", reach)
            .set("greatest", unsigned(burst.limits.passage.reach));
}

std::size_t PassageField::place(std::uint32_t slot, std::uint32_t brick) const
{
    return std::size_t(slot) * std::size_t(m_fields.grid().brickCount()) + brick;
}

std::uint32_t PassageField::roomBrick(std::uint32_t slot, std::uint32_t brick) const
{
    const glm::ivec3 bricks = m_fields.grid().bricks();
    const glm::ivec3 shift(
        0, int(slot) % m_slotsAcross * bricks.y, int(slot) / m_slotsAcross * bricks.z);
    return std::uint32_t(m_roomGrid.brickOf(
        core::BrickGrid::side * (m_fields.grid().brickPosition(int(brick)) + shift)));
}

void PassageField::setGrowthUniforms(Program& each, const GrowCriterion& criterion) const
{
    each.set("volumeSize", m_fields.grid().volumeSize)
        .set("volumeBricks", m_fields.grid().bricks())
        .set("overwritable", m_burst.overwritable)
        .set("lockedLabels", m_burst.lockedLabels);
    if (m_burst.range)
        setRange(each, *m_burst.range);
    criterion.setUniforms(each);
    BrickField& words = m_fields.seedWords(m_burst.plane);
    words.atlas().bindImage(0, GL_READ_WRITE);
    m_fields.labels(m_burst.plane).bindImage(1, GL_READ_WRITE);
    m_fields.codes().bindImage(2, GL_READ_ONLY);
    words.pageTable().bindImage(3, GL_READ_ONLY);
    if (looksBelow()) {
        BrickField& overwritten = m_fields.overwritten(m_burst.plane);
        overwritten.atlas().bindImage(4, GL_READ_WRITE);
        overwritten.pageTable().bindUnit(3);
    }
    criterion.bind(m_fields);
}

/// Only a range asks what was there before growth came.
bool PassageField::looksBelow() const
{
    return m_burst.range && (m_burst.overwritable.any() || m_fields.anyOverwritten(m_burst.plane));
}

std::vector<PassageField::LabelBits> PassageField::labelsIn(
    const GrowCriterion& criterion, const std::vector<std::uint32_t>& bricks)
{
    std::vector<LabelBits> found(bricks.size());
    Program& labels = m_programs.labels();
    setGrowthUniforms(labels, criterion);
    for (std::size_t first = 0; first < bricks.size(); first += mostWorkGroups) {
        const std::size_t count = std::min(mostWorkGroups, bricks.size() - first);
        const Buffer list = bufferOf("passage bricks", std::span(bricks).subspan(first, count));
        Buffer answers({.label = "passage labels", .bytes = count * sizeof(LabelBits)});
        list.bindBase(GL_SHADER_STORAGE_BUFFER, 4);
        answers.bindBase(GL_SHADER_STORAGE_BUFFER, 6);
        labels.dispatch({unsigned(count), 1, 1});
        glMemoryBarrier(GL_ALL_BARRIER_BITS);
        answers.read(std::span(found).subspan(first, count));
    }
    return found;
}

void PassageField::giveSlots(const GrowCriterion& criterion)
{
    LabelBits all{};
    const auto perBrick = labelsIn(criterion, m_fields.seedWords(m_burst.plane).heldBricks());
    for (const LabelBits& bits : perBrick) {
        for (std::size_t word = 0; word < all.size(); ++word)
            all[word] |= bits[word];
    }
    for (std::uint32_t label = 0; label < 256; ++label) {
        if (all[label / 32] >> label % 32 & 1u)
            m_labels.push_back(label);
    }
    const int slots = int(m_labels.size());
    const glm::ivec3 bricks = m_fields.grid().bricks();
    m_slotsAcross = std::clamp(deepestTexture / bricks.y, 1, std::max(slots, 1));
    const int rows = (slots + m_slotsAcross - 1) / m_slotsAcross;
    m_roomGrid.volumeSize =
        core::BrickGrid::side * bricks * glm::ivec3(1, m_slotsAcross, std::max(rows, 1));
    m_rooms = BrickField(
        {.label = "rooms", .format = GL_R32UI, .emptyVoxel = 0xFFFFFFFFu, .grid = m_roomGrid});
    m_pages.assign(place(std::uint32_t(slots), 0), 0);
    m_known.assign(m_pages.size(), Known::Nothing);
    m_pageTable = Buffer({.label = "passage pages",
        .bytes = std::max<std::size_t>(m_pages.size(), 1) * sizeof(std::uint32_t)});
    m_bits = Buffer({.label = "passage bits", .bytes = firstPages * pageBytes});
    m_programs.room().set("slotsAcross", unsigned(m_slotsAcross));
}

void PassageField::prepare(
    const GrowCriterion& criterion, const std::vector<std::uint32_t>& frontBricks)
{
    if (frontBricks.empty())
        return;
    if (m_labels.empty())
        giveSlots(criterion);
    std::vector<std::vector<std::uint32_t>> bySlot(m_labels.size());
    if (m_labels.size() == 1) {
        bySlot[0] = frontBricks;
    } else {
        const std::vector<LabelBits> labels = labelsIn(criterion, frontBricks);
        for (std::size_t i = 0; i < frontBricks.size(); ++i) {
            for (std::size_t slot = 0; slot < m_labels.size(); ++slot) {
                if (labels[i][m_labels[slot] / 32] >> m_labels[slot] % 32 & 1u)
                    bySlot[slot].push_back(frontBricks[i]);
            }
        }
    }
    std::vector<std::uint32_t> needed; // of the grid of rooms
    for (std::uint32_t slot = 0; slot < bySlot.size(); ++slot) {
        bySlot[slot] = m_fields.withNeighbours(bySlot[slot]);
        for (const std::uint32_t brick : bySlot[slot])
            needed.push_back(roomBrick(slot, brick));
    }
    std::vector<std::uint32_t> held = m_rooms.heldBricks();
    if (held.size() + needed.size() > roomsKept) {
        std::sort(needed.begin(), needed.end());
        std::erase_if(held, [&needed](std::uint32_t brick) {
            return std::binary_search(needed.begin(), needed.end(), brick);
        });
        m_rooms.release(held);
    }
    for (std::uint32_t slot = 0; slot < bySlot.size(); ++slot) {
        std::vector<std::uint32_t>& bricks = bySlot[slot];
        std::erase_if(bricks,
            [this, slot](std::uint32_t brick) { return m_rooms.holds(roomBrick(slot, brick)); });
        for (std::size_t first = 0; first < bricks.size(); first += bricksAtOnce) {
            const auto begin = bricks.begin() + std::ptrdiff_t(first);
            const auto end = begin + std::ptrdiff_t(std::min(bricksAtOnce, bricks.size() - first));
            workOut(criterion, slot, {begin, end});
        }
    }
}

void PassageField::workOut(
    const GrowCriterion& criterion, std::uint32_t slot, const std::vector<std::uint32_t>& bricks)
{
    // Rooms look at centres in the bricks beside them, and these at what is free beside them.
    const std::vector<std::uint32_t> near = m_fields.withNeighbours(bricks);
    const std::vector<std::uint32_t> far = m_fields.withNeighbours(near);
    takePages(slot, far);

    const std::shared_ptr<Program> held =
        m_programs.free(m_burst.limits, looksBelow(), m_burst.range.has_value());
    Program& free = *held;
    setGrowthUniforms(free, criterion);
    run(free, jobsFor(slot, far, Known::Free));
    run(m_programs.centres(), jobsFor(slot, near, Known::Centres));

    std::vector<std::uint32_t> rooms;
    std::vector<Job> jobs;
    for (const std::uint32_t brick : bricks) {
        rooms.push_back(roomBrick(slot, brick));
        jobs.push_back({.brick = brick, .slot = slot, .label = m_labels[slot], .page = 0});
    }
    m_rooms.ensure(rooms, BrickField::NewPages::AnyContent);
    m_rooms.pageTable().bindUnit(2);
    m_rooms.atlas().bindImage(0, GL_READ_WRITE);
    run(m_programs.room(), jobs);
}

void PassageField::takePages(std::uint32_t slot, const std::vector<std::uint32_t>& bricks)
{
    const auto missing = [&] {
        return std::uint32_t(std::count_if(bricks.begin(), bricks.end(),
            [&](std::uint32_t brick) { return m_pages[place(slot, brick)] == 0; }));
    };
    if (m_pagesTaken + missing() > mostPages)
        forgetBits();
    const std::uint32_t wanted = m_pagesTaken + missing();
    std::uint32_t room = std::uint32_t(m_bits.bytes() / pageBytes);
    if (wanted > room) {
        while (room < wanted)
            room *= 2;
        Buffer larger({.label = "passage bits", .bytes = room * pageBytes});
        m_bits.copyTo(larger, m_pagesTaken * pageBytes);
        m_bits = std::move(larger);
    }
    for (const std::uint32_t brick : bricks) {
        std::uint32_t& page = m_pages[place(slot, brick)];
        if (page == 0)
            page = ++m_pagesTaken;
    }
    m_pageTable.write(std::span<const std::uint32_t>(m_pages));
}

/// Rooms stay; what is asked for again is worked out again.
void PassageField::forgetBits()
{
    m_pages.assign(m_pages.size(), 0);
    m_known.assign(m_known.size(), Known::Nothing);
    m_pagesTaken = 0;
}

std::vector<PassageField::Job> PassageField::jobsFor(
    std::uint32_t slot, const std::vector<std::uint32_t>& bricks, Known wanted)
{
    std::vector<Job> jobs;
    for (const std::uint32_t brick : bricks) {
        Known& known = m_known[place(slot, brick)];
        if (known >= wanted)
            continue;
        known = wanted;
        jobs.push_back({.brick = brick,
            .slot = slot,
            .label = m_labels[slot],
            .page = m_pages[place(slot, brick)] - 1});
    }
    return jobs;
}

void PassageField::run(Program& program, const std::vector<Job>& jobs)
{
    if (jobs.empty())
        return;
    const Buffer list = bufferOf("passage jobs", jobs);
    list.bindBase(GL_SHADER_STORAGE_BUFFER, 4);
    m_bits.bindBase(GL_SHADER_STORAGE_BUFFER, 6);
    m_pageTable.bindBase(GL_SHADER_STORAGE_BUFFER, 7);
    program.dispatch({unsigned(jobs.size()), 1, 1});
    glMemoryBarrier(GL_ALL_BARRIER_BITS);
}

void PassageField::setUniforms(Program& program) const
{
    std::array<unsigned, 64> slots{};
    for (std::size_t slot = 0; slot < m_labels.size(); ++slot)
        slots[m_labels[slot] / 4] |= unsigned(slot) << m_labels[slot] % 4 * 8;
    program.set("slotOfLabel", std::span<const unsigned>(slots))
        .set("slotsAcross", unsigned(m_slotsAcross));
}

void PassageField::bind()
{
    if (!m_rooms.created())
        return;
    m_rooms.atlas().bindUnit(1);
    m_rooms.pageTable().bindUnit(2);
}

} // namespace gpu
