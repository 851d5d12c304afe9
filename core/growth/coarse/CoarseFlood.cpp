// SPDX-License-Identifier: Apache-2.0
#include "core/growth/coarse/CoarseFlood.h"

#include "core/growth/SeedWord.h"
#include "core/growth/coarse/CoarsePassage.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdlib>

namespace core {

namespace {

constexpr std::size_t cellsBetweenLooks = 1 << 16; ///< at whether it was cancelled
constexpr std::uint8_t carvedFrom = 128; ///< GrowLimits::onlyVisible

/// What is known of a cell, and of a voxel in a cell that holds barriers.
enum Mark : std::uint8_t {
    Closed = 0,
    Open = 1,
    OpenToRivals = 2,
    Taken = 4,
    TakenByRival = 8,
    /// The cell holds barriers, and its voxels have marks of their own. It may be open besides, as
    /// any other, but it is never taken itself.
    Divided = 16,
    Narrow = 32, ///< open, but a ball has no room around it
};
using Of = CoarseSeed::Of;
constexpr std::size_t claimants = 3; ///< Of

constexpr std::uint8_t openTo(Of of)
{
    return of == Of::Own ? Open : OpenToRivals;
}
constexpr std::uint8_t takenBy(Of of)
{
    return of == Of::Own ? Taken : TakenByRival;
}

/// Works on marks of all cells, with one more layer around them that nothing enters, so that a
/// neighbour is a fixed distance away and need not be looked up.
class Flood {
public:
    /// @param hasRivals else nobody asks who comes first
    Flood(
        const CoarseCodes& codes, const CoarseWalls& walls, const CoarseRule& rule, bool hasRivals)
        : m_grid(codes.grid())
        , m_cells(m_grid.size())
        , m_row(std::size_t(m_cells.x) + 2)
        , m_layer(m_row * (std::size_t(m_cells.y) + 2))
        , m_walls(walls)
        , m_rule(rule)
        , m_hasRivals(hasRivals)
        , m_own(codesWithin(rule, rule.among))
        , m_rivals(hasRivals ? codesWithin(rule, rule.rivalsAmong) : std::vector<std::uint8_t>())
        , m_passage(rule.passage, m_grid)
        , m_marks(m_layer * (std::size_t(m_cells.z) + 2), Closed)
        , m_waiting(hasRivals ? std::size_t(greatestSide()) + 1 : 1)
    {
        open(codes.codes());
        if (m_passage.isTold())
            narrow();
        divide();
        for (std::size_t i = 0; i < m_steps.size(); ++i)
            m_steps[i] = stepTo(seedWord::offsets[i]);
    }

    void begin(const CoarseSeed& seed)
    {
        if (!isWithin(seed.code, seed.of) || !isInBox(seed.voxel))
            return;
        const glm::ivec3 own = seed.voxel / m_grid.cell;
        if (isClosed(m_grid.numberOf(own), seed.of))
            return;
        const std::size_t at = placeOf(own);
        if (m_passage.isTold())
            return beginAround(own, seed.of);
        if ((m_marks[at] & Divided) != 0)
            return beginInside(at, seed);
        if ((m_marks[at] & (Taken | TakenByRival)) != 0)
            return;
        const bool isOpen = (m_marks[at] & openTo(seed.of)) != 0;
        m_marks[at] = takenBy(seed.of);
        if (isOpen)
            return wait({.at = at, .of = seed.of}, 0);
        for (const Step& step : m_steps)
            goOn(at, step, seed.of);
    }

    [[nodiscard]] bool run(const Progress& progress)
    {
        std::size_t done = 0;
        std::size_t idle = 0;
        for (; idle < m_waiting.size(); m_now = (m_now + 1) % m_waiting.size(), ++idle) {
            // Who comes first goes on first, so that it takes what several reach now.
            for (std::vector<Place>& places : m_waiting[m_now]) {
                while (!places.empty()) {
                    idle = 0;
                    if (done++ % cellsBetweenLooks == 0 && progress.cancelled())
                        return false;
                    const Place place = places.back();
                    places.pop_back();
                    goOnFrom(place);
                }
            }
        }
        if (m_passage.isTold())
            cover();
        return !progress.cancelled();
    }

