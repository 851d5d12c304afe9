// SPDX-License-Identifier: Apache-2.0
#include "core/chunks/DoubtfulChunks.h"

#include "core/chunks/BoxWalk.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace core {

namespace {

constexpr std::int64_t whole = 256; ///< shares are in 256ths
/// So that a neck with a sixth of the faces of a cube's side counts half.
constexpr std::int64_t narrowTimes = 4;
/// So that a contact with twice the faces of a cube's side counts half.
constexpr std::int64_t wideTimes = 2;
/// A chunk whose likelihood speaks for the outside by this much is not in doubt. It is less than
/// one deviation, because missing parts of organs are about as likely on both sides, and their
/// neighbours only slightly less.
constexpr std::int64_t lostLead = 40;
/// The doubt of a chunk must be at least its voxels divided by this.
constexpr std::int64_t leastShare = 16;
/// Doubt below the segment's voxels divided by leastPart, or below leastDoubt voxels, is ignored.
constexpr std::int64_t leastPart = 4000;
constexpr std::int64_t leastDoubt = 16;
/// For how many of the most doubtful chunks the number of chunks is suggested.
constexpr std::size_t suggestedBy = 3;
/// The second and third count only if their doubt is at least that of the first divided by
/// doubtfulPart, and if the number of chunks that they need is at most timesAsMany times the one
/// that the first needs, or at most fewEnough.
constexpr std::int64_t doubtfulPart = 8;
constexpr int timesAsMany = 2;
constexpr int fewEnough = 60;

/// The number of voxel faces on one side of a cube with this number of voxels.
std::int64_t facesOfCube(std::int64_t voxels)
{
    std::int64_t edge = 1;
    while ((edge + 1) * (edge + 1) * (edge + 1) <= voxels)
        ++edge;
    return edge * edge;
}

/// The share of a part, in units of 1/whole; 0 if there is nothing at all.
std::int64_t shareOf(std::int64_t part, std::int64_t all)
{
    return all > 0 ? whole * part / all : 0;
}

} // namespace

DoubtfulChunks::Around& DoubtfulChunks::Around::operator+=(const Around& other)
{
    for (std::size_t side = 0; side < bonds.size(); ++side) {
        bonds[side] += other.bonds[side];
        faces[side] += other.faces[side];
    }
    return *this;
}

DoubtfulChunks::Around& DoubtfulChunks::Around::operator-=(const Around& other)
{
    for (std::size_t side = 0; side < bonds.size(); ++side) {
        bonds[side] -= other.bonds[side];
        faces[side] -= other.faces[side];
    }
    return *this;
}

DoubtfulChunks::DoubtfulChunks(const ChunkTree& tree, const ChunkSurvey& survey,
    std::uint8_t segment, std::vector<bool> isInside)
    : m_tree(tree)
    , m_survey(survey)
    , m_segment(segment)
    , m_leafIsInside(std::move(isInside))
    , m_held(tree.chunkCount())
    , m_doubts(tree.chunkCount())
{
    for (Chunk leaf = 0; leaf < Chunk(tree.finest()); ++leaf) {
        m_held[leaf] = m_leafIsInside[leaf] ? std::int64_t(tree.voxels(leaf).size()) : 0;
        m_allHeld += m_held[leaf];
    }
    for (Chunk chunk = 0; chunk < tree.chunkCount(); ++chunk) {
        if (const auto parent = tree.parent(chunk))
            m_held[*parent] += m_held[chunk];
    }
    const std::vector<Around> around = lookAround();
    for (Chunk chunk = 0; chunk < tree.chunkCount(); ++chunk)
        m_doubts[chunk] = doubtOf(chunk, around[chunk]);
}

std::vector<bool> DoubtfulChunks::ownedBy(const ChunkTree& tree, std::uint8_t segment)
{
    std::vector<bool> owned;
    for (Chunk leaf = 0; leaf < Chunk(tree.finest()); ++leaf)
        owned.push_back(tree.owner(leaf) == segment);
    return owned;
}

