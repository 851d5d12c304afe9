// SPDX-License-Identifier: Apache-2.0
#include "core/growth/cut/CutWriting.h"

#include "core/growth/SeedWord.h"

#include <algorithm>
#include <array>

namespace core {

namespace {

using Voxel = WordBricks::Voxel;

void fill(CutBrick& brick, std::uint32_t number)
{
    brick.brick = number;
    brick.words.assign(BrickGrid::voxelsPerBrick, seedWord::unvisited);
    brick.leaving.assign(BrickGrid::voxelsPerBrick, 0);
}

} // namespace

CutWriting::CutWriting(const WordBricks& words)
    : m_words(words)
    , m_bricks(words.count() / BrickGrid::voxelsPerBrick)
{
    for (std::size_t place = 0; place < m_bricks.size(); ++place)
        m_places[words.brickOf(Voxel(place << 12))] = place;
}

void CutWriting::leave(Voxel voxel, std::uint32_t label)
{
    CutBrick& brick = begun(voxel >> 12);
    brick.words[voxel & 4095u] = seedWord::unvisited;
    brick.leaving[voxel & 4095u] = std::uint8_t(label);
}

void CutWriting::replace(Voxel voxel, std::uint32_t word)
{
    begun(voxel >> 12).words[voxel & 4095u] = word;
}

void CutWriting::setBarrier(const glm::ivec3& place)
{
    const auto number = std::uint32_t(m_words.grid().brickOf(place));
    const auto known = m_places.find(number);
    CutBrick& brick = known != m_places.end() ? begun(known->second) : m_further[number];
    if (brick.words.empty())
        fill(brick, number);
    brick.words[std::size_t(BrickGrid::offsetInBrick(place))] = seedWord::barrier;
}

void CutWriting::setBarrierAround(const glm::ivec3& place)
{
    for (const std::array<int, 3>& offset : seedWord::offsets) {
        const glm::ivec3 next = place + glm::ivec3(offset[0], offset[1], offset[2]);
        if (glm::any(glm::lessThan(next, glm::ivec3(0)))
            || glm::any(glm::greaterThanEqual(next, m_words.grid().volumeSize)))
            continue;
        const std::uint32_t word = wordAt(next);
        if (!seedWord::isMember(word) && !seedWord::isPendingSeed(word)
            && word != seedWord::barrier)
            setBarrier(next);
    }
}

std::vector<CutBrick> CutWriting::take()
{
    std::vector<CutBrick> taken;
    for (CutBrick& brick : m_bricks) {
        if (!brick.words.empty())
            taken.push_back(std::move(brick));
    }
    for (auto& [number, brick] : m_further)
        taken.push_back(std::move(brick));
    std::sort(taken.begin(), taken.end(),
        [](const CutBrick& a, const CutBrick& b) { return a.brick < b.brick; });
    return taken;
}

std::uint32_t CutWriting::wordAt(const glm::ivec3& place) const
{
    const auto number = std::uint32_t(m_words.grid().brickOf(place));
    const auto offset = std::size_t(BrickGrid::offsetInBrick(place));
    if (const auto known = m_places.find(number); known != m_places.end()) {
        const CutBrick& brick = m_bricks[known->second];
        return brick.words.empty() ? m_words[Voxel(known->second << 12 | offset)]
                                   : brick.words[offset];
    }
    const auto further = m_further.find(number);
    return further == m_further.end() ? seedWord::unvisited : further->second.words[offset];
}

CutBrick& CutWriting::begun(std::size_t place)
{
    CutBrick& brick = m_bricks[place];
    if (!brick.words.empty())
        return brick;
    const auto first = Voxel(place << 12);
    fill(brick, m_words.brickOf(first));
    for (std::uint32_t i = 0; i < BrickGrid::voxelsPerBrick; ++i)
        brick.words[i] = m_words[first + i];
    return brick;
}

} // namespace core
