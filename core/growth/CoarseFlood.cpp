// SPDX-License-Identifier: Apache-2.0
#include "core/growth/CoarseFlood.h"

#include "core/growth/SeedWord.h"

#include <algorithm>

namespace core {

namespace {

constexpr std::size_t cellsBetweenLooks = 1 << 16; ///< at whether it was cancelled

class Flood {
public:
    Flood(const CoarseCodes& codes, std::span<const std::uint8_t> labels, const CoarseRule& rule)
        : m_grid(codes.grid())
        , m_cells(m_grid.size())
        , m_codes(codes.codes())
        , m_labels(labels)
        , m_rule(rule)
        , m_reached(m_grid.cellCount())
    {
    }

    void begin(const CoarseSeed& seed)
    {
        if (seed.code < m_rule.lowCode || seed.code > m_rule.highCode || !isInBox(seed.voxel))
            return;
        const glm::ivec3 own = seed.voxel / m_grid.cell;
        if (isClosed(m_grid.numberOf(own)))
            return;
        const bool isOpen = this->isOpen(own);
        reach(own, isOpen);
        for (std::uint32_t i = 0; i < seedWord::directions && !isOpen; ++i)
            goTo(own + offset(i));
    }

    [[nodiscard]] bool run(const Progress& progress)
    {
        for (std::size_t next = 0; next < m_queue.size(); ++next) {
            if (next % cellsBetweenLooks == 0 && progress.cancelled())
                return false;
            const glm::ivec3 place = m_queue[next];
            for (int i = 0; i < m_rule.connectivity; ++i)
                goTo(place + offset(std::uint32_t(i)));
        }
        return !progress.cancelled();
    }

    [[nodiscard]] CoarseReach reach() const
    {
        CoarseReach reach{.cells = {}, .states = {}, .voxels = m_voxels};
        if (m_box.empty())
            return reach;
        reach.cells = {glm::max(m_box.minimum - CoarseReach::margin, glm::ivec3(0)),
            glm::min(m_box.maximum + CoarseReach::margin, m_cells)};
        reach.states = reachedIn(reach.cells);
        std::vector<std::uint16_t> widened = reach.states;
        for (int axis = 0; axis < 3; ++axis) {
            // A cell of one voxel has no border in it.
            if (m_grid.cell[axis] > 1)
                widen(widened, reach.cells, axis);
        }
        std::size_t at = 0;
        forEach(reach.cells, [&](std::size_t number) {
            if (reach.states[at] == CoarseReach::Beyond && widened[at] != CoarseReach::Beyond
                && !isClosed(number))
                reach.states[at] = CoarseReach::Rim;
            ++at;
        });
        return reach;
    }

private:
    static glm::ivec3 offset(std::uint32_t direction)
    {
        const auto& step = seedWord::offsets[direction];
        return {step[0], step[1], step[2]};
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
    [[nodiscard]] bool isOpen(const glm::ivec3& place) const
    {
        const std::size_t number = m_grid.numberOf(place);
        const int code = m_codes[number];
        return code >= m_rule.lowCode && code <= m_rule.highCode && !isClosed(number)
            && isInBox(m_grid.sampleOf(place));
    }
    void goTo(const glm::ivec3& place)
    {
        const bool isInside = glm::all(glm::greaterThanEqual(place, glm::ivec3(0)))
            && glm::all(glm::lessThan(place, m_cells));
        if (isInside && isOpen(place))
            reach(place, true);
    }
    /// @param goesOn whether the flood goes on from here
    void reach(const glm::ivec3& place, bool goesOn)
    {
        std::uint8_t& reached = m_reached[m_grid.numberOf(place)];
        if (reached != 0)
            return;
        reached = 1;
        m_voxels += m_grid.voxelsIn(place);
        m_box = m_box.united({place, place + 1});
        if (goesOn)
            m_queue.push_back(place);
    }
    template <class Does> void forEach(const VoxelBox& cells, Does does) const
    {
        for (int z = cells.minimum.z; z < cells.maximum.z; ++z) {
            for (int y = cells.minimum.y; y < cells.maximum.y; ++y) {
                std::size_t number = m_grid.numberOf({cells.minimum.x, y, z});
                for (int x = cells.minimum.x; x < cells.maximum.x; ++x, ++number)
                    does(number);
            }
        }
    }
    [[nodiscard]] std::vector<std::uint16_t> reachedIn(const VoxelBox& cells) const
    {
        std::vector<std::uint16_t> states;
        const glm::ivec3 size = cells.maximum - cells.minimum;
        states.reserve(std::size_t(size.x) * std::size_t(size.y) * std::size_t(size.z));
        forEach(cells, [&](std::size_t number) {
            states.push_back(m_reached[number] != 0 ? CoarseReach::Reached : CoarseReach::Beyond);
        });
        return states;
    }
    /// Each cell that has one beside it along an axis.
    static void widen(std::vector<std::uint16_t>& states, const VoxelBox& cells, int axis)
    {
        const glm::ivec3 size = cells.maximum - cells.minimum;
        std::size_t step = 1;
        for (int before = 0; before < axis; ++before)
            step *= std::size_t(size[before]);
        const std::vector<std::uint16_t> narrow = states;
        const auto length = std::size_t(size[axis]);
        for (std::size_t at = 0; at < states.size(); ++at) {
            const std::size_t along = at / step % length;
            if ((along > 0 && narrow[at - step] != 0)
                || (along + 1 < length && narrow[at + step] != 0))
                states[at] = CoarseReach::Reached;
        }
    }

    CoarseGrid m_grid;
    glm::ivec3 m_cells;
    const std::vector<std::uint16_t>& m_codes;
    std::span<const std::uint8_t> m_labels;
    const CoarseRule& m_rule;
    std::vector<std::uint8_t> m_reached; ///< by cell
    std::vector<glm::ivec3> m_queue;
    VoxelBox m_box; ///< cells
    std::int64_t m_voxels = 0;
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

} // namespace core
