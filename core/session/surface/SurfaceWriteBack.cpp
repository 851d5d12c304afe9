// SPDX-License-Identifier: Apache-2.0
#include "core/session/surface/SurfaceWriteBack.h"

#include "core/brick/BrickGrid.h"
#include "core/brick/VoxelRunSets.h"

#include <algorithm>
#include <map>
#include <utility>

namespace core {

namespace {

/// Columns from and to (not included) of one row.
using Columns = std::vector<std::pair<std::uint64_t, std::uint64_t>>;

/// Calls visit(row, first column, one past the last) for every piece of a run that lies in one row.
template <typename Visit>
void forEachRowPiece(const VoxelRuns& voxels, const glm::ivec3& size, const Visit& visit)
{
    const auto width = std::uint64_t(size.x);
    for (const VoxelRun& run : voxels.runs()) {
        const std::uint64_t end = run.first + run.count;
        for (std::uint64_t at = run.first; at < end;) {
            const std::uint64_t row = at / width;
            const std::uint64_t last = std::min(end, (row + 1) * width);
            visit(row, at - row * width, last - row * width);
            at = last;
        }
    }
}

/// Sorted, those that touch joined.
Columns joined(Columns columns)
{
    std::sort(columns.begin(), columns.end());
    Columns whole;
    for (const auto& [from, to] : columns) {
        if (whole.empty() || whole.back().second < from)
            whole.emplace_back(from, to);
        else
            whole.back().second = std::max(whole.back().second, to);
    }
    return whole;
}

glm::ivec3 voxelAt(std::uint64_t place, const glm::ivec3& size)
{
    const auto width = std::uint64_t(size.x);
    const auto height = std::uint64_t(size.y);
    return {int(place % width), int(place / width % height), int(place / width / height)};
}

/// The box around voxels, as far as a volume goes.
VoxelBox boxAround(const VoxelRuns& voxels, const glm::ivec3& size, int margin)
{
    glm::ivec3 least = size;
    glm::ivec3 most(-1);
    forEachRowPiece(voxels, size, [&](std::uint64_t row, std::uint64_t from, std::uint64_t to) {
        const int y = int(row % std::uint64_t(size.y));
        const int z = int(row / std::uint64_t(size.y));
        least = glm::min(least, glm::ivec3(int(from), y, z));
        most = glm::max(most, glm::ivec3(int(to) - 1, y, z));
    });
    return {.minimum = glm::max(least - margin, glm::ivec3(0)),
        .maximum = glm::min(most + 1 + margin, size)};
}

/// The columns of voxels, by row, in the box of all rows that have any and of their neighbours.
class RowsOfBox {
public:
    /// @param voxels not empty
    RowsOfBox(const VoxelRuns& voxels, const glm::ivec3& size)
        : m_box(boxAround(voxels, size, 1))
        , m_rows(std::size_t(m_box.maximum.y - m_box.minimum.y)
              * std::size_t(m_box.maximum.z - m_box.minimum.z))
    {
        forEachRowPiece(voxels, size, [&](std::uint64_t row, std::uint64_t from, std::uint64_t to) {
            const auto rowsOfSlice = std::uint64_t(size.y);
            m_rows[placeOf(int(row % rowsOfSlice), int(row / rowsOfSlice))].emplace_back(from, to);
        });
    }

    [[nodiscard]] const VoxelBox& box() const { return m_box; }
    /// @pre the row lies in the box
    [[nodiscard]] const Columns& at(int y, int z) const { return m_rows[placeOf(y, z)]; }

private:
    [[nodiscard]] std::size_t placeOf(int y, int z) const
    {
        return std::size_t(z - m_box.minimum.z) * std::size_t(m_box.maximum.y - m_box.minimum.y)
            + std::size_t(y - m_box.minimum.y);
    }

