// SPDX-License-Identifier: Apache-2.0
#include "core/refine/tools/ToolBehaviour.h"

namespace core {

namespace {

class SmoothBehaviour final : public ToolBehaviour {
public:
    SmoothBehaviour(const SmoothTool& tool, const ToolScale& scale)
        : ToolBehaviour(scale)
        , m_tool(tool)
    {
    }

    double walkMm(double pressure) const override { return 0.25 * m_tool.radiusMm * pressure; }

    int stepsAtPlace() const override { return 3; }
    void lift() override { m_radiusMm = 0.0; }

    std::vector<VertexId> moveTo(const SimplexMesh& mesh, const SurfaceSample& sample) override
    {
        m_centre = sample.placeLps;
        m_radiusMm = m_tool.radiusMm * sample.pressure;
        std::vector<VertexId> reached;
        for (VertexId id = 0; id < mesh.vertexSlots(); ++id) {
            if (mesh.hasVertex(id) && mesh.mark(id) != SurfaceMark::Green
                && weightAt(mesh.position(id)) > 0.0)
                reached.push_back(id);
        }
        return reached;
    }

    std::optional<Grip> gripOf(
        const SurfacePoint& point, const Past& /*past*/, const glm::dvec3& placeLps) override
    {
        const double weight = weightAt(point.positionLps);
        if (weight <= 0.0)
            return std::nullopt;
        // The forces alone are at work, with the place where they take it for its own.
        return Grip{.placeLps = point.positionLps + weight * (placeLps - point.positionLps)};
    }

private:
    /// 1 at the centre, 0 at the rim.
    [[nodiscard]] double weightAt(const glm::dvec3& positionLps) const
    {
        const glm::dvec3 from = positionLps - m_centre;
        return m_radiusMm > 0.0 ? 1.0 - glm::dot(from, from) / (m_radiusMm * m_radiusMm) : 0.0;
    }

    SmoothTool m_tool;
    glm::dvec3 m_centre{0.0};
    double m_radiusMm = 0.0;
};

} // namespace

std::unique_ptr<ToolBehaviour> behaviourOf(const SmoothTool& tool, const ToolScale& scale)
{
    return std::make_unique<SmoothBehaviour>(tool, scale);
}

} // namespace core
