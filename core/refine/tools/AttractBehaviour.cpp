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
            Part& part = m_parts[id];
            if (!part.isTouched)
                part = {.from = mesh.position(id), .last = mesh.position(id), .isTouched = true};
            reached.push_back(id);
        }
        return reached;
    }

    std::optional<Grip> gripOf(
        const SurfacePoint& point, const Past& /*past*/, const glm::dvec3& placeLps) override
    {
        if (point.vertex >= m_parts.size() || !m_parts[point.vertex].isTouched)
            return std::nullopt;
        Part& part = m_parts[point.vertex];
        // Looked for from where it was: from where it is now it would go on from edge to edge.
        const double goneMm = glm::dot(point.positionLps - part.from, point.normalLps);
        const auto edgeMm = m_tool.grey->edgeAlongMm(
            point.positionLps - goneMm * point.normalLps, point.normalLps, m_tool.reachMm);
        part.last = placeLps;
        if (edgeMm) {
            const double strideMm = m_scale.strideMm(point);
            part.last +=
                share * std::clamp(*edgeMm - goneMm, -strideMm, strideMm) * point.normalLps;
        }
        return Grip{.placeLps = part.last};
    }

    void adopt(const SimplexMesh& mesh, VertexId id) override
    {
        grow(mesh);
        Part& part = m_parts[id];
        // It may be as well a vertex that is active for the first time.
        if (part.isTouched && part.last == mesh.position(id))
            return;
        glm::dvec3 gone(0.0);
        int touched = 0;
        for (const VertexId near : mesh.neighbours(id)) {
            if (!m_parts[near].isTouched)
                continue;
            gone += mesh.position(near) - m_parts[near].from;
            ++touched;
        }
        part = {.from = mesh.position(id), .last = mesh.position(id), .isTouched = touched >= 2};
        if (part.isTouched)
            part.from -= gone / double(touched);
    }

private:
    struct Part {
        glm::dvec3 from{0.0}; ///< where it was before
        glm::dvec3 last{0.0}; ///< where it was left
        bool isTouched = false;
    };

    void grow(const SimplexMesh& mesh)
    {
        m_parts.resize(std::max<std::size_t>(m_parts.size(), mesh.vertexSlots()));
    }

    AttractTool m_tool;
    std::vector<Part> m_parts; ///< by vertex
};

} // namespace

std::unique_ptr<ToolBehaviour> behaviourOf(const AttractTool& tool, const ToolScale& scale)
{
    return std::make_unique<AttractBehaviour>(tool, scale);
}

} // namespace core
