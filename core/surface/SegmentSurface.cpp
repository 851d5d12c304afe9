// SPDX-License-Identifier: Apache-2.0
#include "core/surface/SegmentSurface.h"

#include "core/surface/CornerFans.h"

#include <algorithm>
#include <array>
#include <unordered_map>

namespace core {

namespace {

/// Rounds of smoothing, each a step inwards and a slightly longer one outwards (Taubin 1995), so
/// that the whole does not shrink.
constexpr int rounds = 12;
constexpr float inwards = 0.5F;
constexpr float outwards = -0.53F;

/// The faces between voxels as polygons, before they are smoothed.
struct Borders {
    std::vector<glm::vec3> vertices;
    std::vector<std::array<std::uint32_t, 4>> quads;
    std::vector<std::vector<std::uint32_t>> others; ///< with points amid their edges
};

struct Box {
    glm::ivec3 first{0};
    glm::ivec3 size{0}; ///< 0: there is no voxel
};

Box boxOf(std::span<const std::uint8_t> labels, std::uint8_t label, const glm::ivec3& size)
{
    glm::ivec3 least = size;
    glm::ivec3 most(-1);
    std::size_t i = 0;
    for (int z = 0; z < size.z; ++z) {
        for (int y = 0; y < size.y; ++y) {
            for (int x = 0; x < size.x; ++x, ++i) {
                if (labels[i] != label)
                    continue;
                least = glm::min(least, glm::ivec3(x, y, z));
                most = glm::max(most, glm::ivec3(x, y, z));
            }
        }
    }
    return most.x < 0 ? Box{} : Box{.first = least, .size = most - least + 1};
}

/// Walks the box plane by plane; coordinates within are of the box.
class BorderWalk {
public:
    BorderWalk(std::span<const std::uint8_t> labels, std::uint8_t label, const glm::ivec3& size,
        const Box& box)
        : m_labels(labels)
        , m_label(label)
        , m_size(size)
        , m_box(box)
    {
    }

    Borders walk()
    {
        const std::size_t corners = cornerAt({m_box.size.x, m_box.size.y, 0}) + 1;
        for (Plane& plane : m_planes) {
            plane.first.resize(corners);
            plane.configuration.resize(corners);
        }
        for (int z = 0; z <= m_box.size.z; ++z) {
            makeCorners(z);
            makeFaces(z);
        }
        return std::move(m_made);
    }

private:
    /// The corners between two slices.
    struct Plane {
        std::vector<std::uint32_t> first; ///< of each corner's vertices
        std::vector<std::uint8_t> configuration;
    };

    [[nodiscard]] bool inside(const glm::ivec3& voxel) const
    {
        if (glm::any(glm::lessThan(voxel, glm::ivec3(0)))
            || glm::any(glm::greaterThanEqual(voxel, m_box.size)))
            return false;
        const glm::ivec3 at = m_box.first + voxel;
        const std::size_t row = std::size_t(at.z) * std::size_t(m_size.y) + std::size_t(at.y);
        return m_labels[row * std::size_t(m_size.x) + std::size_t(at.x)] == m_label;
    }
    [[nodiscard]] std::size_t cornerAt(const glm::ivec3& corner) const
    {
        return std::size_t(corner.y) * std::size_t(m_box.size.x + 1) + std::size_t(corner.x);
    }
    [[nodiscard]] const Plane& plane(int z) const { return m_planes[std::size_t(z % 2)]; }
    [[nodiscard]] glm::vec3 place(const glm::ivec3& corner) const
    {
        return glm::vec3(m_box.first + corner) - 0.5F;
    }

    void makeCorners(int z)
    {
        Plane& made = m_planes[std::size_t(z % 2)];
        for (int y = 0; y <= m_box.size.y; ++y) {
            // Voxels move from beyond the corner to before it as the corner moves along x.
            int configuration = 0;
            for (int x = 0; x <= m_box.size.x; ++x) {
                configuration = (configuration >> 1) & 0x55;
                for (int other = 0; other < 4; ++other) {
                    const glm::ivec3 voxel(x, y - 1 + (other & 1), z - 1 + (other >> 1));
                    if (inside(voxel))
                        configuration |= 2 << (2 * other);
                }
                const std::size_t at = cornerAt({x, y, z});
                made.configuration[at] = std::uint8_t(configuration);
                made.first[at] = std::uint32_t(m_made.vertices.size());
                const int count = cornerFans(std::uint8_t(configuration)).count;
                for (int fan = 0; fan < count; ++fan)
                    m_made.vertices.push_back(place({x, y, z}));
            }
        }
    }

