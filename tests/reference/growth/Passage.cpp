// SPDX-License-Identifier: Apache-2.0
#include "tests/reference/growth/Passage.h"

#include "core/growth/SeedWord.h"

#include <algorithm>
#include <limits>

namespace reference {

namespace seedWord = core::seedWord;

namespace {

constexpr int nowhere = std::numeric_limits<int>::max();

template <class Visit> void forEachVoxel(const glm::ivec3& from, const glm::ivec3& to, Visit visit)
{
    for (int z = from.z; z <= to.z; ++z)
        for (int y = from.y; y <= to.y; ++y)
            for (int x = from.x; x <= to.x; ++x)
                visit(glm::ivec3(x, y, z));
}

bool isSeedOf(std::uint32_t word, std::uint32_t label)
{
    if (seedWord::label(word) != label)
        return false;
    return seedWord::isPendingSeed(word)
        || (seedWord::isMember(word)
            && (seedWord::isSeed(word) || seedWord::generation(word) == 0));
}

} // namespace

Passage::Passage(const core::GrowBurst& burst, const glm::ivec3& volumeSize)
    : m_burst(burst)
    , m_size(volumeSize)
    , m_isAsked(core::isAsked(burst.limits.passage))
{
    if (!m_isAsked)
        return;
    const core::Passage& passage = burst.limits.passage;
    const glm::ivec3 reach(core::greatestPassageReach);
    forEachVoxel(-reach, reach, [&](const glm::ivec3& step) {
        const glm::ivec3 units = step * passage.spacing;
        const int square = units.x * units.x + units.y * units.y + units.z * units.z;
        if (square <= passage.reach)
            m_ball.push_back({step, square});
    });
    std::sort(m_ball.begin(), m_ball.end(),
        [](const Offset& a, const Offset& b) { return a.square < b.square; });
}

void Passage::look(std::uint32_t label, const std::function<bool(const glm::ivec3&)>& allows,
    const DenseArray<std::uint32_t>& words, const DenseArray<std::uint8_t>& labels,
    const std::function<bool(const glm::ivec3&)>& isInRange)
{
    const auto array = [this] {
        return DenseArray<std::uint8_t>{
            m_size, std::vector<std::uint8_t>(std::size_t(m_size.x) * m_size.y * m_size.z, 0)};
    };
    DenseArray<std::uint8_t> free = array();
    forEachVoxel(glm::ivec3(0), m_size - 1, [&](const glm::ivec3& voxel) {
        const std::uint32_t word = words.at(voxel);
        const std::uint32_t direction = seedWord::direction(word);
        const std::uint8_t held = labels.at(voxel);
        const bool grown = seedWord::isMember(word) && seedWord::generation(word) > 0
            && direction != 29 && direction != 30
            && !m_burst.lockedLabels.test(seedWord::label(word));
        const bool open = grown || held == 0 || held == label || m_burst.overwritable.test(held);
        free.at(voxel) =
            open && word != seedWord::barrier && isInRange(voxel) && allows(voxel) ? 1 : 0;
    });
    DenseArray<std::uint8_t> centres = array();
    DenseArray<std::uint8_t> withSeed = array();
    forEachVoxel(glm::ivec3(0), m_size - 1, [&](const glm::ivec3& centre) {
        const bool fits = std::all_of(m_ball.begin(), m_ball.end(), [&](const Offset& offset) {
            return free.at(glm::clamp(centre + offset.step, glm::ivec3(0), m_size - 1)) == 1;
        });
        if (!fits)
            return;
        centres.at(centre) = 1;
        withSeed.at(centre) = std::any_of(m_ball.begin(), m_ball.end(), [&](const Offset& offset) {
            const glm::ivec3 voxel = centre + offset.step;
            return words.contains(voxel) && isSeedOf(words.at(voxel), label);
        });
    });
    m_rooms[label] = {.room = nearest(centres), .entry = nearest(withSeed)};
}

DenseArray<int> Passage::nearest(const DenseArray<std::uint8_t>& centres) const
{
    DenseArray<int> squares{m_size, std::vector<int>(centres.values.size(), nowhere)};
    forEachVoxel(glm::ivec3(0), m_size - 1, [&](const glm::ivec3& centre) {
        if (!centres.at(centre))
            return;
        for (const Offset& offset : m_ball) {
            const glm::ivec3 voxel = centre + offset.step;
            if (squares.contains(voxel))
                squares.at(voxel) = std::min(squares.at(voxel), offset.square);
        }
    });
    return squares;
}

bool Passage::passes(std::uint32_t label, const glm::ivec3& parent, const glm::ivec3& voxel) const
{
    const Rooms& rooms = m_rooms.at(label);
    const int from = rooms.room.at(parent);
    const int to = rooms.room.at(voxel);
    if (to == nowhere)
        return false;
    if ((from == 0 && to == 0) || from < to)
        return true;
    const int before = rooms.entry.at(parent);
    const int after = rooms.entry.at(voxel);
    return before != nowhere && after < before && (to != 0 || after == 0);
}

} // namespace reference
