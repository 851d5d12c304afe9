// SPDX-License-Identifier: Apache-2.0
#include "gpu/render/parts/SurfaceBuffers.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <type_traits>
#include <utility>

namespace gpu {

namespace {

/// Two runs with no more than so many between them are sent as one: each costs a call.
constexpr std::uint32_t mostBetween = 8;

std::uint32_t packed(const glm::vec3& normal)
{
    std::uint32_t word = 0;
    for (int axis = 0; axis < 3; ++axis) {
        const auto number = int(std::lround(std::clamp(normal[axis], -1.0f, 1.0f) * 511.0f));
        word |= (std::uint32_t(number) & 0x3FFu) << (10 * axis);
    }
    return word;
}

/// With some to spare.
std::size_t roomFor(std::size_t count)
{
    return count + count / 4 + 256;
}

} // namespace

void SurfaceBuffers::Dirty::add(std::uint32_t id)
{
    if (id >= m_has.size())
        m_has.resize(id + 1, false);
    if (m_has[id])
        return;
    m_has[id] = true;
    m_ids.push_back(id);
}

void SurfaceBuffers::Dirty::addAll(std::size_t count)
{
    for (std::size_t id = 0; id < count; ++id)
        add(std::uint32_t(id));
}

template <class Run> void SurfaceBuffers::Dirty::takeRuns(Run run)
{
    std::sort(m_ids.begin(), m_ids.end());
    for (std::size_t i = 0; i < m_ids.size();) {
        std::size_t end = i + 1;
        while (end < m_ids.size() && m_ids[end] - m_ids[end - 1] <= mostBetween + 1)
            ++end;
        run(m_ids[i], m_ids[end - 1] + 1);
        i = end;
    }
    for (const std::uint32_t id : m_ids)
        m_has[id] = false;
    m_ids.clear();
}

void SurfaceBuffers::clear()
{
    for (const glm::dvec3& position : m_positions)
        m_changed.add(position);
    m_dirtyVertices = {};
    m_dirtyCorners = {};
    m_dirtyFaces = {};
    // What was sent of others must not be drawn on.
    m_dirtyCorners.addAll(m_corners.size());
    m_corners.assign(m_corners.size(), Corners{});
    m_positions.clear();
    m_normals.clear();
    m_marks.clear();
    m_rings.clear();
    m_middles.clear();
    m_faceCount = 0;
}

void SurfaceBuffers::apply(const core::SurfaceUpdate& update)
{
    if (update.isWhole)
        clear();
    ++m_revision;
    for (const core::SurfaceUpdate::Vertex& vertex : update.vertices)
        putVertex(vertex);
    // A vertex has room for three faces: those that go make it for those that come.
    for (const core::SurfaceUpdate::Face& face : update.faces)
        takeFace(face.id);
    for (const core::SurfaceUpdate::Face& face : update.faces)
        putFace(face.id, face.ring);
}

void SurfaceBuffers::putVertex(const core::SurfaceUpdate::Vertex& vertex)
{
    const core::VertexId id = vertex.id;
    if (id == core::noId)
        return;
    if (id >= m_positions.size()) {
        m_positions.resize(id + 1, vertex.positionLps);
        m_normals.resize(id + 1);
        m_marks.resize(id + 1);
        m_corners.resize(std::max(m_corners.size(), m_positions.size()));
    }
    m_changed.add(m_positions[id]);
    m_changed.add(vertex.positionLps);
    m_positions[id] = vertex.positionLps;
    m_normals[id] = glm::vec3(vertex.normalLps);
    m_marks[id] = vertex.mark;
    m_dirtyVertices.add(id);
    for (const Corner& corner : m_corners[id]) {
        if (corner.face == core::noId)
            continue;
        m_dirtyFaces.add(corner.face);
        noteChanged(m_rings[corner.face]);
    }
}

void SurfaceBuffers::takeFace(core::FaceId face)
{
    if (face >= m_rings.size() || m_rings[face].empty())
        return;
    noteChanged(m_rings[face]);
    for (const core::VertexId id : m_rings[face]) {
        for (Corner& corner : m_corners[id]) {
            if (corner.face == face)
                corner = {};
        }
        m_dirtyCorners.add(id);
    }
    m_rings[face].clear();
    --m_faceCount;
}

void SurfaceBuffers::putFace(core::FaceId face, const core::FaceRing& ring)
{
    const bool known = std::all_of(
        ring.begin(), ring.end(), [this](core::VertexId id) { return id < m_positions.size(); });
    if (ring.empty() || !known || face == core::noId)
        return;
    if (face >= m_rings.size()) {
        m_rings.resize(face + 1);
        m_middles.resize(face + 1);
    }
    m_rings[face] = ring;
    ++m_faceCount;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        Corners& corners = m_corners[ring[i]];
        const auto unused = std::find_if(corners.begin(), corners.end(),
            [](const Corner& corner) { return corner.face == core::noId; });
        if (unused != corners.end())
            *unused = {face, ring[(i + 1) % ring.size()]};
        m_dirtyCorners.add(ring[i]);
    }
    m_dirtyFaces.add(face);
    noteChanged(ring);
}

void SurfaceBuffers::noteChanged(const core::FaceRing& ring)
{
    for (const core::VertexId id : ring)
        m_changed.add(m_positions[id]);
}

