// SPDX-License-Identifier: Apache-2.0
#include "core/refine/tools/GreyBox.h"
#include "core/refine/tools/ToolBehaviour.h"

#include <algorithm>

namespace core {

namespace {

/// Of the way to the edge, in a step.
constexpr double share = 0.5;

class AttractBehaviour final : public ToolBehaviour {
public:
    AttractBehaviour(const AttractTool& tool, const ToolScale& scale)
        : ToolBehaviour(scale)
        , m_tool(tool)
    {
    }

    double walkMm(double pressure) const override { return 0.25 * m_tool.radiusMm * pressure; }
    int stepsAtPlace() const override { return 3; }

    std::vector<VertexId> moveTo(const SimplexMesh& mesh, const SurfaceSample& sample) override
    {
        std::vector<VertexId> reached;
        if (!m_tool.grey)
            return reached;
        grow(mesh);
        const double radiusMm = m_tool.radiusMm * sample.pressure;
        for (VertexId id = 0; id < mesh.vertexSlots(); ++id) {
            const glm::dvec3 way = mesh.position(id) - sample.placeLps;
            if (!mesh.hasVertex(id) || mesh.mark(id) == SurfaceMark::Green
                || glm::dot(way, way) > radiusMm * radiusMm)
                continue;
            m_isTouched[id] = 1;
            reached.push_back(id);
        }
        return reached;
    }

    std::optional<Grip> gripOf(
        const SurfacePoint& point, const Past& /*past*/, const glm::dvec3& placeLps) override
    {
        if (point.vertex >= m_isTouched.size() || m_isTouched[point.vertex] == 0)
            return std::nullopt;
        const auto edgeMm =
            m_tool.grey->edgeAlongMm(point.positionLps, point.normalLps, m_tool.reachMm);
        if (!edgeMm)
            return Grip{.placeLps = placeLps};
        const double strideMm = m_scale.strideMm(point);
        return Grip{.placeLps = placeLps
                + share * std::clamp(*edgeMm, -strideMm, strideMm) * point.normalLps};
    }

    void adopt(const SimplexMesh& mesh, VertexId id) override
    {
        grow(mesh);
        int touched = 0;
        for (const VertexId near : mesh.neighbours(id))
            touched += m_isTouched[near];
        // It may be as well a vertex that is active for the first time.
        m_isTouched[id] = touched >= 2 || m_isTouched[id] != 0 ? 1 : 0;
    }

private:
    void grow(const SimplexMesh& mesh)
    {
        m_isTouched.resize(std::max<std::size_t>(m_isTouched.size(), mesh.vertexSlots()), 0);
    }

    AttractTool m_tool;
    std::vector<std::uint8_t> m_isTouched; ///< by vertex
};

} // namespace

std::unique_ptr<ToolBehaviour> behaviourOf(const AttractTool& tool, const ToolScale& scale)
{
    return std::make_unique<AttractBehaviour>(tool, scale);
}

} // namespace core
