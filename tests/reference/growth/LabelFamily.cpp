// SPDX-License-Identifier: Apache-2.0
#include "tests/reference/growth/LabelFamily.h"

#include <algorithm>

namespace reference {

namespace seedWord = core::seedWord;

glm::ivec3 placeOf(const LabelFamily::Words& words, std::size_t voxel)
{
    const auto x = std::size_t(words.size.x);
    const auto y = std::size_t(words.size.y);
    return {int(voxel % x), int(voxel / x % y), int(voxel / (x * y))};
}

std::vector<std::size_t> neighbours(
    const LabelFamily::Words& words, std::size_t voxel, int directions)
{
    std::vector<std::size_t> found;
    const glm::ivec3 place = placeOf(words, voxel);
    for (int direction = 0; direction < directions; ++direction) {
        const auto& offset = seedWord::offsets[std::size_t(direction)];
        const glm::ivec3 next = place + glm::ivec3(offset[0], offset[1], offset[2]);
        if (words.contains(next))
            found.push_back(words.offset(next));
    }
    return found;
}

LabelFamily::LabelFamily(const Words& words, std::uint32_t label)
    : m_words(words)
    , m_label(label)
{
    for (std::size_t voxel = 0; voxel < words.values.size(); ++voxel) {
        if (isMember(voxel))
            m_byGeneration[generation(voxel)].insert(voxel);
    }
    for (const auto& [n, members] : m_byGeneration) {
        for (const std::size_t voxel : members) {
            if (!isRoot(voxel))
                m_steps = std::max(m_steps, parentDirections(voxel));
        }
    }
}

bool LabelFamily::isMember(std::size_t voxel) const
{
    const std::uint32_t word = m_words.values[voxel];
    return seedWord::isMember(word) && seedWord::label(word) == m_label;
}

bool LabelFamily::isRoot(std::size_t voxel) const
{
    return seedWord::direction(m_words.values[voxel]) >= 30 || generation(voxel) == 0;
}

std::uint32_t LabelFamily::generation(std::size_t voxel) const
{
    return seedWord::generation(m_words.values[voxel]);
}

/// Rule 2: over faces; edges too; corners too.
int LabelFamily::parentDirections(std::size_t voxel) const
{
    auto direction = int(seedWord::direction(m_words.values[voxel]));
    if (direction == int(seedWord::heldDirection)) {
        direction = 0;
        while (direction < 26 && !isEarlierMemberFrom(voxel, direction))
            ++direction;
        if (direction == 26)
            return 6;
    }
    return direction < 6 ? 6 : direction < 18 ? 18 : 26;
}

bool LabelFamily::isEarlierMemberFrom(std::size_t voxel, int direction) const
{
    const auto& offset = seedWord::offsets[std::size_t(direction)];
    const glm::ivec3 from = placeOf(m_words, voxel) - glm::ivec3(offset[0], offset[1], offset[2]);
    return m_words.contains(from) && isMember(m_words.offset(from))
        && generation(m_words.offset(from)) < generation(voxel);
}

std::vector<std::size_t> LabelFamily::parents(std::size_t voxel) const
{
    std::vector<std::size_t> found;
    if (isRoot(voxel))
        return found;
    for (const std::size_t next : neighbours(m_words, voxel, parentDirections(voxel))) {
        if (isMember(next) && generation(next) < generation(voxel))
            found.push_back(next);
    }
    return found;
}

LabelFamily::Set LabelFamily::behind(const Set& from) const
{
    Set found;
    for (const std::size_t voxel : from) {
        if (!isRoot(voxel))
            found.insert(voxel);
    }
    for (const auto& [n, members] : m_byGeneration) {
        for (const std::size_t voxel : members) {
            const std::vector<std::size_t> before = parents(voxel);
            if (!before.empty()
                && std::all_of(before.begin(), before.end(),
                    [&](std::size_t parent) { return found.count(parent) != 0; }))
                found.insert(voxel);
        }
    }
    return found;
}

/// Rule 9: the sketch's distance from each member, and the roots'.
LabelFamily::Set LabelFamily::notNearerToRoots(const Set& some, const Set& sketch) const
{
    Set roots;
    for (const auto& [n, members] : m_byGeneration) {
        for (const std::size_t voxel : members) {
            if (isRoot(voxel))
                roots.insert(voxel);
        }
    }
    const std::map<std::size_t, int> toSketch = distancesFrom(sketch);
    const std::map<std::size_t, int> toRoots = distancesFrom(roots);
    Set found;
    for (const std::size_t voxel : some) {
        const auto root = toRoots.find(voxel);
        const auto near = toSketch.find(voxel);
        const bool nearer =
            root != toRoots.end() && (near == toSketch.end() || root->second < near->second);
        if (!nearer)
            found.insert(voxel);
    }
    return found;
}
std::map<std::size_t, int> LabelFamily::distancesFrom(const Set& from) const
{
    std::map<std::size_t, int> distances;
    Set ring = from;
    for (int distance = 0; !ring.empty(); ++distance) {
        Set next;
        for (const std::size_t voxel : ring)
            distances.emplace(voxel, distance);
        for (const std::size_t voxel : ring) {
            for (const std::size_t other : neighbours(m_words, voxel, m_steps)) {
                if (isMember(other) && distances.count(other) == 0)
                    next.insert(other);
            }
        }
        ring = std::move(next);
    }
    return distances;
}

/// Rule 10, made less again and again until nothing is.
LabelFamily::Times LabelFamily::timesOf(const Set& staying, const Set& leaving) const
{
    Times times;
    for (const auto& [n, members] : m_byGeneration) {
        for (const std::size_t voxel : members) {
            if (leaving.count(voxel) == 0 && staying.count(voxel) == 0)
                times[voxel] = n;
        }
    }
    for (bool changed = true; changed;) {
        changed = false;
        for (const std::size_t voxel : staying) {
            for (const std::size_t next : neighbours(m_words, voxel, m_steps)) {
                const auto other = times.find(next);
                if (other == times.end())
                    continue;
                const std::uint32_t time = std::max(generation(voxel), other->second + 1);
                const auto own = times.find(voxel);
                if (time > seedWord::maxGeneration || (own != times.end() && own->second <= time))
                    continue;
                times[voxel] = time;
                changed = true;
            }
        }
    }
    return times;
}
std::uint32_t LabelFamily::retimed(std::size_t voxel, const Times& times) const
{
    const auto earlier = [&](std::size_t other) {
        const auto time = times.find(other);
        return time != times.end() && time->second < times.at(voxel);
    };
    const std::vector<std::size_t> before = parents(voxel);
    if (times.at(voxel) == generation(voxel) && std::any_of(before.begin(), before.end(), earlier))
        return m_words.values[voxel];
    int lowest = 0;
    const auto leadsHere = [&](int direction) {
        const auto& offset = seedWord::offsets[std::size_t(direction)];
        const glm::ivec3 from =
            placeOf(m_words, voxel) - glm::ivec3(offset[0], offset[1], offset[2]);
        return m_words.contains(from) && earlier(m_words.offset(from));
    };
    while (!leadsHere(lowest))
        ++lowest;
    const bool held = seedWord::direction(m_words.values[voxel]) == seedWord::heldDirection;
    return seedWord::member(
        times.at(voxel), m_label, held ? seedWord::heldDirection : std::uint32_t(lowest));
}

} // namespace reference
