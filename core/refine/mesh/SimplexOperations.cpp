// SPDX-License-Identifier: Apache-2.0
#include "core/refine/mesh/SimplexOperations.h"

#include <algorithm>

namespace core {

namespace {

std::size_t placeOf(const FaceRing& ring, VertexId id)
{
    return std::size_t(std::find(ring.begin(), ring.end(), id) - ring.begin());
}

/// The other neighbours of an end of an edge, following it around to the left.
std::array<VertexId, 2> others(const SimplexMesh& mesh, VertexId id, VertexId neighbour)
{
    const int slot = mesh.slotOf(id, neighbour);
    const auto& neighbours = mesh.neighbours(id);
    return {neighbours[std::size_t((slot + 1) % 3)], neighbours[std::size_t((slot + 2) % 3)]};
}

void replaceNeighbour(SimplexMeshEdit& edit, VertexId id, VertexId old, VertexId now)
{
    auto neighbours = edit.mesh().neighbours(id);
    std::replace(neighbours.begin(), neighbours.end(), old, now);
    edit.link(id, neighbours, edit.mesh().facesAt(id));
}

void replaceFace(SimplexMeshEdit& edit, VertexId id, FaceId old, FaceId now)
{
    auto faces = edit.mesh().facesAt(id);
    std::replace(faces.begin(), faces.end(), old, now);
    edit.link(id, edit.mesh().neighbours(id), faces);
}

void leaveRing(SimplexMeshEdit& edit, FaceId face, VertexId id)
{
    FaceRing ring = edit.mesh().ring(face);
    ring.erase(ring.begin() + std::ptrdiff_t(placeOf(ring, id)));
    edit.setRing(face, std::move(ring));
}

/// Lets @p id follow @p before.
void enterRing(SimplexMeshEdit& edit, FaceId face, VertexId before, VertexId id)
{
    FaceRing ring = edit.mesh().ring(face);
    ring.insert(ring.begin() + std::ptrdiff_t(placeOf(ring, before)) + 1, id);
    edit.setRing(face, std::move(ring));
}

bool areNeighbours(const SimplexMesh& mesh, FaceId one, FaceId other)
{
    const FaceRing& ring = mesh.ring(one);
    for (std::size_t i = 0; i < ring.size(); ++i) {
        if (mesh.faceAcross(ring, i) == other)
            return true;
    }
    return false;
}

} // namespace

EdgeSurroundings surroundingsOf(const SimplexMesh& mesh, VertexId from, VertexId to)
{
    const auto there = std::size_t(mesh.slotOf(from, to));
    const auto back = std::size_t(mesh.slotOf(to, from));
    return {.from = from,
        .to = to,
        .left = mesh.facesAt(from)[there],
        .right = mesh.facesAt(to)[back],
        .behind = mesh.facesAt(from)[(there + 1) % 3],
        .ahead = mesh.facesAt(to)[(back + 1) % 3]};
}

bool isFree(const SimplexMesh& mesh, FaceId id)
{
    const FaceRing& ring = mesh.ring(id);
    return std::none_of(ring.begin(), ring.end(),
        [&](VertexId vertex) { return mesh.mark(vertex) == SurfaceMark::Green; });
}

bool canMergeFaces(const SimplexMesh& mesh, const EdgeSurroundings& edge)
{
    if (mesh.ring(edge.behind).size() < 4 || mesh.ring(edge.ahead).size() < 4
        || mesh.ring(edge.left).size() + mesh.ring(edge.right).size() < 7)
        return false;
    for (const FaceId face : {edge.left, edge.right, edge.behind, edge.ahead}) {
        if (!isFree(mesh, face))
            return false;
    }
    // A face beside both, other than those at the ends, would share two edges with the new one.
    const FaceRing& left = mesh.ring(edge.left);
    for (std::size_t i = 0; i < left.size(); ++i) {
        const FaceId beside = mesh.faceAcross(left, i);
        if (beside != edge.right && beside != edge.behind && beside != edge.ahead
            && areNeighbours(mesh, beside, edge.right))
            return false;
    }
    return true;
}

bool mergeFaces(SimplexMeshEdit& edit, VertexId from, VertexId to)
{
    const SimplexMesh& mesh = edit.mesh();
    const EdgeSurroundings edge = surroundingsOf(mesh, from, to);
    if (!canMergeFaces(mesh, edge))
        return false;
    const auto [leftBehind, rightBehind] = others(mesh, from, to);
    const auto [rightAhead, leftAhead] = others(mesh, to, from);
    // Around the left face from behind `to`'s place, then around the right one.
    const FaceRing& left = mesh.ring(edge.left);
    const FaceRing& right = mesh.ring(edge.right);
    FaceRing ring;
    ring.reserve(left.size() + right.size() - 4);
    const std::size_t afterLeft = placeOf(left, to) + 1;
    for (std::size_t i = 0; i + 2 < left.size(); ++i)
        ring.push_back(left[(afterLeft + i) % left.size()]);
    const std::size_t afterRight = placeOf(right, from) + 1;
    for (std::size_t i = 0; i + 2 < right.size(); ++i) {
        const VertexId id = right[(afterRight + i) % right.size()];
        ring.push_back(id);
        replaceFace(edit, id, edge.right, edge.left);
    }
    edit.setRing(edge.left, std::move(ring));
    edit.removeFace(edge.right);
    leaveRing(edit, edge.behind, from);
    leaveRing(edit, edge.ahead, to);
    replaceNeighbour(edit, leftBehind, from, rightBehind);
    replaceNeighbour(edit, rightBehind, from, leftBehind);
    replaceNeighbour(edit, leftAhead, to, rightAhead);
    replaceNeighbour(edit, rightAhead, to, leftAhead);
    edit.removeVertex(from);
    edit.removeVertex(to);
    return true;
}

std::optional<std::array<VertexId, 2>> splitFace(
    SimplexMeshEdit& edit, FaceId face, std::size_t first, std::size_t second)
{
    const SimplexMesh& mesh = edit.mesh();
    if (first > second)
        std::swap(first, second);
    const FaceRing ring = mesh.ring(face);
    if (first == second || second >= ring.size())
        return std::nullopt;
    const std::array<std::size_t, 2> places{first, second};
    std::array<FaceId, 2> beyond{};
    for (std::size_t i = 0; i < 2; ++i)
        beyond[i] = mesh.faceAcross(ring, places[i]);
    if (!isFree(mesh, face) || !isFree(mesh, beyond[0]) || !isFree(mesh, beyond[1]))
        return std::nullopt;

    std::array<VertexId, 2> added{noId, noId};
    for (std::size_t i = 0; i < 2; ++i) {
        const VertexId before = ring[places[i]];
        const VertexId after = ring[(places[i] + 1) % ring.size()];
        SimplexVertex vertex;
        vertex.positionLps = 0.5 * (mesh.position(before) + mesh.position(after));
        // Or yellow would creep into what is red where it is stretched.
        vertex.mark = mesh.mark(after) == SurfaceMark::Red ? SurfaceMark::Red : mesh.mark(before);
        added[i] = edit.addVertex(vertex);
        enterRing(edit, beyond[i], after, added[i]);
    }
    FaceRing between{added[0]};
    between.insert(between.end(), ring.begin() + std::ptrdiff_t(first) + 1,
        ring.begin() + std::ptrdiff_t(second) + 1);
    between.push_back(added[1]);
    FaceRing rest(ring.begin(), ring.begin() + std::ptrdiff_t(first) + 1);
    rest.push_back(added[0]);
    rest.push_back(added[1]);
    rest.insert(rest.end(), ring.begin() + std::ptrdiff_t(second) + 1, ring.end());
    const FaceId made = edit.addFace(between);
    edit.setRing(face, std::move(rest));
    for (std::size_t i = first + 1; i <= second; ++i)
        replaceFace(edit, ring[i], face, made);

    for (std::size_t i = 0; i < 2; ++i) {
        const VertexId before = ring[places[i]];
        const VertexId after = ring[(places[i] + 1) % ring.size()];
        // Read anew: both may lie on edges that follow each other.
        replaceNeighbour(edit, before, after, added[i]);
        replaceNeighbour(edit, after, before, added[i]);
    }
    // To the left of the way on along the split face lies what is on that side of the new edge.
    const VertexId end0 = ring[first];
    const VertexId next0 = ring[first + 1];
    const VertexId end1 = ring[second];
    const VertexId next1 = ring[(second + 1) % ring.size()];
    edit.link(added[0], {next0, added[1], end0}, {made, face, beyond[0]});
    edit.link(added[1], {next1, added[0], end1}, {face, made, beyond[1]});
    return added;
}

bool canSwapEdge(const SimplexMesh& mesh, const EdgeSurroundings& edge)
{
    if (mesh.ring(edge.left).size() < 4 || mesh.ring(edge.right).size() < 4
        || edge.behind == edge.ahead)
        return false;
    for (const FaceId face : {edge.left, edge.right, edge.behind, edge.ahead}) {
        if (!isFree(mesh, face))
            return false;
    }
    return !areNeighbours(mesh, edge.behind, edge.ahead);
}

bool swapEdge(SimplexMeshEdit& edit, VertexId from, VertexId to)
{
    const SimplexMesh& mesh = edit.mesh();
    const EdgeSurroundings edge = surroundingsOf(mesh, from, to);
    if (!canSwapEdge(mesh, edge))
        return false;
    const auto [leftBehind, rightBehind] = others(mesh, from, to);
    const auto [rightAhead, leftAhead] = others(mesh, to, from);
    leaveRing(edit, edge.left, to);
    leaveRing(edit, edge.right, from);
    // Behind: right neighbour, from, left neighbour; `to` comes in before `from`. Ahead the other
    // way round.
    enterRing(edit, edge.behind, rightBehind, to);
    enterRing(edit, edge.ahead, leftAhead, from);
    replaceNeighbour(edit, rightBehind, from, to);
    replaceNeighbour(edit, leftAhead, to, from);
    edit.link(from, {to, leftAhead, leftBehind}, {edge.ahead, edge.left, edge.behind});
    edit.link(to, {from, rightBehind, rightAhead}, {edge.behind, edge.right, edge.ahead});
    const glm::dvec3 middle = 0.5 * (mesh.position(from) + mesh.position(to));
    const auto between = [&](VertexId one, VertexId other) {
        return (middle + mesh.position(one) + mesh.position(other)) / 3.0;
    };
    const glm::dvec3 leftPlace = between(leftBehind, leftAhead);
    const glm::dvec3 rightPlace = between(rightBehind, rightAhead);
    edit.move(from, leftPlace);
    edit.move(to, rightPlace);
    return true;
}

} // namespace core
