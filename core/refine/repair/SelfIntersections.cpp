// SPDX-License-Identifier: Apache-2.0
#include "core/refine/repair/SelfIntersections.h"

#include "core/refine/mesh/SimplexDual.h"
#include "core/refine/repair/TriangleCrossing.h"
#include "core/refine/voxels/SurfaceVoxels.h"

#include <algorithm>

namespace core {

namespace {

class TriangleGrid {
public:
    TriangleGrid(const SimplexMesh& mesh, const VolumeGeometry& geometry)
        : m_surface(onLattice(mesh, geometry))
        , m_faces(trianglesOf(mesh).faces)
    {
        const std::size_t count = m_surface.triangles.size();
        m_lows.reserve(count);
        m_highs.reserve(count);
        std::int64_t extent = 0;
        std::int64_t greatest = 0;
        for (const glm::uvec3& triangle : m_surface.triangles) {
            const auto& points = m_surface.vertices;
            m_lows.push_back(
                glm::min(glm::min(points[triangle.x], points[triangle.y]), points[triangle.z]));
            m_highs.push_back(
                glm::max(glm::max(points[triangle.x], points[triangle.y]), points[triangle.z]));
            const glm::ivec3 size = m_highs.back() - m_lows.back();
            const std::int64_t longest = std::max({size.x, size.y, size.z});
            extent += longest;
            greatest = std::max(greatest, longest);
        }
        // Half as wide again as a triangle; a huge one is not to fill the grid.
        constexpr std::int64_t least = 1024;
        constexpr std::int64_t mostCells = 64;
        const std::int64_t mean = extent / std::max<std::int64_t>(std::int64_t(count), 1);
        m_cell = std::int32_t(std::max({least, mean + mean / 2, greatest / mostCells}));
        for (std::size_t i = 0; i < count; ++i)
            enter(std::uint32_t(i));
        std::sort(m_entries.begin(), m_entries.end());
    }

    [[nodiscard]] std::vector<CrossingFaces> crossings() const
    {
        return collectCrossings(m_entries.size(),
            [this](std::size_t from, std::size_t to, std::vector<CrossingFaces>& found) {
                std::size_t begin = cellBegin(from);
                const std::size_t last = cellBegin(to);
                while (begin < last) {
                    std::size_t end = begin + 1;
                    while (end < m_entries.size() && m_entries[end].cell == m_entries[begin].cell)
                        ++end;
                    lookThrough(begin, end, found);
                    begin = end;
                }
            });
    }

private:
    struct Entry {
        std::uint64_t cell = 0;
        std::uint32_t triangle = 0;
        bool operator<(const Entry& other) const
        {
            return cell != other.cell ? cell < other.cell : triangle < other.triangle;
        }
    };

    [[nodiscard]] glm::ivec3 cellOf(const glm::ivec3& point) const
    {
        // What lies below 0 counts from there on, too.
        constexpr std::int32_t bias = 1 << 29;
        return (point + bias) / m_cell;
    }
    [[nodiscard]] static std::uint64_t keyOf(const glm::ivec3& cell)
    {
        return (std::uint64_t(cell.z) << 42U) | (std::uint64_t(cell.y) << 21U)
            | std::uint64_t(cell.x);
    }
    void enter(std::uint32_t triangle)
    {
        const glm::ivec3 low = cellOf(m_lows[triangle]);
        const glm::ivec3 high = cellOf(m_highs[triangle]);
        for (int z = low.z; z <= high.z; ++z) {
            for (int y = low.y; y <= high.y; ++y) {
                for (int x = low.x; x <= high.x; ++x)
                    m_entries.push_back({.cell = keyOf({x, y, z}), .triangle = triangle});
            }
        }
    }
    /// The first entry of a cell at or behind a place in the list.
    [[nodiscard]] std::size_t cellBegin(std::size_t at) const
    {
        while (at > 0 && at < m_entries.size() && m_entries[at].cell == m_entries[at - 1].cell)
            ++at;
        return at;
    }
    void lookThrough(std::size_t begin, std::size_t end, std::vector<CrossingFaces>& found) const
    {
        for (std::size_t i = begin; i < end; ++i) {
            for (std::size_t j = i + 1; j < end; ++j) {
                const std::uint32_t a = m_entries[i].triangle;
                const std::uint32_t b = m_entries[j].triangle;
                if (glm::any(glm::greaterThan(m_lows[a], m_highs[b]))
                    || glm::any(glm::greaterThan(m_lows[b], m_highs[a])))
                    continue;
                // In the first cell that has both.
                if (keyOf(cellOf(glm::max(m_lows[a], m_lows[b]))) != m_entries[begin].cell
                    || !passThroughEachOther(triangleAt(a), triangleAt(b)))
                    continue;
                const auto [one, other] = std::minmax(m_faces[a], m_faces[b]);
                found.push_back({.one = one, .other = other});
            }
        }
    }
    [[nodiscard]] LatticeTriangle triangleAt(std::uint32_t triangle) const
    {
        const glm::uvec3& at = m_surface.triangles[triangle];
        return {LatticeCorner{at.x, m_surface.vertices[at.x]},
            LatticeCorner{at.y, m_surface.vertices[at.y]},
            LatticeCorner{at.z, m_surface.vertices[at.z]}};
    }

    LatticeSurface m_surface;
    std::vector<FaceId> m_faces; ///< of each triangle
    std::vector<glm::ivec3> m_lows;
    std::vector<glm::ivec3> m_highs;
    std::int32_t m_cell = 1;
    std::vector<Entry> m_entries;
};

} // namespace

std::vector<CrossingFaces> selfIntersections(
    const SimplexMesh& mesh, const VolumeGeometry& geometry)
{
    return TriangleGrid(mesh, geometry).crossings();
}

} // namespace core
