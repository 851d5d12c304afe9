// SPDX-License-Identifier: Apache-2.0
// What IntervalOpener does for each interval; what it does once stands in IntervalOpener.cpp.
#include "core/growth/interval/IntervalOpener.h"

#include <algorithm>

namespace core {

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
    std::vector<bool> isListed(words.count(), false);
    std::vector<Voxel> front;
    const auto list = [&](Voxel voxel) {
        if (isListed[voxel])
            return;
        isListed[voxel] = true;
        front.push_back(voxel);
    };
    const auto wake = [&](Voxel voxel) {
        if (seedWord::isMember(words[voxel]))
            return; // a seed that was admitted
        words.forNeighbours(
            voxel, 0, m_neighbours, [&](Voxel neighbour, std::uint32_t word, std::uint32_t) {
                if (grows(word))
                    list(neighbour);
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
                    list(voxel);
            });
    }
    return front;
}

void IntervalOpener::revert()
{
    m_bricks.revert([this](std::uint32_t now, std::uint32_t before) {
        countMember(now, -1);
        countMember(before, 1);
    });
}

std::vector<LeakGuard::Voxel> IntervalOpener::inVolume(std::span<const Voxel> voxels) const
{
    std::vector<LeakGuard::Voxel> named;
    named.reserve(voxels.size());
    for (const Voxel voxel : voxels)
        named.push_back({.brick = m_bricks.words().brickOf(voxel), .offset = voxel & 4095u});
    std::sort(named.begin(), named.end());
    return named;
}

} // namespace core
