// SPDX-License-Identifier: Apache-2.0
#include "core/refine/tools/SurfaceHolds.h"

#include <algorithm>

namespace core {

namespace {

/// Of the way home.
constexpr double springShare = 0.5;

} // namespace

void SurfaceHolds::learn(const SimplexMesh& mesh, std::span<const VertexId> active)
{
    if (m_step == 0)
        m_slotsAtFirst = mesh.vertexSlots();
    m_holds.resize(std::max<std::size_t>(m_holds.size(), mesh.vertexSlots()));
    ++m_step;
    for (const VertexId id : active) {
        Hold& hold = m_holds[id];
        if (isSame(mesh, id))
            continue;
        hold = held(mesh, id);
        m_tool.adopt(mesh, id);
    }
}

void SurfaceHolds::stopped(const SimplexMesh& mesh, std::span<const VertexId> vertices)
{
    for (const VertexId id : vertices) {
        if (id >= m_holds.size() || !m_holds[id].isKnown)
            continue;
        Hold& hold = m_holds[id];
        hold.last = mesh.position(id);
        // The tool does not wait for it, and what it was to lie on holds it no longer.
        if (hold.gripped == m_step) {
            hold.home = hold.last;
            hold.normal = glm::dvec3(0.0);
            hold.leftMm = 0.0;
        }
        m_tool.stopped(mesh, id);
    }
}

bool SurfaceHolds::isSame(const SimplexMesh& mesh, VertexId id) const
{
    return id < m_holds.size() && m_holds[id].isKnown && m_holds[id].last == mesh.position(id);
}

SurfaceHolds::Hold SurfaceHolds::held(const SimplexMesh& mesh, VertexId id) const
{
    const glm::dvec3 place = mesh.position(id);
    Hold hold{.home = place,
        .last = place,
        .isKnown = true,
        .isMade = id >= m_slotsAtFirst || m_holds[id].isKnown};
    glm::dvec3 normals(0.0);
    glm::dvec3 homewards(0.0);
    double offMm = 0.0;
    int touched = 0;
    for (const VertexId near : mesh.neighbours(id)) {
        if (!isSame(mesh, near))
            continue;
        const Hold& other = m_holds[near];
        homewards += other.home - other.last;
        if (other.normal == glm::dvec3(0.0))
            continue;
        normals += other.normal;
        offMm += glm::dot(other.home - place, other.normal);
        ++touched;
    }
    const double length = glm::length(normals);
    if (touched < 2 || length < 0.9 * double(touched)) {
        // Where it would have been, had its neighbours not been moved; but one that was there
        // before is at home where it is.
        if (hold.isMade)
            hold.home = place + homewards / 3.0;
        return hold;
    }
    hold.normal = normals / length;
    hold.home = place + offMm / double(touched) * hold.normal;
    return hold;
}

glm::dvec3 SurfaceHolds::forceMm(const SurfacePoint& point) const
{
    if (follows(point.mark))
        return glm::dvec3(0.0);
    return springShare * (m_holds[point.vertex].home - point.positionLps);
}

void SurfaceHolds::guide(const SurfacePoint& point, glm::dvec3& forceMm, glm::dvec3& placeLps)
{
    Hold& hold = m_holds[point.vertex];
    const bool isFree = m_isYellowFree && follows(point.mark);
    const auto grip = isFree
        ? std::optional<ToolBehaviour::Grip>()
        : m_tool.gripOf(point, {.homeLps = hold.home, .isMade = hold.isMade}, placeLps);
    if (grip) {
        placeLps = grip->placeLps;
        forceMm = placeLps - point.positionLps;
        // One that goes slowly because others have farther to go is not at rest.
        const double movedMm = glm::length(forceMm);
        if (movedMm > 0.0 && grip->leftMm > movedMm)
            forceMm *= grip->leftMm / movedMm;
        hold.home = placeLps;
        hold.normal = grip->normalLps;
        hold.leftMm = grip->leftMm;
        hold.gripped = m_step;
    } else if (hold.normal != glm::dvec3(0.0) && !isFree) {
        forceMm -= glm::dot(forceMm, hold.normal) * hold.normal;
        placeLps -= glm::dot(placeLps - hold.home, hold.normal) * hold.normal;
    }
    hold.last = placeLps;
}

double SurfaceHolds::leftMm(std::span<const VertexId> active) const
{
    double most = 0.0;
    for (const VertexId id : active) {
        if (isGripped(id))
            most = std::max(most, m_holds[id].leftMm);
    }
    return most;
}

} // namespace core
