// SPDX-License-Identifier: Apache-2.0
#include "core/refine/repair/FaceGrid.h"

#include "core/base/Progress.h"
#include "core/refine/mesh/SimplexDual.h"
#include "core/refine/voxels/SurfaceFill.h"

#include <algorithm>
#include <bit>

namespace core {

namespace {

/// In the mean: where faces have grown beyond it, looking through their cells takes too long.
constexpr std::size_t mostEntriesOfAFace = 16;

} // namespace

FaceGrid::FaceGrid(
    const SimplexMesh& mesh, const VolumeGeometry& geometry, const Progress* progress)
    : m_mesh(mesh)
    , m_progress(progress)
    , m_toIndex(geometry)
    , m_points(mesh.vertexSlots())
    , m_middles(mesh.faceSlots())
    , m_boxes(mesh.faceSlots())
{
    for (const VertexId id : mesh.vertexIds())
        place(id);
    for (const FaceId face : mesh.faceIds())
        measure(face);
    build();
}

void FaceGrid::build()
{
    std::size_t count = 0;
    std::int64_t extent = 0;
    std::int64_t greatest = 0;
    for (const FaceBox& box : m_boxes) {
        if (box.empty())
            continue;
        const glm::ivec3 size = box.high - box.low;
        const std::int64_t longest = std::max({size.x, size.y, size.z});
        ++count;
        extent += longest;
        greatest = std::max(greatest, longest);
    }
    // About a quarter as wide again as a face; a huge one is not to fill the grid.
    constexpr std::int64_t least = 256;
    constexpr std::int64_t mostCells = 64;
    const std::int64_t mean = extent / std::max<std::int64_t>(std::int64_t(count), 1);
    const std::int64_t wanted = std::max({least, mean + mean / 4, greatest / mostCells});
    m_cellBits = int(std::bit_width(std::uint64_t(wanted - wanted / 4)));
    m_firsts.assign(std::bit_ceil(std::max<std::size_t>(2 * count, 64)), noEntry);
    m_entries.clear();
    m_entries.reserve(6 * count);
    m_free = noEntry;
    for (FaceId face = 0; face < m_boxes.size(); ++face)
        enter(face);
    // Twice what there is now, or a few huge faces would have it built again and again.
    m_mostEntries = std::max(mostEntriesOfAFace * count, 2 * m_entries.size());
}

void FaceGrid::refresh(std::span<const FaceId> faces)
{
    m_points.resize(std::max<std::size_t>(m_points.size(), m_mesh.vertexSlots()));
    m_middles.resize(std::max<std::size_t>(m_middles.size(), m_mesh.faceSlots()));
    m_boxes.resize(std::max<std::size_t>(m_boxes.size(), m_mesh.faceSlots()));
    for (const FaceId face : faces) {
        const FaceBox before = m_boxes[face];
        if (m_mesh.hasFace(face)) {
            for (const VertexId id : m_mesh.ring(face))
                place(id);
            measure(face);
        } else {
            m_boxes[face] = {};
        }
        const FaceBox after = m_boxes[face];
        if (!before.empty() && !after.empty() && cellOf(before.low) == cellOf(after.low)
            && cellOf(before.high) == cellOf(after.high))
            continue;
        m_boxes[face] = before;
        leave(face);
        m_boxes[face] = after;
        enter(face);
    }
    if (m_entries.size() > m_mostEntries)
        build();
}

void FaceGrid::place(VertexId id)
{
    m_points[id] = latticePoint(m_toIndex(m_mesh.position(id)));
}

void FaceGrid::measure(FaceId face)
{
    const glm::ivec3 middle = latticePoint(m_toIndex(middleOf(m_mesh, face)));
    FaceBox box{.low = middle, .high = middle};
    for (const VertexId id : m_mesh.ring(face)) {
        box.low = glm::min(box.low, m_points[id]);
        box.high = glm::max(box.high, m_points[id]);
    }
    m_middles[face] = middle;
    m_boxes[face] = box;
}

glm::ivec3 FaceGrid::cellOf(const glm::ivec3& place) const
{
    return place >> m_cellBits;
}

std::size_t FaceGrid::placeOf(const glm::ivec3& cell) const
{
    std::uint64_t key = std::uint64_t(std::uint32_t(cell.x)) * 0x9e3779b97f4a7c15ULL
        + std::uint64_t(std::uint32_t(cell.y)) * 0xc2b2ae3d27d4eb4fULL
        + std::uint64_t(std::uint32_t(cell.z)) * 0x165667b19e3779f9ULL;
    key ^= key >> 29;
    return std::size_t(key) & (m_firsts.size() - 1);
}

std::uint32_t& FaceGrid::firstOf(const glm::ivec3& cell)
{
    return m_firsts[placeOf(cell)];
}

void FaceGrid::enter(FaceId face)
{
    if (m_boxes[face].empty())
        return;
    forEachCell(m_boxes[face], [&](const glm::ivec3& cell) {
        std::uint32_t& first = firstOf(cell);
        std::uint32_t at = m_free;
        if (at == noEntry) {
            at = std::uint32_t(m_entries.size());
            m_entries.emplace_back();
        } else {
            m_free = m_entries[at].next;
        }
        m_entries[at] = {.face = face, .next = first};
        first = at;
    });
}

void FaceGrid::leave(FaceId face)
{
    if (m_boxes[face].empty())
        return;
    forEachCell(m_boxes[face], [&](const glm::ivec3& cell) {
        std::uint32_t* link = &firstOf(cell);
        while (*link != noEntry && m_entries[*link].face != face)
            link = &m_entries[*link].next;
        if (*link == noEntry)
            return;
        const std::uint32_t at = *link;
        *link = m_entries[at].next;
        m_entries[at].next = m_free;
        m_free = at;
    });
}

FaceFan FaceGrid::fanOf(FaceId face) const
{
    return {.box = m_boxes[face],
        .middle = {.point = m_mesh.vertexSlots() + face, .place = m_middles[face]},
        .ring = m_mesh.ring(face),
        .points = m_points.data()};
}

void FaceGrid::lookAround(FaceId face, std::vector<CrossingFaces>& found) const
{
    const FaceBox& box = m_boxes[face];
    if (box.empty())
        return;
    const FaceFan own = fanOf(face);
    if (passesThroughItself(own))
        found.push_back({.one = face, .other = face});
    forEachCell(box, [&](const glm::ivec3& cell) {
        for (std::uint32_t at = m_firsts[placeOf(cell)]; at != noEntry; at = m_entries[at].next) {
            // Of two that are asked about the lesser one looks, in the first cell that has both.
            const FaceId other = m_entries[at].face;
            const FaceBox& beside = m_boxes[other];
            if (other == face || (isAsked(other) && other < face) || !box.meets(beside)
                || cellOf(glm::max(box.low, beside.low)) != cell)
                continue;
            if (passThroughEachOther(own, fanOf(other)))
                found.push_back({.one = std::min(face, other), .other = std::max(face, other)});
        }
    });
}

std::vector<CrossingFaces> FaceGrid::crossingsOf(std::span<const FaceId> faces)
{
    m_asked.resize(m_boxes.size(), 0);
    ++m_question;
    for (const FaceId face : faces)
        m_asked[face] = m_question;
    // A face of two cells with the same bucket is met there twice.
    return collectCrossings(
        faces.size(), [&](std::size_t begin, std::size_t end, std::vector<CrossingFaces>& found) {
            for (std::size_t i = begin; i < end; ++i) {
                if (m_progress && m_progress->cancelled())
                    return;
                lookAround(faces[i], found);
            }
        });
}

} // namespace core
