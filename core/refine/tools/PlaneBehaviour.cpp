// SPDX-License-Identifier: Apache-2.0
#include "core/refine/tools/ToolBehaviour.h"
#include "core/refine/tools/ToolSheet.h"

#include <algorithm>
#include <cmath>

namespace core {

namespace {

/// Nearer to the plane than this a vertex lies on it.
constexpr double skinMm = 1e-10;

class PlaneBehaviour final : public ToolBehaviour {
public:
    PlaneBehaviour(const PlaneTool& tool, const ToolScale& scale)
        : ToolBehaviour(scale)
        , m_tool(tool)
    {
    }

    double walkMm(double pressure) const override
    {
        return std::min(0.5 * m_scale.edgeMm, 0.25 * m_tool.radiusMm * pressure);
    }

    std::vector<VertexId> moveTo(const SimplexMesh& mesh, const SurfaceSample& sample) override
    {
        const glm::dvec3 normal =
            sample.normalLps == glm::dvec3(0.0) ? m_tool.normalLps : sample.normalLps;
        const double length = glm::length(normal);
        if (m_tool.acrossLps == glm::dvec3(0.0) || m_way.empty())
            m_normal = length > 0.0 ? normal / length : glm::dvec3(0.0);
        if (m_tool.acrossLps != glm::dvec3(0.0))
            turnAlong(sample.placeLps);
        m_centre = sample.placeLps;
        m_radiusMm = m_tool.radiusMm * sample.pressure;
        beginStep(mesh);
        std::vector<VertexId> reached;
        for (VertexId id = 0; id < mesh.vertexSlots(); ++id) {
            if (mesh.hasVertex(id) && mesh.mark(id) != SurfaceMark::Green
                && isReached(mesh.position(id)) && isOfSheet(id))
                reached.push_back(id);
        }
        return reached;
    }

    void beginStep(const SimplexMesh& mesh) override
    {
        // What lies on the plane already connects what stands on it.
        if (m_scale.isApart)
            m_sheet.find(mesh, m_centre, [this](const glm::dvec3& place) {
                return isInCylinder(place, -m_scale.edgeMm, m_tool.heightMm);
            });
    }

    std::optional<Grip> gripOf(
        const SurfacePoint& point, const Past& past, const glm::dvec3& placeLps) override
    {
        if (!isOfSheet(point.vertex)
            || (!isReached(point.positionLps) && !isDrawnBelow(point.positionLps, past)))
            return std::nullopt;
        const double height = glm::dot(point.positionLps - m_centre, m_normal);
        const double leftMm = std::abs(height);
        const double strideMm = m_scale.strideMm(point);
        const glm::dvec3 moved = placeLps - point.positionLps;
        glm::dvec3 aside = moved - glm::dot(moved, m_normal) * m_normal;
        const double asideMm = glm::length(aside);
        if (asideMm > 0.5 * strideMm)
            aside *= 0.5 * strideMm / asideMm;
        glm::dvec3 place =
            point.positionLps + aside - std::clamp(height, -strideMm, strideMm) * m_normal;
        if (leftMm > strideMm)
            return Grip{.placeLps = place, .leftMm = leftMm, .normalLps = glm::dvec3(0.0)};
        // Twice: the first takes it there but for the rounding of long ways.
        for (int i = 0; i < 2; ++i)
            place -= glm::dot(place - m_centre, m_normal) * m_normal;
        return Grip{.placeLps = place, .leftMm = leftMm, .normalLps = m_normal};
    }

private:
    /// The way of the last half radius tells the direction: the last bit of it alone trembles.
    void turnAlong(const glm::dvec3& placeLps)
    {
        m_way.push_back(placeLps);
        const double baseMm = 0.5 * m_tool.radiusMm;
        while (m_way.size() > 2 && glm::distance(m_way[1], placeLps) >= baseMm)
            m_way.erase(m_way.begin());
        const glm::dvec3 way = placeLps - m_way.front();
        const glm::dvec3 normal = glm::cross(m_tool.acrossLps, way);
        const double length = glm::length(normal);
        if (glm::length(way) < 0.5 * baseMm || !(length > 0.0))
            return;
        const double side = glm::dot(normal, m_normal);
        // Straight on along what it looked at, there is no telling.
        if (side != 0.0)
            m_normal = (side > 0.0 ? 1.0 : -1.0) / length * normal;
    }
    /// Whether forces, or a change of structure, took it past the plane with what is on it.
    [[nodiscard]] bool isDrawnBelow(const glm::dvec3& positionLps, const Past& past) const
    {
        const glm::dvec3 from = positionLps - m_centre;
        const double height = glm::dot(from, m_normal);
        const double deepest = (isReached(past.homeLps) ? 1.0 : 0.1) * m_scale.edgeMm;
        return height < -skinMm && height > -deepest && (past.isMade || isReached(past.homeLps))
            && glm::dot(from, from) - height * height <= m_radiusMm * m_radiusMm;
    }
    [[nodiscard]] bool isReached(const glm::dvec3& positionLps) const
    {
        return isInCylinder(positionLps, skinMm, m_tool.heightMm);
    }
    /// Above the one height, up to the other.
    [[nodiscard]] bool isInCylinder(
        const glm::dvec3& positionLps, double aboveMm, double mostMm) const
    {
        const glm::dvec3 from = positionLps - m_centre;
        const double height = glm::dot(from, m_normal);
        return height > aboveMm && height <= mostMm
            && glm::dot(from, from) - height * height <= m_radiusMm * m_radiusMm;
    }
    [[nodiscard]] bool isOfSheet(VertexId id) const
    {
        return !m_scale.isApart || m_sheet.contains(id);
    }

    PlaneTool m_tool;
    ToolSheet m_sheet; ///< if it holds no more than that
    glm::dvec3 m_normal{0.0};
    std::vector<glm::dvec3> m_way; ///< the last places, if it turns along them
    glm::dvec3 m_centre{0.0};
    double m_radiusMm = 0.0;
};

} // namespace

std::unique_ptr<ToolBehaviour> behaviourOf(const PlaneTool& tool, const ToolScale& scale)
{
    return std::make_unique<PlaneBehaviour>(tool, scale);
}

} // namespace core
