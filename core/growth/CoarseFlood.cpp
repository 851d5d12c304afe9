// SPDX-License-Identifier: Apache-2.0
#include "core/growth/CoarseFlood.h"

#include "core/growth/SeedWord.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace core {

namespace {

constexpr std::size_t cellsBetweenLooks = 1 << 16; ///< at whether it was cancelled

enum Mark : std::uint8_t { Closed, Open, Taken };

/// Works on marks of all cells, with one more layer around them that nothing enters, so that a
/// neighbour is a fixed distance away and need not be looked up.
class Flood {
public:
    Flood(const CoarseCodes& codes, std::span<const std::uint8_t> labels, const CoarseRule& rule)
        : m_grid(codes.grid())
        , m_cells(m_grid.size())
        , m_row(std::size_t(m_cells.x) + 2)
        , m_layer(m_row * (std::size_t(m_cells.y) + 2))
        , m_labels(labels)
        , m_rule(rule)
        , m_marks(m_layer * (std::size_t(m_cells.z) + 2), Closed)
    {
        open(codes.codes());
    }

    void begin(const CoarseSeed& seed)
    {
        if (seed.code < m_rule.lowCode || seed.code > m_rule.highCode || !isInBox(seed.voxel))
            return;
        const glm::ivec3 own = seed.voxel / m_grid.cell;
        if (isClosed(m_grid.numberOf(own)))
            return;
        const std::size_t at = placeOf(own);
        const bool isOpen = m_marks[at] != Closed;
        take(at);
        m_marks[at] = Taken;
        for (std::size_t i = 0; i < seedWord::directions && !isOpen; ++i)
            take(at + stepOf(i));
    }

    [[nodiscard]] bool run(const Progress& progress)
    {
        std::array<std::size_t, seedWord::directions> steps{};
        for (std::size_t i = 0; i < steps.size(); ++i)
            steps[i] = stepOf(i);
        const auto count = std::size_t(m_rule.connectivity);
        for (std::size_t done = 0; !m_waiting.empty(); ++done) {
            if (done % cellsBetweenLooks == 0 && progress.cancelled())
                return false;
            const std::size_t at = m_waiting.back();
            m_waiting.pop_back();
            for (std::size_t i = 0; i < count; ++i)
                take(at + steps[i]);
        }
        return !progress.cancelled();
    }

    [[nodiscard]] CoarseReach reach() const
    {
        CoarseReach reach;
        const VoxelBox taken = countTaken(reach.voxels);
        if (taken.empty())
            return reach;
        reach.cells = {glm::max(taken.minimum - CoarseReach::margin, glm::ivec3(0)),
            glm::min(taken.maximum + CoarseReach::margin, m_cells)};
        const glm::ivec3 size = reach.cells.maximum - reach.cells.minimum;
        reach.states.resize(std::size_t(size.x) * std::size_t(size.y) * std::size_t(size.z));
        std::size_t state = 0;
        forEachRow(reach.cells, [&](const glm::ivec3& first) {
            const std::uint8_t* const marks = &m_marks[placeOf(first)];
            for (int x = 0; x < size.x; ++x, ++state)
                reach.states[state] =
                    marks[x] == Taken ? CoarseReach::Reached : CoarseReach::Beyond;
        });
        addRim(reach);
        return reach;
    }

private:
    [[nodiscard]] std::size_t placeOf(const glm::ivec3& cell) const
    {
        return std::size_t(cell.z + 1) * m_layer + std::size_t(cell.y + 1) * m_row
            + std::size_t(cell.x + 1);
    }
    /// To be added; it wraps where it leads back.
    [[nodiscard]] std::size_t stepOf(std::size_t direction) const
    {
        const std::array<int, 3>& step = seedWord::offsets[direction];
        return std::size_t(step[2]) * m_layer + std::size_t(step[1]) * m_row + std::size_t(step[0]);
    }
    [[nodiscard]] bool isInBox(const glm::ivec3& voxel) const
    {
        return glm::all(glm::greaterThanEqual(voxel, m_rule.boxFrom))
            && glm::all(glm::lessThanEqual(voxel, m_rule.boxTo));
    }
    [[nodiscard]] bool isClosed(std::size_t number) const
    {
        return m_rule.closed.test(m_labels.empty() ? 0 : m_labels[number]);
    }
    void take(std::size_t at)
    {
        if (m_marks[at] != Open)
            return;
        m_marks[at] = Taken;
        m_waiting.push_back(at);
    }
    /// @param does called with the first cell of each row of a box
    template <class Does> static void forEachRow(const VoxelBox& cells, Does does)
    {
        for (int z = cells.minimum.z; z < cells.maximum.z; ++z) {
            for (int y = cells.minimum.y; y < cells.maximum.y; ++y)
                does(glm::ivec3(cells.minimum.x, y, z));
        }
    }
    void open(const std::vector<std::uint16_t>& codes)
    {
        // In each row the same cells have their middle in the box.
        int from = 0;
        while (from < m_cells.x && m_grid.sampleOf({from, 0, 0}).x < m_rule.boxFrom.x)
            ++from;
        int to = m_cells.x;
        while (to > from && m_grid.sampleOf({to - 1, 0, 0}).x > m_rule.boxTo.x)
            --to;
        if (from == to)
            return;
        forEachRow({{from, 0, 0}, {to, m_cells.y, m_cells.z}}, [&](const glm::ivec3& first) {
            if (!isInBox(m_grid.sampleOf(first)))
                return;
            std::size_t number = m_grid.numberOf(first);
            std::uint8_t* const marks = &m_marks[placeOf(first)];
            for (int x = 0; x < to - from; ++x, ++number) {
                const int code = codes[number];
                if (code >= m_rule.lowCode && code <= m_rule.highCode && !isClosed(number))
                    marks[x] = Open;
            }
        });
    }
    /// @param voxels in them
    /// @return the box of those that were taken
    [[nodiscard]] VoxelBox countTaken(std::int64_t& voxels) const
    {
        VoxelBox taken;
        forEachRow({glm::ivec3(0), m_cells}, [&](const glm::ivec3& first) {
            const std::uint8_t* const marks = &m_marks[placeOf(first)];
            int from = m_cells.x;
            int to = 0;
            std::int64_t count = 0;
            for (int x = 0; x < m_cells.x; ++x) {
                if (marks[x] != Taken)
                    continue;
                from = std::min(from, x);
                to = x + 1;
                ++count;
            }
            if (count == 0)
                return;
            taken = taken.united({{from, first.y, first.z}, {to, first.y + 1, first.z + 1}});
            voxels += count * m_grid.voxelsIn(first);
            if (to == m_cells.x) // cut off
                voxels += m_grid.voxelsIn({to - 1, first.y, first.z}) - m_grid.voxelsIn(first);
        });
        return taken;
    }
    /// Makes Rim of what touches a reached cell.
    void addRim(CoarseReach& reach) const
    {
        const glm::ivec3 size = reach.cells.maximum - reach.cells.minimum;
        std::vector<std::uint16_t> widened = reach.states;
        std::vector<std::uint16_t> narrow;
        std::size_t step = 1;
        for (int axis = 0; axis < 3; step *= std::size_t(size[axis]), ++axis) {
            // A cell of one voxel has no border in it.
            if (m_grid.cell[axis] == 1)
                continue;
            narrow = widened;
            std::size_t state = 0;
            forEachRow({glm::ivec3(0), size}, [&](const glm::ivec3& first) {
                glm::ivec3 at = first;
                for (; at.x < size.x; ++at.x, ++state) {
                    if ((at[axis] > 0 && narrow[state - step] != CoarseReach::Beyond)
                        || (at[axis] + 1 < size[axis]
                            && narrow[state + step] != CoarseReach::Beyond))
                        widened[state] = CoarseReach::Reached;
                }
            });
        }
        std::size_t state = 0;
        forEachRow(reach.cells, [&](const glm::ivec3& first) {
            std::size_t number = m_grid.numberOf(first);
            for (int x = 0; x < size.x; ++x, ++state, ++number) {
                if (widened[state] != reach.states[state] && !isClosed(number))
                    reach.states[state] = CoarseReach::Rim;
            }
        });
    }

