// SPDX-License-Identifier: Apache-2.0
#include "core/delta/SeedWordPrediction.h"

#include "core/growth/SeedWord.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace core {

namespace {

constexpr std::uint32_t directions = 6;
constexpr std::uint32_t lowBits = (1U << 13) - 1;
constexpr std::uint32_t noGeneration = 0xFFFFFFFFU;
constexpr std::size_t mostBricks = std::size_t(1) << 20; ///< as many as a Voxel numbers

/// A voxel of all the bricks: 4096 · place of the brick + voxel.
using Voxel = std::uint32_t;
constexpr Voxel none = 0xFFFFFFFFU;

bool isClaim(std::uint32_t difference)
{
    return (difference & seedWord::notMember) != 0;
}

bool admitsSeed(std::uint32_t difference)
{
    return (difference & lowBits) == 0;
}

/// Steps from voxel to voxel, over the borders of bricks too.
class Neighbourhood {
public:
    Neighbourhood(const std::vector<SeedWordBrick>& bricks, const glm::ivec2& along)
        : m_beside(bricks.size())
    {
        std::map<BrickKey, std::uint32_t> places;
        for (const SeedWordBrick& brick : bricks)
            places.emplace(brick.key, std::uint32_t(places.size()));
        const auto x = std::uint32_t(along.x);
        const auto y = std::uint32_t(along.y);
        for (std::size_t i = 0; i < bricks.size(); ++i) {
            const BrickKey& key = bricks[i].key;
            const std::uint32_t row = key.brick / x % y;
            const auto to = [&](bool inside, std::int64_t step) {
                const std::int64_t number = std::int64_t(key.brick) + step;
                const auto found = inside && number >= 0
                    ? places.find({key.field, key.plane, std::uint32_t(number)})
                    : places.end();
                return found == places.end() ? none : found->second;
            };
            const std::int64_t slice = std::int64_t(x) * y;
            m_beside[i] = {to(key.brick % x + 1 < x, 1), to(key.brick % x > 0, -1),
                to(row + 1 < y, x), to(row > 0, -std::int64_t(x)), to(true, slice),
                to(true, -slice)};
        }
    }

    /// One step by the offset of @p direction; none: no brick is there.
    [[nodiscard]] Voxel step(Voxel voxel, std::uint32_t direction) const
    {
        constexpr std::uint32_t last = BrickGrid::side - 1;
        const std::uint32_t shift = direction / 2 * 4;
        const std::uint32_t at = voxel >> shift & last;
        const bool up = direction % 2 == 0;
        if (at != (up ? last : 0))
            return up ? voxel + (1U << shift) : voxel - (1U << shift);
        const std::uint32_t beside = m_beside[voxel / BrickGrid::voxelsPerBrick][direction];
        if (beside == none)
            return none;
        const std::uint32_t inBrick = voxel % BrickGrid::voxelsPerBrick ^ last << shift;
        return beside * BrickGrid::voxelsPerBrick + inBrick;
    }

private:
    std::vector<std::array<std::uint32_t, directions>> m_beside; ///< places
};

/// What is known of a voxel's claim, in one word; 0: it is none.
namespace cell {
constexpr std::uint32_t isOne = 1U << 31;
constexpr int generationShift = 9;
constexpr std::uint32_t anyLabel = 256U;
constexpr std::uint32_t labelBits = 511U;

std::uint32_t generation(std::uint32_t cell)
{
    return cell >> generationShift & seedWord::maxGeneration;
}

std::uint32_t of(std::uint32_t difference)
{
    const bool seed = admitsSeed(difference);
    const std::uint32_t label = seed ? anyLabel : seedWord::label(~difference);
    return isOne | seedWord::generation(seed ? difference : ~difference) << generationShift | label;
}

bool agree(std::uint32_t a, std::uint32_t b)
{
    return ((a ^ b) & labelBits) == 0 || ((a | b) & anyLabel) != 0;
}
} // namespace cell

using Cells = std::vector<std::uint32_t>;

Cells cellsFor(const std::vector<SeedWordBrick>& bricks)
{
    return Cells(bricks.size() * BrickGrid::voxelsPerBrick, 0);
}

/// Calls @p visit(voxel, difference, brick) for every difference, in the order of bricks.
template <typename Bricks, typename Visit>
void forEachDifference(Bricks& bricks, const Visit& visit)
{
    Voxel first = 0;
    for (auto& brick : bricks) {
        for (std::uint32_t voxel = 0; voxel < BrickGrid::voxelsPerBrick; ++voxel) {
            if (brick.differences[voxel] != 0)
                visit(first + voxel, brick.differences[voxel], brick);
        }
        first += BrickGrid::voxelsPerBrick;
    }
}

/// Rings of predicted voxels around those that are kept.
class Rings {
public:
    Rings(std::vector<SeedWordBrick>& bricks, const glm::ivec2& along)
        : m_bricks(bricks)
        , m_neighbours(bricks, along)
        , m_states(bricks.size() * BrickGrid::voxelsPerBrick, 0)
    {
        std::set<std::uint32_t> labels;
        forEachDifference(
            bricks, [&](Voxel voxel, std::uint32_t difference, const SeedWordBrick& brick) {
                if (!isClaim(difference))
                    return;
                const std::uint32_t claim = cell::of(difference);
                if (brick.predicted.has(voxel % BrickGrid::voxelsPerBrick)) {
                    m_states[voxel] = open;
                    ++m_left;
                } else {
                    m_kept.emplace_back(cell::generation(claim), voxel);
                }
                if (labels.size() < 2 && (claim & cell::anyLabel) == 0)
                    labels.insert(claim & cell::labelBits);
            });
        m_severalLabels = labels.size() > 1;
        std::sort(m_kept.begin(), m_kept.end());
    }

