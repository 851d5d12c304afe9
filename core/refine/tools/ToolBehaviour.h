// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/refine/deform/ExternalForce.h"
#include "core/refine/tools/SurfaceTool.h"

#include <memory>
#include <optional>
#include <vector>

namespace core {

/// Lengths that tools go by.
struct ToolScale {
    double areaMm2 = 1.0; ///< that is wanted of a face
    double edgeMm = 1.0; ///< of a regular face of that area
    /// No vertex goes farther in a step: its neighbours could not follow.
    [[nodiscard]] double strideMm(const SurfacePoint& point) const
    {
        const double local = point.distanceMm < 0.5 * edgeMm ? 0.5 * edgeMm : point.distanceMm;
        return 0.35 * (local < edgeMm ? local : edgeMm);
    }
};

/// The edge of a regular face of that area; of the mesh's mean one for 0.
[[nodiscard]] double edgeMmOf(const SimplexMesh& mesh, double areaMm2);

/// What a tool does with the vertices that it has in its grip, for SurfaceStroke.
class ToolBehaviour {
public:
    explicit ToolBehaviour(const ToolScale& scale)
        : m_scale(scale)
    {
    }
    virtual ~ToolBehaviour() = default;
    ToolBehaviour(const ToolBehaviour&) = delete;
    ToolBehaviour& operator=(const ToolBehaviour&) = delete;

    /// Between two samples it is to be taken over places no farther apart than this.
    [[nodiscard]] virtual double walkMm(double pressure) const = 0;
    /// Takes it there. Gives whom it reaches, without green ones.
    [[nodiscard]] virtual std::vector<VertexId> moveTo(
        const SimplexMesh& mesh, const SurfaceSample& sample) = 0;
    /// Steps at each of these places, at least.
    [[nodiscard]] virtual int stepsAtPlace() const { return 1; }
    /// … and at most, while it has something to move out of its way.
    [[nodiscard]] virtual int mostStepsAtPlace() const { return 48; }
    /// Once in each step, before it.
    virtual void beginStep(const SimplexMesh& /*mesh*/) { }
    /// The pen is up.
    virtual void lift() { }

    struct Past {
        glm::dvec3 homeLps{0.0}; ///< where the vertex was before the tool came, or since it left
        bool isMade = false; ///< by restructuring, in this stroke
    };
    struct Grip {
        glm::dvec3 placeLps{0.0}; ///< where the vertex goes in this step
        double leftMm = 0.0; ///< and how far it is to go yet, before the step
        /// Unit vector along which it is not to leave that place any more, once it is let go; 0:
        /// it may.
        glm::dvec3 normalLps{0.0};
    };
    /// None: the tool does not hold it. Called by several threads at once, but once a step for a
    /// vertex.
    /// @param placeLps where forces would take it
    [[nodiscard]] virtual std::optional<Grip> gripOf(
        const SurfacePoint& point, const Past& past, const glm::dvec3& placeLps) = 0;
    /// The one vertex that it moves itself; noId: there is none.
    [[nodiscard]] virtual VertexId dragged() const { return noId; }
    /// A vertex that is new.
    virtual void adopt(const SimplexMesh& /*mesh*/, VertexId /*id*/) { }

protected:
    ToolScale m_scale;
};

/// It grips nothing: painting is the stroke's.
[[nodiscard]] std::unique_ptr<ToolBehaviour> behaviourOf(
    const MarkBrush& tool, const ToolScale& scale);
[[nodiscard]] std::unique_ptr<ToolBehaviour> behaviourOf(
    const SphereTool& tool, const ToolScale& scale);
[[nodiscard]] std::unique_ptr<ToolBehaviour> behaviourOf(
    const PlaneTool& tool, const ToolScale& scale);
[[nodiscard]] std::unique_ptr<ToolBehaviour> behaviourOf(
    const SmoothTool& tool, const ToolScale& scale);
[[nodiscard]] std::unique_ptr<ToolBehaviour> behaviourOf(
    const DragTool& tool, const ToolScale& scale);
[[nodiscard]] std::unique_ptr<ToolBehaviour> behaviourOf(
    const AttractTool& tool, const ToolScale& scale);
/// A template of which there is no shape (TemplateShape.h) grips nothing.
[[nodiscard]] std::unique_ptr<ToolBehaviour> behaviourOf(
    const TemplateTool& tool, const ToolScale& scale, const SimplexMesh& mesh);

} // namespace core
