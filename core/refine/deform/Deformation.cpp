// SPDX-License-Identifier: Apache-2.0
#include "core/refine/deform/Deformation.h"

#include "core/base/ParallelFor.h"
#include "core/refine/mesh/InternalForces.h"

#include <algorithm>

namespace core {

namespace {

/// Fewer vertices than this are not worth a thread.
constexpr std::size_t fewVertices = 2048;
constexpr int mostShares = 16;

/// Calls work(i) for each i below @p count, several at once.
template <typename Work> void forEach(std::size_t count, int shares, const Work& work)
{
    if (shares == 0)
        shares = count < fewVertices ? 1 : mostShares;
    const auto share = [&](int s) {
        const std::size_t end = count * std::size_t(s + 1) / std::size_t(shares);
        for (std::size_t i = count * std::size_t(s) / std::size_t(shares); i < end; ++i)
            work(i);
    };
    if (shares == 1)
        share(0);
    else
        parallelFor(shares, share);
}

/// The mean one.
double neighbourDistanceMm(const SimplexMesh& mesh, VertexId id)
{
    double sum = 0.0;
    for (const VertexId near : mesh.neighbours(id))
        sum += glm::distance(mesh.position(id), mesh.position(near));
    return sum / 3.0;
}

double meanOf(const std::vector<double>& numbers)
{
    double sum = 0.0;
    for (const double number : numbers)
        sum += number;
    return numbers.empty() ? 0.0 : sum / double(numbers.size());
}

} // namespace

void Deformation::activate(const SimplexMesh& mesh, std::span<const VertexId> vertices)
{
    m_motions.resize(std::max<std::size_t>(m_motions.size(), mesh.vertexSlots()));
    bool isSorted = true;
    for (const VertexId id : vertices) {
        if (!mesh.hasVertex(id) || mesh.mark(id) == SurfaceMark::Green)
            continue;
        Motion& motion = m_motions[id];
        motion.quiet = 0;
        if (motion.isActive)
            continue;
        motion = {.isActive = true};
        isSorted = isSorted && (m_active.empty() || m_active.back() < id);
        m_active.push_back(id);
    }
    if (!isSorted)
        std::sort(m_active.begin(), m_active.end());
}

void Deformation::activateAll(const SimplexMesh& mesh)
{
    activate(mesh, mesh.vertexIds());
}

void Deformation::rest(std::span<const VertexId> vertices)
{
    for (const VertexId id : vertices) {
        if (id < m_motions.size())
            m_motions[id].isActive = false;
    }
    forgetInactive();
}

void Deformation::restAll()
{
    m_active.clear();
    m_motions.clear();
}

void Deformation::stop(std::span<const VertexId> vertices)
{
    for (const VertexId id : vertices) {
        if (id < m_motions.size())
            m_motions[id].speed = glm::dvec3(0.0);
    }
}

void Deformation::restructured(const SimplexMesh& mesh, std::span<const VertexId> vertices)
{
    for (const VertexId id : m_active)
        m_motions[id].isActive = mesh.hasVertex(id);
    for (const VertexId id : vertices) {
        if (id < m_motions.size())
            m_motions[id].isActive = false;
    }
    forgetInactive();
    activate(mesh, vertices);
}

void Deformation::forgetInactive()
{
    std::erase_if(m_active, [&](VertexId id) { return !m_motions[id].isActive; });
}

DeformationStep Deformation::step(
    SimplexMeshEdit& edit, std::span<const ExternalForce* const> forces, SurfaceGuide* guide)
{
    const SimplexMesh& mesh = edit.mesh();
    m_motions.resize(std::max<std::size_t>(m_motions.size(), mesh.vertexSlots()));
    for (const VertexId id : m_active)
        m_motions[id].isActive = mesh.hasVertex(id) && mesh.mark(id) != SurfaceMark::Green;
    forgetInactive();
    measureCurvatures(mesh);
    m_pulls.resize(m_active.size());
    m_distances.resize(m_active.size());
    forEach(m_active.size(), m_settings.shares,
        [&](std::size_t i) { m_distances[i] = neighbourDistanceMm(mesh, m_active[i]); });
    const double strideMm = m_settings.stride * meanOf(m_distances);
    forEach(m_active.size(), m_settings.shares, [&](std::size_t i) {
        const VertexId id = m_active[i];
        const SurfacePoint point{.vertex = id,
            .positionLps = mesh.position(id),
            .normalLps = evenNormal(mesh, id),
            .mark = mesh.mark(id),
            .curvaturePerMm = m_curvatures[id],
            .distanceMm = m_distances[i]};
        glm::dvec3 external(0.0);
        for (const ExternalForce* force : forces)
            external += force->forceMm(point);
        // A stride beyond the neighbours would fold the surface before they could follow; and were
        // it the longer the farther they are left behind, those ahead would run away.
        const double lengthMm = glm::length(external);
        const double mostMm = std::min(strideMm, m_settings.stride * point.distanceMm);
        if (lengthMm > mostMm)
            external *= mostMm / lengthMm;
        Pull& pull = m_pulls[i];
        pull.force = m_settings.internal * internalForceMm(mesh, id, m_curvatures[id])
            + m_settings.external * external;
        pull.place = point.positionLps + (1.0 - m_settings.damping) * m_motions[id].speed
            + m_settings.timeStep * pull.force;
        if (guide)
            guide->guide(point, pull.force, pull.place);
    });

    DeformationStep report{.active = m_active.size()};
    std::vector<VertexId> woken;
    for (std::size_t i = 0; i < m_active.size(); ++i) {
        const VertexId id = m_active[i];
        Motion& motion = m_motions[id];
        motion.speed = m_pulls[i].place - mesh.position(id);
        edit.move(id, m_pulls[i].place);
        const double forceMm = glm::length(m_pulls[i].force);
        report.greatestForceMm = std::max(report.greatestForceMm, forceMm);
        report.greatestMoveMm = std::max(report.greatestMoveMm, glm::length(motion.speed));
        if (forceMm > m_settings.stirringMm) {
            const auto& near = mesh.neighbours(id);
            woken.insert(woken.end(), near.begin(), near.end());
        }
        motion.quiet = forceMm < m_settings.negligibleMm ? std::uint8_t(motion.quiet + 1) : 0;
        motion.isActive = motion.quiet < m_settings.quietSteps;
    }
    forgetInactive();
    std::erase_if(woken, [&](VertexId id) { return m_motions[id].isActive; });
    activate(mesh, woken);
    return report;
}

glm::dvec3 Deformation::evenNormal(const SimplexMesh& mesh, VertexId id) const
{
    const auto& near = mesh.neighbours(id);
    const glm::dvec3 sum =
        3.0 * m_normals[id] + m_normals[near[0]] + m_normals[near[1]] + m_normals[near[2]];
    const double length = glm::length(sum);
    return length > 0.0 ? sum / length : glm::dvec3(0.0);
}

void Deformation::measureCurvatures(const SimplexMesh& mesh)
{
    const std::size_t slots = mesh.vertexSlots();
    m_stamps.resize(slots, 0);
    m_normals.resize(slots);
    m_curvatures.resize(slots);
    m_evened.resize(slots);
    if (++m_stamp == 0) {
        std::fill(m_stamps.begin(), m_stamps.end(), 0);
        m_stamp = 1;
    }
    m_measured = m_active;
    for (const VertexId id : m_active)
        m_stamps[id] = m_stamp;
    // What the last round reads lies one neighbour farther out than what it gives, and so on.
    std::vector<std::size_t> ends{m_measured.size()};
    // Normals are evened over the neighbours in any case.
    for (int round = 0; round < std::max(1, m_settings.curvatureRounds); ++round) {
        const std::size_t begin = round == 0 ? 0 : ends[std::size_t(round) - 1];
        const std::size_t end = m_measured.size();
        for (std::size_t i = begin; i < end; ++i) {
            for (const VertexId near : mesh.neighbours(m_measured[i])) {
                if (m_stamps[near] == m_stamp)
                    continue;
                m_stamps[near] = m_stamp;
                m_measured.push_back(near);
            }
        }
        ends.push_back(m_measured.size());
    }
    forEach(m_measured.size(), m_settings.shares, [&](std::size_t i) {
        const SimplexFrame frame = frameAt(mesh, m_measured[i]);
        m_normals[m_measured[i]] = frame.normalLps;
        m_curvatures[m_measured[i]] = frame.curvaturePerMm;
    });
    for (int round = m_settings.curvatureRounds; round-- > 0;) {
        forEach(ends[std::size_t(round)], m_settings.shares, [&](std::size_t i) {
            const VertexId id = m_measured[i];
            const auto& near = mesh.neighbours(id);
            m_evened[id] = 0.25
                * (m_curvatures[id] + m_curvatures[near[0]] + m_curvatures[near[1]]
                    + m_curvatures[near[2]]);
        });
        // What lies farther out was not evened and is not read any more.
        m_curvatures.swap(m_evened);
    }
}

} // namespace core
