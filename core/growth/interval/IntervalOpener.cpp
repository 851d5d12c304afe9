// SPDX-License-Identifier: Apache-2.0
#include "core/growth/interval/IntervalOpener.h"

#include "core/base/ParallelFor.h"

#include <algorithm>
#include <utility>

namespace core {

namespace {

/// So many that no core waits long for another, and so few that what each part counts by generation
/// is little.
constexpr std::size_t partCount = 32;

/// Calls work(part, first, last) for parts of consecutive bricks, on all cores.
template <class Work> void inParts(std::size_t bricks, const Work& work)
{
    parallelFor(int(partCount), [&](int number) {
        const auto part = std::size_t(number);
        work(part, bricks * part / partCount, bricks * (part + 1) / partCount);
    });
}

} // namespace

bool IntervalOpener::suits(const GrowBurst& burst)
{
    GrowLimits boxAlone;
    boxAlone.boxed = burst.limits.boxed;
    boxAlone.boxFrom = burst.limits.boxFrom;
    boxAlone.boxTo = burst.limits.boxTo;
    return burst.opening == GrowOpening::Narrow && burst.limits == boxAlone && !burst.range;
}

std::unique_ptr<IntervalOpener> IntervalOpener::prepare(const GrowBurst& burst,
    const BrickGrid& grid, std::span<const std::uint32_t> held, const ReadGrowthBricks& read)
{
    std::unique_ptr<IntervalOpener> opener(new IntervalOpener(burst, grid, held, read));
    if (!opener->findLabel())
        return nullptr;
    opener->dropUnsupported();
    opener->listSuspended();
    opener->m_bricks.keep();
    return opener;
}

IntervalOpener::IntervalOpener(const GrowBurst& burst, const BrickGrid& grid,
    std::span<const std::uint32_t> held, const ReadGrowthBricks& read)
    : m_burst(burst)
    , m_bricks(grid, held, read)
    , m_neighbours(std::uint32_t(burst.connectivity))
    , m_perGeneration(1, 0)
{
}

bool IntervalOpener::serves(const GrowBurst& burst) const
{
    return suits(burst) && burst.plane == m_burst.plane
        && burst.connectivity == m_burst.connectivity && burst.limits == m_burst.limits
        && burst.overwritable == m_burst.overwritable && burst.lockedLabels == m_burst.lockedLabels
        && burst.tellsHeld == m_burst.tellsHeld;
}

/// @return whether exactly one label grows
bool IntervalOpener::findLabel()
{
    struct Found {
        std::vector<std::uint32_t> perGeneration; // members
        std::uint32_t label = 0;
        bool isOne = true;
    };
    const WordBricks& words = m_bricks.words();
    std::vector<Found> parts(partCount);
    inParts(m_bricks.brickCount(), [&](std::size_t part, std::size_t first, std::size_t last) {
        Found& found = parts[part];
        for (std::size_t i = first << 12; i < last << 12; ++i) {
            const std::uint32_t word = words[Voxel(i)];
            const bool isMember = seedWord::isMember(word);
            if (isMember) {
                const std::size_t generation = seedWord::generation(word);
                if (generation >= found.perGeneration.size())
                    found.perGeneration.resize(generation + 1, 0);
                ++found.perGeneration[generation];
            }
            if (!isMember && !seedWord::isPendingSeed(word))
                continue;
            const std::uint32_t label = seedWord::label(word);
            if (label == found.label || m_burst.lockedLabels.test(label))
                continue;
            found.isOne = found.label == 0;
            found.label = label;
            if (!found.isOne)
                return;
        }
    });
    for (const Found& found : parts) {
        if (!found.isOne || (m_label != 0 && found.label != 0 && found.label != m_label))
            return false;
        m_label = std::max(m_label, found.label);
        countMembers(found.perGeneration);
    }
    return m_label != 0;
}

void IntervalOpener::countMembers(const std::vector<std::uint32_t>& perGeneration)
{
    if (perGeneration.size() > m_perGeneration.size())
        m_perGeneration.resize(perGeneration.size(), 0);
    for (std::size_t generation = 0; generation < perGeneration.size(); ++generation)
        m_perGeneration[generation] += perGeneration[generation];
}

/// What does not qualify whatever the interval is does not qualify under any. So it leaves once,
/// and then others are asked only where something changes. Which neighbours a member may follow
/// does not depend on the directions that are corrected here.
void IntervalOpener::dropUnsupported()
{
    struct Found {
        std::vector<Voxel> leaving;
        std::vector<std::pair<Voxel, std::uint32_t>> corrected; // its direction
    };
    const WordBricks& words = m_bricks.words();
    std::vector<Found> parts(partCount);
    inParts(m_bricks.brickCount(), [&](std::size_t part, std::size_t first, std::size_t last) {
        Found& found = parts[part];
        for (std::size_t i = first << 12; i < last << 12; ++i) {
            const auto voxel = Voxel(i);
            const std::uint32_t word = words[voxel];
            if (!mayLeave(word))
                continue;
            const bool isSeed = seedWord::isSeed(word);
            const std::uint32_t direction = isSeed ? noParent : parentDirection(voxel);
            if (!qualifies(voxel) || (!isSeed && direction == noParent))
                found.leaving.push_back(voxel);
            else if (!seedWord::wasHeld(word) && !isSeed && seedWord::direction(word) != direction)
                found.corrected.emplace_back(voxel, direction);
        }
    });
    std::vector<Voxel> leaving;
    for (const Found& found : parts) {
        leaving.insert(leaving.end(), found.leaving.begin(), found.leaving.end());
        for (const auto& [voxel, direction] : found.corrected) {
            GrowthBricks::State state = m_bricks.at(voxel);
            state.word = seedWord::member(seedWord::generation(state.word), m_label, direction);
            write(voxel, state);
        }
    }
    withdraw(std::move(leaving));
}

/// Suspended voxels, seeds that wait, and the range of codes in each brick.
void IntervalOpener::listSuspended()
{
    struct Found {
        std::vector<Voxel> suspended;
        std::vector<std::uint16_t> codes;
        std::vector<Voxel> pending;
    };
    const WordBricks& words = m_bricks.words();
    m_ranges.resize(m_bricks.brickCount());
    std::vector<Found> parts(partCount);
    inParts(m_bricks.brickCount(), [&](std::size_t part, std::size_t first, std::size_t last) {
        Found& found = parts[part];
        for (std::size_t place = first; place < last; ++place)
            measureBrick(place);
        for (std::size_t i = first << 12; i < last << 12; ++i) {
            const auto voxel = Voxel(i);
            const std::uint32_t word = words[voxel];
            if (seedWord::isMember(word) || word == seedWord::barrier)
                continue;
            if (seedWord::isPendingSeed(word) && seedWord::label(word) == m_label)
                found.pending.push_back(voxel);
            const std::uint32_t direction = words.lowestDirectionTo(
                voxel, m_neighbours, [this](std::uint32_t neighbour) { return grows(neighbour); });
            if (direction == noParent || !isOpen(voxel))
                continue;
            found.suspended.push_back(voxel);
            found.codes.push_back(std::uint16_t(m_bricks.code(voxel)));
        }
    });
    std::vector<Voxel> voxels;
    std::vector<std::uint16_t> codes;
    for (const Found& found : parts) {
        voxels.insert(voxels.end(), found.suspended.begin(), found.suspended.end());
        codes.insert(codes.end(), found.codes.begin(), found.codes.end());
        m_pending.insert(m_pending.end(), found.pending.begin(), found.pending.end());
    }
    m_suspended = SuspendedSeeds(voxels, codes);
}

void IntervalOpener::measureBrick(std::size_t place)
{
    const WordBricks& words = m_bricks.words();
    CodeRange& range = m_ranges[place];
    for (std::size_t i = place << 12; i < (place + 1) << 12; ++i) {
        if (!mayLeave(words[Voxel(i)]))
            continue;
        range.least = std::min(range.least, m_bricks.code(Voxel(i)));
        range.greatest = std::max(range.greatest, m_bricks.code(Voxel(i)));
    }
}

void IntervalOpener::write(Voxel voxel, const GrowthBricks::State& state)
{
    countMember(m_bricks.words()[voxel], -1);
    countMember(state.word, 1);
    m_bricks.write(voxel, state);
}

void IntervalOpener::countMember(std::uint32_t word, int change)
{
    if (!seedWord::isMember(word))
        return;
    const std::uint32_t generation = seedWord::generation(word);
    if (generation >= m_perGeneration.size())
        m_perGeneration.resize(std::size_t(generation) + 1, 0);
    m_perGeneration[generation] += std::uint32_t(change);
}

bool IntervalOpener::mayHold(std::uint8_t label) const
{
    return label == 0 || label == m_label || m_burst.overwritable.test(label);
}

bool IntervalOpener::isInBox(Voxel voxel) const
{
    if (!m_burst.limits.boxed)
        return true;
    const glm::ivec3 at = m_bricks.words().positionOf(voxel);
    return glm::all(glm::greaterThanEqual(at, m_burst.limits.boxFrom))
        && glm::all(glm::lessThanEqual(at, m_burst.limits.boxTo));
}

bool IntervalOpener::grows(std::uint32_t word) const
{
    return seedWord::isMember(word) && seedWord::label(word) == m_label;
}

bool IntervalOpener::mayLeave(std::uint32_t word) const
{
    return grows(word) && seedWord::generation(word) > 0;
}

bool IntervalOpener::isOpen(Voxel voxel) const
{
    const std::uint32_t word = m_bricks.words()[voxel];
    return !seedWord::isMember(word) && word != seedWord::barrier && mayHold(m_bricks.label(voxel))
        && isInBox(voxel);
}

bool IntervalOpener::qualifies(Voxel member) const
{
    const GrowthBricks::State state = m_bricks.at(member);
    const bool hasAdded = !seedWord::wasHeld(state.word) && state.label == m_label;
    return mayHold(hasAdded ? state.overwritten : state.label) && isInBox(member);
}

std::uint32_t IntervalOpener::parentDirection(Voxel voxel) const
{
    const std::uint32_t generation = seedWord::generation(m_bricks.words()[voxel]);
    return m_bricks.words().lowestDirectionTo(voxel, m_neighbours,
        [&](std::uint32_t word) { return grows(word) && seedWord::generation(word) < generation; });
}

} // namespace core
