// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/refine/deform/ExternalForce.h"
#include "core/refine/tools/SurfaceTool.h"

#include <memory>
#include <optional>
#include <vector>

namespace core {

/// The lengths on which tools depend.
struct ToolScale {
    double areaMm2 = 1.0; ///< intended area of a face
    double edgeMm = 1.0; ///< of a regular face of that area
    /// Whether the surface is prevented from passing through itself. Then sphere and plane affect
    /// only the sheet under the pen: the vertices within the tool that are connected, within it,
    /// with the vertex nearest to the pen.
    bool isApart = false;
    /// The greatest distance that a vertex moves in one step; its neighbours could not follow a
    /// longer one.
    [[nodiscard]] double strideMm(const SurfacePoint& point) const
    {
        const double local = point.distanceMm < 0.5 * edgeMm ? 0.5 * edgeMm : point.distanceMm;
        return 0.35 * (local < edgeMm ? local : edgeMm);
    }
};

/// The edge of a regular face of that area; for 0, of the mesh's mean area.
[[nodiscard]] double edgeMmOf(const SimplexMesh& mesh, double areaMm2);

/// How a tool moves the vertices that it holds; used by SurfaceStroke.
class ToolBehaviour {
public:
    explicit ToolBehaviour(const ToolScale& scale)
        : m_scale(scale)
    {
    }
    virtual ~ToolBehaviour() = default;
    ToolBehaviour(const ToolBehaviour&) = delete;
    ToolBehaviour& operator=(const ToolBehaviour&) = delete;

    /// The greatest distance between the places through which the tool is moved from sample to
    /// sample.
    [[nodiscard]] virtual double walkMm(double pressure) const = 0;
    /// Moves the tool to a place. Returns the vertices that it affects, without green ones.
    [[nodiscard]] virtual std::vector<VertexId> moveTo(
        const SimplexMesh& mesh, const SurfaceSample& sample) = 0;
    /// The least number of steps at each place.
    [[nodiscard]] virtual int stepsAtPlace() const { return 1; }
    /// The greatest number of steps at each place, while there is something to move out of the way.
    [[nodiscard]] virtual int mostStepsAtPlace() const { return 48; }
    /// Called before each step.
    virtual void beginStep(const SimplexMesh& /*mesh*/) { }
    /// After the pen was lifted and nothing is left to move, or gets any further: the greatest
    /// number of steps until the stroke ends.
    [[nodiscard]] virtual int mostStepsToRest() const { return 100; }
    /// How far the tool's vertices still have to go, for tools whose vertices do not move straight
    /// to their places; none: the greatest distance of a single vertex counts.
    [[nodiscard]] virtual std::optional<double> leftMm() const { return std::nullopt; }
    /// How often leftMm() was measured so far.
    [[nodiscard]] virtual int looks() const { return 0; }
    /// Called when the pen is lifted.
    virtual void lift() { }

    /// What is known of a vertex from before.
    struct Past {
        /// where the vertex was before the tool came, or after it had left
        glm::dvec3 homeLps{0.0};
        bool isMade = false; ///< created by restructuring in this stroke
    };
    /// How the tool holds a vertex.
    struct Grip {
        glm::dvec3 placeLps{0.0}; ///< where the vertex goes in this step
        double leftMm = 0.0; ///< how far it still has to go, before the step
        /// Unit vector along which it must not leave that place after it was released; 0: it may.
        glm::dvec3 normalLps{0.0};
    };
    /// None: the tool does not hold the vertex. Called by several threads at once, but only once
    /// per step for a vertex.
    /// @param placeLps where forces would move it
    [[nodiscard]] virtual std::optional<Grip> gripOf(
        const SurfacePoint& point, const Past& past, const glm::dvec3& placeLps) = 0;
    /// The only vertex that it moves directly; noId if there is none.
    [[nodiscard]] virtual VertexId dragged() const { return noId; }
    /// Registers a new vertex.
    virtual void adopt(const SimplexMesh& /*mesh*/, VertexId /*id*/) { }
    /// Registers that a vertex was stopped before the place to which the last step moved it,
    /// because it would have met another part of the surface.
    virtual void stopped(const SimplexMesh& /*mesh*/, VertexId /*id*/) { }

protected:
    ToolScale m_scale;
};

/// It holds nothing, since the stroke itself paints.
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
/// Moves the region of a template to a body (TemplateForm::Body).
[[nodiscard]] std::unique_ptr<ToolBehaviour> bodyBehaviour(
    std::shared_ptr<const TemplateShape> shape, const ToolScale& scale, const SimplexMesh& mesh);
/// A template without a shape (TemplateShape.h) holds nothing.
[[nodiscard]] std::unique_ptr<ToolBehaviour> behaviourOf(
    const TemplateTool& tool, const ToolScale& scale, const SimplexMesh& mesh);

} // namespace core