    /// Those across z at this plane, and those of the slice before it.
    void makeFaces(int z)
    {
        for (int y = 0; y <= m_box.size.y; ++y) {
            for (int x = 0; x <= m_box.size.x; ++x) {
                const int here = plane(z).configuration[cornerAt({x, y, z})];
                // Bits of the voxels beyond the corner along x and y, before and beyond along z.
                if (((here >> 3) & 1) != ((here >> 7) & 1))
                    makeFace(2, {x, y, z - 1}, ((here >> 3) & 1) != 0);
                if (z == 0)
                    continue;
                if (((here >> 2) & 1) != ((here >> 3) & 1))
                    makeFace(0, {x - 1, y, z - 1}, ((here >> 2) & 1) != 0);
                if (((here >> 1) & 1) != ((here >> 3) & 1))
                    makeFace(1, {x, y - 1, z - 1}, ((here >> 1) & 1) != 0);
            }
        }
    }

    /// The face between @p before and the voxel that follows it along @p axis.
    void makeFace(int axis, const glm::ivec3& before, bool beforeIsInside)
    {
        const int b = (axis + 1) % 3;
        const int c = (axis + 2) % 3;
        glm::ivec3 beyond = before;
        ++beyond[axis];
        const glm::ivec3 solid = beforeIsInside ? before : beyond;
        std::array<glm::ivec3, 4> corners{beyond, beyond, beyond, beyond};
        ++corners[1][b];
        ++corners[2][b];
        ++corners[2][c];
        ++corners[3][c];
        std::array<std::uint32_t, 4> vertices{};
        for (std::size_t i = 0; i < 4; ++i) {
            const glm::ivec3& corner = corners[i];
            const std::size_t at = cornerAt(corner);
            const int face =
                cornerFace(axis, corner[b] == before[b] ? 1 : 0, corner[c] == before[c] ? 1 : 0);
            const CornerFans& fans = cornerFans(plane(corner.z).configuration[at]);
            vertices[i] = plane(corner.z).first[at] + fans.fanOf[std::size_t(face)];
        }
        if (!beforeIsInside) {
            std::swap(vertices[1], vertices[3]);
            std::swap(corners[1], corners[3]);
        }
        std::vector<std::uint32_t> polygon;
        bool isQuad = true;
        for (std::size_t i = 0; i < 4; ++i) {
            polygon.push_back(vertices[i]);
            const glm::ivec3 lower = glm::min(corners[i], corners[(i + 1) % 4]);
            const glm::ivec3 along = glm::abs(corners[(i + 1) % 4] - corners[i]);
            const int edge = along.x != 0 ? 0 : along.y != 0 ? 1 : 2;
            const CornerFans& fans = cornerFans(plane(lower.z).configuration[cornerAt(lower)]);
            if ((fans.crossed & (2U << unsigned(2 * edge))) == 0)
                continue;
            polygon.push_back(middleOf(lower, edge, solid));
            isQuad = false;
        }
        if (isQuad)
            m_made.quads.push_back(vertices);
        else
            m_made.others.push_back(std::move(polygon));
    }

    /// Four faces meet at this edge: the two of each voxel get a point of their own amid it, or
    /// their edge could be that of the other two.
    std::uint32_t middleOf(const glm::ivec3& lower, int edge, const glm::ivec3& solid)
    {
        const int b = (edge + 1) % 3;
        const int c = (edge + 2) % 3;
        std::uint64_t key = std::uint64_t(lower.z) * std::uint64_t(m_box.size.y + 1);
        key = (key + std::uint64_t(lower.y)) * std::uint64_t(m_box.size.x + 1);
        key = (key + std::uint64_t(lower.x)) * 12 + std::uint64_t(edge) * 4;
        key += (solid[b] == lower[b] ? 1U : 0U) + (solid[c] == lower[c] ? 2U : 0U);
        const auto [found, isNew] =
            m_middles.try_emplace(key, std::uint32_t(m_made.vertices.size()));
        if (isNew) {
            glm::vec3 middle = place(lower);
            middle[edge] += 0.5F;
            m_made.vertices.push_back(middle);
        }
        return found->second;
    }