    VoxelBox m_box;
    std::vector<Columns> m_rows;
};

/// The voxels around what a surface was moved over, a byte each.
class MovedBox {
public:
    MovedBox(const VoxelRuns& moved, const VoxelRuns& inside,
        const std::vector<std::uint8_t>& labels, const glm::ivec3& size, std::uint8_t label)
        : m_size(size)
        , m_box(boxAround(moved, size, writeBackRimVoxels))
        , m_extent(m_box.maximum - m_box.minimum)
        , m_cells(std::size_t(m_extent.x) * std::size_t(m_extent.y) * std::size_t(m_extent.z), 0)
    {
        forEachCell([&](const glm::ivec3& voxel, std::uint8_t& cell) {
            const std::size_t place =
                (std::size_t(voxel.z) * std::size_t(size.y) + std::size_t(voxel.y))
                    * std::size_t(size.x)
                + std::size_t(voxel.x);
            cell = labels[place] == label ? Held : 0;
        });
        mark(inside, Inside, nullptr);
        std::vector<glm::ivec3> reached;
        mark(moved, Taken, &reached);
        for (int step = 0; step < writeBackRimVoxels; ++step)
            reached = spreadFrom(reached);
    }

    /// Calls visit(voxel, is it inside) where the mask has to change.
    template <typename Visit> void forEachChange(const Visit& visit)
    {
        forEachCell([&visit](const glm::ivec3& voxel, std::uint8_t cell) {
            if ((cell & Taken) != 0 && isOff(cell))
                visit(voxel, (cell & Inside) != 0);
        });
    }

private:
    enum Flag : std::uint8_t { Held = 1, Inside = 2, Taken = 4 };

    [[nodiscard]] static bool isOff(std::uint8_t cell)
    {
        return ((cell & Held) != 0) != ((cell & Inside) != 0);
    }
    [[nodiscard]] std::uint8_t& cellAt(const glm::ivec3& voxel)
    {
        const glm::ivec3 at = voxel - m_box.minimum;
        return m_cells[(std::size_t(at.z) * std::size_t(m_extent.y) + std::size_t(at.y))
                * std::size_t(m_extent.x)
            + std::size_t(at.x)];
    }
    template <typename Visit> void forEachCell(const Visit& visit)
    {
        std::size_t at = 0;
        for (int z = m_box.minimum.z; z < m_box.maximum.z; ++z)
            for (int y = m_box.minimum.y; y < m_box.maximum.y; ++y)
                for (int x = m_box.minimum.x; x < m_box.maximum.x; ++x)
                    visit(glm::ivec3(x, y, z), m_cells[at++]);
    }
    /// @param marked gets the voxels; may be null
    void mark(const VoxelRuns& voxels, Flag flag, std::vector<glm::ivec3>* marked)
    {
        forEachRowPiece(
            voxels, m_size, [&](std::uint64_t row, std::uint64_t from, std::uint64_t to) {
                const int y = int(row % std::uint64_t(m_size.y));
                const int z = int(row / std::uint64_t(m_size.y));
                if (y < m_box.minimum.y || y >= m_box.maximum.y || z < m_box.minimum.z
                    || z >= m_box.maximum.z)
                    return;
                const int end = std::min(int(to), m_box.maximum.x);
                for (int x = std::max(int(from), m_box.minimum.x); x < end; ++x) {
                    cellAt({x, y, z}) |= flag;
                    if (marked)
                        marked->emplace_back(x, y, z);
                }
            });
    }
    /// Takes what is off beside what was taken last, to the same side. @return what it took
    [[nodiscard]] std::vector<glm::ivec3> spreadFrom(const std::vector<glm::ivec3>& reached)
    {
        std::vector<glm::ivec3> taken;
        for (const glm::ivec3& voxel : reached) {
            const std::uint8_t side = cellAt(voxel) & Inside;
            const glm::ivec3 first = glm::max(voxel - 1, m_box.minimum);
            const glm::ivec3 end = glm::min(voxel + 2, m_box.maximum);
            for (int z = first.z; z < end.z; ++z) {
                for (int y = first.y; y < end.y; ++y) {
                    for (int x = first.x; x < end.x; ++x) {
                        std::uint8_t& cell = cellAt({x, y, z});
                        if ((cell & Taken) != 0 || !isOff(cell) || (cell & Inside) != side)
                            continue;
                        cell |= Taken;
                        taken.emplace_back(x, y, z);
                    }
                }
            }
        }
        return taken;
    }

