// SPDX-License-Identifier: Apache-2.0
#include "core/refine/repair/MeshRestructuring.h"

#include "core/base/SortUnique.h"
#include "core/refine/mesh/InternalForces.h"
#include "core/refine/mesh/SimplexOperations.h"
#include "core/refine/repair/CrossingGuard.h"
#include "core/refine/repair/FaceShape.h"

#include <algorithm>
#include <cmath>

namespace core {

namespace {

/// A swapped edge grows about as long as the faces are wide; only short ones gain by it. In shares
/// of the root of an area: that of a regular hexagon is 0.62.
constexpr double longestSwapped = 0.75;
/// A face of less than this share of the wanted area is merged whichever way it looks; one that is
/// merely small stays where the surface is bent, or parts as small as faces would go.
constexpr double nothingShare = 0.02;

/// Of the area from which faces are split.
constexpr double largeShare = 1.5;
/// Of a face and its parts.
constexpr int mostHalvings = 8;

class Restructuring {
public:
    Restructuring(
        SimplexMeshEdit& edit, const RestructuringSettings& settings, CrossingGuard* guard)
        : m_edit(edit)
        , m_mesh(edit.mesh())
        , m_settings(settings)
        , m_guard(guard)
    {
    }

    Restructured run(std::span<const VertexId> around)
    {
        lookAt(around);
        forEachFace([this](FaceId face) { weld(face); });
        forEachFace([this](FaceId face) { mergeSmall(face); });
        forEachFace([this](FaceId face) { splitLarge(face); });
        forEachFace([this](FaceId face) { swapAround(face); });
        sortUnique(m_changed);
        for (const FaceId face : m_changed) {
            if (m_mesh.hasFace(face))
                m_done.vertices.insert(
                    m_done.vertices.end(), m_mesh.ring(face).begin(), m_mesh.ring(face).end());
        }
        sortUnique(m_done.vertices);
        return std::move(m_done);
    }

    int bound(std::span<const VertexId> around, const StretchLimits& limits)
    {
        lookAt(around);
        for (int pass = 0; pass < mostHalvings && !m_faces.empty(); ++pass) {
            m_changed.clear();
            forEachFace([&](FaceId face) {
                if (isStretched(face, limits))
                    splitInHalf(face);
            });
            sortUnique(m_changed);
            m_faces = m_changed;
        }
        return m_done.split;
    }

private:
    void lookAt(std::span<const VertexId> around)
    {
        for (const VertexId id : around) {
            if (m_mesh.hasVertex(id))
                m_faces.insert(m_faces.end(), m_mesh.facesAt(id).begin(), m_mesh.facesAt(id).end());
        }
        sortUnique(m_faces);
    }
    [[nodiscard]] bool isStretched(FaceId face, const StretchLimits& limits) const
    {
        const FaceRing& ring = m_mesh.ring(face);
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const glm::dvec3 way =
                m_mesh.position(ring[(i + 1) % ring.size()]) - m_mesh.position(ring[i]);
            if (glm::dot(way, way) > limits.edgeMm * limits.edgeMm)
                return true;
        }
        return areaOf(m_mesh, face) > limits.areaMm2;
    }
    template <typename Change> bool attempt(const Change& change)
    {
        return m_guard ? m_guard->attempt(m_edit, change) : change();
    }
    template <typename Work> void forEachFace(const Work& work)
    {
        for (const FaceId face : m_faces) {
            if (m_mesh.hasFace(face) && isFree(m_mesh, face))
                work(face);
        }
    }
    [[nodiscard]] EdgeSurroundings edgeOf(FaceId face, std::size_t i) const
    {
        const FaceRing& ring = m_mesh.ring(face);
        return surroundingsOf(m_mesh, ring[i], ring[(i + 1) % ring.size()]);
    }
    void changed(const EdgeSurroundings& edge)
    {
        m_changed.insert(m_changed.end(), {edge.left, edge.right, edge.behind, edge.ahead});
    }
    /// Finer where the surface is bent: an edge is to span a like part of a turn.
    [[nodiscard]] double wantedArea(FaceId face) const
    {
        double bent = 0.0;
        for (const VertexId id : m_mesh.ring(face))
            bent += frameAt(m_mesh, id).curvaturePerMm;
        bent /= double(m_mesh.ring(face).size());
        return m_settings.areaMm2
            * std::max(m_settings.finest, 1.0 / (1.0 + 4.0 * bent * bent * m_settings.areaMm2));
    }

