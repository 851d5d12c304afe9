// SPDX-License-Identifier: Apache-2.0
#include "tests/reference/growth/Growth.h"

#include "core/document/Document.h"
#include "core/growth/SeedWord.h"

#include <algorithm>
#include <array>
#include <utility>

namespace reference {

namespace seedWord = core::seedWord;

namespace {

template <class Visit> void forEachVoxel(const glm::ivec3& size, Visit visit)
{
    for (int z = 0; z < size.z; ++z)
        for (int y = 0; y < size.y; ++y)
            for (int x = 0; x < size.x; ++x)
                visit(glm::ivec3(x, y, z));
}

} // namespace

void placeSeeds(DenseFields& fields, const core::SeedPlacement& placement)
{
    auto& words = fields.seedWords(placement.plane);
    for (const glm::ivec3& voxel : placement.taken) {
        std::uint32_t& word = words.at(voxel);
        if (word == seedWord::pendingSeed(placement.label))
            word = seedWord::unvisited;
    }
    for (const glm::ivec3& voxel : placement.voxels) {
        std::uint32_t& word = words.at(voxel);
        if (!seedWord::isMember(word))
            word = std::min(word, seedWord::pendingSeed(placement.label));
    }
}

void eraseLabel(DenseFields& fields, const core::EraseLabel& erase)
{
    for (std::uint8_t& label : fields.labels(erase.plane).values) {
        if (label == erase.label)
            label = 0;
    }
    for (std::uint32_t& word : fields.seedWords(erase.plane).values) {
        const bool bears = seedWord::isMember(word) || seedWord::isPendingSeed(word);
        if (bears && seedWord::label(word) == erase.label)
            word = seedWord::unvisited;
    }
    for (std::uint8_t& overwritten : fields.overwritten(erase.plane).values) {
        if (overwritten == erase.label)
            overwritten = 0;
    }
}

void giveBack(DenseFields& fields, std::uint8_t plane, const glm::ivec3& voxel, std::uint32_t word)
{
    std::uint8_t& held = fields.labels(plane).at(voxel);
    const std::uint32_t direction = seedWord::direction(word);
    if (!seedWord::isMember(word) || seedWord::generation(word) == 0 || direction == 29
        || direction == 30 || held != seedWord::label(word))
        return;
    std::uint8_t& overwritten = fields.overwritten(plane).at(voxel);
    held = overwritten;
    overwritten = 0;
}

void setOrClearBarrier(DenseFields& fields, std::uint8_t plane, bool erase,
    const std::bitset<256>& lockedLabels, const glm::ivec3& voxel)
{
    std::uint32_t& word = fields.seedWords(plane).at(voxel);
    if (erase) {
        if (word == seedWord::barrier)
            word = seedWord::unvisited;
        return;
    }
    const bool bears = seedWord::isMember(word) || seedWord::isPendingSeed(word);
    if (bears && lockedLabels.test(seedWord::label(word)))
        return;
    giveBack(fields, plane, voxel, word);
    word = seedWord::barrier;
}

std::uint32_t shrinkGrowth(DenseFields& fields, const core::ShrinkGrowth& shrink)
{
    auto& words = fields.seedWords(shrink.plane);
    std::uint32_t greatest = shrink.keep;
    forEachVoxel(fields.size(), [&](const glm::ivec3& voxel) {
        std::uint32_t& word = words.at(voxel);
        if (!seedWord::isMember(word))
            return;
        const std::uint32_t label = seedWord::label(word);
        const std::uint32_t direction = seedWord::direction(word);
        const bool seed = direction == 30 || direction == 31;
        if (seedWord::generation(word) > shrink.keep && !shrink.lockedLabels.test(label)) {
            if (seed && shrink.keepSeeds) {
                word = seedWord::member(1, label, direction);
            } else {
                giveBack(fields, shrink.plane, voxel, word);
                word = seed ? seedWord::pendingSeed(label) : seedWord::unvisited;
                return;
            }
        }
        greatest = std::max(greatest, seedWord::generation(word));
    });
    return greatest;
}

Growth::Growth(const DenseArray<std::uint16_t>& codes, DenseArray<std::uint8_t> coverage,
    DenseFields& fields, core::GrowBurst burst)
    : m_burst(std::move(burst))
    , m_fields(fields)
    , m_words(fields.seedWords(m_burst.plane))
    , m_labels(fields.labels(m_burst.plane))
    , m_overwritten(fields.overwritten(m_burst.plane))
    , m_criterion(codes, std::move(coverage), m_words, m_burst)
    , m_generation(m_burst.generation)
{
    if (m_burst.opening == core::GrowOpening::Narrow)
        narrow();
    if (m_burst.opening == core::GrowOpening::Restart)
        m_generation = shrinkGrowth(fields,
            {.plane = m_burst.plane,
                .generation = m_generation,
                .keep = 0,
                .keepSeeds = false,
                .lockedLabels = m_burst.lockedLabels});
    lookForPassages();
    if (m_burst.guard)
        m_watch.emplace(m_words.size, *m_burst.guard);
    std::vector<glm::ivec3> olderMembers;
    std::vector<glm::ivec3> admitted;
    forEachVoxel(m_words.size, [&](const glm::ivec3& voxel) {
        std::uint32_t& word = m_words.at(voxel);
        const std::uint32_t label = seedWord::label(word);
        if (seedWord::isMember(word)) {
            olderMembers.push_back(voxel);
        } else if (seedWord::isPendingSeed(word) && m_generation < seedWord::maxGeneration
            && accepts(label, voxel)) {
            word = seedWord::member(m_generation + 1, label, holds(label, voxel) ? 30 : 31);
            admitted.push_back(voxel);
        }
    });
    if (!admitted.empty())
        finishGeneration(std::move(admitted));
    m_front.insert(m_front.end(), olderMembers.begin(), olderMembers.end());
}

void Growth::lookForPassages()
{
    auto passage = std::make_unique<Passage>(m_burst, m_words.size);
    if (!passage->isAsked())
        return;
    for (const std::uint32_t word : m_words.values) {
        const std::uint32_t label = seedWord::label(word);
        if ((!seedWord::isMember(word) && !seedWord::isPendingSeed(word)) || passage->knows(label))
            continue;
        passage->look(
            label, [&](const glm::ivec3& voxel) { return m_criterion.allows(label, voxel); },
            m_words, m_labels,
            [&](const glm::ivec3& voxel) {
                return isInRange(voxel,
                    seedWord::isMember(m_words.at(voxel)) ? heldBefore(voxel) : m_labels.at(voxel));
            });
    }
    m_passage = std::move(passage);
}

bool Growth::follows(std::uint32_t label, const glm::ivec3& parent, const glm::ivec3& voxel) const
{
    return m_criterion.follows(parent, voxel)
        && (!m_passage || m_passage->passes(label, parent, voxel));
}

void Growth::narrow()
{
    std::vector<glm::ivec3> grown;
    const auto goes = [this](const glm::ivec3& voxel, std::uint32_t becomes) {
        std::uint32_t& word = m_words.at(voxel);
        giveBack(m_fields, m_burst.plane, voxel, word);
        word = becomes;
    };
    forEachVoxel(m_words.size, [&](const glm::ivec3& voxel) {
        const std::uint32_t word = m_words.at(voxel);
        const std::uint32_t label = seedWord::label(word);
        if (!seedWord::isMember(word) || seedWord::generation(word) == 0
            || m_burst.lockedLabels.test(label))
            return;
        if (!seedWord::isSeed(word))
            grown.push_back(voxel);
        else if (!acceptsMember(voxel))
            goes(voxel, seedWord::pendingSeed(label));
    });
    // From early to late: whoever comes before has been decided on.
    const auto generationAt = [this](const glm::ivec3& voxel) {
        return seedWord::generation(m_words.at(voxel));
    };
    std::stable_sort(grown.begin(), grown.end(), [&](const glm::ivec3& a, const glm::ivec3& b) {
        return generationAt(a) < generationAt(b);
    });
    for (const glm::ivec3& voxel : grown) {
        std::uint32_t& word = m_words.at(voxel);
        const std::optional<std::uint32_t> direction = parentDirection(voxel);
        if (!direction)
            goes(voxel, seedWord::unvisited);
        else if (seedWord::direction(word) != 29)
            word = seedWord::member(seedWord::generation(word), seedWord::label(word), *direction);
    }
    m_generation = 0;
    for (const std::uint32_t word : m_words.values) {
        if (seedWord::isMember(word))
            m_generation = std::max(m_generation, seedWord::generation(word));
    }
}

std::optional<std::uint32_t> Growth::parentDirection(const glm::ivec3& voxel) const
{
    const std::uint32_t word = m_words.at(voxel);
    for (std::uint32_t direction = 0; direction < std::uint32_t(m_burst.connectivity);
         ++direction) {
        const std::array<int, 3>& offset = seedWord::offsets[direction];
        const glm::ivec3 parent = voxel - glm::ivec3(offset[0], offset[1], offset[2]);
        if (!m_words.contains(parent) || !acceptsMember(voxel)
            || !m_criterion.follows(parent, voxel))
            continue;
        const std::uint32_t there = m_words.at(parent);
        if (seedWord::isMember(there) && seedWord::label(there) == seedWord::label(word)
            && seedWord::generation(there) < seedWord::generation(word))
            return direction;
    }
    return std::nullopt;
}

bool Growth::accepts(std::uint32_t label, const glm::ivec3& voxel) const
{
    return mayEnter(label, voxel, m_labels.at(voxel)); // changes only where members are
}

bool Growth::acceptsMember(const glm::ivec3& voxel) const
{
    return mayEnter(seedWord::label(m_words.at(voxel)), voxel, heldBefore(voxel));
}

/// What the plane would hold if growth had not added the label of this member.
std::uint8_t Growth::heldBefore(const glm::ivec3& voxel) const
{
    const std::uint32_t word = m_words.at(voxel);
    const std::uint32_t direction = seedWord::direction(word);
    const bool added = seedWord::generation(word) > 0 && direction != 29 && direction != 30
        && m_labels.at(voxel) == seedWord::label(word);
    return added ? m_overwritten.at(voxel) : m_labels.at(voxel);
}

bool Growth::isInRange(const glm::ivec3& voxel, std::uint8_t held) const
{
    const std::optional<core::GrowthRange>& range = m_burst.range;
    return !range || (!range->closed.test(held) && m_criterion.isBetween(voxel, *range));
}

bool Growth::mayEnter(std::uint32_t label, const glm::ivec3& voxel, std::uint8_t held) const
{
    return isInRange(voxel, held) && !m_burst.lockedLabels.test(label)
        && m_criterion.allows(label, voxel)
        && (held == 0 || held == label || m_burst.overwritable.test(held));
}

bool Growth::holds(std::uint32_t label, const glm::ivec3& voxel) const
{
    return m_burst.tellsHeld && m_labels.at(voxel) == label;
}

bool Growth::step()
{
    // A member that was there two steps ago has no neighbour left that it could take: what it is
    // accepted by, it took one step later. So only the last step's additions are asked.
    std::vector<glm::ivec3> added;
    for (const glm::ivec3& parent : m_front) {
        const std::uint32_t label = seedWord::label(m_words.at(parent));
        for (std::uint32_t direction = 0; direction < std::uint32_t(m_burst.connectivity);
             ++direction) {
            const std::array<int, 3>& offset = seedWord::offsets[direction];
            const glm::ivec3 child = parent + glm::ivec3(offset[0], offset[1], offset[2]);
            if (!m_words.contains(child) || !accepts(label, child)
                || !follows(label, parent, child))
                continue;
            std::uint32_t& word = m_words.at(child);
            const std::uint32_t claim =
                seedWord::member(m_generation + 1, label, holds(label, child) ? 29 : direction);
            if (word == seedWord::barrier)
                continue;
            if (!seedWord::isMember(word)) {
                word = claim;
                added.push_back(child);
            } else if (seedWord::generation(word) == m_generation + 1) {
                word = std::min(word, claim);
            }
        }
    }
    if (added.empty())
        return false;
    finishGeneration(std::move(added));
    return true;
}

void Growth::finishGeneration(std::vector<glm::ivec3> added)
{
    ++m_generation;
    m_frontSizes.push_back(std::uint32_t(added.size()));
    for (const glm::ivec3& voxel : added) {
        const auto label = std::uint8_t(seedWord::label(m_words.at(voxel)));
        std::uint8_t& held = m_labels.at(voxel);
        if (!m_burst.tellsHeld)
            m_overwritten.at(voxel) = 0;
        else if (held != label)
            m_overwritten.at(voxel) = held;
        held = label;
    }
    if (m_watch)
        m_alarm = m_watch->look(m_generation, added);
    m_front = std::move(added);
}

void Growth::advance(int steps)
{
    for (int done = 0; steps < 0 || done < steps; ++done) {
        if (m_atClosure || m_alarm || m_generation >= seedWord::maxGeneration)
            return;
        m_atClosure = !step();
    }
}

} // namespace reference
