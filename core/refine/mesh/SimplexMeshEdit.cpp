// SPDX-License-Identifier: Apache-2.0
#include "core/refine/mesh/SimplexMeshEdit.h"

#include <algorithm>

namespace core {

namespace {

/// Whether @p id was not marked before; it is then.
bool markFirst(std::vector<bool>& marked, std::uint32_t id)
{
    if (id >= marked.size())
        marked.resize(std::size_t(id) + 1, false);
    if (marked[id])
        return false;
    marked[id] = true;
    return true;
}

template <typename Change> void sortById(std::vector<Change>& changes)
{
    std::sort(changes.begin(), changes.end(),
        [](const Change& a, const Change& b) { return a.id < b.id; });
}

template <typename Change> bool isAmong(const std::vector<Change>& changes, std::uint32_t id)
{
    return std::any_of(
        changes.begin(), changes.end(), [id](const Change& change) { return change.id == id; });
}

bool isChanged(const SimplexMeshDelta::VertexChange& change)
{
    if (change.before.has_value() != change.after.has_value())
        return true;
    return change.before && !identical(*change.before, *change.after);
}

} // namespace

SimplexMeshEdit::SimplexMeshEdit(SimplexMesh& mesh)
    : m_mesh(mesh)
    , m_touched(mesh.vertexSlots(), false)
    , m_touchedFaces(mesh.faceSlots(), false)
{
}

SimplexMeshEdit::~SimplexMeshEdit()
{
    if (m_isOpen)
        rollback();
}

// Who picked a vertex may name it still when it has been merged with another: where there is none
// nothing is written, or what lies in a free place would not come back on redo.
void SimplexMeshEdit::move(VertexId id, const glm::dvec3& positionLps)
{
    if (!m_mesh.hasVertex(id) || m_mesh.mark(id) == SurfaceMark::Green)
        return;
    touchVertex(id);
    m_mesh.m_positions[id] = positionLps;
}

void SimplexMeshEdit::setMark(VertexId id, SurfaceMark mark)
{
    if (!m_mesh.hasVertex(id) || m_mesh.mark(id) == mark)
        return;
    touchVertex(id);
    m_mesh.m_marks[id] = mark;
}

VertexId SimplexMeshEdit::addVertex(const SimplexVertex& vertex)
{
    const VertexId id = m_mesh.freeVertex();
    touchVertex(id);
    m_mesh.putVertex(id, vertex);
    return id;
}

void SimplexMeshEdit::removeVertex(VertexId id)
{
    Q_ASSERT(m_mesh.mark(id) != SurfaceMark::Green);
    touchVertex(id);
    m_mesh.putVertex(id, std::nullopt);
}

void SimplexMeshEdit::link(
    VertexId id, const std::array<VertexId, 3>& neighbours, const std::array<FaceId, 3>& faces)
{
    Q_ASSERT(m_mesh.mark(id) != SurfaceMark::Green);
    touchVertex(id);
    m_mesh.m_neighbours[id] = neighbours;
    m_mesh.m_faces[id] = faces;
}

FaceId SimplexMeshEdit::addFace(FaceRing ring)
{
    const FaceId id = m_mesh.freeFace();
    touchFace(id);
    m_mesh.putFace(id, std::move(ring));
    return id;
}

void SimplexMeshEdit::setRing(FaceId id, FaceRing ring)
{
    touchFace(id);
    m_mesh.m_rings[id] = std::move(ring);
}

void SimplexMeshEdit::removeFace(FaceId id)
{
    touchFace(id);
    m_mesh.putFace(id, {});
}

SimplexMeshDelta SimplexMeshEdit::commit()
{
    m_isOpen = false;
    return changes();
}

void SimplexMeshEdit::rollback()
{
    m_isOpen = false;
    changes().undo(m_mesh);
}

void SimplexMeshEdit::beginTrial()
{
    m_trial.emplace();
}

std::vector<FaceId> SimplexMeshEdit::trialFaces() const
{
    std::vector<FaceId> faces;
    for (const auto& change : m_trial->faces)
        faces.push_back(change.id);
    std::sort(faces.begin(), faces.end());
    return faces;
}

void SimplexMeshEdit::keepTrial()
{
    m_trial.reset();
}

void SimplexMeshEdit::revertTrial()
{
    m_trial->undo(m_mesh);
    m_trial.reset();
}

WrittenParts SimplexMeshEdit::takeWritten()
{
    WrittenParts written = std::move(m_written);
    m_written = {};
    for (const VertexId id : written.vertices)
        m_isWritten[id] = false;
    for (const FaceId id : written.faces)
        m_isFaceWritten[id] = false;
    std::sort(written.vertices.begin(), written.vertices.end());
    std::sort(written.faces.begin(), written.faces.end());
    return written;
}

void SimplexMeshEdit::touchVertex(VertexId id)
{
    if (markFirst(m_isWritten, id))
        m_written.vertices.push_back(id);
    if (m_trial && !isAmong(m_trial->vertices, id))
        m_trial->vertices.push_back(asItIs(id));
    if (markFirst(m_touched, id))
        m_before.vertices.push_back(asItIs(id));
}

void SimplexMeshEdit::touchFace(FaceId id)
{
    if (markFirst(m_isFaceWritten, id))
        m_written.faces.push_back(id);
    const SimplexMeshDelta::FaceChange change{
        .id = id, .before = m_mesh.hasFace(id) ? m_mesh.ring(id) : FaceRing(), .after = {}};
    if (m_trial && !isAmong(m_trial->faces, id))
        m_trial->faces.push_back(change);
    if (markFirst(m_touchedFaces, id))
        m_before.faces.push_back(change);
}

SimplexMeshDelta::VertexChange SimplexMeshEdit::asItIs(VertexId id) const
{
    SimplexMeshDelta::VertexChange change{.id = id, .before = {}, .after = {}};
    if (m_mesh.hasVertex(id))
        change.before = m_mesh.vertex(id);
    return change;
}

SimplexMeshDelta SimplexMeshEdit::changes()
{
    SimplexMeshDelta delta = std::move(m_before);
    for (auto& change : delta.vertices) {
        if (m_mesh.hasVertex(change.id))
            change.after = m_mesh.vertex(change.id);
    }
    for (auto& change : delta.faces) {
        if (m_mesh.hasFace(change.id))
            change.after = m_mesh.ring(change.id);
    }
    std::erase_if(delta.vertices, [](const auto& change) { return !isChanged(change); });
    std::erase_if(delta.faces, [](const auto& change) { return change.before == change.after; });
    sortById(delta.vertices);
    sortById(delta.faces);
    return delta;
}

} // namespace core
