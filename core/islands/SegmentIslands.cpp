// SPDX-License-Identifier: Apache-2.0
#include "core/islands/SegmentIslands.h"

#include "core/brick/LabelBox.h"

#include <algorithm>
#include <optional>

namespace core {

namespace {

/// Voxels of one row that hang together: columns [begin, end).
struct Run {
    int begin = 0;
    int end = 0;
};

/// All runs of a box's rows, and which of them hang together.
class Parts {
public:
    /// @param touch by how many columns runs of neighbouring rows may miss each other and still
    /// touch: 1 with 26 neighbours, 0 with 6
    Parts(const glm::ivec3& size, int touch)
        : m_size(size)
        , m_touch(touch)
        , m_firstOfRow(std::size_t(size.y) * std::size_t(size.z) + 1, 0)
    {
    }

    /// Rows in the order of memory.
    void beginRow(std::size_t row) { m_firstOfRow[row] = m_runs.size(); }
    void add(int begin, int end)
    {
        m_runs.push_back({begin, end});
        m_parent.push_back(std::uint32_t(m_parent.size()));
    }
    void endRows() { m_firstOfRow.back() = m_runs.size(); }

    /// Joins the runs of each row with those of its neighbours before it.
    /// @return false: cancelled
    bool join(const Progress& progress)
    {
        for (int z = 0; z < m_size.z; ++z) {
            if (progress.cancelled())
                return false;
            for (int y = 0; y < m_size.y; ++y) {
                const std::size_t row = rowAt(y, z);
                if (y > 0)
                    joinRows(row, rowAt(y - 1, z));
                if (z == 0)
                    continue;
                joinRows(row, rowAt(y, z - 1));
                if (m_touch > 0 && y > 0)
                    joinRows(row, rowAt(y - 1, z - 1));
                if (m_touch > 0 && y + 1 < m_size.y)
                    joinRows(row, rowAt(y + 1, z - 1));
            }
        }
        return true;
    }

    [[nodiscard]] std::size_t count() const { return m_runs.size(); }
    [[nodiscard]] const Run& run(std::size_t at) const { return m_runs[at]; }
    /// The part of a run: the number of its first run in memory.
    [[nodiscard]] std::uint32_t partOf(std::size_t run)
    {
        auto root = std::uint32_t(run);
        while (m_parent[root] != root) {
            m_parent[root] = m_parent[m_parent[root]];
            root = m_parent[root];
        }
        return root;
    }
    /// The part that holds a voxel; none if no run does.
    [[nodiscard]] std::optional<std::uint32_t> partAt(const glm::ivec3& voxel)
    {
        const std::size_t row = rowAt(voxel.y, voxel.z);
        for (std::size_t at = m_firstOfRow[row]; at < m_firstOfRow[row + 1]; ++at) {
            if (m_runs[at].begin <= voxel.x && voxel.x < m_runs[at].end)
                return partOf(at);
        }
        return std::nullopt;
    }
    /// Calls @p visit(run, y, z) for all of them in the order of memory.
    template <class Visit> void forEach(const Visit& visit)
    {
        for (int z = 0; z < m_size.z; ++z) {
            for (int y = 0; y < m_size.y; ++y) {
                const std::size_t row = rowAt(y, z);
                for (std::size_t at = m_firstOfRow[row]; at < m_firstOfRow[row + 1]; ++at)
                    visit(at, y, z);
            }
        }
    }

private:
    [[nodiscard]] std::size_t rowAt(int y, int z) const
    {
        return std::size_t(z) * std::size_t(m_size.y) + std::size_t(y);
    }
    void joinRows(std::size_t row, std::size_t other)
    {
        std::size_t one = m_firstOfRow[row];
        std::size_t two = m_firstOfRow[other];
        while (one < m_firstOfRow[row + 1] && two < m_firstOfRow[other + 1]) {
            const bool touches = m_runs[one].begin < m_runs[two].end + m_touch
                && m_runs[two].begin < m_runs[one].end + m_touch;
            if (touches)
                joinRuns(one, two);
            if (m_runs[one].end < m_runs[two].end)
                ++one;
            else
                ++two;
        }
    }
    /// The smaller number stays, so that a part is called after its first run.
    void joinRuns(std::size_t one, std::size_t two)
    {
        const std::uint32_t first = partOf(one);
        const std::uint32_t second = partOf(two);
        m_parent[std::max(first, second)] = std::min(first, second);
    }

