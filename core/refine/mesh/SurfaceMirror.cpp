// SPDX-License-Identifier: Apache-2.0
#include "core/refine/mesh/SurfaceMirror.h"

#include <algorithm>
#include <array>

namespace core {

namespace {

struct Ray {
    glm::dvec3 fromLps;
    glm::dvec3 directionLps;
};

/// How far along the ray a triangle is met from its front (Möller and Trumbore).
std::optional<double> crossing(
    const Ray& ray, const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c)
{
    const glm::dvec3 first = b - a;
    const glm::dvec3 second = c - a;
    const glm::dvec3 across = glm::cross(ray.directionLps, second);
    const double determinant = glm::dot(first, across);
    if (determinant <= 0.0)
        return std::nullopt;
    const glm::dvec3 off = ray.fromLps - a;
    const double u = glm::dot(off, across);
    if (u < 0.0 || u > determinant)
        return std::nullopt;
    const glm::dvec3 beside = glm::cross(off, first);
    const double v = glm::dot(ray.directionLps, beside);
    if (v < 0.0 || u + v > determinant)
        return std::nullopt;
    const double distance = glm::dot(second, beside) / determinant;
    return distance >= 0.0 ? std::optional(distance) : std::nullopt;
}

glm::dvec3 unitOrZero(const glm::dvec3& vector)
{
    const double length = glm::length(vector);
    return length > 0.0 ? vector / length : glm::dvec3(0.0);
}

} // namespace

void SurfaceMirror::putRing(FaceId face, const FaceRing& ring)
{
    if (face >= m_rings.size())
        m_rings.resize(std::size_t(face) + 1);
    FaceRing& known = m_rings[face];
    for (const VertexId id : known) {
        if (--m_uses[id] == 0)
            --m_vertexCount;
    }
    m_faceCount += std::size_t(!ring.empty()) - std::size_t(!known.empty());
    known = ring;
    for (const VertexId id : known) {
        if (id >= m_uses.size()) {
            m_uses.resize(std::size_t(id) + 1, 0);
            m_vertices.resize(m_uses.size());
        }
        if (m_uses[id]++ == 0)
            ++m_vertexCount;
    }
}

void SurfaceMirror::take(const SurfaceUpdate& update)
{
    if (update.isWhole)
        *this = {};
    for (const SurfaceUpdate::Vertex& vertex : update.vertices) {
        if (vertex.id >= m_vertices.size()) {
            m_vertices.resize(std::size_t(vertex.id) + 1);
            m_uses.resize(m_vertices.size(), 0);
        }
        m_vertices[vertex.id] = vertex;
    }
    for (const SurfaceUpdate::Face& face : update.faces)
        putRing(face.id, face.ring);
}

glm::dvec3 SurfaceMirror::middleOf(const FaceRing& ring) const
{
    glm::dvec3 sum(0.0);
    for (const VertexId id : ring)
        sum += m_vertices[id].positionLps;
    return sum / double(ring.size());
}

std::optional<MeshHit> SurfaceMirror::hit(
    const glm::dvec3& fromLps, const glm::dvec3& directionLps, FaceSides sides) const
{
    const Ray ray{.fromLps = fromLps, .directionLps = directionLps};
    std::optional<double> nearest;
    const FaceRing* met = nullptr;
    for (const FaceRing& ring : m_rings) {
        if (ring.empty())
            continue;
        const glm::dvec3 middle = middleOf(ring);
        // A face whose ball the ray passes by need not be looked at by triangles.
        double radiusSquared = 0.0;
        for (const VertexId id : ring) {
            const glm::dvec3 off = m_vertices[id].positionLps - middle;
            radiusSquared = std::max(radiusSquared, glm::dot(off, off));
        }
        const glm::dvec3 away = glm::cross(middle - fromLps, directionLps);
        if (glm::dot(away, away) > radiusSquared)
            continue;
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const glm::dvec3& one = m_vertices[ring[i]].positionLps;
            const glm::dvec3& other = m_vertices[ring[(i + 1) % ring.size()]].positionLps;
            std::optional<double> distance = crossing(ray, middle, one, other);
            // The other way round the back of a triangle is its front.
            if (!distance && sides == FaceSides::Both)
                distance = crossing(ray, middle, other, one);
            if (distance && (!nearest || *distance < *nearest)) {
                nearest = distance;
                met = &ring;
            }
        }
    }
    if (!met)
        return std::nullopt;
    MeshHit hit{.placeLps = fromLps + *nearest * directionLps, .distanceMm = *nearest};
    glm::dvec3 normal(0.0);
    double least = 0.0;
    for (const VertexId id : *met) {
        const SurfaceUpdate::Vertex& vertex = m_vertices[id];
        normal += vertex.normalLps;
        const glm::dvec3 off = vertex.positionLps - hit.placeLps;
        if (hit.vertex == noId || glm::dot(off, off) < least) {
            least = glm::dot(off, off);
            hit.vertex = id;
        }
    }
    hit.normalLps = unitOrZero(normal);
    return hit;
}

