// SPDX-License-Identifier: Apache-2.0
#include "core/chunks/ChunkColours.h"

#include "core/chunks/BoxWalk.h"

#include <algorithm>
#include <bitset>

namespace core {

namespace {

using Chunk = ChunkTree::Chunk;
using Contacts = std::vector<std::pair<Chunk, Chunk>>;

void dropRepeated(Contacts& contacts)
{
    std::sort(contacts.begin(), contacts.end());
    contacts.erase(std::unique(contacts.begin(), contacts.end()), contacts.end());
}

/// Far apart for numbers that follow each other.
std::size_t firstChoice(Chunk chunk)
{
    return chunk * std::size_t(2654435761U) >> 7 & std::size_t(ChunkColours::colours - 1);
}

} // namespace

ChunkColours::ChunkColours(const ChunkTree& tree, const glm::ivec3& size)
{
    std::pair<Chunk, Chunk> last{0, 0};
    BoxWalk(size).forEachPair([&](std::size_t voxel, std::size_t neighbour) {
        const auto one = tree.leafAt(voxel);
        const auto other = tree.leafAt(neighbour);
        if (!one || !other || *one == *other)
            return;
        const std::pair<Chunk, Chunk> contact = std::minmax(*one, *other);
        if (contact != last)
            m_contacts.push_back(contact);
        last = contact;
    });
    dropRepeated(m_contacts);
}

std::vector<std::uint8_t> ChunkColours::of(const ChunkTree& tree, int count) const
{
    const std::vector<Chunk> holders = tree.chunksOfLeaves(count);
    Contacts contacts; // both ways
    for (const auto& [one, other] : m_contacts) {
        if (holders[one] == holders[other])
            continue;
        contacts.emplace_back(holders[one], holders[other]);
        contacts.emplace_back(holders[other], holders[one]);
    }
    dropRepeated(contacts);
    struct Touching {
        std::size_t begin = 0;
        std::size_t end = 0;
        Chunk chunk = 0;
    };
    std::vector<Touching> all;
    for (std::size_t i = 0; i < contacts.size(); ++i) {
        if (i == 0 || contacts[i].first != contacts[i - 1].first)
            all.push_back({.begin = i, .end = i, .chunk = contacts[i].first});
        all.back().end = i + 1;
    }
    // Those that touch most choose first: there is always something left for the others.
    std::stable_sort(all.begin(), all.end(), [](const Touching& one, const Touching& other) {
        return one.end - one.begin > other.end - other.begin;
    });
    const Chunk most = holders.empty() ? 0 : *std::max_element(holders.begin(), holders.end());
    std::vector<int> chosen(std::size_t(most) + 1, -1);
    for (const Touching& touching : all) {
        std::bitset<colours> taken;
        for (std::size_t i = touching.begin; i < touching.end; ++i) {
            if (const int colour = chosen[contacts[i].second]; colour >= 0)
                taken.set(std::size_t(colour));
        }
        std::size_t colour = firstChoice(touching.chunk);
        while (taken.test(colour) && !taken.all())
            colour = (colour + 1) % std::size_t(colours);
        chosen[touching.chunk] = int(colour);
    }
    std::vector<std::uint8_t> result;
    result.reserve(holders.size());
    for (const Chunk chunk : holders)
        result.push_back(
            std::uint8_t(chosen[chunk] >= 0 ? std::size_t(chosen[chunk]) : firstChoice(chunk)));
    return result;
}

} // namespace core