    glm::ivec3 m_size;
    VoxelBox m_box;
    glm::ivec3 m_extent;
    std::vector<std::uint8_t> m_cells;
};

} // namespace

RelabelListed writeBackOf(const EnclosedVoxels& enclosed, const std::vector<std::uint8_t>& labels,
    const glm::ivec3& size, const LabelTarget& target)
{
    const BrickGrid grid{size};
    std::map<std::uint32_t, std::vector<std::uint8_t>> bricks;
    const auto ask = [&](const glm::ivec3& voxel, std::uint8_t what) {
        std::vector<std::uint8_t>& asked = bricks[std::uint32_t(grid.brickOf(voxel))];
        asked.resize(BrickGrid::voxelsPerBrick, 0);
        asked[std::size_t(BrickGrid::offsetInBrick(voxel))] = what;
    };
    const VoxelRuns moved = differing(enclosed.now, enclosed.agreed);
    if (!moved.empty())
        MovedBox(moved, enclosed.now, labels, size, target.label)
            .forEachChange([&ask](const glm::ivec3& voxel, bool isInside) {
                ask(voxel, isInside ? RelabelListed::give : RelabelListed::take);
            });
    if (target.overwritable.any()) {
        const VoxelRuns gained = common(enclosed.now, differing(enclosed.now, enclosed.laid));
        for (const VoxelRun& run : gained.runs()) {
            for (std::uint64_t at = run.first; at < run.first + run.count; ++at) {
                if (labels[std::size_t(at)] != 0 && labels[std::size_t(at)] != target.label)
                    ask(voxelAt(at, size), RelabelListed::give);
            }
        }
    }
    RelabelListed edit{.target = target, .bricks = {}};
    for (auto& [brick, asked] : bricks)
        edit.bricks.push_back({.brick = brick, .asked = std::move(asked)});
    return edit;
}

VoxelRuns shellAround(const VoxelRuns& inside, const glm::ivec3& size)
{
    VoxelRuns shell;
    if (inside.empty())
        return shell;
    const RowsOfBox rows(inside, size);
    const VoxelBox& box = rows.box();
    const auto width = std::uint64_t(size.x);
    for (int z = box.minimum.z; z < box.maximum.z; ++z) {
        for (int y = box.minimum.y; y < box.maximum.y; ++y) {
            Columns near;
            for (int k = std::max(z - 1, box.minimum.z); k < std::min(z + 2, box.maximum.z); ++k) {
                for (int j = std::max(y - 1, box.minimum.y); j < std::min(y + 2, box.maximum.y);
                     ++j) {
                    for (const auto& [from, to] : rows.at(j, k))
                        near.emplace_back(from == 0 ? 0 : from - 1, std::min(to + 1, width));
                }
            }
            const std::size_t row = std::size_t(z) * std::size_t(size.y) + std::size_t(y);
            const auto appendOutside = [&](std::uint64_t from, std::uint64_t to) {
                if (from < to)
                    shell.append(row * width + from, to - from);
            };
            // What is inside in this row lies wholly within what is near.
            const Columns& held = rows.at(y, z);
            auto hole = held.begin();
            for (const auto& [from, to] : joined(std::move(near))) {
                std::uint64_t next = from;
                for (; hole != held.end() && hole->second <= to; ++hole) {
                    appendOutside(next, hole->first);
                    next = hole->second;
                }
                appendOutside(next, to);
            }
        }
    }
    return shell;
}

std::vector<BarrierListed::Brick> placesOf(const VoxelRuns& voxels, const glm::ivec3& size)
{
    const BrickGrid grid{size};
    std::map<std::uint32_t, std::bitset<BrickGrid::voxelsPerBrick>> bricks;
    for (const VoxelRun& run : voxels.runs()) {
        for (std::uint64_t at = run.first; at < run.first + run.count; ++at) {
            const glm::ivec3 voxel = voxelAt(at, size);
            bricks[std::uint32_t(grid.brickOf(voxel))].set(
                std::size_t(BrickGrid::offsetInBrick(voxel)));
        }
    }
    std::vector<BarrierListed::Brick> listed;
    for (const auto& [brick, places] : bricks)
        listed.push_back({.brick = brick, .places = places});
    return listed;
}

} // namespace core