    [[nodiscard]] CoarseReach reach() const
    {
        CoarseReach reach;
        const std::vector<std::int64_t> inside = countInside();
        VoxelBox taken = countTaken(reach.voxels);
        for (std::size_t i = 0; i < inside.size(); ++i) {
            const glm::ivec3& cell = m_walls.barriers->cells()[i];
            if (inside[i] > 0)
                taken = taken.united({cell, cell + 1});
            reach.voxels += inside[i];
        }
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
        addRim(reach, m_grid, [this](const glm::ivec3& cell) {
            const bool isKnown = (m_marks[placeOf(cell)] & (Divided | TakenByRival | Narrow)) != 0;
            return !isKnown && !isClosed(m_grid.numberOf(cell));
        });
        // Only now: beyond a barrier there is no rim.
        for (std::size_t i = 0; i < inside.size(); ++i) {
            if (inside[i] == 0)
                continue;
            const glm::ivec3& cell = m_walls.barriers->cells()[i];
            const glm::ivec3 local = cell - reach.cells.minimum;
            reach.states[std::size_t((local.z * size.y + local.y) * size.x + local.x)] =
                2 * inside[i] >= m_grid.voxelsIn(cell) ? CoarseReach::Reached : CoarseReach::Rim;
        }
        return reach;
    }

private:
    /// A cell from which the flood goes on, or a voxel of a divided one.
    struct Place {
        std::size_t at = 0;
        int voxel = -1; ///< its number in the cell; −1: all of the cell
        Of of = Of::Own;
    };
    /// A step from a cell to one beside it.
    struct Step {
        std::array<int, 3> offset{};
        std::size_t places = 0; ///< to be added; it wraps where it leads back
        int voxels = 1; ///< generations of a growth that lead as far
    };

    [[nodiscard]] std::size_t placeOf(const glm::ivec3& cell) const
    {
        return std::size_t(cell.z + 1) * m_layer + std::size_t(cell.y + 1) * m_row
            + std::size_t(cell.x + 1);
    }
    [[nodiscard]] Step stepTo(const std::array<int, 3>& offset) const
    {
        Step step{.offset = offset};
        step.places = std::size_t(offset[2]) * m_layer + std::size_t(offset[1]) * m_row
            + std::size_t(offset[0]);
        for (int axis = 0; axis < 3; ++axis)
            step.voxels =
                std::max(step.voxels, std::abs(offset[std::size_t(axis)]) * m_grid.cell[axis]);
        return step;
    }
    [[nodiscard]] int greatestSide() const
    {
        return std::max({m_grid.cell.x, m_grid.cell.y, m_grid.cell.z});
    }
    [[nodiscard]] bool isInBox(const glm::ivec3& voxel) const
    {
        return glm::all(glm::greaterThanEqual(voxel, m_rule.boxFrom))
            && glm::all(glm::lessThanEqual(voxel, m_rule.boxTo));
    }
    [[nodiscard]] bool isWithin(int code, Of of) const
    {
        return (of == Of::Own ? m_own : m_rivals)[std::size_t(code)] != 0;
    }
    [[nodiscard]] bool isClosed(std::size_t number, Of of = Of::Own) const
    {
        const std::uint8_t label = m_walls.labels.empty() ? 0 : m_walls.labels[number];
        return (of == Of::Own ? m_rule.closed : m_rule.closedToRivals).test(label)
            || (!m_walls.coverage.empty() && m_walls.coverage[number] >= carvedFrom);
    }