VertexId SurfaceMirror::nearestVertex(const glm::dvec3& placeLps) const
{
    VertexId nearest = noId;
    double least = 0.0;
    for (VertexId id = 0; id < m_vertices.size(); ++id) {
        if (m_uses[id] == 0)
            continue;
        const glm::dvec3 off = m_vertices[id].positionLps - placeLps;
        if (nearest == noId || glm::dot(off, off) < least) {
            least = glm::dot(off, off);
            nearest = id;
        }
    }
    return nearest;
}

std::array<std::size_t, 3> SurfaceMirror::markCounts() const
{
    std::array<std::size_t, 3> counts{};
    for (VertexId id = 0; id < m_vertices.size(); ++id) {
        if (m_uses[id] > 0)
            ++counts[std::size_t(m_vertices[id].mark)];
    }
    return counts;
}

std::vector<MarkedRegion> SurfaceMirror::regions(SurfaceMark mark) const
{
    std::vector<bool> isWanted(m_vertices.size(), false);
    forEachVertex([&](VertexId id, const SurfaceUpdate::Vertex& vertex) {
        isWanted[id] = vertex.mark == mark;
    });
    return regions(isWanted);
}

std::vector<MarkedRegion> SurfaceMirror::regions(const std::vector<bool>& isWanted) const
{
    // Vertices that follow each other in a ring are neighbours: joined to trees of numbers.
    std::vector<VertexId> parents(m_vertices.size());
    for (VertexId id = 0; id < parents.size(); ++id)
        parents[id] = id;
    const auto rootOf = [&parents](VertexId id) {
        while (parents[id] != id)
            id = parents[id] = parents[parents[id]];
        return id;
    };
    const auto isMarked = [&](VertexId id) { return m_uses[id] > 0 && isWanted[id]; };
    std::vector<double> areas(m_vertices.size(), 0.0);
    for (const FaceRing& ring : m_rings) {
        if (ring.empty())
            continue;
        const glm::dvec3 middle = middleOf(ring);
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const VertexId one = ring[i];
            const VertexId other = ring[(i + 1) % ring.size()];
            const double area = glm::length(glm::cross(m_vertices[one].positionLps - middle,
                                    m_vertices[other].positionLps - middle))
                / 2.0;
            areas[one] += area / 2.0;
            areas[other] += area / 2.0;
            if (isMarked(one) && isMarked(other)) {
                const VertexId a = rootOf(one);
                const VertexId b = rootOf(other);
                parents[std::max(a, b)] = std::min(a, b);
            }
        }
    }
    std::vector<std::size_t> places(m_vertices.size(), 0); ///< by root, counted from 1
    std::vector<MarkedRegion> regions;
    for (VertexId id = 0; id < m_vertices.size(); ++id) {
        if (!isMarked(id))
            continue;
        std::size_t& place = places[rootOf(id)];
        if (place == 0) {
            regions.push_back({.first = id});
            place = regions.size();
        }
        MarkedRegion& region = regions[place - 1];
        region.middleLps += m_vertices[id].positionLps;
        region.normalLps += m_vertices[id].normalLps;
        region.areaMm2 += areas[id];
        ++region.vertices;
    }
    for (MarkedRegion& region : regions) {
        region.middleLps /= double(region.vertices);
        region.normalLps = unitOrZero(region.normalLps);
    }
    std::stable_sort(
        regions.begin(), regions.end(), [](const MarkedRegion& one, const MarkedRegion& other) {
            return one.areaMm2 > other.areaMm2;
        });
    return regions;
}

} // namespace core