    void weld(FaceId face)
    {
        const glm::dvec3 area = areaVectorOf(m_mesh, face);
        for (std::size_t i = 0; i < m_mesh.ring(face).size(); ++i) {
            const EdgeSurroundings edge = edgeOf(face, i);
            // Fitted planes cost more than those that tell as much nearly everywhere.
            if (lookAlike(area, areaVectorOf(m_mesh, edge.right)))
                continue;
            const FaceShape shape = shapeOf(m_mesh, face);
            const FaceShape beside = shapeOf(m_mesh, edge.right);
            // At a crease that is meant, larger and larger faces would lie across it.
            if (glm::dot(shape.normalLps, beside.normalLps) < 0.0
                && shape.areaMm2 + beside.areaMm2 < m_settings.greatestShare * m_settings.areaMm2
                && attempt([&] { return mergeFaces(m_edit, edge.from, edge.to); })) {
                ++m_done.welded;
                changed(edge);
                return;
            }
        }
    }

    void mergeSmall(FaceId face)
    {
        const FaceShape shape = shapeOf(m_mesh, face);
        const double wanted = wantedArea(face);
        const bool isThin =
            shape.elongation() > m_settings.greatestElongation && shape.areaMm2 < 0.8 * wanted;
        if (shape.areaMm2 >= m_settings.leastShare * wanted && !isThin)
            return;
        const bool isNothing = shape.areaMm2 < nothingShare * wanted;
        const glm::dvec3 area = areaVectorOf(m_mesh, face);
        EdgeSurroundings best;
        double least = 0.0;
        for (std::size_t i = 0; i < m_mesh.ring(face).size(); ++i) {
            const EdgeSurroundings edge = edgeOf(face, i);
            const double length =
                glm::distance(m_mesh.position(edge.from), m_mesh.position(edge.to));
            const double beside = areaOf(m_mesh, edge.right);
            const double cost = (shape.areaMm2 + beside) / std::max(length, 1e-12);
            if ((best.from != noId && cost >= least) || shape.areaMm2 + beside > 1.6 * wanted
                || !(isNothing || lookAlike(area, areaVectorOf(m_mesh, edge.right)))
                || !canMergeFaces(m_mesh, edge))
                continue;
            least = cost;
            best = edge;
        }
        if (best.from == noId || !attempt([&] { return mergeFaces(m_edit, best.from, best.to); }))
            return;
        ++m_done.merged;
        changed(best);
    }

    void splitLarge(FaceId face)
    {
        const FaceShape shape = shapeOf(m_mesh, face);
        const double wanted = wantedArea(face);
        const bool isLong =
            shape.elongation() > m_settings.greatestElongation && shape.areaMm2 >= 0.8 * wanted;
        if (shape.areaMm2 <= m_settings.greatestShare * wanted && !isLong)
            return;
        // Across its length, through the two edges that pass the middle.
        const FaceRing ring = m_mesh.ring(face);
        std::vector<std::size_t> crossed;
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const double here = glm::dot(m_mesh.position(ring[i]) - shape.middleLps, shape.longWay);
            const double next = glm::dot(
                m_mesh.position(ring[(i + 1) % ring.size()]) - shape.middleLps, shape.longWay);
            if ((here < 0.0) != (next < 0.0))
                crossed.push_back(i);
        }
        if (crossed.size() == 2 && split(face, crossed[0], crossed[1]))
            return;
        // A face as large as this is split in any way that is left.
        if (m_guard && shape.areaMm2 > largeShare * m_settings.greatestShare * wanted)
            splitInHalf(face);
    }

