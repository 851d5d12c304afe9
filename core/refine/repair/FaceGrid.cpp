// SPDX-License-Identifier: Apache-2.0
#include "core/refine/repair/FaceGrid.h"

#include "core/base/ParallelFor.h"
#include "core/refine/mesh/SimplexDual.h"
#include "core/refine/voxels/SurfaceFill.h"

#include <algorithm>
#include <bit>

namespace core {

namespace {

constexpr int shares = 16;
/// Fewer faces than this are not worth a thread.
constexpr std::size_t fewFaces = 256;

/// Whether two boxes have no place in common.
template <typename Low>
bool areApart(const Low& lowA, const Low& highA, const Low& lowB, const Low& highB)
{
    return glm::any(glm::greaterThan(lowA, highB)) || glm::any(glm::greaterThan(lowB, highA));
}

glm::ivec3 lowOf(const LatticeTriangle& triangle)
{
    return glm::min(glm::min(triangle[0].place, triangle[1].place), triangle[2].place);
}

glm::ivec3 highOf(const LatticeTriangle& triangle)
{
    return glm::max(glm::max(triangle[0].place, triangle[1].place), triangle[2].place);
}

} // namespace

FaceGrid::FaceGrid(const SimplexMesh& mesh, const VolumeGeometry& geometry)
    : m_mesh(mesh)
    , m_toIndex(geometry)
    , m_points(mesh.vertexSlots())
    , m_middles(mesh.faceSlots())
    , m_boxes(mesh.faceSlots())
{
    const std::vector<FaceId> faces = mesh.faceIds();
    std::int64_t extent = 0;
    std::int64_t greatest = 0;
    for (const FaceId face : faces) {
        measure(face);
        const glm::ivec3 size = m_boxes[face].high - m_boxes[face].low;
        const std::int64_t longest = std::max({size.x, size.y, size.z});
        extent += longest;
        greatest = std::max(greatest, longest);
    }
    // A quarter as wide again as a face; a huge one is not to fill the grid.
    constexpr std::int64_t least = 256;
    constexpr std::int64_t mostCells = 64;
    const std::int64_t mean = extent / std::max<std::int64_t>(std::int64_t(faces.size()), 1);
    m_cell = std::int32_t(std::max({least, mean + mean / 4, greatest / mostCells}));
    m_buckets.resize(std::bit_ceil(std::max<std::size_t>(2 * faces.size(), 64)));
    for (const FaceId face : faces)
        enter(face);
}

void FaceGrid::refresh(std::span<const FaceId> faces)
{
    m_points.resize(std::max<std::size_t>(m_points.size(), m_mesh.vertexSlots()));
    m_middles.resize(std::max<std::size_t>(m_middles.size(), m_mesh.faceSlots()));
    m_boxes.resize(std::max<std::size_t>(m_boxes.size(), m_mesh.faceSlots()));
    for (const FaceId face : faces) {
        const Box before = m_boxes[face];
        if (m_mesh.hasFace(face))
            measure(face);
        else
            m_boxes[face] = {};
        const Box after = m_boxes[face];
        if (!before.empty() && !after.empty() && cellOf(before.low) == cellOf(after.low)
            && cellOf(before.high) == cellOf(after.high))
            continue;
        m_boxes[face] = before;
        leave(face);
        m_boxes[face] = after;
        enter(face);
    }
}

void FaceGrid::measure(FaceId face)
{
    const glm::ivec3 middle = latticePoint(m_toIndex(middleOf(m_mesh, face)));
    Box box{.low = middle, .high = middle};
    for (const VertexId id : m_mesh.ring(face)) {
        m_points[id] = latticePoint(m_toIndex(m_mesh.position(id)));
        box.low = glm::min(box.low, m_points[id]);
        box.high = glm::max(box.high, m_points[id]);
    }
    m_middles[face] = middle;
    m_boxes[face] = box;
}

glm::ivec3 FaceGrid::cellOf(const glm::ivec3& place) const
{
    // What lies below 0 counts from there on, too.
    constexpr std::int32_t bias = 1 << 29;
    return (place + bias) / m_cell;
}

std::size_t FaceGrid::placeOf(const glm::ivec3& cell) const
{
    std::uint64_t key = std::uint64_t(std::uint32_t(cell.x)) * 0x9e3779b97f4a7c15ULL
        + std::uint64_t(std::uint32_t(cell.y)) * 0xc2b2ae3d27d4eb4fULL
        + std::uint64_t(std::uint32_t(cell.z)) * 0x165667b19e3779f9ULL;
    key ^= key >> 29;
    return std::size_t(key) & (m_buckets.size() - 1);
}

std::vector<FaceId>& FaceGrid::bucketOf(const glm::ivec3& cell)
{
    return m_buckets[placeOf(cell)];
}

const std::vector<FaceId>& FaceGrid::bucketOf(const glm::ivec3& cell) const
{
    return m_buckets[placeOf(cell)];
}

void FaceGrid::enter(FaceId face)
{
    if (m_boxes[face].empty())
        return;
    const glm::ivec3 low = cellOf(m_boxes[face].low);
    const glm::ivec3 high = cellOf(m_boxes[face].high);
    for (int z = low.z; z <= high.z; ++z) {
        for (int y = low.y; y <= high.y; ++y) {
            for (int x = low.x; x <= high.x; ++x)
                bucketOf({x, y, z}).push_back(face);
        }
    }
}

void FaceGrid::leave(FaceId face)
{
    if (m_boxes[face].empty())
        return;
    const glm::ivec3 low = cellOf(m_boxes[face].low);
    const glm::ivec3 high = cellOf(m_boxes[face].high);
    for (int z = low.z; z <= high.z; ++z) {
        for (int y = low.y; y <= high.y; ++y) {
            for (int x = low.x; x <= high.x; ++x) {
                std::vector<FaceId>& bucket = bucketOf({x, y, z});
                const auto found = std::find(bucket.begin(), bucket.end(), face);
                if (found == bucket.end())
                    continue;
                *found = bucket.back();
                bucket.pop_back();
            }
        }
    }
}

void FaceGrid::fanOf(FaceId face, Fan& fan) const
{
    fan.clear();
    const FaceRing& ring = m_mesh.ring(face);
    const LatticeCorner middle{.point = m_mesh.vertexSlots() + face, .place = m_middles[face]};
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const VertexId next = ring[(i + 1) % ring.size()];
        fan.push_back({LatticeCorner{.point = ring[i], .place = m_points[ring[i]]},
            LatticeCorner{.point = next, .place = m_points[next]}, middle});
    }
}