void SurfaceBuffers::makeRoom()
{
    if (m_corners.size() <= m_vertexRoom && m_rings.size() <= m_faceRoom)
        return;
    const std::size_t vertexRoom = roomFor(m_corners.size());
    const std::size_t faceRoom = roomFor(m_rings.size());
    Buffer vertices(
        {.label = "vertices of the surface", .bytes = (vertexRoom + faceRoom) * sizeof(Vertex)});
    Buffer elements({.label = "triangles of the surface", .bytes = vertexRoom * sizeof(Elements)});
    // Where there is no memory for both, room is still wanted next time.
    m_vertexRoom = vertexRoom;
    m_faceRoom = faceRoom;
    m_vertices = std::move(vertices);
    m_elements = std::move(elements);
    if (!m_array)
        m_array.emplace("surface");
    m_array->setVertices(m_vertices, sizeof(Vertex));
    m_array->setElements(m_elements);
    m_array->setAttribute(0, {.components = 3, .offset = offsetof(Vertex, positionLps)});
    m_array->setAttribute(1,
        {.components = 4,
            .type = GL_INT_2_10_10_10_REV,
            .normalized = true,
            .offset = offsetof(Vertex, normalLps)});
    m_array->setAttribute(2,
        {.components = 4,
            .type = GL_UNSIGNED_BYTE,
            .normalized = true,
            .offset = offsetof(Vertex, marks)});
    m_dirtyVertices.addAll(m_positions.size());
    m_dirtyCorners.addAll(m_corners.size());
    m_dirtyFaces.addAll(m_rings.size());
}

SurfaceBuffers::Vertex SurfaceBuffers::vertexOf(core::VertexId id) const
{
    Vertex vertex{.positionLps = glm::vec3(m_positions[id]), .normalLps = packed(m_normals[id])};
    vertex.marks[std::size_t(m_marks[id])] = 255;
    return vertex;
}

void SurfaceBuffers::placeMiddle(core::FaceId face)
{
    const core::FaceRing& ring = m_rings[face];
    if (ring.empty())
        return;
    glm::dvec3 sum{0.0};
    for (const core::VertexId id : ring)
        sum += m_positions[id];
    m_middles[face] = sum / double(ring.size());
}

SurfaceBuffers::Vertex SurfaceBuffers::middleOf(core::FaceId face) const
{
    const core::FaceRing& ring = m_rings[face];
    if (ring.empty())
        return {};
    glm::vec3 normal{0.0f};
    std::array<std::size_t, 3> marked{};
    for (const core::VertexId id : ring) {
        normal += m_normals[id];
        ++marked[std::size_t(m_marks[id])];
    }
    Vertex middle{.positionLps = glm::vec3(m_middles[face]),
        .normalLps = packed(normal / std::max(glm::length(normal), 1e-6f))};
    for (std::size_t mark = 0; mark < marked.size(); ++mark)
        middle.marks[mark] = std::uint8_t(255 * marked[mark] / ring.size());
    middle.marks[3] = 255;
    return middle;
}

SurfaceBuffers::Elements SurfaceBuffers::elementsOf(core::VertexId id) const
{
    Elements elements{}; // nothing is drawn of three times the same vertex
    for (std::size_t i = 0; i < 3; ++i) {
        const Corner& corner = m_corners[id][i];
        if (corner.face == core::noId)
            continue;
        elements[3 * i] = id;
        elements[3 * i + 1] = corner.next;
        elements[3 * i + 2] = std::uint32_t(m_vertexRoom) + corner.face;
    }
    return elements;
}

void SurfaceBuffers::upload()
{
    if (m_dirtyVertices.empty() && m_dirtyCorners.empty() && m_dirtyFaces.empty())
        return;
    makeRoom();
    const auto send = [this](Buffer& buffer, std::size_t first, const auto& values) {
        using Value = typename std::decay_t<decltype(values)>::value_type;
        buffer.write(std::span<const Value>(values), first * sizeof(Value));
        m_counters.bytes += std::int64_t(values.size() * sizeof(Value));
    };
    std::vector<Vertex> vertices;
    m_dirtyVertices.takeRuns([&](core::VertexId first, core::VertexId end) {
        vertices.clear();
        for (core::VertexId id = first; id < end; ++id)
            vertices.push_back(vertexOf(id));
        send(m_vertices, first, vertices);
    });
    m_dirtyFaces.takeRuns([&](core::FaceId first, core::FaceId end) {
        vertices.clear();
        for (core::FaceId face = first; face < end; ++face) {
            placeMiddle(face);
            vertices.push_back(middleOf(face));
        }
        send(m_vertices, m_vertexRoom + first, vertices);
    });
    std::vector<Elements> elements;
    m_dirtyCorners.takeRuns([&](core::VertexId first, core::VertexId end) {
        elements.clear();
        for (core::VertexId id = first; id < end; ++id)
            elements.push_back(elementsOf(id));
        send(m_elements, first, elements);
    });
    ++m_counters.uploads;
    findBounds();
}

void SurfaceBuffers::findBounds()
{
    m_bounds = {};
    for (std::size_t id = 0; id < m_positions.size(); ++id) {
        if (m_corners[id][0].face != core::noId || m_corners[id][1].face != core::noId
            || m_corners[id][2].face != core::noId)
            m_bounds.add(m_positions[id]);
    }
}

WorldBox SurfaceBuffers::takeChanged()
{
    return std::exchange(m_changed, {});
}

void SurfaceBuffers::draw() const
{
    if (m_array && !empty())
        m_array->drawTriangles(int(m_corners.size() * 9));
}

} // namespace gpu
