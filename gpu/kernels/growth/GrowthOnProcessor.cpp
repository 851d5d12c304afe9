// SPDX-License-Identifier: Apache-2.0
#include "core/growth/SeedWord.h"
#include "core/growth/front/GrownBrick.h"
#include "core/growth/front/OpenVoxels.h"
#include "gpu/fields/bricks/BrickVoxels.h"
#include "gpu/kernels/growth/GrowthKernel.h"

#include <algorithm>
#include <bitset>

namespace gpu {

namespace {

/// As many bricks have their codes read at once: 8 MiB of them, however many a wide front reaches.
constexpr std::size_t bricksPerReading = 1024;

} // namespace

bool GrowthKernel::isOnProcessor() const
{
    // The backward flood, which narrows a growth, claims nothing.
    return m_programs.growsOnProcessor() && !m_floodsBack && m_onlyLabel
        && FrontBits::isFor(m_burst.limits);
}

std::vector<std::uint32_t> GrowthKernel::withPendingSeeds(const std::vector<std::uint32_t>& bricks)
{
    const BrickField& words = m_fields.seedWords(m_burst.plane);
    std::vector<std::uint32_t> image(core::BrickGrid::voxelsPerBrick);
    std::vector<std::uint32_t> found;
    for (const std::uint32_t brick : bricks) {
        words.read(brick, std::as_writable_bytes(std::span(image)));
        if (std::any_of(image.begin(), image.end(), core::seedWord::isPendingSeed))
            found.push_back(brick);
    }
    return found;
}

bool GrowthKernel::findFrontOnProcessor(const std::vector<std::uint32_t>& bricks)
{
    const core::BrickGrid& grid = m_fields.grid();
    if (!m_programs.growsOnProcessor() || !FrontBits::isFor(m_burst.limits)
        || !core::openRule(m_burst, 0, grid.volumeSize))
        return false;
    const BrickField& words = m_fields.seedWords(m_burst.plane);
    std::vector<std::uint32_t> image(core::BrickGrid::voxelsPerBrick);
    std::vector<std::uint32_t> grown;
    std::vector<core::VoxelBits> members;
    std::bitset<256> labels;
    for (const std::uint32_t brick : bricks) {
        words.read(brick, std::as_writable_bytes(std::span(image)));
        const core::GrownBrick held = core::grownBrick(image, m_burst.lockedLabels);
        if (held.labels.none())
            continue;
        labels |= held.labels;
        grown.push_back(brick);
        members.push_back(held.members);
    }
    if (labels.count() > 1)
        return false;
    m_frontCount = 0;
    m_frontBricks.clear();
    m_onlyLabel.reset();
    if (labels.none())
        return true;
    for (unsigned label = 0; label < labels.size(); ++label) {
        if (labels.test(label))
            m_onlyLabel = std::uint8_t(label);
    }
    const std::vector<std::uint32_t> asked = m_fields.withNeighbours(grown);
    const std::vector<core::VoxelBits> open = openVoxelsIn(asked);
    std::vector<core::LeakGuard::Voxel> front;
    for (std::size_t i = 0; i < grown.size(); ++i) {
        core::FrontsAround around{};
        for (std::size_t place = 0; place < around.size(); ++place) {
            const glm::ivec3 offset =
                glm::ivec3(int(place % 3), int(place / 3 % 3), int(place / 9)) - 1;
            const glm::ivec3 at = grid.brickPosition(int(grown[i])) + offset;
            if (glm::any(glm::lessThan(at, glm::ivec3(0)))
                || glm::any(glm::greaterThanEqual(at, grid.bricks())))
                continue;
            const auto brick =
                std::uint32_t(at.x + grid.bricks().x * (at.y + grid.bricks().y * at.z));
            const auto found = std::lower_bound(asked.begin(), asked.end(), brick);
            around[place] = &open[std::size_t(found - asked.begin())];
        }
        core::appendVoxels(
            core::besideOpen(m_burst.connectivity, around, members[i]), grown[i], front);
    }
    if (front.empty())
        return true;
    beginOnProcessor(front);
    m_processorFront->setOpen(asked, open);
    m_frontCount = std::uint32_t(front.size());
    m_frontBricks = m_processorFront->frontBricks();
    return true;
}

void GrowthKernel::beginOnProcessor(std::span<const core::LeakGuard::Voxel> front)
{
    const ProcessorFront::Options options{.label = *m_onlyLabel,
        .plane = m_burst.plane,
        .connectivity = m_burst.connectivity,
        .tellsHeld = m_burst.tellsHeld,
        .keepsOverwritten = m_kind.overwritten};
    m_processorFront.emplace(m_fields, options, front, m_generation);
}

std::vector<core::VoxelBits> GrowthKernel::openVoxelsIn(std::span<const std::uint32_t> bricks)
{
    const core::BrickGrid& grid = m_fields.grid();
    BrickField& words = m_fields.seedWords(m_burst.plane);
    const std::optional<core::OpenRule> rule =
        core::openRule(m_burst, *m_onlyLabel, grid.volumeSize);
    if (!rule) {
        prepare({bricks.begin(), bricks.end()}, BrickField::NewPages::Empty);
        const std::shared_ptr<Program> program = m_programs.openBits(m_kind);
        setUniforms(*program);
        bind();
        std::vector<core::VoxelBits> open =
            openBits(*program, words, grid.bricks(), *m_onlyLabel, bricks);
        releaseUnused(); // only the kernel wanted pages of bricks that are merely looked at
        return open;
    }
    std::vector<core::VoxelBits> open(bricks.size());
    std::vector<std::uint32_t> asked;
    std::vector<std::size_t> places; // of those among all
    for (std::size_t i = 0; i < bricks.size(); ++i) {
        if (!m_fields.mayHold(bricks[i], rule->lowCode, rule->highCode))
            continue;
        asked.push_back(bricks[i]);
        places.push_back(i);
    }
    std::vector<std::vector<std::uint16_t>> codes; // of those that are read at once
    std::vector<std::uint32_t> wordsOfBrick(core::BrickGrid::voxelsPerBrick);
    std::vector<std::uint8_t> labels(core::BrickGrid::voxelsPerBrick);
    for (std::size_t i = 0; i < asked.size(); ++i) {
        const std::size_t inReading = i % bricksPerReading;
        if (inReading == 0)
            codes = readCodes(m_fields.codes(), grid,
                std::span(asked).subspan(i, std::min(bricksPerReading, asked.size() - i)));
        core::AskedBrick brick{
            .origin = grid.boxOf(int(asked[i])).minimum, .codes = codes[inReading]};
        if (words.holds(asked[i])) {
            words.read(asked[i], std::as_writable_bytes(std::span(wordsOfBrick)));
            brick.words = wordsOfBrick;
        }
        if (m_fields.hasData(
                {.field = core::Field::Labels, .plane = m_burst.plane, .brick = asked[i]})) {
            readDense(m_fields.labels(m_burst.plane), grid, asked[i], labels);
            brick.labels = labels;
        }
        open[places[i]] = core::openVoxels(*rule, brick);
    }
    return open;
}

int GrowthKernel::advanceOnProcessor(int rings)
{
    if (!m_processorFront)
        beginOnProcessor(listedFront());
    ProcessorFront& front = *m_processorFront;
    const std::vector<std::uint32_t> unknown =
        front.unknown(m_fields.withNeighbours(m_frontBricks));
    if (!unknown.empty())
        front.setOpen(unknown, openVoxelsIn(unknown));
    const std::vector<std::uint32_t> sizes = front.advance(m_generation, rings);
    m_lastTouched = front.claimedBricks();
    // Not all pages of this burst are empty: kernels may have moved its front before.
    const std::vector<std::uint32_t> newPages =
        prepare(m_lastTouched, BrickField::NewPages::AnyContent);
    front.write(m_lastTouched, newPages);
    count(sizes);
    m_frontCount = int(sizes.size()) == rings ? sizes.back() : 0;
    m_frontBricks = front.frontBricks();
    m_allTouched.insert(m_lastTouched.begin(), m_lastTouched.end());
    if (!m_lastTouched.empty())
        m_fields.noteChanged(core::Field::Labels, m_lastTouched);
    if (m_guard && !sizes.empty())
        watch(front.voxels());
    if (m_frontCount == 0)
        m_processorFront.reset(); // at closure; a burst may stay open for long after that
    return int(sizes.size());
}

} // namespace gpu