    /// Through an edge and the one across from it: the longest edge that allows it.
    void splitInHalf(FaceId face)
    {
        const FaceRing ring = m_mesh.ring(face);
        std::vector<std::pair<double, std::size_t>> edges;
        for (std::size_t i = 0; i < ring.size(); ++i)
            edges.emplace_back(-glm::distance(m_mesh.position(ring[i]),
                                   m_mesh.position(ring[(i + 1) % ring.size()])),
                i);
        std::sort(edges.begin(), edges.end());
        for (const auto& [length, i] : edges) {
            if (split(face, i, (i + ring.size() / 2) % ring.size()))
                return;
        }
    }

    bool split(FaceId face, std::size_t one, std::size_t other)
    {
        std::optional<std::array<VertexId, 2>> added;
        if (!attempt([&] {
                added = splitFace(m_edit, face, one, other);
                return added.has_value();
            }))
            return false;
        ++m_done.split;
        changed(surroundingsOf(m_mesh, added->at(0), added->at(1)));
        return true;
    }

    void swapAround(FaceId face)
    {
        for (std::size_t i = 0; i < m_mesh.ring(face).size(); ++i) {
            const EdgeSurroundings edge = edgeOf(face, i);
            const auto size = [&](FaceId id) { return int(m_mesh.ring(id).size()); };
            // What the squares of what they are off from six gain by it.
            if (size(edge.left) + size(edge.right) - size(edge.behind) - size(edge.ahead) <= 2)
                continue;
            const double length =
                glm::distance(m_mesh.position(edge.from), m_mesh.position(edge.to));
            const double area = areaOf(m_mesh, edge.left) + areaOf(m_mesh, edge.right);
            if (length * length > longestSwapped * longestSwapped * 0.5 * area || !isEven(edge)
                || !attempt([&] { return swapEdge(m_edit, edge.from, edge.to); }))
                continue;
            ++m_done.swapped;
            changed(edge);
            return;
        }
    }
    /// Whether the four faces around an edge look the same way.
    [[nodiscard]] bool isEven(const EdgeSurroundings& edge) const
    {
        const std::array<glm::dvec3, 4> areas{areaVectorOf(m_mesh, edge.left),
            areaVectorOf(m_mesh, edge.right), areaVectorOf(m_mesh, edge.behind),
            areaVectorOf(m_mesh, edge.ahead)};
        const glm::dvec3 sum = areas[0] + areas[1] + areas[2] + areas[3];
        return std::all_of(areas.begin(), areas.end(),
            [&](const glm::dvec3& area) { return glm::dot(area, sum) > 0.0; });
    }

    SimplexMeshEdit& m_edit;
    const SimplexMesh& m_mesh;
    const RestructuringSettings& m_settings;
    CrossingGuard* m_guard;
    std::vector<FaceId> m_faces; ///< that are looked at
    std::vector<FaceId> m_changed;
    Restructured m_done;
};

} // namespace

Restructured restructure(SimplexMeshEdit& edit, std::span<const VertexId> around,
    const RestructuringSettings& settings, CrossingGuard* guard)
{
    return Restructuring(edit, settings, guard).run(around);
}

int splitStretched(SimplexMeshEdit& edit, std::span<const VertexId> around,
    const StretchLimits& limits, CrossingGuard* guard)
{
    return Restructuring(edit, {}, guard).bound(around, limits);
}

double meanFaceAreaMm2(const SimplexMesh& mesh)
{
    double sum = 0.0;
    for (const FaceId face : mesh.faceIds())
        sum += areaOf(mesh, face);
    return mesh.faceCount() > 0 ? sum / double(mesh.faceCount()) : 0.0;
}

} // namespace core