/// For each chunk, the sums over its outer borders. A border is an outer one unless both of its
/// leaves are in the chunk: the borders of all leaves are added up, then those within are
/// subtracted.
std::vector<DoubtfulChunks::Around> DoubtfulChunks::lookAround() const
{
    std::vector<Around> around(m_tree.chunkCount());
    std::vector<Around> within(m_tree.chunkCount());
    for (const ChunkSurvey::Border& border : m_survey.borders) {
        const auto seenFrom = [&](Chunk other) {
            Around its;
            const std::size_t side = m_leafIsInside[other] ? 1 : 0;
            its.bonds[side] = std::int64_t(border.bond);
            its.faces[side] = std::int64_t(border.faces);
            return its;
        };
        around[border.first] += seenFrom(border.second);
        around[border.second] += seenFrom(border.first);
        // The first chunk that contains both leaves; chunks have smaller numbers than the one that
        // they are joined into.
        std::optional<Chunk> one = border.first;
        std::optional<Chunk> other = border.second;
        while (one && other && *one != *other)
            (*one < *other ? one : other) = m_tree.parent(std::min(*one, *other));
        if (!one || !other)
            continue;
        within[*one] += seenFrom(border.second);
        within[*one] += seenFrom(border.first);
    }
    for (Chunk chunk = 0; chunk < m_tree.chunkCount(); ++chunk) {
        if (const auto parent = m_tree.parent(chunk)) {
            around[*parent] += around[chunk];
            within[*parent] += within[chunk];
        }
    }
    for (Chunk chunk = 0; chunk < m_tree.chunkCount(); ++chunk)
        around[chunk] -= within[chunk];
    return around;
}

bool DoubtfulChunks::isInside(Chunk chunk) const
{
    return 2 * m_held[chunk] > std::int64_t(m_tree.voxels(chunk).size());
}

std::int64_t DoubtfulChunks::doubtOf(Chunk chunk, const Around& around) const
{
    const std::uint8_t owner = m_tree.owner(chunk);
    if (owner != 0 && owner != m_segment)
        return 0;
    const auto voxels = std::int64_t(m_tree.voxels(chunk).size());
    const bool inside = isInside(chunk);
    if (voxels > (inside ? m_allHeld / 2 : m_allHeld))
        return 0;
    // The tree's likelihood is that for the owner at the time of the division.
    const bool stays = inside == (owner == m_segment);
    const std::int64_t likelihood = stays ? m_tree.likelihood(chunk) : -m_tree.likelihood(chunk);
    const std::int64_t cube = facesOfCube(voxels);
    const auto [outerBonds, innerBonds] = around.bonds;
    const auto [outerFaces, innerFaces] = around.faces;
    const std::int64_t contact = innerBonds / std::int64_t(ChunkSurvey::alike);
    std::int64_t first = 0;
    std::int64_t second = 0;
    std::int64_t unlikely = 0;
    if (inside) {
        unlikely = shareOf(2 * ChunkField::most - likelihood, 3 * ChunkField::most);
        first = shareOf(outerFaces, outerFaces + contact);
        second = shareOf(std::max<std::int64_t>(0, cube - contact), cube + narrowTimes * contact);
    } else if (innerFaces > 0) {
        const std::int64_t lead =
            shareOf(std::clamp<std::int64_t>(lostLead - likelihood, 0, lostLead), lostLead);
        unlikely = lead * lead / whole;
        first = shareOf(innerBonds, innerBonds + outerBonds);
        second = innerBonds / innerFaces * contact / (contact + wideTimes * cube);
    }
    const std::int64_t doubt = voxels * first / whole * second / whole * unlikely / whole;
    return leastShare * doubt < voxels ? 0 : doubt;
}