    CoarseGrid m_grid;
    glm::ivec3 m_cells;
    std::size_t m_row; ///< from a mark to the one in the next row
    std::size_t m_layer;
    std::span<const std::uint8_t> m_labels;
    const CoarseRule& m_rule;
    std::vector<std::uint8_t> m_marks; ///< Mark
    std::vector<std::size_t> m_waiting; ///< places of marks; the flood goes on from there
};

} // namespace

Result<CoarseReach> coarseFlood(const CoarseCodes& codes, std::span<const std::uint8_t> labels,
    const std::vector<CoarseSeed>& seeds, const CoarseRule& rule, const Progress& progress)
{
    Flood flood(codes, labels, rule);
    for (const CoarseSeed& seed : seeds)
        flood.begin(seed);
    if (!flood.run(progress))
        return failure(ErrorCode::Cancelled);
    return flood.reach();
}

CoarseReach inDoubledCells(const CoarseReach& reach)
{
    CoarseReach doubled;
    doubled.voxels = reach.voxels;
    if (reach.cells.empty())
        return doubled;
    doubled.cells = {reach.cells.minimum / 2, (reach.cells.maximum + 1) / 2};
    const glm::ivec3 size = doubled.cells.maximum - doubled.cells.minimum;
    struct Count {
        std::uint8_t cells = 0;
        std::uint8_t reached = 0;
        bool isAny = false;
    };
    std::vector<Count> counts(std::size_t(size.x) * std::size_t(size.y) * std::size_t(size.z));
    std::size_t from = 0;
    for (int z = reach.cells.minimum.z; z < reach.cells.maximum.z; ++z) {
        for (int y = reach.cells.minimum.y; y < reach.cells.maximum.y; ++y) {
            const glm::ivec3 row = glm::ivec3(0, y, z) / 2 - doubled.cells.minimum;
            const std::size_t first =
                (std::size_t(row.z) * std::size_t(size.y) + std::size_t(row.y))
                * std::size_t(size.x);
            for (int x = reach.cells.minimum.x; x < reach.cells.maximum.x; ++x, ++from) {
                Count& count = counts[first + std::size_t(x / 2 - doubled.cells.minimum.x)];
                ++count.cells;
                count.reached += reach.states[from] == CoarseReach::Reached ? 1 : 0;
                count.isAny = count.isAny || reach.states[from] != CoarseReach::Beyond;
            }
        }
    }
    doubled.states.reserve(counts.size());
    for (const Count& count : counts)
        doubled.states.push_back(count.reached > 0 && 2 * count.reached >= count.cells
                ? CoarseReach::Reached
                : count.isAny ? CoarseReach::Rim
                              : CoarseReach::Beyond);
    return doubled;
}

} // namespace core
