// SPDX-License-Identifier: Apache-2.0
#include "core/refine/voxels/SurfaceFill.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace core {

namespace {

__extension__ using Wide = __int128;

constexpr std::int64_t one = std::int64_t(1) << LatticeSurface::bits;

std::int64_t ceilQuotient(std::int64_t number, std::int64_t by)
{
    return number >= 0 ? (number + by - 1) / by : -(-number / by);
}

std::int64_t floorQuotient(std::int64_t number, std::int64_t by)
{
    return -ceilQuotient(-number, by);
}

std::uint64_t mixed(std::uint64_t value)
{
    // splitmix64 (Steele, Lea and Flood 2014)
    value += 0x9E3779B97F4A7C15U;
    value = (value ^ (value >> 30U)) * 0xBF58476D1CE4E5B9U;
    value = (value ^ (value >> 27U)) * 0x94D049BB133111EBU;
    return value ^ (value >> 31U);
}

/// A row's ray goes in (1) or out (−1) before the centre of voxel x.
struct Crossing {
    std::uint64_t row = 0; ///< slice · rows + row
    int x = 0;
    int sign = 0;
};

/// A triangle seen along the rows, turned so that its corners run around it to the left.
class RowTriangle {
public:
    RowTriangle(const glm::ivec3& a, const glm::ivec3& b, const glm::ivec3& c)
        : m_corners{glm::i64vec3(a), glm::i64vec3(b), glm::i64vec3(c)}
        , m_area(side(0, m_corners[2]))
    {
        if (m_area < 0) {
            std::swap(m_corners[1], m_corners[2]);
            m_area = -m_area;
            m_sign = -1;
        }
    }

    [[nodiscard]] bool isSeen() const { return m_area != 0; }
    [[nodiscard]] int sign() const { return m_sign; }
    /// From the first to the last row and slice with a ray in its bounds, within the volume.
    [[nodiscard]] std::array<glm::i64vec2, 2> bounds(const glm::ivec3& size) const
    {
        std::array<glm::i64vec2, 2> bounds;
        for (int axis = 0; axis < 2; ++axis) {
            const auto [low, high] = std::minmax(
                {m_corners[0][axis + 1], m_corners[1][axis + 1], m_corners[2][axis + 1]});
            bounds[0][axis] = std::max<std::int64_t>(ceilQuotient(low, one), 0);
            bounds[1][axis] = std::min<std::int64_t>(floorQuotient(high, one), size[axis + 1] - 1);
        }
        return bounds;
    }
    /// The first voxel whose centre does not lie before it; false: the ray passes it.
    [[nodiscard]] bool meets(std::int64_t row, std::int64_t slice, std::int64_t& voxel) const
    {
        const glm::i64vec3 ray(0, row * one, slice * one);
        Wide along = 0;
        for (int i = 0; i < 3; ++i) {
            const std::int64_t share = side(i, ray);
            // As if the ray lay beside the centres, a trifle in rows and a trifle of that in
            // slices: edges and corners that lie on it belong to one side throughout.
            const glm::i64vec3 way =
                m_corners[std::size_t((i + 1) % 3)] - m_corners[std::size_t(i)];
            if (share < 0 || (share == 0 && !(way.z < 0 || (way.z == 0 && way.y > 0))))
                return false;
            along += Wide(share) * m_corners[std::size_t((i + 2) % 3)].x;
        }
        const Wide whole = Wide(m_area) * one;
        Wide quotient = along / whole;
        if (quotient * whole < along)
            ++quotient;
        voxel = std::int64_t(quotient);
        return true;
    }

private:
    /// Twice the area between an edge and a point; below 2⁶², since corners are below 2²⁹.
    [[nodiscard]] std::int64_t side(int edge, const glm::i64vec3& point) const
    {
        const glm::i64vec3& from = m_corners[std::size_t(edge)];
        const glm::i64vec3 way = m_corners[std::size_t((edge + 1) % 3)] - from;
        const glm::i64vec3 there = point - from;
        return way.y * there.z - way.z * there.y;
    }

