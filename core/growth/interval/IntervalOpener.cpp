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

OpenedInterval IntervalOpener::open(int lowCode, int highCode)
{
    revert();
    m_low = lowCode;
    m_high = highCode;
    withdraw(excluded());
    OpenedInterval opened{.label = std::uint8_t(m_label), .withdrawn = m_left.size()};
    opened.kept = std::uint32_t(m_perGeneration.size() - 1);
    while (opened.kept > 0 && m_perGeneration[opened.kept] == 0)
        --opened.kept;
    std::vector<Voxel> admitted;
    if (opened.kept < seedWord::maxGeneration)
        admitted = admitSeeds(opened.kept + 1);
    opened.front = inVolume(frontFrom(admitted));
    opened.admitted = inVolume(admitted);
    return opened;
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

std::vector<IntervalOpener::Voxel> IntervalOpener::excluded() const
{
    std::vector<Voxel> voxels;
    for (std::size_t place = 0; place < m_ranges.size(); ++place) {
        const CodeRange& range = m_ranges[place];
        if (range.least >= m_low && range.greatest <= m_high)
            continue;
        const auto first = Voxel(place << 12);
        for (Voxel voxel = first; voxel < first + Voxel(BrickGrid::voxelsPerBrick); ++voxel) {
            if (!isInside(m_bricks.code(voxel)) && mayLeave(m_bricks.words()[voxel]))
                voxels.push_back(voxel);
        }
    }
    return voxels;
}

void IntervalOpener::withdraw(std::vector<Voxel> leaving)
{
    const WordBricks& words = m_bricks.words();
    m_left.clear();
    std::vector<Voxel> bereft; // those that lost a neighbour that they may have followed
    while (!leaving.empty()) {
        const Voxel voxel = leaving.back();
        leaving.pop_back();
        const std::uint32_t left = words[voxel];
        if (!mayLeave(left))
            continue; // it was listed twice
        leave(voxel);
        words.forNeighbours(
            voxel, 0, m_neighbours, [&](Voxel neighbour, std::uint32_t word, std::uint32_t) {
                if (!mayLeave(word) || seedWord::isSeed(word)
                    || seedWord::generation(word) <= seedWord::generation(left))
                    return;
                if (parentDirection(neighbour) == noParent)
                    leaving.push_back(neighbour);
                else
                    bereft.push_back(neighbour);
            });
    }
    for (const Voxel voxel : bereft) {
        GrowthBricks::State state = m_bricks.at(voxel);
        if (!mayLeave(state.word) || seedWord::wasHeld(state.word))
            continue;
        const std::uint32_t direction = parentDirection(voxel);
        if (direction == seedWord::direction(state.word))
            continue;
        state.word = seedWord::member(seedWord::generation(state.word), m_label, direction);
        write(voxel, state);
    }
}

void IntervalOpener::leave(Voxel voxel)
{
    GrowthBricks::State state = m_bricks.at(voxel);
    if (!seedWord::wasHeld(state.word) && state.label == m_label) {
        state.label = state.overwritten;
        state.overwritten = 0;
    }
    state.word =
        seedWord::isSeed(state.word) ? seedWord::pendingSeed(m_label) : seedWord::unvisited;
    write(voxel, state);
    m_left.push_back(voxel);
}

/// Seeds that have just become pending are outside the interval.
std::vector<IntervalOpener::Voxel> IntervalOpener::admitSeeds(std::uint32_t generation)
{
    std::vector<Voxel> admitted;
    for (const Voxel voxel : m_pending) {
        if (!isInside(m_bricks.code(voxel)) || !isOpen(voxel))
            continue;
        GrowthBricks::State state = m_bricks.at(voxel);
        const bool held = m_burst.tellsHeld && state.label == m_label;
        state.word = seedWord::member(
            generation, m_label, held ? seedWord::heldSeedDirection : seedWord::seedDirection);
        if (!m_burst.tellsHeld)
            state.overwritten = 0;
        else if (state.label != m_label)
            state.overwritten = state.label;
        state.label = std::uint8_t(m_label);
        write(voxel, state);
        admitted.push_back(voxel);
    }
    return admitted;
}

std::vector<IntervalOpener::Voxel> IntervalOpener::frontFrom(std::span<const Voxel> admitted) const
{
    const WordBricks& words = m_bricks.words();
    std::vector<Voxel> front;
    const auto wake = [&](Voxel voxel) {
        if (seedWord::isMember(words[voxel]))
            return; // a seed that was admitted
        words.forNeighbours(
            voxel, 0, m_neighbours, [&](Voxel neighbour, std::uint32_t word, std::uint32_t) {
                if (grows(word))
                    front.push_back(neighbour);
            });
    };
    for (const Voxel voxel : m_suspended.within(m_low, m_high))
        wake(voxel);
    for (const Voxel voxel : m_left) {
        if (isInside(m_bricks.code(voxel)) && isOpen(voxel))
            wake(voxel);
    }
    for (const Voxel voxel : admitted) {
        words.forNeighbours(
            voxel, 0, m_neighbours, [&](Voxel neighbour, std::uint32_t, std::uint32_t) {
                if (isInside(m_bricks.code(neighbour)) && isOpen(neighbour))
                    front.push_back(voxel);
            });
    }
    std::sort(front.begin(), front.end());
    front.erase(std::unique(front.begin(), front.end()), front.end());
    return front;
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

void IntervalOpener::revert()
{
    m_bricks.revert([this](std::uint32_t now, std::uint32_t before) {
        countMember(now, -1);
        countMember(before, 1);
    });
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

std::vector<LeakGuard::Voxel> IntervalOpener::inVolume(std::span<const Voxel> voxels) const
{
    std::vector<LeakGuard::Voxel> named;
    named.reserve(voxels.size());
    for (const Voxel voxel : voxels)
        named.push_back(m_bricks.words().brickOf(voxel) << 12 | (voxel & 4095u));
    std::sort(named.begin(), named.end());
    return named;
}

} // namespace core
