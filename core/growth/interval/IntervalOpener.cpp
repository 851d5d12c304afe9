// SPDX-License-Identifier: Apache-2.0
#include "core/growth/interval/IntervalOpener.h"

#include <algorithm>
#include <utility>

namespace core {

bool IntervalOpener::suits(const GrowBurst& burst)
{
    GrowLimits boxAlone;
    boxAlone.boxed = burst.limits.boxed;
    boxAlone.boxFrom = burst.limits.boxFrom;
    boxAlone.boxTo = burst.limits.boxTo;
    return burst.opening == GrowOpening::Narrow && burst.limits == boxAlone;
}

std::unique_ptr<IntervalOpener> IntervalOpener::prepare(const GrowBurst& burst,
    const BrickGrid& grid, std::span<const std::uint32_t> held, const ReadGrowthBricks& read)
{
    std::unique_ptr<IntervalOpener> opener(new IntervalOpener(burst, grid, held, read));
    if (!opener->findLabel())
        return nullptr;
    opener->dropUnsupported();
    opener->listSuspended();
    opener->measureBricks();
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
    const WordBricks& words = m_bricks.words();
    for (std::size_t i = 0; i < words.count(); ++i) {
        const std::uint32_t word = words[Voxel(i)];
        const bool isMember = seedWord::isMember(word);
        if (isMember)
            countMember(word, 1);
        if (!isMember && !seedWord::isPendingSeed(word))
            continue;
        const std::uint32_t label = seedWord::label(word);
        if (m_burst.lockedLabels.test(label))
            continue;
        if (m_label != 0 && label != m_label)
            return false;
        m_label = label;
    }
    return m_label != 0;
}

/// What does not qualify whatever the interval is does not qualify under any. So it leaves once,
/// and then others are asked only where something changes.
void IntervalOpener::dropUnsupported()
{
    const WordBricks& words = m_bricks.words();
    std::vector<Voxel> leaving;
    for (std::size_t i = 0; i < words.count(); ++i) {
        const auto voxel = Voxel(i);
        const std::uint32_t word = words[voxel];
        if (!mayLeave(word))
            continue;
        const bool isSeed = seedWord::isSeed(word);
        const std::uint32_t direction = isSeed ? noParent : parentDirection(voxel);
        if (!qualifies(voxel) || (!isSeed && direction == noParent)) {
            leaving.push_back(voxel);
            continue;
        }
        if (seedWord::wasHeld(word) || isSeed || seedWord::direction(word) == direction)
            continue;
        GrowthBricks::State state = m_bricks.at(voxel);
        state.word = seedWord::member(seedWord::generation(word), m_label, direction);
        write(voxel, state);
    }
    withdraw(std::move(leaving));
}

void IntervalOpener::listSuspended()
{
    const WordBricks& words = m_bricks.words();
    std::vector<bool> listed(words.count(), false);
    std::vector<Voxel> voxels;
    std::vector<std::uint16_t> codes;
    for (std::size_t i = 0; i < words.count(); ++i) {
        if (seedWord::isPendingSeed(words[Voxel(i)]) && seedWord::label(words[Voxel(i)]) == m_label)
            m_pending.push_back(Voxel(i));
        if (!grows(words[Voxel(i)]))
            continue;
        words.forNeighbours(
            Voxel(i), 0, m_neighbours, [&](Voxel neighbour, std::uint32_t word, std::uint32_t) {
                if (seedWord::isMember(word) || listed[neighbour] || !isOpen(neighbour))
                    return;
                listed[neighbour] = true;
                voxels.push_back(neighbour);
                codes.push_back(std::uint16_t(m_bricks.code(neighbour)));
            });
    }
    m_suspended = SuspendedSeeds(voxels, codes);
}

void IntervalOpener::measureBricks()
{
    const WordBricks& words = m_bricks.words();
    m_ranges.resize(m_bricks.brickCount());
    for (std::size_t i = 0; i < words.count(); ++i) {
        if (!mayLeave(words[Voxel(i)]))
            continue;
        CodeRange& range = m_ranges[i >> 12];
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
    std::uint32_t lowest = noParent;
    m_bricks.words().forNeighbours(
        voxel, 0, m_neighbours, [&](Voxel, std::uint32_t word, std::uint32_t direction) {
            if (grows(word) && seedWord::generation(word) < generation)
                lowest = std::min(lowest, direction ^ 1u);
        });
    return lowest;
}

} // namespace core