    std::array<glm::i64vec3, 3> m_corners;
    std::int64_t m_area = 0;
    int m_sign = 1;
};

VoxelRuns insideOf(std::vector<Crossing> crossings, SurfaceKind kind, const glm::ivec3& size)
{
    std::sort(crossings.begin(), crossings.end(), [](const Crossing& a, const Crossing& b) {
        return a.row != b.row ? a.row < b.row : a.x < b.x;
    });
    VoxelRuns voxels;
    int around = 0;
    for (std::size_t i = 0; i + 1 < crossings.size(); ++i) {
        const Crossing& here = crossings[i];
        const Crossing& next = crossings[i + 1];
        around = (i > 0 && crossings[i - 1].row != here.row ? 0 : around) + here.sign;
        const bool inside = kind == SurfaceKind::Closed ? around != 0 : around % 2 != 0;
        if (inside && next.row == here.row && next.x > here.x)
            voxels.append(here.row * std::uint64_t(size.x) + std::uint64_t(here.x),
                std::uint64_t(next.x - here.x));
    }
    return voxels;
}

} // namespace

glm::ivec3 latticePoint(const glm::dvec3& index)
{
    constexpr double farthest = 32767.0;
    return glm::ivec3(glm::round(glm::clamp(index, -farthest, farthest) * double(one)));
}

SurfaceKind kindOf(const LatticeSurface& surface)
{
    std::vector<std::uint64_t> numbers;
    numbers.reserve(surface.vertices.size());
    for (const glm::ivec3& vertex : surface.vertices) {
        std::uint64_t number = 0;
        for (int axis = 0; axis < 3; ++axis)
            number = mixed(number ^ std::uint32_t(vertex[axis]));
        numbers.push_back(number);
    }
    // Sums of numbers made of both ends, which only cancel by pairs.
    std::uint64_t sum = 0;
    std::vector<std::uint64_t> edges;
    edges.reserve(3 * surface.triangles.size());
    for (const glm::uvec3& triangle : surface.triangles) {
        for (int i = 0; i < 3; ++i) {
            const std::uint64_t a = numbers[triangle[i]];
            const std::uint64_t b = numbers[triangle[(i + 1) % 3]];
            if (a == b)
                continue;
            const std::uint64_t edge = mixed(mixed(std::min(a, b)) + std::max(a, b));
            sum += a < b ? edge : -edge;
            edges.push_back(edge);
        }
    }
    if (sum == 0)
        return SurfaceKind::Closed;
    std::sort(edges.begin(), edges.end());
    for (std::size_t first = 0; first < edges.size();) {
        std::size_t end = first;
        while (end < edges.size() && edges[end] == edges[first])
            ++end;
        if ((end - first) % 2 != 0)
            return SurfaceKind::Open;
        first = end;
    }
    return SurfaceKind::TwoFaced;
}

Result<VoxelRuns> fillSurface(const LatticeSurface& surface, SurfaceKind kind,
    const glm::ivec3& size, const Progress& progress)
{
    constexpr std::size_t mostCrossings = std::size_t(1) << 27; // 2 GiB
    constexpr std::int64_t mostRays = std::int64_t(1) << 34;
    std::vector<Crossing> crossings;
    std::int64_t rays = 0;
    for (std::size_t i = 0; i < surface.triangles.size(); ++i) {
        if (i % 4096 == 0 && progress.cancelled())
            return failure(ErrorCode::Cancelled);
        const glm::uvec3& corners = surface.triangles[i];
        const RowTriangle triangle(
            surface.vertices[corners.x], surface.vertices[corners.y], surface.vertices[corners.z]);
        if (!triangle.isSeen())
            continue;
        const auto [first, last] = triangle.bounds(size);
        if (first.x > last.x || first.y > last.y)
            continue;
        rays += (last.x - first.x + 1) * (last.y - first.y + 1);
        for (std::int64_t slice = first.y; slice <= last.y; ++slice) {
            for (std::int64_t row = first.x; row <= last.x; ++row) {
                std::int64_t voxel = 0;
                if (triangle.meets(row, slice, voxel))
                    crossings.push_back({.row = std::uint64_t(slice * size.y + row),
                        .x = int(std::clamp<std::int64_t>(voxel, 0, size.x)),
                        .sign = triangle.sign()});
            }
        }
        if (rays > mostRays || crossings.size() > mostCrossings)
            return failure(ErrorCode::OutOfMemory);
    }
    return insideOf(std::move(crossings), kind, size);
}

} // namespace core