    /// @param voxels on the way there
    void wait(const Place& place, int voxels)
    {
        const std::size_t when = (m_now + std::size_t(voxels)) % m_waiting.size();
        m_waiting[when][std::size_t(place.of)].push_back(place);
    }
    void goOnFrom(const Place& place)
    {
        const auto count = std::size_t(m_rule.connectivity);
        if (place.voxel >= 0)
            return goOnInside(place);
        for (std::size_t i = 0; i < count; ++i)
            goOn(place.at, m_steps[i], place.of);
    }
    /// From all of a cell to the next one.
    void goOn(std::size_t from, const Step& step, Of of)
    {
        const std::size_t at = from + step.places;
        if ((m_marks[at] & openTo(of)) == 0)
            return;
        if ((m_marks[at] & Divided) == 0)
            return take(at, of, step.voxels);
        // The voxels of that one that touch this.
        glm::ivec3 first(0);
        glm::ivec3 end = m_grid.cell;
        for (int axis = 0; axis < 3; ++axis) {
            const int along = step.offset[std::size_t(axis)];
            if (along > 0)
                end[axis] = 1;
            else if (along < 0)
                first[axis] = m_grid.cell[axis] - 1;
        }
        for (int z = first.z; z < end.z; ++z)
            for (int y = first.y; y < end.y; ++y)
                for (int x = first.x; x < end.x; ++x)
                    takeInside(at, numberIn({x, y, z}), of, halfOf(step.voxels));
    }
    void goOnInside(const Place& place)
    {
        const glm::ivec3& cell = m_grid.cell;
        const glm::ivec3 voxel(
            place.voxel % cell.x, place.voxel / cell.x % cell.y, place.voxel / cell.x / cell.y);
        for (std::size_t i = 0; i < std::size_t(m_rule.connectivity); ++i) {
            const std::array<int, 3>& offset = seedWord::offsets[i];
            glm::ivec3 next = voxel + glm::ivec3(offset[0], offset[1], offset[2]);
            std::array<int, 3> leads{}; // to which cell
            for (int axis = 0; axis < 3; ++axis) {
                int& along = leads[std::size_t(axis)];
                along = next[axis] < 0 ? -1 : next[axis] >= cell[axis] ? 1 : 0;
                next[axis] -= along * cell[axis];
            }
            if (leads == std::array<int, 3>{}) {
                takeInside(place.at, numberIn(next), place.of, 1);
                continue;
            }
            const Step step = stepTo(leads);
            const std::size_t at = place.at + step.places;
            if ((m_marks[at] & openTo(place.of)) == 0)
                continue;
            if ((m_marks[at] & Divided) != 0)
                takeInside(at, numberIn(next), place.of, 1);
            else
                take(at, place.of, halfOf(step.voxels));
        }
    }
    [[nodiscard]] static int halfOf(int voxels) { return (voxels + 1) / 2; }
    [[nodiscard]] int numberIn(const glm::ivec3& local) const
    {
        return (local.z * m_grid.cell.y + local.y) * m_grid.cell.x + local.x;
    }
    void take(std::size_t at, Of of, int voxels)
    {
        m_marks[at] = takenBy(of);
        wait({.at = at, .of = of}, voxels);
    }
    /// @param at of a divided cell
    [[nodiscard]] std::uint8_t& markInside(std::size_t at, int voxel)
    {
        return m_inside[std::size_t(m_numbers[at]) * voxelsOfCell() + std::size_t(voxel)];
    }
    [[nodiscard]] std::size_t voxelsOfCell() const
    {
        return std::size_t(m_grid.cell.x) * std::size_t(m_grid.cell.y) * std::size_t(m_grid.cell.z);
    }
    void takeInside(std::size_t at, int voxel, Of of, int voxels)
    {
        std::uint8_t& mark = markInside(at, voxel);
        if ((mark & openTo(of)) == 0)
            return;
        mark = takenBy(of);
        wait({.at = at, .voxel = voxel, .of = of}, voxels);
    }
    /// A seed in a cell with barriers stays on its side of them, whatever the middle voxel is.
    void beginInside(std::size_t at, const CoarseSeed& seed)
    {
        if ((m_marks[at] & openTo(seed.of)) == 0) {
            m_marks[at] |= openTo(seed.of);
            const std::span<const std::uint8_t> passable =
                m_walls.barriers->passable(m_numbers[at]);
            for (std::size_t i = 0; i < passable.size(); ++i) {
                std::uint8_t& mark = markInside(at, int(i));
                if (passable[i] != 0 && (mark & (Taken | TakenByRival)) == 0)
                    mark |= openTo(seed.of);
            }
        }
        takeInside(at, numberIn(seed.voxel % m_grid.cell), seed.of, 0);
    }
    /// In all balls that hold the seed; in none, it stays alone.
    void beginAround(const glm::ivec3& own, Of of)
    {
        for (const glm::ivec3& step : m_passage.steps()) {
            const glm::ivec3 cell = own + step;
            if (glm::any(glm::lessThan(cell, glm::ivec3(0)))
                || glm::any(glm::greaterThanEqual(cell, m_cells)))
                continue;
            const std::size_t at = placeOf(cell);
            if ((m_marks[at] & openTo(of)) != 0)
                take(at, of, 0);
        }
        std::uint8_t& mark = m_marks[placeOf(own)];
        if ((mark & (Divided | Taken | TakenByRival)) == 0)
            mark = takenBy(of);
    }
    /// Leaves only those cells open around which a ball has room.
    void narrow()
    {
        if (m_walls.barriers) {
            for (const glm::ivec3& cell : m_walls.barriers->cells())
                m_marks[placeOf(cell)] = Closed;
        }
        std::vector<std::uint8_t> isOpen(m_grid.cellCount());
        forEachCell([&](std::size_t number, std::uint8_t& mark) {
            isOpen[number] = mark != Closed ? 1 : 0;
        });
        m_centres = m_passage.centres(isOpen);
        forEachCell([&](std::size_t number, std::uint8_t& mark) {
            if (m_centres[number] == 0)
                mark = (mark & Open) != 0 ? Narrow : Closed;
        });
    }
    /// Takes what is in the balls around the cells that were taken.
    void cover()
    {
        forEachCell([&](std::size_t number, std::uint8_t& mark) {
            m_centres[number] = m_centres[number] != 0 && mark == Taken ? 1 : 0;
        });
        const std::vector<std::uint8_t> covered = m_passage.covered(m_centres);
        forEachCell([&](std::size_t number, std::uint8_t& mark) {
            if (mark == Narrow && covered[number] != 0)
                mark = Taken;
        });
    }
    /// @param does called with the number and the mark of each
    template <class Does> void forEachCell(Does does)
    {
        std::size_t number = 0;
        forEachRow({glm::ivec3(0), m_cells}, [&](const glm::ivec3& first) {
            std::uint8_t* const marks = &m_marks[placeOf(first)];
            for (int x = 0; x < m_cells.x; ++x, ++number)
                does(number, marks[x]);
        });
    }
    /// Gives marks to the voxels of the cells that hold barriers.
    void divide()
    {
        if (!m_walls.barriers || m_walls.barriers->cells().empty())
            return;
        const std::vector<glm::ivec3>& cells = m_walls.barriers->cells();
        m_numbers.resize(m_marks.size());
        m_inside.reserve(cells.size() * voxelsOfCell());
        for (std::size_t i = 0; i < cells.size(); ++i) {
            const std::size_t at = placeOf(cells[i]);
            m_numbers[at] = std::uint32_t(i);
            for (const std::uint8_t isPassable : m_walls.barriers->passable(i))
                m_inside.push_back(isPassable != 0 ? m_marks[at] : std::uint8_t(Closed));
            m_marks[at] |= Divided;
        }
    }
    /// How many voxels of each cell with barriers were taken.
    [[nodiscard]] std::vector<std::int64_t> countInside() const
    {
        std::vector<std::int64_t> counts(m_inside.size() / voxelsOfCell());
        for (std::size_t i = 0; i < counts.size(); ++i) {
            const auto first = m_inside.begin() + std::ptrdiff_t(i * voxelsOfCell());
            counts[i] =
                std::count(first, first + std::ptrdiff_t(voxelsOfCell()), std::uint8_t(Taken));
        }
        return counts;
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
                if (isWithin(code, Of::Own) && !isClosed(number))
                    marks[x] |= Open;
                if (m_hasRivals && isWithin(code, Of::RivalAfter)
                    && !isClosed(number, Of::RivalAfter))
                    marks[x] |= OpenToRivals;
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

    CoarseGrid m_grid;
    glm::ivec3 m_cells;
    std::size_t m_row; ///< from a mark to the one in the next row
    std::size_t m_layer;
    const CoarseWalls& m_walls;
    const CoarseRule& m_rule;
    bool m_hasRivals;
    std::vector<std::uint8_t> m_own; ///< by code: 1 where the growth may take it
    std::vector<std::uint8_t> m_rivals; ///< the same for who grows with it
    CoarsePassage m_passage;
    std::vector<std::uint8_t> m_centres; ///< by cell: around which a ball has room
    std::array<Step, seedWord::directions> m_steps;
    std::vector<std::uint8_t> m_marks; ///< Mark
    std::vector<std::uint32_t> m_numbers; ///< by place: of a divided cell, among them
    std::vector<std::uint8_t> m_inside; ///< Mark of the voxels of divided cells
    /// Where the flood goes on: by when, a ring of as many voxels as the longest step leads, and by
    /// who comes first (Of).
    std::vector<std::array<std::vector<Place>, claimants>> m_waiting;
    std::size_t m_now = 0; ///< in the ring
};

} // namespace

Result<CoarseReach> coarseFlood(const CoarseCodes& codes, const CoarseWalls& walls,
    const std::vector<CoarseSeed>& seeds, const CoarseRule& rule, const Progress& progress)
{
    const auto isRival = [](const CoarseSeed& seed) { return seed.of != Of::Own; };
    Flood flood(codes, walls, rule, std::any_of(seeds.begin(), seeds.end(), isRival));
    // A cell that holds seeds of several is the growth's own.
    for (const bool rivals : {false, true}) {
        for (const CoarseSeed& seed : seeds) {
            if (isRival(seed) == rivals)
                flood.begin(seed);
        }
    }
    if (!flood.run(progress))
        return failure(ErrorCode::Cancelled);
    return flood.reach();
}

} // namespace core