    glm::ivec3 m_size;
    int m_touch;
    std::vector<std::size_t> m_firstOfRow; ///< and the end of the last one
    std::vector<Run> m_runs;
    std::vector<std::uint32_t> m_parent;
};

/// The runs of voxels in a box that are the label's, or those that are not.
Parts partsIn(const VoxelBox& box, std::span<const std::uint8_t> labels, const glm::ivec3& size,
    std::uint8_t label, bool own)
{
    const glm::ivec3 boxSize = box.maximum - box.minimum;
    Parts parts(boxSize, own ? 1 : 0);
    for (int z = box.minimum.z; z < box.maximum.z; ++z) {
        for (int y = box.minimum.y; y < box.maximum.y; ++y) {
            const auto* row = &labels[(std::size_t(z) * std::size_t(size.y) + std::size_t(y))
                * std::size_t(size.x)];
            parts.beginRow(std::size_t(z - box.minimum.z) * std::size_t(boxSize.y)
                + std::size_t(y - box.minimum.y));
            for (int x = box.minimum.x; x < box.maximum.x;) {
                const bool isOwn = row[x] == label;
                int end = x + 1;
                while (end < box.maximum.x && (row[end] == label) == isOwn)
                    ++end;
                if (isOwn == own)
                    parts.add(x - box.minimum.x, end - box.minimum.x);
                x = end;
            }
        }
    }
    parts.endRows();
    return parts;
}

/// Of each part, by its first run; 0 for numbers that are none.
std::vector<std::int64_t> sizesOf(Parts& parts)
{
    std::vector<std::int64_t> sizes(parts.count(), 0);
    for (std::size_t at = 0; at < parts.count(); ++at)
        sizes[parts.partOf(at)] += parts.run(at).end - parts.run(at).begin;
    return sizes;
}

/// Of an index in memory, x fastest.
glm::ivec3 voxelAt(std::size_t index, const glm::ivec3& size)
{
    const auto columns = std::size_t(size.x);
    const auto rows = std::size_t(size.y);
    return {int(index % columns), int(index / columns % rows), int(index / columns / rows)};
}

/// Parts of the background that reach the box's border lead out of the segment: no voxel beyond
/// the box is the segment's.
void dropOpen(Parts& parts, const glm::ivec3& size, std::vector<std::int64_t>& sizes)
{
    std::vector<std::uint32_t> open;
    parts.forEach([&](std::size_t at, int y, int z) {
        const Run& run = parts.run(at);
        const bool atBorder = run.begin == 0 || run.end == size.x || y == 0 || y + 1 == size.y
            || z == 0 || z + 1 == size.z;
        if (atBorder)
            open.push_back(parts.partOf(at));
    });
    for (const std::uint32_t part : open)
        sizes[part] = 0;
}

} // namespace

Result<IslandChange> islandChange(std::span<const std::uint8_t> labels, const glm::ivec3& size,
    std::uint8_t label, IslandRule rule, std::int64_t voxels, const Progress& progress,
    std::size_t clicked)
{
    if (isOfClicked(rule) && (clicked >= labels.size() || labels[clicked] != label))
        return IslandChange();
    const VoxelBox box = boxOfLabel(labels, size, label);
    if (box.empty())
        return IslandChange();
    const bool holes = rule == IslandRule::FillHoles;
    Parts parts = partsIn(box, labels, size, label, !holes);
    if (!parts.join(progress))
        return failure(ErrorCode::Cancelled);
    std::vector<std::int64_t> sizes = sizesOf(parts);
    if (holes)
        dropOpen(parts, box.maximum - box.minimum, sizes);
    const auto largest = std::max_element(sizes.begin(), sizes.end()) - sizes.begin();
    std::optional<std::uint32_t> clickedPart;
    if (isOfClicked(rule))
        clickedPart = parts.partAt(voxelAt(clicked, size) - box.minimum);
    const auto isMeant = [&](std::uint32_t part) {
        switch (rule) {
        case IslandRule::FillHoles:
            return sizes[part] > 0 && sizes[part] <= voxels;
        case IslandRule::KeepLargest:
            return std::ptrdiff_t(part) != largest;
        case IslandRule::RemoveSmall:
            return sizes[part] < voxels;
        case IslandRule::KeepClicked:
            return part != clickedPart;
        case IslandRule::RemoveClicked:
        case IslandRule::GiveClicked:
            return part == clickedPart;
        }
        return false;
    };
    IslandChange change;
    parts.forEach([&](std::size_t at, int y, int z) {
        const std::uint32_t part = parts.partOf(at);
        if (!isMeant(part))
            return;
        change.parts += part == at ? 1 : 0;
        const Run& run = parts.run(at);
        const std::uint64_t row = (std::uint64_t(box.minimum.z + z) * std::uint64_t(size.y)
                                      + std::uint64_t(box.minimum.y + y))
            * std::uint64_t(size.x);
        change.voxels.append(
            row + std::uint64_t(box.minimum.x + run.begin), std::uint64_t(run.end - run.begin));
    });
    return change;
}

} // namespace core