std::vector<DoubtfulChunks::Chunk> DoubtfulChunks::inOrder(std::vector<Chunk> chunks) const
{
    const std::int64_t least = std::max(leastDoubt, m_allHeld / leastPart);
    chunks.erase(std::remove_if(chunks.begin(), chunks.end(),
                     [&](Chunk chunk) { return m_doubts[chunk] < least; }),
        chunks.end());
    std::sort(chunks.begin(), chunks.end(), [this](Chunk one, Chunk other) {
        return m_doubts[one] != m_doubts[other] ? m_doubts[one] > m_doubts[other] : one < other;
    });
    return chunks;
}

std::uint32_t DoubtfulChunks::middleOf(Chunk chunk, const std::vector<Chunk>& ofLeaves) const
{
    const BoxWalk walk(m_survey.size);
    const auto placeOf = [&](Chunk leaf) {
        return glm::i64vec3(walk.placeOf(m_survey.middles[leaf]));
    };
    glm::i64vec3 sum(0);
    for (Chunk leaf = 0; leaf < Chunk(ofLeaves.size()); ++leaf) {
        if (ofLeaves[leaf] == chunk)
            sum += placeOf(leaf) * std::int64_t(m_tree.voxels(leaf).size());
    }
    const glm::i64vec3 centre = sum / std::int64_t(m_tree.voxels(chunk).size());
    std::uint32_t middle = 0;
    std::int64_t nearest = std::numeric_limits<std::int64_t>::max();
    for (Chunk leaf = 0; leaf < Chunk(ofLeaves.size()); ++leaf) {
        if (ofLeaves[leaf] != chunk)
            continue;
        const glm::i64vec3 off = placeOf(leaf) - centre;
        const std::int64_t squared = off.x * off.x + off.y * off.y + off.z * off.z;
        if (squared < nearest) {
            nearest = squared;
            middle = m_survey.middles[leaf];
        }
    }
    return middle;
}

std::vector<DoubtfulChunks::Doubtful> DoubtfulChunks::of(int count, std::size_t most) const
{
    std::vector<Chunk> chunks = inOrder(m_tree.division(count));
    chunks.resize(std::min(chunks.size(), most));
    const std::vector<Chunk> ofLeaves = m_tree.chunksOfLeaves(count);
    std::vector<Doubtful> doubtful;
    for (const Chunk chunk : chunks)
        doubtful.push_back({.chunk = chunk,
            .isInside = isInside(chunk),
            .doubt = m_doubts[chunk],
            .middle = middleOf(chunk, ofLeaves)});
    return doubtful;
}

std::optional<int> DoubtfulChunks::suggestedCount() const
{
    std::vector<Chunk> all(m_tree.chunkCount());
    for (Chunk chunk = 0; chunk < m_tree.chunkCount(); ++chunk)
        all[chunk] = chunk;
    all = inOrder(std::move(all));
    if (all.empty())
        return std::nullopt;
    const auto contains = [this](Chunk outer, Chunk inner) {
        std::optional<Chunk> holder = inner;
        while (holder && *holder < outer)
            holder = m_tree.parent(*holder);
        return holder == outer;
    };
    std::vector<Chunk> taken;
    int least = m_tree.fewest();
    int greatest = m_tree.finest();
    const std::int64_t doubt = m_doubts[all.front()] / doubtfulPart;
    const int most = std::max(fewEnough, timesAsMany * m_tree.fewestWith(all.front()));
    for (const Chunk chunk : all) {
        if (m_doubts[chunk] < doubt || taken.size() == suggestedBy)
            break;
        const bool isKnown = std::any_of(taken.begin(), taken.end(),
            [&](Chunk before) { return contains(before, chunk) || contains(chunk, before); });
        if (isKnown)
            continue;
        taken.push_back(chunk);
        const int low = std::max(least, m_tree.fewestWith(chunk));
        const int high = std::min(greatest, m_tree.mostWith(chunk));
        if (low <= std::min(high, most)) {
            least = low;
            greatest = high;
        }
    }
    return least;
}

} // namespace core