    std::span<const std::uint8_t> m_labels;
    std::uint8_t m_label;
    glm::ivec3 m_size;
    Box m_box;
    std::array<Plane, 2> m_planes;
    std::unordered_map<std::uint64_t, std::uint32_t> m_middles;
    Borders m_made;
};

/// Moves every vertex towards the mean of its neighbours by a share, never too far from where the
/// border is.
void shift(std::vector<glm::vec3>& vertices, const std::vector<glm::vec3>& border,
    const Borders& borders, float share)
{
    std::vector<glm::vec4> sums(vertices.size(), glm::vec4(0.0F));
    // Around the faces each edge occurs once in each direction: each vertex meets its neighbours
    // once.
    for (const auto& quad : borders.quads) {
        for (std::size_t i = 0; i < 4; ++i)
            sums[quad[i]] += glm::vec4(vertices[quad[(i + 1) % 4]], 1.0F);
    }
    for (const auto& polygon : borders.others) {
        for (std::size_t i = 0; i < polygon.size(); ++i)
            sums[polygon[i]] += glm::vec4(vertices[polygon[(i + 1) % polygon.size()]], 1.0F);
    }
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        const glm::vec3 mean = glm::vec3(sums[i]) / sums[i].w;
        const glm::vec3 moved = vertices[i] + share * (mean - vertices[i]);
        vertices[i] =
            glm::clamp(moved, border[i] - greatestSurfaceShift, border[i] + greatestSurfaceShift);
    }
}

std::vector<glm::uvec3> trianglesOf(const Borders& borders, const std::vector<glm::vec3>& vertices)
{
    std::vector<glm::uvec3> triangles;
    triangles.reserve(2 * borders.quads.size() + 4 * borders.others.size());
    const auto apart = [&](std::uint32_t a, std::uint32_t b) {
        const glm::vec3 between = vertices[a] - vertices[b];
        return glm::dot(between, between);
    };
    for (const auto& [a, b, c, d] : borders.quads) {
        if (apart(a, c) <= apart(b, d)) {
            triangles.emplace_back(a, b, c);
            triangles.emplace_back(a, c, d);
        } else {
            triangles.emplace_back(b, c, d);
            triangles.emplace_back(b, d, a);
        }
    }
    for (const auto& polygon : borders.others) {
        // From a point amid an edge, which is the second behind the corner before it.
        const std::size_t count = polygon.size();
        std::size_t middle = 0;
        const auto isMiddle = [&](std::size_t i) {
            const glm::vec3 fraction = borders.vertices[polygon[i]] - 0.5F;
            return fraction != glm::floor(fraction);
        };
        while (!isMiddle(middle))
            ++middle;
        for (std::size_t i = 1; i + 1 < count; ++i)
            triangles.emplace_back(
                polygon[middle], polygon[(middle + i) % count], polygon[(middle + i + 1) % count]);
    }
    return triangles;
}

} // namespace

SegmentSurface segmentSurface(
    std::span<const std::uint8_t> labels, std::uint8_t label, const glm::ivec3& size)
{
    const Box box = boxOf(labels, label, size);
    if (box.size.x == 0)
        return {};
    const Borders borders = BorderWalk(labels, label, size, box).walk();
    SegmentSurface surface;
    surface.vertices = borders.vertices;
    for (int round = 0; round < rounds; ++round) {
        shift(surface.vertices, borders.vertices, borders, inwards);
        shift(surface.vertices, borders.vertices, borders, outwards);
    }
    surface.triangles = trianglesOf(borders, surface.vertices);
    return surface;
}

SegmentSurface segmentBorders(
    std::span<const std::uint8_t> labels, std::uint8_t label, const glm::ivec3& size)
{
    const Box box = boxOf(labels, label, size);
    if (box.size.x == 0)
        return {};
    Borders borders = BorderWalk(labels, label, size, box).walk();
    std::vector<glm::uvec3> triangles = trianglesOf(borders, borders.vertices);
    return {.vertices = std::move(borders.vertices), .triangles = std::move(triangles)};
}

} // namespace core