bool FaceGrid::cross(const Fan& one, const Fan& other)
{
    for (const LatticeTriangle& a : one) {
        const glm::ivec3 low = lowOf(a);
        const glm::ivec3 high = highOf(a);
        for (const LatticeTriangle& b : other) {
            if (!areApart(low, high, lowOf(b), highOf(b)) && passThroughEachOther(a, b))
                return true;
        }
    }
    return false;
}

bool FaceGrid::crossesItself(const Fan& fan)
{
    for (std::size_t i = 0; i < fan.size(); ++i) {
        for (std::size_t j = i + 1; j < fan.size(); ++j) {
            if (passThroughEachOther(fan[i], fan[j]))
                return true;
        }
    }
    return false;
}

void FaceGrid::lookAround(FaceId face, const std::vector<bool>& isAsked, std::vector<FaceId>& near,
    std::array<Fan, 2>& fans, std::vector<CrossingFaces>& found) const
{
    const Box& box = m_boxes[face];
    if (box.empty())
        return;
    near.clear();
    const glm::ivec3 low = cellOf(box.low);
    const glm::ivec3 high = cellOf(box.high);
    for (int z = low.z; z <= high.z; ++z) {
        for (int y = low.y; y <= high.y; ++y) {
            for (int x = low.x; x <= high.x; ++x) {
                for (const FaceId other : bucketOf({x, y, z})) {
                    const Box& beside = m_boxes[other];
                    // Of two that are asked about the lesser one looks.
                    if (other == face || (isAsked[other] && other < face)
                        || areApart(box.low, box.high, beside.low, beside.high))
                        continue;
                    near.push_back(other);
                }
            }
        }
    }
    std::sort(near.begin(), near.end());
    near.erase(std::unique(near.begin(), near.end()), near.end());
    fanOf(face, fans[0]);
    if (crossesItself(fans[0]))
        found.push_back({.one = face, .other = face});
    for (const FaceId other : near) {
        fanOf(other, fans[1]);
        if (cross(fans[0], fans[1]))
            found.push_back({.one = std::min(face, other), .other = std::max(face, other)});
    }
}

std::vector<CrossingFaces> FaceGrid::crossingsOf(std::span<const FaceId> faces) const
{
    std::vector<bool> isAsked(m_boxes.size(), false);
    for (const FaceId face : faces)
        isAsked[face] = true;
    std::array<std::vector<CrossingFaces>, shares> found;
    const auto look = [&](std::size_t begin, std::size_t end, std::vector<CrossingFaces>& into) {
        std::vector<FaceId> near;
        std::array<Fan, 2> fans;
        for (std::size_t i = begin; i < end; ++i)
            lookAround(faces[i], isAsked, near, fans, into);
    };
    if (faces.size() < fewFaces)
        look(0, faces.size(), found[0]);
    else
        parallelFor(shares, [&](int share) {
            look(faces.size() * std::size_t(share) / shares,
                faces.size() * (std::size_t(share) + 1) / shares, found[std::size_t(share)]);
        });
    std::vector<CrossingFaces> all;
    for (const auto& part : found)
        all.insert(all.end(), part.begin(), part.end());
    std::sort(all.begin(), all.end());
    return all;
}

} // namespace core
