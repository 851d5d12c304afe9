// SPDX-License-Identifier: Apache-2.0
#include "core/refine/tools/ToolBehaviour.h"

namespace core {

namespace {

class BrushBehaviour final : public ToolBehaviour {
public:
    BrushBehaviour(const MarkBrush& brush, const ToolScale& scale)
        : ToolBehaviour(scale)
        , m_radiusMm(brush.radiusMm)
    {
    }

    double walkMm(double pressure) const override { return 0.5 * m_radiusMm * pressure; }
    std::vector<VertexId> moveTo(
        const SimplexMesh& /*mesh*/, const SurfaceSample& /*sample*/) override
    {
        return {};
    }
    std::optional<Grip> gripOf(const SurfacePoint& /*point*/, const Past& /*past*/,
        const glm::dvec3& /*placeLps*/) override
    {
        return std::nullopt;
    }

private:
    double m_radiusMm;
};

} // namespace

std::unique_ptr<ToolBehaviour> behaviourOf(const MarkBrush& tool, const ToolScale& scale)
{
    return std::make_unique<BrushBehaviour>(tool, scale);
}

} // namespace core
