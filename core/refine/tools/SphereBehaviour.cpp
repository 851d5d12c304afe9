// SPDX-License-Identifier: Apache-2.0
#include "core/refine/mesh/InternalForces.h"
#include "core/refine/tools/ToolBehaviour.h"
#include "core/refine/tools/ToolSheet.h"

#include <algorithm>
#include <cmath>

namespace core {

namespace {

/// A vertex on the sphere, to the last bits, is out of it.
constexpr double skin = 1e-9;
/// Where the surface lies near the centre the shortest way out is any; there it is rather the way
/// that the surface looks. In radii from the centre.
constexpr double unsureShare = 0.25;

class SphereBehaviour final : public ToolBehaviour {
public:
    SphereBehaviour(const SphereTool& tool, const ToolScale& scale)
        : ToolBehaviour(scale)
        , m_toolRadiusMm(tool.radiusMm)
    {
    }

    double walkMm(double pressure) const override
    {
        return std::min(0.5 * m_scale.edgeMm, 0.25 * m_toolRadiusMm * pressure);
    }

    std::vector<VertexId> moveTo(const SimplexMesh& mesh, const SurfaceSample& sample) override
    {
        m_centre = sample.placeLps;
        m_radiusMm = m_toolRadiusMm * sample.pressure;
        beginStep(mesh);
        std::vector<VertexId> reached;
        glm::dvec3 normals(0.0);
        double outside = 0.0;
        std::size_t within = 0;
        for (VertexId id = 0; id < mesh.vertexSlots(); ++id) {
            const glm::dvec3 way = mesh.position(id) - m_centre;
            if (!mesh.hasVertex(id) || !isWithin(way) || !isOfSheet(id))
                continue;
            const glm::dvec3 normal = frameAt(mesh, id).normalLps;
            normals += normal;
            outside += glm::dot(normal, way);
            ++within;
            if (mesh.mark(id) != SurfaceMark::Green)
                reached.push_back(id);
        }
        // It keeps to the side on which it met the surface, until it lets go of it.
        if (within == 0)
            m_side = 0.0;
        else if (m_side == 0.0)
            m_side = outside >= 0.0 ? 1.0 : -1.0;
        m_facing = within == 0 ? glm::dvec3(0.0) : m_side / double(within) * normals;
        return reached;
    }

    void beginStep(const SimplexMesh& mesh) override
    {
        if (m_scale.isApart)
            m_sheet.find(mesh, m_centre,
                [this](const glm::dvec3& place) { return isWithin(place - m_centre); });
    }

    std::optional<Grip> gripOf(
        const SurfacePoint& point, const Past& /*past*/, const glm::dvec3& placeLps) override
    {
        const glm::dvec3 from = point.positionLps - m_centre;
        if (!isWithin(from) || !isOfSheet(point.vertex))
            return std::nullopt;
        const glm::dvec3 way = wayOut(from);
        // |from + t way| = radius
        const double along = glm::dot(from, way);
        const double leftMm =
            std::sqrt(std::max(0.0, along * along + m_radiusMm * m_radiusMm - glm::dot(from, from)))
            - along;
        const double strideMm = m_scale.strideMm(point);
        // Forces may move it aside only.
        const glm::dvec3 moved = placeLps - point.positionLps;
        glm::dvec3 aside = moved - glm::dot(moved, way) * way;
        const double asideMm = glm::length(aside);
        if (asideMm > 0.5 * strideMm)
            aside *= 0.5 * strideMm / asideMm;
        const glm::dvec3 to = from + aside + std::min(leftMm, strideMm) * way;
        const double distance = glm::length(to);
        const bool arrives = leftMm <= strideMm || distance >= m_radiusMm;
        const glm::dvec3 place = arrives ? m_radiusMm / distance * to : to;
        return Grip{.placeLps = m_centre + place,
            .leftMm = leftMm,
            .normalLps = arrives ? place / m_radiusMm : glm::dvec3(0.0)};
    }

private:
    [[nodiscard]] bool isOfSheet(VertexId id) const
    {
        return !m_scale.isApart || m_sheet.contains(id);
    }
    [[nodiscard]] bool isWithin(const glm::dvec3& fromCentre) const
    {
        return glm::dot(fromCentre, fromCentre) < m_radiusMm * m_radiusMm * (1.0 - skin);
    }
    [[nodiscard]] glm::dvec3 wayOut(const glm::dvec3& from) const
    {
        const double distance = glm::length(from);
        const double along = glm::dot(from, m_facing);
        const double unsure = std::max(0.0, unsureShare * m_radiusMm - along) / m_radiusMm;
        const glm::dvec3 radial = distance > 0.0 ? from / distance : glm::dvec3(0.0);
        const glm::dvec3 way = radial + 8.0 * unsure * m_facing;
        const double length = glm::length(way);
        if (length > 1e-6)
            return way / length;
        const double facing = glm::length(m_facing);
        return facing > 0.0 ? m_facing / facing : glm::dvec3(0.0, 0.0, 1.0);
    }

    double m_toolRadiusMm;
    ToolSheet m_sheet; ///< if it holds no more than that
    glm::dvec3 m_centre{0.0};
    double m_radiusMm = 0.0;
    double m_side = 0.0; ///< 1: the centre is within the body; −1: outside; 0: it meets nothing
    glm::dvec3 m_facing{0.0}; ///< mean way that the surface looks, or away from that
};

} // namespace

std::unique_ptr<ToolBehaviour> behaviourOf(const SphereTool& tool, const ToolScale& scale)
{
    return std::make_unique<SphereBehaviour>(tool, scale);
}

} // namespace core