    /// @return false: some are not reached
    bool spread()
    {
        std::vector<Voxel> ring;
        std::vector<Voxel> reached;
        auto kept = m_kept.begin();
        std::uint32_t generation = 0;
        while (m_left > 0) {
            if (ring.empty()) {
                if (kept == m_kept.end())
                    return false;
                generation = kept->first;
            }
            for (; kept != m_kept.end() && kept->first == generation; ++kept)
                ring.push_back(kept->second);
            ++generation;
            reached.clear();
            if (generation <= seedWord::maxGeneration)
                reach(ring, reached);
            close(reached, generation);
            ring.swap(reached);
        }
        return true;
    }

private:
    // Of a voxel that is predicted; 0: it is none, or its ring is closed. The lowest three bits are
    // the direction, once it is reached.
    static constexpr std::uint8_t open = 0x10;
    static constexpr std::uint8_t reachedNow = 0x08;
    static constexpr std::uint8_t directionBits = 0x07;

    void reach(const std::vector<Voxel>& ring, std::vector<Voxel>& reached)
    {
        for (const Voxel parent : ring) {
            for (std::uint32_t direction = 0; direction < directions; ++direction) {
                const Voxel voxel = m_neighbours.step(parent, direction);
                if (voxel == none)
                    continue;
                std::uint8_t& state = m_states[voxel];
                if (state == 0 || (m_severalLabels && !agree(parent, voxel)))
                    continue;
                const bool first = (state & reachedNow) == 0;
                if (first)
                    reached.push_back(voxel);
                if (first || direction < (state & directionBits))
                    state = std::uint8_t(open | reachedNow | direction);
            }
        }
    }

    void close(const std::vector<Voxel>& reached, std::uint32_t generation)
    {
        for (const Voxel voxel : reached) {
            std::uint32_t& difference = differenceAt(voxel);
            difference = ~seedWord::member(
                generation, seedWord::label(~difference), m_states[voxel] & directionBits);
            m_states[voxel] = 0;
        }
        m_left -= reached.size();
    }

    [[nodiscard]] std::uint32_t& differenceAt(Voxel voxel)
    {
        return m_bricks[voxel / BrickGrid::voxelsPerBrick]
            .differences[voxel % BrickGrid::voxelsPerBrick];
    }
    [[nodiscard]] bool agree(Voxel a, Voxel b)
    {
        return cell::agree(cell::of(differenceAt(a)), cell::of(differenceAt(b)));
    }

    std::vector<SeedWordBrick>& m_bricks;
    Neighbourhood m_neighbours;
    std::vector<std::uint8_t> m_states;
    bool m_severalLabels = false;
    std::vector<std::pair<std::uint32_t, Voxel>> m_kept; ///< by generation
    std::size_t m_left = 0; ///< predicted ones that are not reached yet
};

} // namespace

void markPredicted(std::vector<SeedWordBrick>& bricks, const glm::ivec2& along)
{
    if (bricks.size() >= mostBricks)
        return;
    const Neighbourhood neighbours(bricks, along);
    Cells cells = cellsFor(bricks);
    forEachDifference(bricks, [&](Voxel voxel, std::uint32_t difference, SeedWordBrick&) {
        if (isClaim(difference))
            cells[voxel] = cell::of(difference);
    });
    forEachDifference(bricks, [&](Voxel voxel, std::uint32_t difference, SeedWordBrick& brick) {
        if (!isClaim(difference) || admitsSeed(difference))
            return;
        std::uint32_t earliest = noGeneration;
        std::uint32_t from = 0;
        for (std::uint32_t direction = 0; direction < directions; ++direction) {
            const Voxel beside = neighbours.step(voxel, direction ^ 1U);
            const std::uint32_t parent = beside == none ? 0 : cells[beside];
            if (parent != 0 && cell::generation(parent) < earliest
                && cell::agree(cells[voxel], parent)) {
                earliest = cell::generation(parent);
                from = direction;
            }
        }
        const std::uint32_t word = ~difference;
        if (earliest != noGeneration
            && word == seedWord::member(earliest + 1, seedWord::label(word), from))
            brick.predicted.add(voxel % BrickGrid::voxelsPerBrick);
    });
}

bool completePredicted(std::vector<SeedWordBrick>& bricks, const glm::ivec2& along)
{
    if (bricks.size() >= mostBricks)
        return false;
    return Rings(bricks, along).spread();
}

std::uint32_t predictedDifference(std::uint8_t label)
{
    return ~seedWord::member(0, label, 0);
}

std::uint8_t labelOfDifference(std::uint32_t difference)
{
    return std::uint8_t(seedWord::label(~difference));
}

} // namespace core
